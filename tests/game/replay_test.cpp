#include "core/base/random.h"
#include "core/game/replay.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>

#include <filesystem>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Replay randomReplay(std::uint64_t seed) {
    Random random(seed);
    Replay replay;
    replay.level = seed % 3 == 0 ? "with \"quotes\" and \\ and ü.json" : "01_some_level.json";
    replay.seed = (std::uint64_t{random.next()} << 32) | random.next();
    if (seed % 2 == 0) {
        replay.levelHash = (std::uint64_t{random.next()} << 32) | random.next();
    }
    const std::uint32_t updates = random.below(3000);
    Controls keys;
    for (std::uint32_t i = 0; i < updates; ++i) {
        if (random.below(4) == 0) {
            keys = controlsFromBits(static_cast<std::uint8_t>(random.below(16)));
        }
        replay.append(keys);
    }
    return replay;
}

} // namespace

class ReplayTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsWrittenIsReadBack() {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            const Replay replay = randomReplay(seed);
            const std::string text = replayText(replay);
            const Result<Replay> read = parseReplay(text);
            QVERIFY2(read && read.value() == replay, qPrintable(QString("seed %1").arg(seed)));
            QCOMPARE(replayText(read.value()), text);
            QVERIFY(text.ends_with("}\n"));
        }
    }
    void equalUpdatesShareARun() {
        Replay replay;
        for (int i = 0; i < 10; ++i) {
            replay.append(i < 7 ? thrust : left);
        }
        QCOMPARE(replay.runs.size(), std::size_t(2));
        QCOMPARE(replay.runs[0].count, std::int64_t(7));
        QCOMPARE(replay.updates(), std::int64_t(10));
    }
    void aRecordedGameComesOutAgain() {
        Level level = openSpace();
        addWall(level, Vec2(3, 4), Vec2(-3, 4));
        Replay replay;
        replay.seed = 12;
        Session session(level, replay.seed);
        const auto play = [&](const Controls& keys, int updates) {
            for (int i = 0; i < updates; ++i) {
                session.step(keys);
                replay.append(keys);
            }
        };
        play(idle, 7);
        play(right, 1);
        play(idle, 1);
        play(tow, 3);
        QCOMPARE(replayed(level, replay).phase, Phase::Towing);
        play(thrust, 140);
        const Outcome outcome = replayed(level, replay);
        QCOMPARE(outcome.hash, session.hash());
        QCOMPARE(outcome.phase, session.phase());
        QCOMPARE(outcome.time, session.time());
        QCOMPARE(outcome.fuel, session.fuel());
        QCOMPARE(outcome.lives, session.lives());
        QCOMPARE(outcome.updates, session.updates());
        QVERIFY(outcome.won() != outcome.lost() || session.phase() == Phase::Towing);
    }
    void anEditedLevelIsNoticed() {
        Level level = openSpace();
        Replay replay;
        replay.append(idle);
        QVERIFY(!replayed(level, replay).levelChanged); // nothing is claimed
        replay.levelHash = levelHash(level);
        QVERIFY(!replayed(level, replay).levelChanged);
        addWall(level, Vec2(3, 4), Vec2(-3, 4));
        QVERIFY(replayed(level, replay).levelChanged);
    }
    void whatIsNoReplayIsRefusedWithItsReason_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("argument");
        const auto row = [](const char* name, const QByteArray& text, const char* code, const char* argument) {
            QTest::addRow("%s", name) << text << QString(code) << QString(argument);
        };
        row("empty", "", "replay-not-json", "1");
        row("cut off", "{\"replay\":1,\n\"level\":", "replay-not-json", "2");
        row("not JSON", "\n\nreplay", "replay-not-json", "3");
        row("invalid UTF-8", "{\"level\":\"\xff\xfe\"}", "replay-not-json", "1");
        row("a list", "[]", "replay-bad-field", "");
        row("a number too large", "{\"replay\":1e999}", "replay-not-json", "1");
        row("no version", "{}", "replay-bad-field", "/replay");
        row("version as text", "{\"replay\":\"1\"}", "replay-bad-field", "/replay");
        row("version 0", "{\"replay\":0}", "replay-bad-field", "/replay");
        row("newer", "{\"replay\":2}", "replay-newer", "2");
        row("no level", "{\"replay\":1}", "replay-bad-field", "/level");
        row("level as number", "{\"replay\":1,\"level\":7}", "replay-bad-field", "/level");
        const QByteArray head = "{\"replay\":1,\"level\":\"a\",";
        row("bad hash", head + "\"levelHash\":\"xyz\",\"seed\":1,\"updates\":[]}", "replay-bad-field", "/levelHash");
        row("negative seed", head + "\"seed\":-1,\"updates\":[]}", "replay-bad-field", "/seed");
        row("no updates", head + "\"seed\":1}", "replay-bad-field", "/updates");
        row("updates as object", head + "\"seed\":1,\"updates\":{}}", "replay-bad-field", "/updates");
        row("bare number", head + "\"seed\":1,\"updates\":[3]}", "replay-bad-field", "/updates/0");
        row("three numbers", head + "\"seed\":1,\"updates\":[[1,2,3]]}", "replay-bad-field", "/updates/0");
        row("bits too many", head + "\"seed\":1,\"updates\":[[1,2],[16,2]]}", "replay-bad-field", "/updates/1/0");
        row("negative bits", head + "\"seed\":1,\"updates\":[[-1,2]]}", "replay-bad-field", "/updates/0/0");
        row("fraction", head + "\"seed\":1,\"updates\":[[1,2.5]]}", "replay-bad-field", "/updates/0/1");
        row("count 0", head + "\"seed\":1,\"updates\":[[1,0]]}", "replay-bad-field", "/updates/0/1");
        row("count beyond 64 bits", head + "\"seed\":1,\"updates\":[[1,18446744073709551615]]}", "replay-bad-field",
            "/updates/0/1");
        row("too long", head + "\"seed\":1,\"updates\":[[1,1000000],[0,1]]}", "replay-too-long", "1000000");
        row("nested", head + "\"updates\":" + QByteArray(100000, '['), "replay-bad-field", "");
    }
    void whatIsNoReplayIsRefusedWithItsReason() {
        QFETCH(QByteArray, text);
        QFETCH(QString, code);
        QFETCH(QString, argument);
        const Result<Replay> read = parseReplay(std::string_view(text.data(), static_cast<std::size_t>(text.size())));
        QVERIFY(!read);
        QCOMPARE(QString::fromStdString(read.error().code), code);
        QCOMPARE(QString::fromStdString(read.error().arguments.at(0)), argument);
    }
    void brokenFilesNeverCrash() {
        const std::string good = replayText(randomReplay(2));
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            Random random(seed);
            std::string text = good.substr(0, 300);
            for (std::uint32_t i = 0; i <= random.below(4); ++i) {
                text[random.below(static_cast<std::uint32_t>(text.size()))] = static_cast<char>(random.below(256));
            }
            const Result<Replay> read = parseReplay(text);
            QVERIFY2(!read || read.value().updates() <= maxReplayUpdates, qPrintable(QString("seed %1").arg(seed)));
        }
    }
    void aFieldThatIsUnknownOrGivenTwiceIsRefused() {
        const std::string good = R"({"replay": 1, "level": "a.json", "seed": 1, "updates": [[0, 1]])";
        QVERIFY(bool(parseReplay(good + "}")));
        QVERIFY((parseReplay(good + R"(, "speed": 2})").error() == Error{"replay-unknown-field", {"speed"}}));
        QVERIFY((parseReplay(good + R"(, "": 2})").error() == Error{"replay-unknown-field", {""}}));
        QVERIFY((parseReplay(good + R"(, "seed": 2})").error() == Error{"replay-duplicate-field", {"seed"}}));
        QVERIFY((parseReplay(good + R"(, "se\u0065d": 2})").error() == Error{"replay-duplicate-field", {"seed"}}));
        // What a newer version has added is its own business.
        QCOMPARE(parseReplay(R"({"replay": 2, "level": "", "speed": 2})").error().code, std::string("replay-newer"));
    }
    void filesAreWrittenWholeOrNotAtAll() {
        const QTemporaryDir dir;
        const std::filesystem::path path = std::filesystem::path(dir.path().toStdString()) / "flight.json";
        const Replay replay = randomReplay(4);
        QVERIFY(!writeReplay(path, replay));
        const Result<Replay> read = readReplay(path);
        QVERIFY(read && read.value() == replay);
        QCOMPARE(std::distance(std::filesystem::directory_iterator(dir.path().toStdString()), {}), 1);

        const Result<Replay> none = readReplay(path.parent_path() / "none.json");
        QVERIFY(!none && none.error().code == "cannot-read");
        const Result<Replay> folder = readReplay(path.parent_path());
        QVERIFY(!folder && folder.error().code == "cannot-read");
        const std::optional<Error> failed = writeReplay(path.parent_path() / "no" / "such" / "folder.json", replay);
        QVERIFY(failed && failed->code == "folder-missing" && failed->arguments.size() == 2);
    }
};

SPACETOW_TEST(ReplayTest)
#include "replay_test.moc"
