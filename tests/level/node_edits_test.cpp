#include "core/level/node_edits.h"

#include "core/level/edits.h"
#include "core/level/knife.h"
#include "core/level/lint.h"
#include "tests/support/body_with.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using Points = std::vector<Vec2>;

Points square(double side = 2) {
    return {{0, 0}, {side, 0}, {side, side}, {0, side}};
}

Level levelWith(LevelShape shape, const Vec2& position = {1, 2}) {
    Level level;
    level.objects.append(bodyWith(1, std::move(shape), position));
    return level;
}

const BodyObject& bodyOf(const Level& level, Key key = 1) {
    return std::get<BodyObject>(level.objects.find(key)->data);
}

Points pointsOf(const Level& level, int shape = 0, Key key = 1) {
    return *verticesOf(bodyOf(level, key).shapes[static_cast<std::size_t>(shape)]);
}

std::vector<NodeRef> nodes(std::initializer_list<int> vertices, Key key = 1, int shape = 0) {
    std::vector<NodeRef> result;
    for (const int vertex : vertices) {
        result.push_back({key, shape, vertex});
    }
    return result;
}

std::map<std::string, int> errorsOf(const Level& level) {
    std::map<std::string, int> errors;
    for (const Problem& problem : lint(level)) {
        if (problem.severity == Severity::Error) {
            // A connector to what is no body loses it when that goes: one fault in place of the other.
            ++errors[problem.code.text().starts_with("connector-end") ? "connector-end"
                                                                      : std::string(problem.code.text())];
        }
    }
    return errors;
}

/// A part of the nodes of the level, ascending.
std::vector<NodeRef> someNodes(const Level& level, Random& random) {
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        keys.push_back(object.key);
    }
    std::vector<NodeRef> all = allNodes(level, keys);
    const std::uint32_t share = 1 + random.next() % 4;
    std::erase_if(all, [&](const NodeRef&) { return random.next() % 4 >= share; });
    return all;
}

} // namespace

class NodeEditsTest : public QObject {
    Q_OBJECT

  private slots:
    void aNodeIsInsertedOnItsSegment() {
        const NodeEdit edit = withNode(levelWith(EdgeChain{square(), true}), {1, 0, 3}, {1, 3});
        QCOMPARE(pointsOf(edit.level), (Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}));
        QCOMPARE(edit.nodes, nodes({4}));
    }
    void anOpenChainHasNoSegmentAfterItsLastNode() {
        const Level level = levelWith(LineChain{square()});
        QCOMPARE(withNode(level, {1, 0, 3}, {1, 3}).level, level);
    }
    void midpointsComeBetweenSelectedNodes() {
        const NodeEdit edit = withMidpoints(levelWith(LineChain{square()}), nodes({1, 2}));
        QCOMPARE(pointsOf(edit.level), (Points{{0, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}));
        QCOMPARE(edit.nodes, nodes({1, 2, 3}));
    }
    void aPolygonGetsNoMoreCornersThanItMayHave() {
        Points corners;
        for (int i = 0; i < 600; ++i) {
            corners.push_back({std::cos(i * 0.01), std::sin(i * 0.01)});
        }
        const Level level = levelWith(Polygon{corners});
        const std::vector<Key> keys{1};
        QCOMPARE(withMidpoints(level, allNodes(level, keys)).level, level);
    }
    void neighboursOfRemovedNodesAreJoined() {
        QCOMPARE(pointsOf(withoutNodes(levelWith(EdgeChain{square(), true}), nodes({1}))),
                 (Points{{0, 0}, {2, 2}, {0, 2}}));
    }
    void aClosedChainOfTwoNodesOpens() {
        const Level level = withoutNodes(levelWith(EdgeChain{square(), true}), nodes({1, 2}));
        QVERIFY(!isClosed(bodyOf(level).shapes[0]));
    }
    void whatHasTooFewNodesGoesAndItsBodyWithIt() {
        QVERIFY(withoutNodes(levelWith(Polygon{square()}), nodes({0, 1})).objects.empty());
        QVERIFY(withoutNodes(levelWith(LineChain{square()}), nodes({0, 1, 2})).objects.empty());
    }
    void aBodyKeepsItsOtherShapesAndTheirUnknownFields() {
        Object object = bodyWith(1, LineChain{square()});
        std::get<BodyObject>(object.data).shapes.push_back(Circle{{0, 0}, 1});
        object.unknownFields = R"({"/glow": 1, "/shapes/0/a": 2, "/shapes/1/b": 3})";
        Level level;
        level.objects.append(object);
        level = withoutNodes(level, nodes({0, 1, 2}));
        QCOMPARE(bodyOf(level).shapes, (std::vector<LevelShape>{Circle{{0, 0}, 1}}));
        QCOMPARE(level.objects.find(1)->unknownFields, std::string(R"({"/glow": 1, "/shapes/0/b": 3})"));
    }
    void theFinishKeepsItsEnds() {
        Level level;
        level.objects.append({1, "", FinishObject{{0, 0}, {1, 0}}, ""});
        QCOMPARE(withoutNodes(level, nodes({0, 1})), level);
    }
    void segmentsGoAndLeaveTheChainOpen() {
        const Level open = withoutSegments(levelWith(EdgeChain{square(), true}), nodes({1, 2})).level;
        QCOMPARE(pointsOf(open), (Points{{2, 2}, {0, 2}, {0, 0}, {2, 0}}));
        const Level two = withoutSegments(levelWith(LineChain{square()}), nodes({1, 2})).level;
        QCOMPARE(pointsOf(two, 0), (Points{{0, 0}, {2, 0}}));
        QCOMPARE(pointsOf(two, 1), (Points{{2, 2}, {0, 2}}));
    }
    void aChainBreaksAtANode() {
        const NodeEdit edit = brokenAt(levelWith(EdgeChain{square(), false, 0.5}), nodes({0, 1}));
        QCOMPARE(bodyOf(edit.level).shapes, (std::vector<LevelShape>{EdgeChain{{{0, 0}, {2, 0}}, false, 0.5},
                                                                     EdgeChain{{{2, 0}, {2, 2}, {0, 2}}, false, 0.5}}));
        QCOMPARE(edit.nodes, (std::vector<NodeRef>{{1, 0, 0}, {1, 0, 1}, {1, 1, 0}}));
    }
    void aClosedChainOpensWhereItBreaks() {
        const Level level = brokenAt(levelWith(LineChain{square(), true}), nodes({2})).level;
        QCOMPARE(pointsOf(level), (Points{{2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}}));
        QVERIFY(!isClosed(bodyOf(level).shapes[0]));
    }
    void aPartRunsTheOtherWayAsAChainOfItsOwn() {
        const NodeEdit edit =
            reversedPart(levelWith(EdgeChain{{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, false, 1}), nodes({1, 2}));
        QCOMPARE(pointsOf(edit.level, 0), (Points{{0, 0}, {1, 0}}));
        QCOMPARE(pointsOf(edit.level, 1), (Points{{2, 0}, {1, 0}}));
        QCOMPARE(pointsOf(edit.level, 2), (Points{{2, 0}, {3, 0}}));
        QCOMPARE(edit.nodes, nodes({0, 1}, 1, 1));
    }
    void turningAllRoundTwiceIsNoChange() {
        for (const bool closed : {false, true}) {
            const Level level = levelWith(EdgeChain{square(), closed});
            const NodeEdit once = reversedPart(level, nodes({0, 1, 2, 3}));
            QVERIFY(once.level != level);
            QCOMPARE(once.level, reversed(level, std::vector<Key>{1}));
            QCOMPARE(reversedPart(once.level, once.nodes).level, level);
        }
    }
    void segmentsAreMadeStraightAboutTheFirstNode() {
        const Level level =
            straightened(levelWith(LineChain{{{0, 0}, {3, 0.1}, {3.2, 2}, {9, 9}}}), nodes({0, 1, 2})).level;
        const Points points = pointsOf(level);
        QCOMPARE(points[0], Vec2(0, 0));
        QVERIFY(std::abs(points[1].y()) == 0 && std::abs(points[1].x() - Vec2(3, 0.1).norm()) < 1e-9);
        QVERIFY(std::abs(points[2].x() - points[1].x()) < 1e-9);
        QCOMPARE(points[3], Vec2(9, 9));
    }
    void endsAreWeldedInTheMiddle_data() {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("second");
        QTest::addColumn<Points>("joined");
        QTest::newRow("end to start") << 1 << 0 << Points{{0, 0}, {1.5, 0}, {3, 0}};
        QTest::newRow("start to end") << 0 << 1 << Points{{2, 0}, {1.5, 0}, {1, 0}};
        QTest::newRow("end to end") << 1 << 1 << Points{{0, 0}, {2, 0}, {2, 0}};
        QTest::newRow("start to start") << 0 << 0 << Points{{3, 0}, {1, 0}, {1, 0}};
    }
    void endsAreWeldedInTheMiddle() {
        QFETCH(int, first);
        QFETCH(int, second);
        QFETCH(Points, joined);
        Level level;
        level.objects.append(bodyWith(7, EdgeChain{{{0, 0}, {1, 0}}}, {1, 1}));
        level.objects.append(bodyWith(3, EdgeChain{{{2, 0}, {3, 0}}}, {1, 1}));
        const std::vector<NodeRef> ends{{3, 0, second}, {7, 0, first}};
        QVERIFY(canJoin(level, ends, JoinWay::Weld));
        const NodeEdit edit = spacetow::joined(level, ends, JoinWay::Weld);
        QCOMPARE(edit.level.objects.size(), 1);
        QCOMPARE(pointsOf(edit.level, 0, 7), joined);
        QCOMPARE(edit.nodes, (std::vector<NodeRef>{{7, 0, 1}}));
    }
    void endsOfOneChainCloseIt() {
        const Level welded = joined(levelWith(LineChain{square()}), nodes({0, 3}), JoinWay::Weld).level;
        QCOMPARE(pointsOf(welded), (Points{{0, 1}, {2, 0}, {2, 2}}));
        const Level closed = joined(levelWith(LineChain{square()}), nodes({0, 3}), JoinWay::Segment).level;
        QCOMPARE(pointsOf(closed), square());
        QVERIFY(isClosed(bodyOf(closed).shapes[0]));
    }
    void wallsAreNotJoinedWithLines() {
        Level level = levelWith(EdgeChain{{{0, 0}, {1, 0}}});
        level.objects.append(bodyWith(2, LineChain{{{0, 0}, {1, 0}}}));
        QVERIFY(!canJoin(level, std::vector<NodeRef>{{1, 0, 0}, {2, 0, 0}}, JoinWay::Weld));
    }
    void whatWasBrokenIsJoinedAgain() {
        const Level level = levelWith(EdgeChain{square()});
        const NodeEdit broken = brokenAt(level, nodes({1}));
        QCOMPARE(joined(broken.level, broken.nodes, JoinWay::Weld).level, level);
    }
    void nodesInOnePlaceAreFoundUnlessLocked() {
        Level level = levelWith(EdgeChain{square()});
        level.objects.append(bodyWith(2, LineChain{{{3, 2}, {5, 5}}}));
        Object locked = bodyWith(3, LineChain{{{3, 2}, {5, 5}}});
        locked.locked = true;
        level.objects.append(locked);
        QCOMPARE(nodesAt(level, std::vector<Vec2>{{3, 2}}), (std::vector<NodeRef>{{1, 0, 1}, {2, 0, 0}}));
    }
    void aKnifeSplitsChains() {
        const std::vector<Key> keys{1};
        const CutLevel open = cutAlong(levelWith(EdgeChain{square(), false, 1}, {0, 0}), keys, {1, -1}, {1, 3});
        QCOMPARE(pointsOf(open.level, 0), (Points{{0, 0}, {1, 0}}));
        QCOMPARE(pointsOf(open.level, 1), (Points{{1, 0}, {2, 0}, {2, 2}, {1, 2}}));
        QCOMPARE(pointsOf(open.level, 2), (Points{{1, 2}, {0, 2}}));
        QCOMPARE(open.places.size(), std::size_t{2});
        const CutLevel once = cutAlong(levelWith(LineChain{square(), true}, {0, 0}), keys, {1, -1}, {1, 1});
        QCOMPARE(pointsOf(once.level), (Points{{1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 0}}));
    }
    void aKnifeSplitsPolygonsItGoesRightThrough() {
        const std::vector<Key> keys{1};
        const Level level = levelWith(Polygon{square()}, {0, 0});
        const CutLevel cut = cutAlong(level, keys, {1, -1}, {1, 3});
        QCOMPARE(pointsOf(cut.level, 0), (Points{{1, 0}, {2, 0}, {2, 2}, {1, 2}}));
        QCOMPARE(pointsOf(cut.level, 1), (Points{{1, 2}, {0, 2}, {0, 0}, {1, 0}}));
        QCOMPARE(cutAlong(level, keys, {1, -1}, {1, 1}).level, level);
        QCOMPARE(cutAlong(level, keys, {0, -1}, {0, 3}).level, level); // along a side
        QCOMPARE(pointsOf(cutAlong(level, keys, {-1, -1}, {3, 3}).level, 0).size(), std::size_t{3});
    }
    void aConcavePolygonFallsIntoAsManyPiecesAsTheKnifeMakes() {
        const Points comb{{0, 0}, {5, 0}, {5, 3}, {4, 3}, {4, 1}, {3, 1},
                          {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
        const CutLevel cut = cutAlong(levelWith(Polygon{comb}, {0, 0}), std::vector<Key>{1}, {-1, 2}, {6, 2});
        QCOMPARE(bodyOf(cut.level).shapes.size(), std::size_t{4});
        QVERIFY(errorsOf(cut.level).empty());
    }
    void editsLeaveTheirInputUntouchedAndTheirOutputValid() {
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            Random random(seed);
            const Level level = randomLevel(seed, 12);
            const Level before = level;
            const std::vector<NodeRef> chosen = someNodes(level, random);
            std::vector<NodeRef> two = chosen;
            two.resize(std::min<std::size_t>(2, two.size()));
            std::vector<Key> keys;
            for (const Object& object : level.objects) {
                keys.push_back(object.key);
            }
            const std::vector<std::pair<const char*, Level>> results{
                {"midpoints", withMidpoints(level, chosen).level},
                {"remove", withoutNodes(level, chosen)},
                {"segments", withoutSegments(level, chosen).level},
                {"break", brokenAt(level, chosen).level},
                {"reverse", reversedPart(level, chosen).level},
                {"straighten", straightened(level, chosen).level},
                {"weld", joined(level, two, JoinWay::Weld).level},
                {"join", joined(level, two, JoinWay::Segment).level},
                {"cut", cutAlong(level, keys, {-20, -1}, {20, 2}).level},
            };
            QCOMPARE(level, before);
            std::map<std::string, int> known = errorsOf(level);
            for (const auto& [name, result] : results) {
                for (const auto& [code, count] : errorsOf(result)) {
                    // Corners that go or move may make a polygon cross itself, and walls reach the ship, as
                    // dragging them may.
                    const bool shape = code.starts_with("polygon-") || code.ends_with("-in-wall");
                    // More nodes may lie where some were out of range.
                    QVERIFY2(shape || count <= known[code] || (code == "out-of-range" && known[code] > 0),
                             qPrintable(QString("seed %1, %2: %3").arg(seed).arg(name).arg(code.c_str())));
                }
                for (const Object& object : result.objects) {
                    const auto* body = std::get_if<BodyObject>(&object.data);
                    QVERIFY2(body == nullptr || !body->shapes.empty(), name);
                }
            }
        }
    }
};

SPACETOW_TEST(NodeEditsTest)
#include "node_edits_test.moc"
