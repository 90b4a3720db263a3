// What an update costs grows with what moves, what an edit costs with what is edited, and not with how much stands
// still. Work is counted: memory that is touched, leaves of trees. Nothing is timed.

#include "core/physics/state/world_data.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/touched_memory.h"

#include <algorithm>
#include <functional>
#include <utility>

using namespace spacetow;
using namespace spacetow::test;

namespace {

// A level as large as that, and one that is small; thin runs look for faults of memory only.
const int largeLevel = usualOrThin(100000, 10000);
constexpr int smallLevel = 1000;

Vec2 groundAt(double x) {
    return {x, 3 * std::sin(0.7 * x) + 0.3 * std::sin(11 * x)};
}

struct Terrain {
    World world;
    std::vector<BodyId> edges;
    BodyId ball;
};

/// One body an edge, and one ball that rolls about.
Terrain terrain(int edges, double depth) {
    Terrain made{World(withIterations(20)), {}, {}};
    for (int i = 0; i < edges; ++i) {
        made.edges.push_back(add(made.world, edgeBody(groundAt(0.2 * i), groundAt(0.2 * (i + 1)), depth)));
    }
    made.ball = add(made.world, ball({20, 5}, 0.2));
    return made;
}

// An eighth of what looking at all records of the large level touches; the system itself now and then touches a quarter
// of that.
constexpr std::size_t aPassOverAll = 100000 * sizeof(BodyRecord) / 8;

/// The middle of some counts: now and then the system itself touches something.
template <class Work>
std::optional<std::size_t> usuallyTouchedBy(const Work& work) {
    std::vector<std::size_t> counts;
    for (int i = 0; i < 5; ++i) {
        const auto bytes = touchedBy(work);
        if (!bytes) {
            return std::nullopt;
        }
        counts.push_back(*bytes);
    }
    std::sort(counts.begin(), counts.end());
    return counts[counts.size() / 2];
}

} // namespace

class LargeLevelTest : public QObject {
    Q_OBJECT

  private slots:
    void anUpdateTouchesNoMoreInALargeLevel_data() {
        QTest::addColumn<double>("depth");
        QTest::addColumn<bool>("sleeps");
        QTest::newRow("thin walls") << 0.0 << false;
        QTest::newRow("walls without a back") << noBack << false;
        QTest::newRow("a ball that falls asleep") << noBack << true;
    }
    void anUpdateTouchesNoMoreInALargeLevel() {
        QFETCH(double, depth);
        QFETCH(bool, sleeps);
        std::vector<std::size_t> touched;
        std::vector<double> heights;
        for (const int edges : {smallLevel, largeLevel}) {
            Terrain level = terrain(edges, depth);
            level.world.setSleeping(sleeps);
            run(level.world, 0.1);
            const auto bytes = usuallyTouchedBy([&] { run(level.world, 0.4); });
            if (!bytes) {
                QSKIP("This system does not count the memory that is touched.");
            }
            touched.push_back(*bytes);
            heights.push_back(level.world.body(level.ball).pose.position.y());
        }
        QCOMPARE(heights[0], heights[1]); // the same happens in both
        QVERIFY(heights[0] < 4);
        QVERIFY2(touched[1] < touched[0] + aPassOverAll,
                 qPrintable(QString("%1 and %2 bytes").arg(touched[0]).arg(touched[1])));
    }

    void treesGrowWithTheNumberOfEdgesHoweverDense_data() {
        QTest::addColumn<double>("depth");
        QTest::newRow("thin") << 0.0;
        QTest::newRow("thick") << 3.0;
        QTest::newRow("without a back") << noBack;
    }
    void treesGrowWithTheNumberOfEdgesHoweverDense() {
        QFETCH(double, depth);
        std::vector<double> leaves;
        const int most = usualOrThin(32000, 8000);
        for (const int edges : {most / 8, most}) {
            World world(withIterations(1));
            BodyDef def{.kind = BodyKind::Static};
            const double width = 160.0 / edges;
            for (int i = 0; i < edges; ++i) {
                def.shapes.emplace_back(Edge{groundAt(width * i), groundAt(width * (i + 1)), depth});
            }
            add(world, def);
            world.update();
            leaves.push_back(static_cast<double>(world.data().broadPhase.statics->tree.cells().size()));
        }
        QVERIFY2(leaves[1] < 10 * leaves[0], qPrintable(QString("%1 and %2").arg(leaves[0]).arg(leaves[1])));
    }

    void anEditMakesNothingAnewButWhatItTouches() {
        Terrain level = terrain(largeLevel, noBack);
        run(level.world, 0.1);
        const std::shared_ptr<const StaticGeometry> all = level.world.data().broadPhase.statics;
        const auto middle = static_cast<std::size_t>(largeLevel / 2);
        const std::pair<const char*, std::function<void(std::size_t)>> edits[] = {
            {"move",
             [&](std::size_t at) {
                 level.world.setPose(level.edges[at], {0, 0.25}, 0);
             }},
            {"back",
             [&](std::size_t at) {
                 level.world.setPose(level.edges[at], {0, 0}, 0);
             }},
            {"remove", [&](std::size_t at) { level.world.removeBody(level.edges[at + 9]); }},
            {"add",
             [&](std::size_t) {
                 add(level.world, edgeBody({0, 9}, {1, 9}));
             }},
            {"switch off", [&](std::size_t at) { level.world.setActive(level.edges[at - 7], false); }},
        };
        for (const auto& [name, edit] : edits) {
            std::optional<std::size_t> bytes;
            for (const std::size_t at : {middle, middle + 100, middle + 200}) { // the system touches something, too
                const auto once = touchedBy([&, change = edit] {
                    change(at);
                    level.world.update();
                });
                bytes = bytes && once ? std::min(*bytes, *once) : once;
            }
            QVERIFY2(level.world.data().broadPhase.statics == all, name);
            QVERIFY(level.world.data().broadPhase.staticChanges->geometry.colliders.size() < 30);
            QVERIFY2(!bytes || *bytes < 2 * aPassOverAll,
                     qPrintable(QString("%1: %2").arg(name).arg(bytes.value_or(0))));
        }
    }
};

SPACETOW_TEST(LargeLevelTest)
#include "large_level_test.moc"
