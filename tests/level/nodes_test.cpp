#include "core/level/nodes.h"

#include "core/level/file.h"
#include "core/level/outline.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::vector<Key> everyKey(const Level& level) {
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        keys.push_back(object.key);
    }
    return keys;
}

} // namespace

class NodesTest : public QObject {
    Q_OBJECT

  private slots:
    void nodesLieWhereTheOutlineHasItsCorners() {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const Level level = randomLevel(seed, 12);
            const Outlines outlines(level);
            for (const Object& object : level.objects) {
                if (!std::holds_alternative<BodyObject>(object.data)) {
                    continue;
                }
                const std::vector<NodePath> paths = nodePaths(object.data);
                const std::vector<OutlinePath> outline = outlines.of(object).paths;
                QCOMPARE(paths.size(), outline.size());
                for (std::size_t i = 0; i < paths.size(); ++i) {
                    QCOMPARE(paths[i].closed, outline[i].closed);
                    QCOMPARE(paths[i].points.size(), outline[i].points.size());
                    for (std::size_t j = 0; j < paths[i].points.size(); ++j) {
                        const Vec2 error = paths[i].points[j] - outline[i].points[j];
                        QVERIFY(error.norm() <= 1e-11 * std::max(1.0, outline[i].points[j].norm()));
                    }
                }
            }
        }
    }

    void everyNodeIsFoundAgainByItsPlace() {
        const Level level = populatedLevel();
        const std::vector<NodeRef> nodes = allNodes(level, everyKey(level));
        QCOMPARE(nodes.size(), std::size_t{3 + 3 + 3 + 2});
        for (const NodeRef& node : nodes) {
            QVERIFY(nodePosition(level, node).has_value());
        }
        QVERIFY(!nodePosition(level, {1, 3, 0}));
        QVERIFY(!nodePosition(level, {1, 0, 3}));
        QVERIFY(!nodePosition(level, {1, 0, -1}));
        QVERIFY(!nodePosition(level, {3, 0, 0}));
        QVERIFY(!nodePosition(level, {99, 0, 0}));
    }

    void mappedNodesGoWhereTheMapSendsThemAndOthersStay() {
        const Level before = populatedLevel();
        const NodeRef moved{1, 2, 1};
        const Level after =
            withMappedNodes(before, std::vector<NodeRef>{moved, {5, 0, 1}}, Affine::translation({0.5, -0.25}));
        for (const NodeRef& node : allNodes(before, everyKey(before))) {
            const bool goes = node == moved || node == NodeRef{5, 0, 1};
            const Vec2 delta = goes ? Vec2(0.5, -0.25) : Vec2(0, 0);
            QVERIFY((*nodePosition(after, node) - *nodePosition(before, node) - delta).norm() < 1e-9);
        }
        QVERIFY(after.objects.sharesPiece(1, before.objects));
    }

    void aNodeOfATurnedBodyLandsOnTheGridToTheLastBit() {
        Level level;
        BodyObject body;
        body.angle = 0.7;
        body.position = {0.3, 0.1};
        body.shapes = {LineChain{{{0, 0}, {1, 0}, {1, 1}}, false}};
        level.objects.append({1, "", body, {}});
        const NodeRef node{1, 0, 2};
        const Vec2 way = Vec2(2.75, -0.5) - *nodePosition(level, node);
        level = withMappedNodes(std::move(level), std::vector<NodeRef>{node}, Affine::translation(way));
        QVERIFY((*nodePosition(level, node) == Vec2(2.75, -0.5)));
    }
};

SPACETOW_TEST(NodesTest)
#include "nodes_test.moc"
