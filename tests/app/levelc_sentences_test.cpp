// What levelc says of levels and drawings that have the fault that a code stands for.

#include "core/level/file.h"
#include "tests/support/run_levelc.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QTemporaryDir>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Shapes = std::vector<LevelShape>;

/// A ship in the middle of bodies with these shapes.
Level caveOf(const std::vector<Shapes>& bodies) {
    Level level;
    level.objects.append({1, {}, ShipObject{}, {}});
    Key key = 2;
    for (const Shapes& shapes : bodies) {
        BodyObject body;
        body.filter.tags = TagMask::bit(wallTag);
        body.shapes = shapes;
        level.objects.append({key++, {}, std::move(body), {}});
    }
    return level;
}

LineChain line(std::vector<Vec2> vertices) {
    return {std::move(vertices), false};
}

EdgeChain wall(std::vector<Vec2> vertices) {
    return {std::move(vertices), false, 0.5};
}

/// Left, bottom and right of a room, solid outside; the top is open.
EdgeChain withoutTop() {
    return wall({{-4, 3}, {-4, -3}, {4, -3}, {4, 3}});
}

/// The top of the same room from its wrong side, and the bottom from the right one, in one chain that goes round
/// outside.
EdgeChain topAndBottom(std::vector<Vec2> top) {
    top.insert(top.end(), {{8, 3}, {8, -5}, {-6, -5}, {-6, -3}, {-4, -3}, {4, -3}});
    return wall(std::move(top));
}

std::string bowTies(int count) {
    std::string text = R"({"schema": 2, "objects": [)";
    for (int i = 0; i < count; ++i) {
        text += i == 0 ? "\n" : ",\n";
        text += R"({"type": "body", "key": ")" + std::string(i < 10 ? "0000001" : "000001") + std::to_string(i) +
                R"(", "position": [)" + std::to_string(5 * i) +
                R"(, 0], "shapes": [{"type": "polygon", "vertices": [[0, 0], [1, 1], [1, 0], [0, 1]]}]})";
    }
    return text + "]}";
}

std::string manyUnknownFields(int count) {
    std::string text = R"({"schema": 2, "objects": [])";
    for (int i = 0; i < count; ++i) {
        text += ",\n\"what" + std::to_string(i) + "\": 0";
    }
    return text + "}";
}

std::string tiledMap(const std::string& objects) {
    return "<map orientation='orthogonal' width='9' height='9' tilewidth='16' tileheight='16'><objectgroup>" + objects +
           "</objectgroup></map>";
}

std::string manyClasses(int count) {
    std::string objects;
    for (int i = 0; i < count; ++i) {
        objects += "<object id='" + std::to_string(i + 1) + "' class='kind" + std::to_string(i) + "' x='" +
                   std::to_string(40 * i) + "' y='0' width='16' height='16'/>";
    }
    return tiledMap(objects);
}

} // namespace

class LevelcSentencesTest : public QObject {
    Q_OBJECT

  private slots:
    void aFaultIsToldByItsCodeAndInASentence_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("said");
        const auto row = [](const char* said, const std::string& text) {
            QTest::newRow(QByteArray(said).left(QByteArray(said).indexOf(':')).constData()) << text << QString(said);
        };
        const auto cave = [&row](const char* said, const std::vector<Shapes>& bodies) {
            row(said, levelText(caveOf(bodies)));
        };
        // A hand's breadth from its neighbours, so that it does not go on from them.
        cave("leak-wall-reversed: The ship can get out through this wall: it is solid on the wrong side. Reverse it.",
             {{withoutTop()}, {wall({{-3.95, 3}, {3.95, 3}})}});
        cave("leak-chain-reversed: The ship can get out through this chain: all its 2 walls are solid on the wrong "
             "side.",
             {{withoutTop()}, {wall({{-3.95, 3}, {0, 4}, {3.95, 3}})}});
        cave("leak-edge-reversed: The ship can get out through edge 1 of this chain: it is solid on the wrong side.",
             {{wall({{-4, 3}, {-4, -3}})}, {wall({{4, -3}, {4, 3}})}, {topAndBottom({{-4, 3}, {4, 3}})}});
        cave("leak-edges-reversed: The ship can get out: 2 walls, of which this is one, are solid on the wrong side.",
             {{wall({{-4, 3}, {-4, -3}})}, {wall({{4, -3}, {4, 3}})}, {topAndBottom({{-4, 3}, {0, 4}, {4, 3}})}});
        cave("leak-not-closed: The ship can get out: this chain is not closed, its ends are 1 m apart.",
             {{line({{-4, 3}, {-4, -3}, {4, -3}, {4, 3}, {-3, 3}})}});
        cave("leak-wall-missing: The ship can get out: a wall of 1 m is missing between two ends of this object.",
             {{line({{-4, 3}, {-4, -3}, {4, -3}}), line({{4, -3}, {4, 3}, {-3, 3}})}});
        cave("leak-opening: The ship can get out: there is an opening of 1 m in this object.",
             {{line({{-4, 6}, {-4, -3}, {4, -3}}), line({{4, -3}, {4, 3}, {-3, 3}})}});
        cave("leak-gap: The ship can get out: a wall of 1 m is missing between the end of this one and that of the "
             "two-way line at ",
             {{line({{-4, 3}, {-4, -3}, {4, -3}})}, {line({{4, -3}, {4, 3}, {-3, 3}})}});
        cave("leak-too-short: The ship can get out: this wall ends 1 m before the two-way line at ",
             {{line({{-4, 6}, {-4, -3}, {4, -3}})}, {line({{4, -3}, {4, 3}, {-3, 3}})}});
        cave("leak-between: The ship can get out between this and the two-way line at ",
             {{line({{-2, 8}, {-0.5, 3}, {-4, 3}, {-4, -3}, {0, -3}})},
              {line({{0, -3}, {4, -3}, {4, 3}, {0.5, 3}, {2, 8}})}});
        row("polygon-crosses-itself: The polygon crosses itself: the sides from vertex 0 and from vertex 2 meet.",
            bowTies(1));
        row("polygon-not-simple: The polygon crosses itself.", bowTies(21)); // the place is looked for in the first few
        row("more-problems: There are 100 more problems, which are not listed.", manyUnknownFields(1100));
    }
    void aFaultIsToldByItsCodeAndInASentence() {
        QFETCH(std::string, text);
        QFETCH(QString, said);
        write("level.json", text);
        const LevelcRun run = runLevelc({"check", path("level.json")});
        QVERIFY2(run.out.contains(": " + said), qPrintable(run.out + run.err));
    }

    void whatADrawingHasAndALevelCannotIsTold_data() {
        QTest::addColumn<std::string>("text");
        QTest::addColumn<QString>("said");
        QTest::newRow("a form of a later Tiled")
            << tiledMap(
                   "<object id='1' x='0' y='0' width='9' height='9'/>\n<object id='2' x='0' y='0'><capsule/></object>")
            << "Objects of a form that is not known here were left out (once, in line 2).";
        QTest::newRow("more tags than there can be")
            << manyClasses(33) << "All 32 tags are taken; these were left out: ";
    }
    void whatADrawingHasAndALevelCannotIsTold() {
        QFETCH(std::string, text);
        QFETCH(QString, said);
        write("map.tmx", text);
        const LevelcRun run = runLevelc({"import", path("map.tmx"), "-o", path("level.json")});
        QCOMPARE(run.status, 0);
        QVERIFY2(run.err.contains(path("map.tmx") + ": " + said), qPrintable(run.err));
    }

  private:
    QString path(const QString& name) const { return m_folder.filePath(name); }
    void write(const QString& name, const std::string& text) const {
        QFile file(path(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text.data(), static_cast<qint64>(text.size())), static_cast<qint64>(text.size()));
    }

    QTemporaryDir m_folder;
};

SPACETOW_TEST(LevelcSentencesTest)
#include "levelc_sentences_test.moc"
