#include "core/base/random.h"
#include "core/game/codes.h"
#include "core/game/replay.h"
#include "tests/support/folders.h"
#include "tests/support/game_levels.h"
#include "tests/support/live_level.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <QFile>
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

/// The same, played with: bodies were held, and the level was edited.
Replay randomPlay(std::uint64_t seed) {
    Replay replay = randomReplay(seed);
    Random random(seed);
    std::int64_t update = 0;
    for (std::uint32_t i = random.below(30); i > 0; --i, update += 1 + random.below(9)) {
        const auto number = [&] { return random.uniform(-1e3, 1e3); };
        Grab grab{1 + random.next() % 1000, Vec2(number(), number()), Vec2(number(), random.below(9))};
        replay.holds.push_back({update, random.below(5) == 0 ? std::nullopt : std::optional(grab)});
    }
    Level level = randomLevel(seed);
    update = random.below(3);
    for (std::uint32_t i = 1 + random.below(4); i > 0; --i, update += 1 + random.below(400)) {
        const Level next = randomLevel(seed * 100 + i);
        replay.edits.push_back({update, deltaBetween(level, next)});
        level = next;
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
    void soIsWhatWasDoneByHand() {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            const Replay replay = randomPlay(seed);
            const std::string text = replayText(replay);
            QVERIFY(text.starts_with("{\n\"replay\": 2,"));
            const Result<Replay> read = parseReplay(text);
            QVERIFY2(read && read.value() == replay, qPrintable(QString("seed %1").arg(seed)));
            QCOMPARE(replayText(read.value()), text);
        }
        QVERIFY(replayText(randomReplay(3)).starts_with("{\n\"replay\": 1,")); // older programs know that
    }
    void howItEndedIsWrittenAndReadBack() {
        for (const FlightEnd end : {FlightEnd::Won, FlightEnd::Lost, FlightEnd::UnderWay}) {
            for (const std::uint64_t seed : {3, 4}) {
                Replay replay = seed == 3 ? randomReplay(seed) : randomPlay(seed);
                replay.ended = {end, 12.34, 0.1 + 0.2, Vec2(-1e-7, 8.9), 617, 12.34};
                replay.ended->place = end == FlightEnd::UnderWay ? std::nullopt : replay.ended->place;
                const std::string text = replayText(replay);
                QVERIFY(text.starts_with("{\n\"replay\": 3,"));
                QVERIFY(parseReplay(text).value() == replay);
            }
        }
    }
    void filesOfEveryVersionAreReadAndWrittenAsTheyAre() {
        const QString folder = test::sourceFolder() + "/tests/replays/format/";
        for (int version = 1; version <= replayVersion; ++version) {
            QFile file(folder + QStringLiteral("version_%1.replay.json").arg(version));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const std::string text = file.readAll().toStdString();
            const Result<Replay> read = parseReplay(text);
            QVERIFY2(read, qPrintable(file.fileName()));
            QCOMPARE(QString::fromStdString(replayText(read.value())), QString::fromStdString(text));
            QCOMPARE(read.value().ended.has_value(), version >= 3);
            QCOMPARE(read.value().kind, version >= 4 ? RunKind::Simulation : RunKind::Game);
        }
    }
    void whatItIsOfIsWrittenAndReadBack() {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Replay replay = seed % 2 == 0 ? randomReplay(seed) : randomPlay(seed);
            replay.kind = RunKind::Simulation;
            const std::string text = replayText(replay);
            QVERIFY(text.starts_with("{\n\"replay\": 4,\n\"kind\": \"simulation\","));
            QVERIFY(parseReplay(text).value() == replay);
            replay.kind = RunKind::Game;
            QVERIFY(replayText(replay).find("\n\"kind\"") == std::string::npos); // older programs know that
        }
        const std::string rest = R"("level": "a.json", "seed": 1, "updates": [[0, 1]]})";
        QCOMPARE(parseReplay(R"({"replay": 4, "kind": "game", )" + rest).value().kind, RunKind::Game);
        QCOMPARE(parseReplay(R"({"replay": 4, )" + rest).value().kind, RunKind::Game);
    }
    void otherInputsMayEndOtherwise() {
        Replay replay = randomReplay(2);
        replay.ended = {FlightEnd::Won, 1, 1, Vec2(1, 2), 3, 0.06};
        const Replay based = basedOn(replay, openSpace(), yard());
        QVERIFY(based.edits.size() == 1 && based.ended == replay.ended); // it is the same flight
        setInputs(replay, InputRuns(), openSpace());
        QVERIFY(!replay.ended);
    }
    void inputsAreToldToTheRecordingAndComeFromItAgain() {
        const Level level = yard();
        InputRuns inputs;
        const StepInput held{thrust, Grab{boxKey, Vec2(0, 0.1), Vec2(1, 2)}, {}};
        inputs.append({idle, {}, {}}, 20);
        inputs.append(held, 15);
        inputs.append({thrust, held.grab, without(level, ballKey)});
        inputs.append(held, 4);
        inputs.append({left, {}, {}}, 30);
        inputs.append({left, Grab{boxKey, Vec2(0, 0), Vec2(std::nan(""), 0)}, {}}, 3); // does nothing, and is not told
        Replay replay;
        setInputs(replay, inputs, level);
        QCOMPARE(replay.updates(), std::int64_t(73));
        QCOMPARE(replay.runs.size(), std::size_t(3));
        QCOMPARE(replay.holds.size(), std::size_t(2));
        Session session(level);
        for (InputReader all(inputs); !all.isAtEnd();) {
            session.step(all.next());
        }
        const Result<Replay> read = parseReplay(replayText(replay));
        QCOMPARE(replayed(level, read.value()).hash, session.hash());
        QVERIFY(replayed(yard(), replay).hash != replayed(openSpace(), replay).hash);
        // Who has edited the level since plays the same.
        const std::shared_ptr<const Level> now = without(level, floorKey);
        const Replay based = basedOn(replay, level, *now);
        QCOMPARE(replayed(*now, based).hash, session.hash());
        QVERIFY(basedOn(replay, level, yard()) == replay);
    }
    void inputsAreCutAndGivenOnInParts() {
        InputRuns inputs;
        inputs.append({left, {}, {}}, 10);
        inputs.append({right, {}, {}}, 10);
        const InputRuns later = inputs.after(14);
        QCOMPARE(later.updates(), std::int64_t(6));
        QCOMPARE(later.runs().size(), std::size_t(1));
        QCOMPARE(inputs.after(4).updates(), std::int64_t(16));
        QCOMPARE(inputs.after(90).updates(), std::int64_t(0));
        inputs.cutAt(7);
        QCOMPARE(inputs.updates(), std::int64_t(7));
        QCOMPARE(inputs.runs().size(), std::size_t(1));
        const InputRuns edited = later.withLevel(std::make_shared<const Level>());
        QCOMPARE(edited.updates(), std::int64_t(6));
        QVERIFY(edited.runs().front().input.level && edited.runs().front().count == 1);
        QVERIFY(!edited.runs().back().input.level);
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
    void rulesThatHaveNotActedYetAreNoticedByTheHashOfTheLevel() {
        const Level level = openSpace();
        Replay replay;
        replay.append(idle);
        replay.levelHash = levelHash(level);
        Level stronger = level;
        stronger.rules.thrust += 1;
        Level farther = level;
        farther.rules.towRange += 1;
        for (const Level& other : {stronger, farther}) {
            QCOMPARE(Session(other).hash(), Session(level).hash()); // which is of the state alone
            QVERIFY(replayed(other, replay).levelChanged);
        }
    }
    void whatIsNoReplayIsRefusedWithItsReason_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("arguments");
        const auto row = [](const char* name, const QByteArray& text, const char* code, const char* arguments) {
            QTest::addRow("%s", name) << text << QString(code) << QString(arguments);
        };
        row("empty", "", "empty-file", "");
        row("cut off", "{\"replay\":1,\n\"level\":", "not-sound-json", "2 unexpected-end");
        row("not JSON", "\n\nreplay", "not-sound-json", "3 not-json replay");
        row("invalid UTF-8", "{\"level\":\"\xff\xfe\"}", "not-sound-json", "1 not-utf8");
        row("a list", "[]", "replay-none", "");
        row("a number too large", "{\"replay\":\n1e999}", "not-sound-json", "2 number-too-large 1e999");
        row("no version", "{}", "replay-bad-field", "/replay 1");
        row("version as text", "{\"replay\":\"1\"}", "replay-bad-field", "/replay 1");
        row("version 0", "{\"replay\":0}", "replay-bad-field", "/replay 1");
        row("newer", "{\"replay\":5}", "replay-newer", "5 4");
        const auto quoted = [](QByteArray text) { return text.replace('\'', '"'); };
        row("hands in the first version", quoted("{'replay':1,'level':'','seed':1,'updates':[],'holds':[]}"),
            "replay-unknown-field", "holds 1");
        const QByteArray two = quoted("{'replay':2,'level':'','seed':1,'updates':[[0,9]],");
        row("holds as number", two + quoted("'holds':3}"), "replay-bad-field", "/holds 1");
        row("an empty hold", two + quoted("'holds':[[]]}"), "replay-bad-field", "/holds/0 1");
        row("a hold of no key", two + quoted("'holds':[[1,'x',0,0,0,0]]}"), "replay-bad-field", "/holds/0 1");
        row("a hold of text", two + quoted("'holds':[[1,'00000001',0,'a',0,0]]}"), "replay-bad-field", "/holds/0/3 1");
        row("holds out of order", two + quoted("'holds':[[5],[5]]}"), "replay-bad-field", "/holds/1/0 1");
        row("an edit too short", two + quoted("'edits':[[1,'{}']]}"), "replay-bad-field", "/edits/0 1");
        row("an edit of no level", two + quoted("'edits':[[1,']',[],[]]]}"), "replay-bad-field", "/edits/0/1 1");
        row("an edit of an empty text", two + quoted("'edits':[[1,'{}',[],[7]]]}"), "replay-bad-field", "/edits/0/1 1");
        const QByteArray three = quoted("{'replay':3,'level':'','seed':1,'updates':[[0,9]],'end':");
        row("an end in the second version", two + quoted("'end':{}}"), "replay-unknown-field", "end 1");
        row("an end that is no object", three + "[]}", "replay-bad-field", "/end 1");
        row("an end without an outcome", three + "{}}", "replay-bad-field", "/end/outcome 1");
        row("an outcome that is none", three + quoted("{'outcome':'stopped'}}"), "replay-bad-field", "/end/outcome 1");
        const QByteArray end = three + quoted("{'outcome':'won','fuel':1,'seconds':3,");
        row("a negative time", end + quoted("'update':2,'time':-1}}"), "replay-bad-field", "/end/time 1");
        row("an update too late", end + quoted("'update':1000001,'time':1}}"), "replay-bad-field", "/end/update 1");
        row("a place of one number", end + quoted("'update':2,'time':1,'place':[1]}}"), "replay-bad-field",
            "/end/place 1");
        row("an end with more", end + quoted("'update':2,'time':1,'x':1}}"), "replay-unknown-field", "x 1");
        row("an end told twice", end + quoted("'update':2,'time':1,'time':1}}"), "replay-duplicate-field", "time 1");
        row("a kind in the third version", quoted("{'replay':3,'kind':'game','level':'','seed':1,'updates':[]}"),
            "replay-unknown-field", "kind 1");
        const QByteArray four = quoted("{'replay':4,'level':'','seed':1,'updates':[],'kind':");
        row("a kind that is none", four + quoted("'film'}"), "replay-bad-field", "/kind 1");
        row("a kind that is a number", four + "1}", "replay-bad-field", "/kind 1");
        row("a kind told twice", four + quoted("'game','kind':'simulation'}"), "replay-duplicate-field", "kind 1");
        row("no level", "{\"replay\":1}", "replay-bad-field", "/level 1");
        row("level as number", "{\"replay\":1,\"level\":7}", "replay-bad-field", "/level 1");
        const QByteArray head = "{\"replay\":1,\"level\":\"a\",";
        row("bad hash", head + "\"levelHash\":\"xyz\",\"seed\":1,\"updates\":[]}", "replay-bad-field", "/levelHash 1");
        row("negative seed", head + "\"seed\":-1,\"updates\":[]}", "replay-bad-field", "/seed 1");
        row("no updates", head + "\"seed\":1}", "replay-bad-field", "/updates 1");
        row("updates as object", head + "\"seed\":1,\"updates\":{}}", "replay-bad-field", "/updates 1");
        row("bare number", head + "\"seed\":1,\"updates\":[3]}", "replay-bad-field", "/updates/0 1");
        row("three numbers", head + "\"seed\":1,\"updates\":[[1,2,3]]}", "replay-bad-field", "/updates/0 1");
        row("bits too many", head + "\"seed\":1,\"updates\":[[1,2],[16,2]]}", "replay-bad-field", "/updates/1/0 1");
        row("negative bits", head + "\"seed\":1,\"updates\":[[-1,2]]}", "replay-bad-field", "/updates/0/0 1");
        row("fraction", head + "\"seed\":1,\"updates\":[[1,2.5]]}", "replay-bad-field", "/updates/0/1 1");
        row("count 0", head + "\"seed\":1,\"updates\":[[1,0]]}", "replay-bad-field", "/updates/0/1 1");
        row("count beyond 64 bits", head + "\"seed\":1,\"updates\":[[1,18446744073709551615]]}", "replay-bad-field",
            "/updates/0/1 1");
        row("too long", head + "\"seed\":1,\"updates\":[[1,1000000],[0,1]]}", "replay-too-long", "1000000");
        row("nested", head + "\"updates\":" + QByteArray(100000, '['), "not-sound-json", "1 nested-too-deep 64");
        row("a bit too nested", head + "\"seed\":1,\"updates\":[\n[[1,2]],\n[[[[1]]]]]}", "not-sound-json",
            "3 nested-too-deep 4");
        row("in a later line", head + "\"seed\":1,\n\"updates\":[\n[1,2],\n[16,2]]}", "replay-bad-field",
            "/updates/1/0 4");
        row("missing in the end", three + quoted("\n{'outcome':\n'won'}}"), "replay-bad-field", "/end/time 2");
    }
    void whatIsNoReplayIsRefusedWithItsReason() {
        QFETCH(QByteArray, text);
        QFETCH(QString, code);
        QFETCH(QString, arguments);
        const Result<Replay> read = parseReplay(std::string_view(text.data(), static_cast<std::size_t>(text.size())));
        QVERIFY(!read);
        QCOMPARE(QString::fromUtf8(read.error().code.text()), code);
        QStringList found;
        for (const std::string& argument : read.error().arguments) {
            found << QString::fromStdString(argument);
        }
        QCOMPARE(found.join(' '), arguments);
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
        const std::string played = replayText(randomPlay(4));
        for (std::uint64_t seed = 0; seed < 300; ++seed) {
            Random random(seed);
            std::string text = played;
            text[random.below(static_cast<std::uint32_t>(text.size()))] = static_cast<char>(random.below(256));
            const Result<Replay> read = parseReplay(text);
            QVERIFY2(!read || parseReplay(replayText(read.value())).value() == read.value(),
                     qPrintable(QString("seed %1").arg(seed)));
        }
    }
    void aFieldThatIsUnknownOrGivenTwiceIsRefused() {
        const std::string good = R"({"replay": 1, "level": "a.json", "seed": 1, "updates": [[0, 1]])";
        QVERIFY(bool(parseReplay(good + "}")));
        QVERIFY((parseReplay(good + R"(, "speed": 2})").error() ==
                 Error{GameCode("replay-unknown-field"), {"speed", "1"}}));
        QVERIFY((parseReplay(good + R"(, "": 2})").error() == Error{GameCode("replay-unknown-field"), {"", "1"}}));
        QVERIFY((parseReplay(good + R"(, "seed": 2})").error() ==
                 Error{GameCode("replay-duplicate-field"), {"seed", "1"}}));
        QVERIFY((parseReplay(good + R"(, "se\u0065d": 2})").error() ==
                 Error{GameCode("replay-duplicate-field"), {"seed", "1"}}));
        // What a newer version has added is its own business.
        QCOMPARE(parseReplay(R"({"replay": 5, "level": "", "speed": 2})").error().code.text(),
                 std::string("replay-newer"));
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
        QVERIFY(!none && none.error().code.text() == "cannot-read");
        const Result<Replay> folder = readReplay(path.parent_path());
        QVERIFY(!folder && folder.error().code.text() == "cannot-read");
        const std::optional<Error> failed = writeReplay(path.parent_path() / "no" / "such" / "folder.json", replay);
        QVERIFY(failed && failed->code.text() == "folder-missing" && failed->arguments.size() == 2);
    }
};

SPACETOW_TEST(ReplayTest)
#include "replay_test.moc"
