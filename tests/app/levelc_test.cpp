#include "core/game/replay.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/random_level.h"
#include "tests/support/run_levelc.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <filesystem>

using namespace spacetow;
using namespace spacetow::test;

namespace {

const char* const drawing = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"50\">\n"
                            "  <rect id=\"box\" x=\"10\" y=\"10\" width=\"20\" height=\"20\"/>\n"
                            "  <path id=\"bend\" d=\"M0 40Q50 0 100 40\" fill=\"none\" stroke=\"black\"/>\n"
                            "  <text>left out</text>\n"
                            "</svg>";

/// A box that falls and a ground to fall on.
Level falling(double groundHalf = 50) {
    Level level;
    level.name = "Falling";
    level.gravity = {0, -10};
    BodyObject box;
    box.kind = BodyKind::Dynamic;
    box.shapes = {Circle{{0, 0}, 0.5}};
    box.position = {0, 20};
    box.velocity = {1, 0};
    BodyObject ground;
    ground.shapes = {EdgeChain{{{-groundHalf, 0}, {groundHalf, 0}}, false, noBack}};
    level.objects.append({0xb0, "ball", box, {}});
    level.objects.append({0xb1, "ground", ground, {}});
    return level;
}

QJsonObject bodyNamed(const QByteArray& dump, const QString& name) {
    for (const QJsonValue& body : QJsonDocument::fromJson(dump)["bodies"].toArray()) {
        if (body["name"].toString() == name) {
            return body.toObject();
        }
    }
    return {};
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class LevelcTest : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        m_folder.emplace();
        QVERIFY(m_folder->isValid());
    }

    void badUsageIsRefusedWithTwo_data() {
        QTest::addColumn<QStringList>("arguments");
        const QString level = "good.json";
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("unknown command") << QStringList{"fly"};
        QTest::newRow("check without a file") << QStringList{"check"};
        QTest::newRow("fix of two files") << QStringList{"fix", level, level};
        QTest::newRow("unknown option") << QStringList{"check", "--loud", level};
        QTest::newRow("file that is not there") << QStringList{"check", "missing.json"};
        QTest::newRow("folder") << QStringList{"check", "."};
        QTest::newRow("info of two") << QStringList{"info", level, level};
        QTest::newRow("info of no level") << QStringList{"info", "bad.json"};
        QTest::newRow("simulate without a number") << QStringList{"simulate", level};
        QTest::newRow("simulate half an update") << QStringList{"simulate", level, "--updates", "0.5"};
        QTest::newRow("simulate backwards") << QStringList{"simulate", level, "--updates", "-1"};
        QTest::newRow("dump to nowhere") << QStringList{"simulate", level,    "--updates",
                                                        "1",        "--dump", "nowhere/out.json"};
        QTest::newRow("render to nothing") << QStringList{"render", level};
        QTest::newRow("render to a text") << QStringList{"render", level, "-o", "out.txt"};
        QTest::newRow("render nothing wide") << QStringList{"render", level, "-o", "out.png", "--size", "0x10"};
        QTest::newRow("render too wide") << QStringList{"render", level, "-o", "out.png", "--size", "99999x10"};
        QTest::newRow("render unknown overlay")
            << QStringList{"render", level, "-o", "out.png", "--overlays", "aabb,soul"};
        QTest::newRow("import of nothing") << QStringList{"import", "-o", "out.json"};
        QTest::newRow("import to nothing") << QStringList{"import", "drawing.svg"};
        QTest::newRow("import at no scale") << QStringList{"import", "drawing.svg", "-o", "out.json", "--scale", "0"};
        QTest::newRow("import of odd walls")
            << QStringList{"import", "drawing.svg", "-o", "out.json", "--walls", "paper"};
        QTest::newRow("import too fine") << QStringList{"import", "drawing.svg", "-o", "out.json", "--tolerance", "0"};
        QTest::newRow("import of a level") << QStringList{"import", level, "-o", "out.json"};
        QTest::newRow("replay of one file") << QStringList{"replay", level};
        QTest::newRow("replay of no replay") << QStringList{"replay", level, level};
    }
    void badUsageIsRefusedWithTwo() {
        QFETCH(QStringList, arguments);
        write("good.json", levelText(falling()));
        write("bad.json", "{");
        write("drawing.svg", drawing);
        const LevelcRun run = runLevelc(inFolder(arguments));
        QCOMPARE(run.status, 2);
        QVERIFY(!run.err.isEmpty());
    }

    void helpIsNoMistake_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("of the program") << QStringList{"--help"};
        for (const char* command : {"check", "fix", "import", "info", "render", "simulate", "replay", "flights"}) {
            QTest::newRow(command) << QStringList{command, "--help"};
        }
    }
    void helpIsNoMistake() {
        QFETCH(QStringList, arguments);
        const LevelcRun run = runLevelc(arguments);
        QCOMPARE(run.status, 0);
        QVERIFY(run.out.contains("levelc", Qt::CaseInsensitive));
    }

    void importMakesALevelAndTellsWhatItLeavesOut() {
        write("drawing.svg", drawing);
        const QStringList start{"import", path("drawing.svg"), "-o", path("out.json")};
        const LevelcRun run = runLevelc(start);
        QCOMPARE(run.status, 0);
        QCOMPARE(run.out, QString());
        QCOMPARE(run.err,
                 QStringLiteral("levelc: %1: Text was left out (once, in line 4). Turn it into paths to have it.\n")
                     .arg(path("drawing.svg")));
        const Level level = *parseLevel(contents(path("out.json")).toStdString()).level;
        QCOMPARE(level.name, std::string("drawing"));
        QCOMPARE(level.objects.size(), 2);
        const auto& box = std::get<BodyObject>(level.objects[0].data);
        QCOMPARE(std::get<Polygon>(box.shapes.front()).vertices.size(), std::size_t{4});
        QCOMPARE(box.position, Vec2(0.1, 0.4)); // y is up
        const auto bend = std::get<LineChain>(std::get<BodyObject>(level.objects[1].data).shapes.front());

        QCOMPARE(runLevelc(start + QStringList{"--scale", "1", "--tolerance", "0.001", "--walls", "one-way"}).status,
                 0);
        const Level fine = *parseLevel(contents(path("out.json")).toStdString()).level;
        QCOMPARE(std::get<BodyObject>(fine.objects[0].data).position, Vec2(10, 40));
        const auto& walls = std::get<EdgeChain>(std::get<BodyObject>(fine.objects[1].data).shapes.front());
        QVERIFY(walls.vertices.size() > 3 * bend.vertices.size());
        QCOMPARE(runLevelc(start + QStringList{"--outlines"}).status, 0);
        QVERIFY(contents(path("out.json")).count("\"lines\"") == 2);
    }

    void checkPrintsALineAProblem() {
        write("good.json", levelText(falling()));
        write("warning.json", std::string(levelText(falling())).insert(1, "\n  \"glow\": 1,"));
        write("error.json",
              "{\n  \"schema\": 1,\n  \"objects\": [\n    {\"key\": \"00000001\", \"type\": \"boat\"}\n  ]\n}\n");
        QCOMPARE(runLevelc({"check", path("good.json")}).status, 0);
        QCOMPARE(runLevelc({"check", path("good.json")}).out, QString());

        const LevelcRun warning = runLevelc({"check", path("warning.json")});
        QCOMPARE(warning.status, 0);
        QCOMPARE(warning.out, path("warning.json") + ":2: warning: unknown-field: The field “glow” is not known here. "
                                                     "It is kept, but does nothing. (/glow)\n");

        const LevelcRun error = runLevelc({"check", path("good.json"), path("error.json")});
        QCOMPARE(error.status, 1);
        QVERIFY(error.out.startsWith(path("error.json") + ":4: error: unknown-choice: "));
        QVERIFY(error.out.endsWith(" (/objects/0/type)\n"));

        QCOMPARE(runLevelc({"check", path("error.json"), path("missing.json")}).status, 2);
    }

    void checkSpeaksJsonToo() {
        write("error.json",
              "{\"schema\": 1, \"objects\": [{\"key\": \"00000007\", \"type\": \"ship\", \"angle\": \"up\"}]}");
        const LevelcRun run = runLevelc({"check", "--json", path("error.json")});
        QCOMPARE(run.status, 1);
        const QJsonArray problems = QJsonDocument::fromJson(run.out.toUtf8()).array();
        QCOMPARE(problems.size(), 1);
        const QJsonObject problem = problems[0].toObject();
        QCOMPARE(problem["file"].toString(), path("error.json"));
        QCOMPARE(problem["line"].toInt(), 1);
        QCOMPARE(problem["severity"].toString(), QString("error"));
        QCOMPARE(problem["code"].toString(), QString("not-a-number"));
        QCOMPARE(problem["pointer"].toString(), QString("/objects/0/angle"));
        QCOMPARE(problem["object"].toString(), QString("00000007"));
        QVERIFY(problem["message"].toString().contains("angle"));

        write("good.json", levelText(falling()));
        const LevelcRun none = runLevelc({"check", "--json", path("good.json")});
        QCOMPARE(none.status, 0);
        QVERIFY(QJsonDocument::fromJson(none.out.toUtf8()).isArray());
    }

    void fixCuresWhatIsSafeAndSaysWhat() {
        const std::string faulty =
            "{\"schema\": 2, \"rules\": {\"background\": \"clouds\"}, \"objects\": [{\"key\": \"00000001\", "
            "\"type\": \"body\", \"name\": \"floor\", \"shapes\": [{\"type\": \"lines\", \"vertices\": "
            "[[0, 0], [1, 0], [1, 0], [2, 1]]}]}]}\n";
        write("faulty.json", faulty);
        const LevelcRun run = runLevelc({"fix", path("faulty.json"), "-o", path("cured.json")});
        QCOMPARE(run.status, 0);
        QVERIFY2(run.out.contains("Merge points: floor: Vertices 1 and 2"), qPrintable(run.out));
        QVERIFY2(run.out.contains("2 fixed, 0 left"), qPrintable(run.out));
        QCOMPARE(runLevelc({"check", path("cured.json")}).out, QString());
        QVERIFY(runLevelc({"check", path("faulty.json")}).out.contains("zero-length-wall"));

        const LevelcRun json = runLevelc({"fix", "--json", path("faulty.json")});
        const QJsonObject said = QJsonDocument::fromJson(json.out.toUtf8()).object();
        QCOMPARE(said["fixed"].toArray().size(), 2);
        QCOMPARE(said["left"].toArray().size(), 0);
        QCOMPARE(runLevelc({"check", path("faulty.json")}).out, QString());
    }

    void fixLeavesAFileAloneInWhichThereIsNothingToDo() {
        const std::string spelled = "{\"schema\":2,\"name\":\"as I spell it\",\"objects\":[]}";
        write("good.json", spelled);
        QCOMPARE(runLevelc({"fix", path("good.json")}).status, 0);
        QFile file(path("good.json"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll().toStdString(), spelled);
        write("ship.json", "{\"schema\": 2, \"objects\": [{\"key\": \"00000007\", \"type\": \"ship\"}]}");
        QCOMPARE(runLevelc({"fix", path("ship.json")}).status, 1);
    }

    void checkLeavesOutWhatIsHidden() {
        write("ship.json", "{\"schema\": 2, \"objects\": [{\"key\": \"00000007\", \"type\": \"ship\"}], "
                           "\"hiddenProblems\": [{\"rule\": \"payload-missing\"}, {\"rule\": \"finish-missing\"}]}");
        QCOMPARE(runLevelc({"check", path("ship.json")}).out, QString());
        QCOMPARE(runLevelc({"check", path("ship.json")}).status, 0);
        QCOMPARE(runLevelc({"check", "--all", path("ship.json")}).status, 1);
    }

    void infoSaysWhatIsInALevel() {
        write("level.json", levelText(populatedLevel()));
        const LevelcRun run = runLevelc({"info", path("level.json")});
        QCOMPARE(run.status, 0);
        for (const char* line : {"name: Everything", "author: Nobody",
                                 "objects: 3 body, 1 ship, 1 payload, 1 finish, 1 connector, 2 group",
                                 "shapes: 1 edges, 1 lines, 1 polygon, 3 circle, 9 vertices", "gravity: (0.5, -2) m/s²",
                                 "update: 0.01 s, 50 iterations, 4 sub-steps",
                                 "rules: 5 lives, tow range 2.5 m, gravity flips on towing, background plain",
                                 "tags: wall, ship, payload, finish, debris, ice"}) {
            QVERIFY2(run.out.contains(QString(line) + '\n'), line);
        }
        QVERIFY(run.out.contains(QRegularExpression("bounds: \\(-?[0-9.]+, -?[0-9.]+\\) to \\(42, 43\\) m\n")));
    }

    void simulateFollowsTheParabola() {
        write("level.json", levelText(falling()));
        const LevelcRun run =
            runLevelc({"simulate", path("level.json"), "--updates", "50", "--hash", "--dump", path("out.json")});
        QCOMPARE(run.status, 0);
        QVERIFY2(run.out.contains(QRegularExpression("^updates=50 time=1 bodies=2 hash=[0-9a-f]{16}\n$")),
                 qPrintable(run.out));
        const QJsonObject ball = bodyNamed(contents(path("out.json")), "ball");
        QCOMPARE(ball["key"].toString(), QString("000000b0"));
        QVERIFY(std::abs(ball["position"][0].toDouble() - 1) < 1e-3);
        QVERIFY(std::abs(ball["position"][1].toDouble() - 15) < 1e-2);
        QVERIFY(std::abs(ball["velocity"][1].toDouble() + 10) < 1e-2);
        QVERIFY(ball.contains("angle") && ball.contains("angularVelocity"));
        QCOMPARE(runLevelc({"simulate", path("level.json"), "--updates", "50", "--hash"}).out, run.out);
    }

    void noUpdatesLeaveEverythingWhereItWas() {
        write("level.json", levelText(falling()));
        QCOMPARE(runLevelc({"simulate", path("level.json"), "--updates", "0", "--dump", path("out.json")}).status, 0);
        QCOMPARE(bodyNamed(contents(path("out.json")), "ball")["position"].toArray(), (QJsonArray{0, 20}));
    }

    void renderDrawsPicturesOfTheSizeAskedFor() {
        write("level.json", levelText(falling(10)));
        const LevelcRun png =
            runLevelc({"render", path("level.json"), "-o", path("out.png"), "--size", "320x200", "--overlays",
                       "aabb,incircle,velocity,orientation,normals,quadtree,contacts,tension,trails,masses,"
                       "names,islands,tags,risk,collides"});
        QCOMPARE(png.status, 0);
        const QByteArray picture = contents(path("out.png"));
        QVERIFY(picture.startsWith("\x89PNG"));
        // Width and height stand in the header, most significant byte first.
        QCOMPARE(picture.mid(16, 8).toHex(), QByteArray("00000140000000c8"));
        QCOMPARE(runLevelc({"render", path("level.json"), "-o", path("out.svg"), "--size", "320x200"}).status, 0);
        const QByteArray drawing = contents(path("out.svg"));
        QVERIFY(drawing.contains("viewBox=\"0 0 320 200\"") && drawing.contains("<title>Falling</title>"));
        QVERIFY(drawing.count("<path") + drawing.count("<polyline") + drawing.count("<circle") > 2);
    }

    void overlaysAreDrawnWhenAskedFor() {
        write("level.json", levelText(falling()));
        QByteArray last;
        for (const char* overlays : {"", "velocity", "normals", "masses", "islands", "trails"}) {
            QCOMPARE(runLevelc({"render", path("level.json"), "-o", path("out.png"), "--overlays", overlays}).status,
                     0);
            const QByteArray picture = contents(path("out.png"));
            QVERIFY2(picture != last, overlays);
            last = picture;
        }
    }

    void aFlightThatIsNotWonGivesOne() {
        write("level.json", levelText(populatedLevel()));
        Replay replay;
        replay.level = "level.json";
        replay.append({});
        replay.append({});
        write("flight.json", replayText(replay));
        const LevelcRun run =
            runLevelc({"replay", path("level.json"), path("flight.json"), "--dump", path("out.json")});
        QCOMPARE(run.status, 1);
        QVERIFY2(run.out.contains(QRegularExpression(
                     "^outcome=(running|lost) time=[0-9.]+ fuel=[0-9.]+ lives=5 hash=[0-9a-f]{16}\n$")),
                 qPrintable(run.out));
        QVERIFY(!bodyNamed(contents(path("out.json")), "ship").isEmpty());
    }

    void aRecordedFlightWinsItsLevel_data() {
        QTest::addColumn<QString>("level");
        QTest::addColumn<QString>("flight");
        const QString flights = sourceFolder() + "/tests/replays/";
        for (const QString& name : QDir(flights).entryList({"*.replay.json"})) {
            const QString level = QString(name).replace(".replay.json", ".json");
            QTest::newRow(qPrintable(level)) << sourceFolder() + "/levels/" + level << flights + name;
        }
        QTest::newRow("none that is not there") << QString() << QString();
    }
    void aRecordedFlightWinsItsLevel() {
        QFETCH(QString, level);
        QFETCH(QString, flight);
        const LevelcRun run = runLevelc({"replay", level, flight});
        QCOMPARE(run.status, level.isEmpty() ? 2 : 0);
        QCOMPARE(run.out.startsWith("outcome=won "), !level.isEmpty());
    }

  private:
    QString path(const QString& name) const { return m_folder->filePath(name); }
    void write(const QString& name, const std::string& text) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text.data(), static_cast<qint64>(text.size())), static_cast<qint64>(text.size()));
    }
    /// File names among the arguments, moved to the folder of the test.
    QStringList inFolder(QStringList arguments) const {
        for (QString& argument : arguments) {
            if (argument.contains('.') && argument != "0.5") {
                argument = path(argument);
            }
        }
        return arguments;
    }

    std::optional<QTemporaryDir> m_folder;
};

SPACETOW_TEST(LevelcTest)
#include "levelc_test.moc"
