#include "core/level/leak.h"

#include "core/level/file.h"
#include "core/level/fixes.h"
#include "core/level/leak_mesh.h"
#include "core/level/lint.h"
#include "tests/support/body_with.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <filesystem>

using namespace spacetow;
using namespace spacetow::test;

namespace {

bool isFine(int /*object*/) {
    return false;
}

std::vector<Leak> leaksIn(const Level& level) {
    return leaksOf(level, isFine);
}

Level aroundTheShip(std::vector<LevelShape> shapes) {
    Level level;
    level.objects.append({1, "ship", ShipObject{}, {}});
    Key key = 2;
    for (LevelShape& shape : shapes) {
        level.objects.append(bodyWith(key++, std::move(shape)));
    }
    return level;
}

const std::vector<Vec2> room{{-4, -3}, {4, -3}, {4, 3}, {-4, 3}}; // anticlockwise: walls face inward

bool isNear(const Vec2& a, const Vec2& b, double metres) {
    return (a - b).norm() <= metres;
}

/// Whether the two places are those, in any order.
bool areAt(const Leak& leak, const Vec2& a, const Vec2& b, double metres) {
    return (isNear(leak.from.at, a, metres) && isNear(leak.to.at, b, metres)) ||
           (isNear(leak.from.at, b, metres) && isNear(leak.to.at, a, metres));
}

} // namespace

class LeakTest : public QObject {
    Q_OBJECT

  private slots:
    void theShipIsAsWideAsItsHullIsThin() { QVERIFY(std::abs(leastShipWidth() - 0.16 / std::hypot(0.2, 0.4)) < 1e-12); }

    void aClosedCaveHasNoLeak() {
        QVERIFY(leaksIn(aroundTheShip({EdgeChain{room, true, 0.5}})).empty());
        QVERIFY(leaksIn(aroundTheShip({LineChain{room, true}})).empty());
        QVERIFY(leaksIn(aroundTheShip({EdgeChain{room, true}})).empty());
    }

    void withoutAShipOrWallsThereIsNone() {
        Level level = aroundTheShip({EdgeChain{room, false, 0.5}});
        QCOMPARE(leaksIn(level).size(), std::size_t{1});
        level.objects.erase(1);
        QVERIFY(leaksIn(level).empty());
        QVERIFY(leaksIn(aroundTheShip({})).empty());
        QVERIFY(leaksIn(Level()).empty());
    }

    void aGapIsALeakFromTheWidthOfTheShipOn() {
        for (const bool oneWay : {true, false}) {
            for (const double gap : {0.1, leastShipWidth() - 1e-3, leastShipWidth() + 1e-3, 1.0}) {
                std::vector<Vec2> vertices = room;
                vertices.push_back(Vec2(-4, -3 + gap));
                const LevelShape shape =
                    oneWay ? LevelShape(EdgeChain{vertices, false, 0.5}) : LevelShape(LineChain{vertices, false});
                const std::vector<Leak> leaks = leaksIn(aroundTheShip({shape}));
                QCOMPARE(leaks.size(), std::size_t{gap > leastShipWidth() ? 1u : 0u});
                if (!leaks.empty()) {
                    QCOMPARE(leaks[0].kind, Leak::Kind::Opening);
                    QVERIFY(areAt(leaks[0], vertices.front(), vertices.back(), 1e-5));
                    QVERIFY(leaks[0].from.isEnd && leaks[0].to.isEnd);
                    QVERIFY(std::abs(leaks[0].width - gap) < 1e-5);
                    QVERIFY(leaks[0].path.back().x() < -4);
                }
            }
        }
    }

    void aWallThatIsTooShortIsNamed() {
        // The last wall ends 1 m before a block.
        const std::vector<LevelShape> shapes{LineChain{{{-4, 2}, {-4, -3}, {4, -3}, {4, 3}, {-2, 3}}, false},
                                             Polygon{{{-5, 2}, {-3, 2}, {-3, 4}, {-5, 4}}}};
        const std::vector<Leak> leaks = leaksIn(aroundTheShip(shapes));
        QCOMPARE(leaks.size(), std::size_t{1});
        const LeakPlace& end = leaks[0].from.isEnd ? leaks[0].from : leaks[0].to;
        const LeakPlace& block = leaks[0].from.isEnd ? leaks[0].to : leaks[0].from;
        QVERIFY(isNear(end.at, {-2, 3}, 1e-5) && end.object == 1 && end.segment == 3);
        QVERIFY(isNear(block.at, {-3, 3}, 1e-5) && block.object == 2);
    }

    void aReversedWallIsNamedAndAWholeReversedChainToo() {
        std::vector<LevelShape> shapes{EdgeChain{{room[1], room[2], room[3], room[0]}, false, 0.5},
                                       EdgeChain{{room[1], room[0]}, false, 0.5}};
        std::vector<Leak> leaks = leaksIn(aroundTheShip(shapes));
        QCOMPARE(leaks.size(), std::size_t{1});
        QCOMPARE(leaks[0].kind, Leak::Kind::Reversed);
        QVERIFY(leaks[0].from.object == 2 && leaks[0].walls == 1 && areAt(leaks[0], room[0], room[1], 1e-9));
        QVERIFY(leaks[0].path.back().y() < -3);

        leaks = leaksIn(aroundTheShip({EdgeChain{{room[3], room[2], room[1], room[0]}, true, 0.5}}));
        QCOMPARE(leaks.size(), std::size_t{1});
        QVERIFY(leaks[0].kind == Leak::Kind::Reversed && leaks[0].walls == 4 && leaks[0].isWhole);
    }

    void aReversedChainIsWholeThoughRocksHideSomeOfItsWalls() {
        const std::vector<Vec2> around{room[3], {-2, 3}, {2, 3}, room[2], room[1], room[0]}; // clockwise
        const Polygon rock{{{-3, 2}, {3, 2}, {3, 3.5}, {-3, 3.5}}};
        const Level level = aroundTheShip({EdgeChain{around, true, 0.1}, rock});
        const std::vector<Leak> leaks = leaksIn(level);
        QCOMPARE(leaks.size(), std::size_t{1});
        QVERIFY(leaks[0].kind == Leak::Kind::Reversed && leaks[0].isWhole);
        QCOMPARE(leaks[0].walls, 6);
        const std::vector<Problem> problems = lint(level);
        const auto turns = [](const Problem& problem) {
            const Fix* const fix = fixFor(problem);
            return fix != nullptr && fix->label == "fix-reverse";
        };
        const auto found = std::ranges::find_if(problems, turns);
        QVERIFY(found != problems.end());
        QVERIFY(leaksIn(fixed(level, *found)).empty());
    }

    void aChainWithWallsThatAreRightIsNotWhole() {
        const std::vector<LevelShape> shapes{
            EdgeChain{{room[1], room[2], room[3], room[0]}, false, 0.5},
            EdgeChain{{room[1], room[0], {-3, -2.5}, {-3, -1.5}}, false, 0.1}}; // and stands in the room
        const std::vector<Leak> leaks = leaksIn(aroundTheShip(shapes));
        QCOMPARE(leaks.size(), std::size_t{1});
        QVERIFY(leaks[0].kind == Leak::Kind::Reversed && leaks[0].walls == 1 && !leaks[0].isWhole);
    }

    void aReversedWallNarrowerThanTheShipIsNone() {
        const auto leaksWith = [](double width, std::vector<Vec2> between) {
            const Vec2 corner(-4 + width, -3);
            between.insert(between.begin(), corner);
            between.push_back(room[0]);
            return leaksIn(aroundTheShip(
                {EdgeChain{{corner, room[1], room[2], room[3], room[0]}, false, 0.5}, EdgeChain{between, false, 0.5}}));
        };
        QVERIFY(leaksWith(0.3, {}).empty());
        QCOMPARE(leaksWith(0.6, {}).size(), std::size_t{1});
        QCOMPARE(leaksWith(0.6, {{-3.7, -3}}).size(), std::size_t{1});
        QVERIFY(leaksWith(0.3, {{-3.85, -3}}).empty());
    }

    void allOpeningsOfACaveAreFound() {
        const std::vector<Leak> leaks = leaksIn(
            aroundTheShip({LineChain{{{-20, 2}, {20, 2}}, false}, LineChain{{{-20, -2}, {0, -2.5}, {20, -2}}, false}}));
        QCOMPARE(leaks.size(), std::size_t{2});
        for (const Leak& leak : leaks) {
            QVERIFY(leak.from.isEnd && leak.to.isEnd && std::abs(leak.width - 4) < 1e-5);
        }
        QVERIFY(leaks[0].path.back().x() * leaks[1].path.back().x() < 0);
    }

    void whereThereIsNoCaveThereIsNoLeak() {
        std::vector<Vec2> hills;
        for (int x = -50; x <= 50; x += 2) {
            hills.emplace_back(x, -3 + std::sin(x));
        }
        QVERIFY(leaksIn(aroundTheShip({EdgeChain{hills, false, 1}})).empty());
        QVERIFY(leaksIn(aroundTheShip({EdgeChain{{{-9, 3}, {-8, -3}, {8, -3}, {9, 3}}, false, 1}})).empty());
        QVERIFY(leaksIn(aroundTheShip({Circle{{0, -5}, 4}, Polygon{{{3, 1}, {5, 1}, {4, 3}}}})).empty());
        QVERIFY(leaksIn(aroundTheShip({EdgeChain{{{-1, 1}, {1, 1}}, false, 0.1}})).empty());
    }

    void anOpeningThatLeadsToTheFinishIsTheWay() {
        Level level = aroundTheShip({LineChain{{{-1, 6}, {-4, 6}, {-4, -3}, {4, -3}, {4, 6}, {1, 6}}, false}});
        QCOMPARE(leaksIn(level).size(), std::size_t{1});
        level.objects.append({50, "", FinishObject{{-1, 1}, {1, 1}}, {}});
        QCOMPARE(leaksIn(level).size(), std::size_t{1});
        level.objects.erase(level.objects.size() - 1);
        level.objects.append({50, "", FinishObject{{-1, 8}, {1, 8}}, {}});
        QVERIFY(leaksIn(level).empty());
    }

    void anInnerRoomMayOpenIntoAClosedCave() {
        const std::vector<Vec2> hangar{{-1, 2}, {-3, 2}, {-3, -2}, {3, -2}, {3, 2}, {1, 2}};
        const std::vector<Vec2> cave{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
        QCOMPARE(leaksIn(aroundTheShip({LineChain{hangar, false}})).size(), std::size_t{1});
        QVERIFY(leaksIn(aroundTheShip({LineChain{hangar, false}, EdgeChain{cave, true, 1}})).empty());
    }

    /// Whoever flies up there is gone for good; whoever wants that hides the problem.
    void aShaftThatIsOpenAtTheTopIsALeak() {
        const Level level = aroundTheShip({EdgeChain{{{-1, 9}, {-1, -1}, {1, -1}, {1, 9}}, false, 1}});
        const std::vector<Leak> leaks = leaksIn(level);
        QCOMPARE(leaks.size(), std::size_t{1});
        QVERIFY(areAt(leaks[0], {-1, 9}, {1, 9}, 1e-5));
        const std::vector<Problem> problems = lint(level);
        const auto leak = std::ranges::find(problems, LevelCode("leak-not-closed"), &Problem::code);
        QVERIFY(leak != problems.end());
        const Level hidden = withProblemHidden(level, *leak, true);
        QVERIFY(hiddenAmong(hidden, problems)[static_cast<std::size_t>(leak - problems.begin())]);
    }

    void whatTheShipDoesNotTouchDoesNotKeepItIn() {
        Level level = aroundTheShip(
            {LineChain{{room[0], room[1], room[2], room[3]}, false}, LineChain{{room[3], room[0]}, false}});
        QVERIFY(leaksIn(level).empty());
        Object changed = level.objects[2];
        std::get<BodyObject>(changed.data).filter.tags = TagMask::bit(7);
        level.objects.replace(2, changed);
        QCOMPARE(leaksIn(level).size(), std::size_t{1});
        std::get<BodyObject>(changed.data).filter = {};
        std::get<BodyObject>(changed.data).tangible = false;
        level.objects.replace(2, changed);
        QCOMPARE(leaksIn(level).size(), std::size_t{1});
        std::get<BodyObject>(changed.data).tangible = true;
        std::get<BodyObject>(changed.data).kind = BodyKind::Dynamic;
        level.objects.replace(2, changed);
        QCOMPARE(leaksIn(level).size(), std::size_t{1});
        std::get<BodyObject>(changed.data).frozen = true; // stays where it is
        level.objects.replace(2, changed);
        QVERIFY(leaksIn(level).empty());
    }

    void whatIsMissingOrReversedIsCuredInOneStep() {
        const std::vector<Vec2> open{room[0], room[1], room[2], room[3]};
        const std::vector<Vec2> backwards{room[3], room[2], room[1], room[0]};
        const std::vector<std::pair<LevelCode, std::vector<LevelShape>>> spoilt{
            {LevelCode("leak-not-closed"), {EdgeChain{open, false, 0.5}}},
            {LevelCode("leak-not-closed"), {LineChain{open, false}}},
            {LevelCode("leak-chain-reversed"), {EdgeChain{backwards, true, 0.5}}},
            {LevelCode("leak-gap"),
             {EdgeChain{{room[0], room[1]}, false, 0.5}, EdgeChain{{room[1], room[2], room[3]}, false, 0.5}}},
            {LevelCode("leak-too-short"),
             {LineChain{{{-4, 2}, {-4, -3}, {4, -3}, {4, 3}, {-2, 3}}, false},
              Polygon{{{-5, 2}, {-3, 2}, {-3, 4}, {-5, 4}}}}},
        };
        for (const auto& [code, shapes] : spoilt) {
            const Level level = aroundTheShip(shapes);
            const std::vector<Problem> problems = lint(level);
            const auto found = std::ranges::find(problems, code, &Problem::code);
            QVERIFY2(found != problems.end() && !found->wayOut.empty(), code.text().data());
            QVERIFY2(fixFor(*found) != nullptr, code.text().data());
            QVERIFY2(leaksIn(fixed(level, *found)).empty(), code.text().data());
        }
    }

    void wallsThatNearlyLieOnEachOtherMeetAtFewPlaces() {
        const auto file = readLevel((sourceFolder() + "/tests/fuzz/found/level-3.json").toStdString());
        QVERIFY(file && file.value().level);
        const std::vector<LeakWall> walls = leakWalls(*file.value().level, isFine);
        const LeakMesh mesh(walls, {2.3, 1.3}, leastShipWidth(), {});
        QVERIFY(mesh.isSound());
        QVERIFY2(mesh.net().vertexCount() < 10 * static_cast<int>(walls.size()),
                 QByteArray::number(mesh.net().vertexCount()));
    }

    void shippedLevelsAreClean() {
        const std::filesystem::path folder = (sourceFolder() + "/levels").toStdString();
        int count = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
            if (entry.path().extension() == ".json") {
                const auto file = readLevel(entry.path());
                QVERIFY(file && file.value().level);
                QVERIFY2(leaksIn(*file.value().level).empty(), entry.path().c_str());
                ++count;
            }
        }
        QVERIFY(count > 0);
    }

    void aStopEndsTheSearchWithoutAnAnswer() {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(leaksOf(aroundTheShip({EdgeChain{room, false, 0.5}}), isFine, stop.get_token()).empty());
    }
};

SPACETOW_TEST(LeakTest)
#include "leak_test.moc"
