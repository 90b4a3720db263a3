#include "core/level/edits.h"
#include "core/level/file.h"
#include "tests/support/folders.h"
#include "tests/support/run_levelc.h"
#include "tests/support/test_main.h"

#include <QFile>
#include <QTemporaryDir>

#include <filesystem>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using KeysToMove = std::vector<Key>;

Level cave() {
    Level level;
    for (const Key key : {1u, 2u}) {
        BodyObject wall;
        wall.shapes = {EdgeChain{{{0, 0}, {4, double(key)}}, false, noBack}};
        level.objects.append({key, key == 1 ? "floor" : "roof", wall, {}});
    }
    return level;
}

} // namespace

class LevelcCompareTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_folder.emplace(); }

    void diffTellsWhatIsDifferentInWords() {
        Level after = renamed(moved(cave(), KeysToMove{1}, {2, 0}), 2, "ceiling");
        after.objects.append({9, "stone", BodyObject{.shapes = {Circle{}}}, {}});
        const QString a = saved("a.json", cave());
        const QString b = saved("b.json", after);
        const LevelcRun told = runLevelc({"diff", a, b});
        QCOMPARE(told.status, 1);
        QCOMPARE(told.out.split('\n', Qt::SkipEmptyParts),
                 (QStringList{"~ floor (One-way wall): Position x 0 m → 2 m",
                              "~ ceiling (One-way wall): Name “roof” → “ceiling”", "+ stone (Circle): added"}));
        const LevelcRun same = runLevelc({"diff", a, a});
        QCOMPARE(same.status, 0);
        QVERIFY(same.out.isEmpty());
        QCOMPARE(runLevelc({"diff", a, path("none.json")}).status, 2);
        QCOMPARE(runLevelc({"diff", a}).status, 2);
    }

    void diffServesGit() {
        const QString b = saved("b.json", cave());
        const LevelcRun told = runLevelc({"diff", "--git", "levels/x.json", "/dev/null", ".", ".", b, "abc", "100644"});
        QCOMPARE(told.status, 0);
        QCOMPARE(told.out.split('\n').value(0), QString("level levels/x.json"));
        QVERIFY(told.out.contains("+ roof (One-way wall): added"));
    }

    void diffDoesNotEndGitsWholeDiffWhereSomethingIsNoLevel() {
        const QString b = saved("b.json", cave());
        const QString broken = path("broken.json");
        writeFile(broken.toStdString(), "<<<<<<< ours").value();
        for (const auto& [from, to] : {std::pair(b, broken), std::pair(broken, b)}) {
            const LevelcRun told = runLevelc({"diff", "--git", "x.json", from, "abc", "100644", to, "abd", "100644"});
            QCOMPARE(told.status, 0);
            QVERIFY2(told.out.contains("! cannot be compared"), qPrintable(told.out));
            QVERIFY2(told.err.contains("broken.json:1"), qPrintable(told.err));
        }
        // Of a file that is in conflict git gives the name alone.
        const LevelcRun torn = runLevelc({"diff", "--git", "x.json"});
        QCOMPARE(torn.status, 0);
        QCOMPARE(torn.out, QString("level x.json\n! not merged yet\n"));
    }

    void mergePutsBothSidesTogetherAndNamesConflicts() {
        const QString base = saved("base.json", cave());
        const QString ours = saved("ours.json", moved(cave(), KeysToMove{1}, {2, 0}));
        const QString theirs = saved("theirs.json", renamed(cave(), 2, "ceiling"));
        const QString out = path("out.json");
        const LevelcRun clean = runLevelc({"merge", base, ours, theirs, "-o", out});
        QCOMPARE(clean.status, 0);
        QVERIFY(*readLevel(out.toStdString()).value().level ==
                renamed(moved(cave(), KeysToMove{1}, {2, 0}), 2, "ceiling"));
        const QString other = saved("other.json", moved(cave(), KeysToMove{1}, {0, 3}));
        const LevelcRun torn = runLevelc({"merge", base, ours, other});
        QCOMPARE(torn.status, 1);
        QVERIFY2(torn.err.contains("floor (One-way wall): both sides changed “position”."), qPrintable(torn.err));
        QVERIFY(*readLevel(ours.toStdString()).value().level == moved(cave(), KeysToMove{1}, {2, 0}));
        QCOMPARE(runLevelc({"merge", base, ours, other, "--theirs"}).status, 1);
        QVERIFY(*readLevel(ours.toStdString()).value().level == moved(cave(), KeysToMove{1}, {0, 3}));
        QCOMPARE(runLevelc({"merge", base, ours, path("none.json")}).status, 2);
    }

    void whatBothSidesTogetherGetWrongIsAConflict() {
        const auto withShip = [](Key key) {
            Level level = cave();
            level.objects.append({key, {}, ShipObject{{1, 1}}, {}});
            return level;
        };
        const QString base = saved("base.json", cave());
        const LevelcRun two = runLevelc({"merge", base, saved("ours.json", withShip(7)),
                                         saved("theirs.json", withShip(8)), "-o", path("out.json")});
        QCOMPARE(two.status, 1);
        QVERIFY2(two.err.contains("conflict: both sides together make an error"), qPrintable(two.err));
        // What one side had wrong before is nothing new.
        Level wrong = withShip(7);
        wrong.objects.append({8, {}, ShipObject{{2, 2}}, {}});
        const QString theirs = saved("theirs.json", renamed(cave(), 2, "ceiling"));
        QCOMPARE(runLevelc({"merge", base, saved("wrong.json", wrong), theirs, "-o", path("out.json")}).status, 0);
    }

    void whatBothSidesHaveAddedIsMergedToo() {
        const QString nothing = path("empty.json"); // as git gives it for a base that is not there
        writeFile(nothing.toStdString(), "").value();
        const QString ours = saved("ours.json", cave());
        const QString theirs = saved("theirs.json", renamed(cave(), 2, "ceiling"));
        QCOMPARE(runLevelc({"merge", nothing, ours, ours, "-o", path("same.json")}).status, 0);
        const LevelcRun torn = runLevelc({"merge", nothing, ours, theirs});
        QCOMPARE(torn.status, 1);
        QVERIFY2(torn.err.contains("conflict"), qPrintable(torn.err));
        QCOMPARE(runLevelc({"merge", ours, nothing, theirs}).status, 2);
    }

  private:
    QString path(const char* name) const { return m_folder->filePath(name); }
    QString saved(const char* name, const Level& level) const {
        const QString file = path(name);
        if (writeLevel(file.toStdString(), level)) {
            qFatal("cannot write %s", name);
        }
        return file;
    }

    std::optional<QTemporaryDir> m_folder;
};

SPACETOW_TEST(LevelcCompareTest)
#include "levelc_compare_test.moc"
