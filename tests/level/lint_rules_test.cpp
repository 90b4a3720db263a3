// Rules of lint that look at walls together and at the game as a whole.
#include "core/level/file.h"
#include "core/level/fixes.h"
#include "core/level/groups.h"
#include "tests/support/cave_levels.h"
#include "tests/support/cpu_time.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class LintRulesTest : public QObject {
    Q_OBJECT

  private slots:
    void wallsAndGamesAreJudgedAsAWhole_data() {
        QTest::addColumn<QString>("expected");
        QTest::addColumn<Level>("level");
        const auto row = [](const char* name, const char* expected, const Level& level) {
            QTest::newRow(name) << QString(expected) << level;
        };
        const Level cave = squareCave();
        const auto chain = [](double gap) {
            return bodyOf(edgesOf({{3, 8}, {4, 8}, {4, 9}, {3, 9}, {3, 8 + gap}}, false, 0.2));
        };
        row("a closed cave", "", cave);
        row("one wall reversed", "wall-reversed@4", withWallAt(cave, {{10, 0}, {0, 0}}));
        row("one wall of two", "walls-disagree@1", [] {
            Level level;
            putObject(level, bodyOf(edgesOf({{0, 0}, {1, 0}})));
            putObject(level, bodyOf(edgesOf({{2, 1}, {1, 0}})));
            return level;
        }());
        row("a ridge of three walls that meet", "", [] {
            Level level;
            putObject(level, bodyOf(edgesOf({{0, 0}, {1, 0}})));
            putObject(level, bodyOf(edgesOf({{2, 1}, {1, 0}})));
            putObject(level, bodyOf(edgesOf({{1, 0}, {1, -3}})));
            return level;
        }());
        row("ends 20 mm apart", "chain-nearly-closed@8", withMore(cave, chain(0.02)));
        row("ends that meet", "", withMore(cave, chain(0)));
        row("ends far apart", "", withMore(cave, chain(0.3)));
        row("a gap between two bodies", "chain-gap@4", withWallAt(cave, {{0, 0}, {9.98, 0}}));
        row("a small wall of small steps", "", [] {
            Level level;
            putObject(level, bodyOf(edgesOf({{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}})));
            return level;
        }());
        row("a wall twice", "wall-twice@8", withMore(cave, bodyOf(edgesOf({{0, 0}, {10, 0}}, false, noBack))));
        row("a wall that turns its back on another", "",
            withMore(squareCave(0.5), bodyOf(edgesOf({{10, 0}, {0, 0}}, false, 0.5))));
        BodyObject pad = bodyOf(edgesOf({{0, 0}, {10, 0}}, false, noBack));
        pad.restitution = 0.9;
        row("a wall of another surface on a wall", "", withMore(cave, pad));
        row("a part of a chain on another wall", "walls-overlap@8",
            withMore(cave, bodyOf(edgesOf({{0, 0}, {10, 0}, {12, -3}}, false, noBack))));
        row("a line there and back", "walls-overlap-themselves@1", [] {
            Level level;
            putObject(level, bodyOf(LineChain{{{0, 0}, {3, 0}, {0, 0}}, false}));
            return level;
        }());
        row("a rock twice", "object-twice@9",
            withMore(withMore(cave, bodyOf(Circle{{5, 8}, 0.5})), bodyOf(Circle{{5, 8}, 0.5})));
        row("two rocks of a size", "",
            withMore(withMore(cave, bodyOf(Circle{{5, 8}, 0.5})), bodyOf(Circle{{6, 8}, 0.5})));

        const std::vector<Vec2> pillar{{5, 8}, {5, 9}, {6, 9}, {6, 8}};
        row("a pillar without a back", "no-back-reaches-through@8",
            withMore(withFirst<PayloadObject>(cave,
                                              [](auto& p) {
                                                  p.position = {4, 2};
                                              }),
                     bodyOf(edgesOf(pillar, true, noBack))));
        row("a pillar that is too deep", "depth-reaches-through@8", withMore(cave, bodyOf(edgesOf(pillar, true, 1.5))));
        row("a pillar of its own depth", "", withMore(cave, bodyOf(edgesOf(pillar, true, 1))));
        row("a shelf without a back", "shelf-without-back@8",
            withMore(cave, bodyOf(edgesOf({{6, 2}, {8, 2}}, false, noBack))));
        row("a shelf with a back", "", withMore(cave, bodyOf(edgesOf({{6, 2}, {8, 2}}, false, 0.15))));
        row("thin walls and long steps", "wall-too-thin@8", [&] {
            Level level = withMore(cave, bodyOf(edgesOf({{6, 2}, {8, 2}}, false, 0.15)));
            level.iterations = 1;
            return level;
        }());

        row("payload outside", "payload-outside@2", withFirst<PayloadObject>(squareCave(0.5), [](auto& p) {
                p.position = {20, 5};
            }));
        row("finish outside", "finish-outside@3", withFirst<FinishObject>(cave, [](auto& f) {
                f = {{12, 0}, {12, 5}};
            }));
        row("finish partly outside", "", withFirst<FinishObject>(cave, [](auto& f) { f = {{8, 5}, {12, 5}}; }));
        row("ship outside", "ship-outside@1", withFirst<ShipObject>(squareCave(0.5), [](auto& s) {
                s.position = {20, 5};
            }));
        row("a finish of no length", "finish-without-length@3",
            withFirst<FinishObject>(cave, [](auto& f) { f.b = f.a; }));
        row("payload on the finish", "payload-on-finish@2", withFirst<PayloadObject>(cave, [](auto& p) {
                p.position = {8.1, 5};
            }));
        row("gravity beyond the thrust", "gravity-too-strong", [&] {
            Level level = cave;
            level.gravity = {0, -2.375};
            return level;
        }());
        row("gravity as strong as it may be", "", [&] {
            Level level = cave;
            level.gravity = {0, -1.89};
            return level;
        }());
        row("a payload that cannot be lifted", "payload-too-heavy@2",
            withFirst<PayloadObject>(cave, [](auto& p) { p.mass = 1.5; }));
        row("a background that is not there", "background-unknown", [&] {
            Level level = cave;
            level.rules.background = "clouds";
            return level;
        }());
        row("a wall of another tag", "wall-not-tagged@4",
            withFirst<BodyObject>(cave, [](BodyObject& b) { b.filter.tags = TagMask::bit(9); }));
        row("walls that are scenery", "", withMore(cave, [] {
                BodyObject scenery = bodyOf(edgesOf({{1, 1}, {2, 1}}));
                scenery.filter.tags = TagMask::bit(debrisTag);
                return scenery;
            }()));
        const std::array wall{Key{4}};
        row("a hidden wall", "hidden-in-play@4", withVisible(cave, wall, false));
        row("a hidden group with a wall", "hidden-in-play@50",
            withVisible(grouped(cave, wall, {50, "", GroupObject{}, {}}), std::array{Key{50}}, false));
        row("a hidden wall where no ship flies", "", [] {
            Level level;
            putObject(level, bodyOf(edgesOf({{0, 0}, {1, 0}})));
            return withVisible(level, std::array{level.objects[0].key}, false);
        }());
        row("a bar of walls over a floor of walls", "walls-never-meet@2", [] {
            Level level;
            putObject(level, bodyOf(LineChain{{{-5, 0}, {5, 0}}, false}), "floor");
            putObject(level, bodyOf(LineChain{{{-1, 1}, {1, 1.2}}, false}, BodyKind::Dynamic), "bar");
            return level;
        }());
        row("a bar of walls over a floor of rock", "", [] {
            Level level;
            putObject(level, bodyOf(Polygon{{{-5, -1}, {5, -1}, {5, 0}, {-5, 0}}}), "floor");
            putObject(level, bodyOf(LineChain{{{-1, 1}, {1, 1.2}}, false}, BodyKind::Dynamic), "bar");
            return level;
        }());
    }
    void wallsAndGamesAreJudgedAsAWhole() {
        QFETCH(QString, expected);
        QFETCH(Level, level);
        QCOMPARE(problemsOf(level), expected);
    }

    void pointsOnStraightSidesAreNotedOnceAShape() {
        Level level;
        putObject(level, bodyOf(Polygon{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}}}));
        QCOMPARE(problemsOf(level), QString());
        QCOMPARE(problemsOf(level, Severity::Note), QString("idle-points@1"));
    }

    void thePairThatNeverMeetsIsNamed() {
        Level level;
        putObject(level, bodyOf(LineChain{{{-5, 0}, {5, 0}}, false}), "floor");
        putObject(level, bodyOf(LineChain{{{-1, 1}, {1, 1.2}}, false}, BodyKind::Dynamic), "bar");
        QCOMPARE(lint(level).at(0).arguments.at(0), std::string("floor"));
    }

    void randomCavesThatAreAsTheyShouldBeAreNotComplainedOf() {
        for (std::uint64_t seed = 1; seed <= (isFullRun() ? 500u : 60u); ++seed) {
            QVERIFY2(problemsOf(plainCave(seed)).isEmpty(),
                     qPrintable(QString("seed %1: ").arg(seed) + problemsOf(plainCave(seed))));
        }
    }

    void hundredThousandWallsTakeTwoSeconds() {
        const int edges = isFullRun() ? 100'000 : 20'000;
        const Level level = manyRocks(edges / 4);
        const CpuTimer timer;
        QCOMPARE(problemsOf(level), QString());
        QVERIFY2(timer.seconds() < 2.0 * 2 * edges / 100'000, qPrintable(QString::number(timer.seconds())));
    }

    void aStopIsObeyed() {
        std::stop_source source;
        source.request_stop();
        const CpuTimer timer;
        QVERIFY(lint(manyRocks(5000), source.get_token()).empty());
        QVERIFY(timer.seconds() < 0.1);
    }

    void whatIsHiddenIsFoundAndMarkedAsHidden() {
        Level level = withWallAt(squareCave(), {{10, 0}, {0, 0}});
        const std::vector<Problem> problems = lint(level);
        QCOMPARE(hiddenAmong(level, problems), std::vector<bool>{false});
        level = withProblemHidden(level, problems[0], true);
        QCOMPARE(lint(level), problems);
        QCOMPARE(hiddenAmong(level, problems), std::vector<bool>{true});
        QVERIFY(withSafeFixes(level).cured.empty());
        QVERIFY(parseLevel(levelText(level)).level == level);
        QVERIFY(withProblemHidden(level, problems[0], false).hiddenProblems.empty());
    }

    void unknownFieldsStayWithTheirHiddenProblem() {
        Level level;
        level.hiddenProblems = {{"wall-twice", 1}, {"idle-points", 2}, {"of-a-newer-version", 3}};
        level.unknownFields = R"({"/x": 1, "/hiddenProblems/0/why": "A", "/hiddenProblems/2/why": "C"})";
        const auto problem = [](LevelCode rule, Key object) {
            Problem found;
            found.code = rule;
            found.object = object;
            return found;
        };
        const Level without = withProblemHidden(level, problem("idle-points", 2), false);
        QCOMPARE(without.unknownFields,
                 std::string(R"({"/x": 1, "/hiddenProblems/0/why": "A", "/hiddenProblems/1/why": "C"})"));
        QCOMPARE(withProblemHidden(level, problem("wall-twice", 1), false).unknownFields,
                 std::string(R"({"/x": 1, "/hiddenProblems/1/why": "C"})"));
        QVERIFY(withProblemHidden(level, problem("wall-twice", 1), true) == level); // it is already
        QCOMPARE(withProblemHidden(level, problem("walls-overlap", 4), true).unknownFields, level.unknownFields);
    }
};

SPACETOW_TEST(LintRulesTest)
#include "lint_rules_test.moc"
