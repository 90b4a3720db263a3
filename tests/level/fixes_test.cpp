// What lint finds is cured, and nothing else is changed.
#include "core/level/fixes.h"

#include "tests/support/cave_levels.h"
#include "tests/support/full_run.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// The level with one more fault of a random kind, of those with a fix.
Level spoiled(Level level, Random& random) {
    std::vector<int> chains; // open ones of several walls
    int rock = -1;
    for (int i = 0; i < level.objects.size(); ++i) {
        if (const auto* body = std::get_if<BodyObject>(&level.objects[i].data)) {
            const auto* chain = std::get_if<EdgeChain>(&body->shapes.front());
            if (chain != nullptr && !chain->closed) {
                chains.push_back(i);
            }
            rock = chain == nullptr ? i : rock;
        }
    }
    const int index = chains[random.below(static_cast<std::uint32_t>(chains.size()))];
    Object object = level.objects[index];
    auto& chain = std::get<EdgeChain>(std::get<BodyObject>(object.data).shapes.front());
    const auto middle = [&](auto& v) { return v.begin() + 1 + random.below(static_cast<std::uint32_t>(v.size() - 1)); };
    switch (random.below(9)) {
    case 0:
        std::ranges::reverse(chain.vertices);
        break;
    case 1:
        chain.vertices.back() +=
            0.03 * (chain.vertices[chain.vertices.size() - 2] - chain.vertices.back()).normalized();
        break;
    case 2: {
        const auto at = middle(chain.vertices);
        chain.vertices.insert(at, *at);
        break;
    }
    case 3:
        object.key = freshKey(level, random.next());
        level.objects.append(object);
        return level;
    case 4:
        object.parent = 0xabcdef01;
        break;
    case 5:
        level.rules.background = "clouds";
        return level;
    case 6: {
        Object twin = level.objects[rock];
        twin.key = freshKey(level, random.next());
        level.objects.append(twin);
        return level;
    }
    case 7: {
        Object turned = level.objects[rock];
        std::ranges::reverse(std::get<Polygon>(std::get<BodyObject>(turned.data).shapes.front()).vertices);
        level.objects.replace(rock, turned);
        return level;
    }
    default:
        putObject(level, bodyOf(edgesOf({{-0.2, 6}, {-0.2, 6.4}, {0.2, 6.4}, {0.2, 6}}, true,
                                        random.below(2) == 0 ? noBack : 3)));
        return level;
    }
    level.objects.replace(index, std::move(object));
    return level;
}

std::map<std::pair<LevelCode, Key>, int> counted(const std::vector<Problem>& problems) {
    std::map<std::pair<LevelCode, Key>, int> counts;
    for (const Problem& problem : problems) {
        ++counts[{problem.code, problem.object}];
    }
    return counts;
}

} // namespace

class FixesTest : public QObject {
    Q_OBJECT

  private slots:
    void aFixCuresItsProblemAndTouchesNothingElse() {
        for (std::uint64_t seed = 1; seed <= (isFullRun() ? 1000u : 80u); ++seed) {
            Random random(seed);
            const Level level = spoiled(plainCave(seed), random);
            const std::vector<Problem> problems = lint(level);
            QVERIFY2(!problems.empty(), seedText(seed));
            for (const Problem& problem : problems) {
                if (fixFor(problem) == nullptr) {
                    continue;
                }
                const Level cured = fixed(level, problem);
                const auto before = counted(problems);
                for (const auto& [what, count] : counted(lint(cured))) {
                    const bool isIt = what == std::pair(problem.code, problem.object);
                    const auto was = before.contains(what) ? before.at(what) : 0;
                    QVERIFY2(isIt ? count < was : count <= was,
                             qPrintable(
                                 QString("seed %1: %2 leaves or makes %3 of %4")
                                     .arg(seed)
                                     .arg(QString::fromUtf8(problem.code.text()), QString::fromUtf8(what.first.text()))
                                     .arg(what.second)));
                }
                for (const Object& object : level.objects) {
                    const Object* const now = cured.objects.find(object.key);
                    QVERIFY2(object.key == problem.object || (now != nullptr && *now == object), seedText(seed));
                }
            }
        }
    }

    void allSafeFixesTogetherLeaveNothingThatTheyCure() {
        int curedLevels = 0;
        for (std::uint64_t seed = 1; seed <= (isFullRun() ? 1000u : 60u); ++seed) {
            Random random(seed);
            Level level = plainCave(seed);
            for (int i = 0; i < 4; ++i) {
                level = spoiled(std::move(level), random);
            }
            const FixedLevel cured = withSafeFixes(level);
            curedLevels += cured.cured.empty() ? 0 : 1;
            for (const Problem& problem : lint(cured.level)) {
                const Fix* const fix = fixFor(problem);
                QVERIFY2(fix == nullptr || !fix->isSafe,
                         qPrintable(QString("seed %1: %2").arg(seed).arg(QString::fromUtf8(problem.code.text()))));
            }
            QVERIFY2(withSafeFixes(cured.level).cured.empty(), seedText(seed));
        }
        QVERIFY(curedLevels > 50); // two faults may undo each other, or be for the author to judge
    }

    void aFixOfAnotherLevelChangesNothing() {
        const Level cave = plainCave(1);
        for (const Fix& fix : fixes()) {
            Problem problem;
            problem.code = fix.problem;
            problem.object = 0xdeadbeef;
            problem.pointer = "/objects/4711/shapes/3";
            problem.place = {Vec2(0, 0), Vec2(1, 0)};
            if (fix.problem != "background-unknown") {
                QVERIFY2(fixed(cave, problem) == cave, fix.problem.text().data());
            }
        }
    }

    void aShipInAWallIsMovedToTheNearestFreePlace() {
        Level level = squareCave(0.5);
        level = withFirst<ShipObject>(level, [](auto& ship) { ship.position = {2, 0.1}; });
        const std::vector<Problem> problems = lint(level);
        QCOMPARE(problemsOf(level), QString("ship-in-wall@1"));
        const Level cured = fixed(level, problems[0]);
        QCOMPARE(problemsOf(cured), QString());
        const Vec2 now = std::get<ShipObject>(cured.objects[0].data).position;
        QVERIFY2((now - Vec2(2, 0.1)).norm() < 0.5, qPrintable(QString::number(now.y())));
    }

    void aCaveThatWasDrawnClockwiseIsTurnedInsideOutInOneStep() {
        const std::vector<Vec2> clockwise{{0, 0}, {0, 10}, {10, 10}, {10, 0}};
        for (const double depth : {noBack, 8.0}) {
            Level level;
            putObject(level, ShipObject{{2, 5}, 0});
            putObject(level, PayloadObject{{5, 5}, 0.2, 0.25});
            putObject(level, FinishObject{{8, 4}, {8, 6}});
            const Key key = putObject(level, bodyOf(edgesOf(clockwise, true, depth)));
            const std::vector<Problem> problems = lint(level);
            QCOMPARE(problemsOf(level), QString("cave-inside-out@%1").arg(key));
            QCOMPARE(problemsOf(fixed(level, problems[0])), QString());
        }
    }

    void aShipOnARockOfTheCaveIsInARock() {
        const std::vector<Vec2> clockwise{{1, 4}, {1, 6}, {3, 6}, {3, 4}}; // round the ship
        QCOMPARE(problemsOf(withMore(squareCave(0.5), bodyOf(edgesOf(clockwise, true, 1.9)))),
                 QString("ship-in-wall@1"));
    }

    void aPolygonThatCrossesItselfIsUntangled() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Random random(seed);
            Polygon polygon;
            for (std::uint32_t i = 4 + random.below(9); i > 0; --i) {
                polygon.vertices.emplace_back(random.uniform(-5, 5), random.uniform(-5, 5));
            }
            Level level;
            const Key key = putObject(level, bodyOf(polygon));
            for (const Problem& problem : lint(level)) {
                const Level cured = fixed(level, problem);
                QVERIFY2(problemsOf(cured).isEmpty(), seedText(seed));
                const auto& now =
                    std::get<Polygon>(std::get<BodyObject>(cured.objects.find(key)->data).shapes.front()).vertices;
                QVERIFY2(std::ranges::is_permutation(now, polygon.vertices), seedText(seed));
            }
        }
    }

    void everyRuleThatHasAFixIsOneThatLintKnows() {
        QVERIFY(fixes().size() > 30);
        for (const Fix& fix : fixes()) {
            Problem problem;
            problem.code = fix.problem;
            problem.place = {Vec2(0, 0), Vec2(1, 0)};
            QVERIFY2(fixFor(problem) == &fix, fix.problem.text().data());
        }
    }
};

SPACETOW_TEST(FixesTest)
#include "fixes_test.moc"
