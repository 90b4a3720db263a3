#include "tests/support/contact_scenes.h"

#include "core/base/random.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/overlaps.h"
#include "core/physics/broad_phase/separating_face.h"
#include "core/physics/solver/contact_graph.h"
#include "core/physics/state/world_data.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Part boxPart(const Vec2& center, double halfWidth, double halfHeight) {
    const double x = halfWidth;
    const double y = halfHeight;
    return partsOf(Polygon{{center + Vec2(-x, -y), center + Vec2(x, -y), center + Vec2(x, y), center + Vec2(-x, y)}})
        .front();
}

Vec2 pointIn(Random& random, const Aabb& box) {
    const double x = random.uniform(box.min.x(), box.max.x());
    return {x, random.uniform(box.min.y(), box.max.y())};
}

/// Some boxes, balls, and a long body or two that turn among them, in a frame that turns.
World randomHeap(Random& random) {
    World world({.gravity = {0, -9.81}, .seconds = 1.0 / 60, .iterations = 4, .substeps = 1});
    BodyDef frame{.kind = BodyKind::Kinematic, .shapes = {}};
    for (const double side : {-1.0, 1.0}) {
        for (const bool upright : {false, true}) {
            const Vec2 at = upright ? Vec2(4 * side, 0) : Vec2(0, 4 * side);
            Polygon wall = std::get<Polygon>(box({0, 0}, upright ? 0.1 : 4, upright ? 4 : 0.1).shapes[0]);
            for (Vec2& v : wall.vertices) {
                v += at;
            }
            frame.shapes.emplace_back(wall);
        }
    }
    frame.angularVelocity = random.uniform(-3, 3);
    frame.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
    add(world, frame);
    for (int i = 0; i < 30; ++i) {
        const Vec2 at(-3 + 1.1 * (i % 6), -3 + 1.1 * static_cast<int>(i / 6));
        BodyDef def = random.below(3) == 0   ? ball(at, random.uniform(0.1, 0.4))
                      : random.below(4) == 0 ? box(at, random.uniform(0.8, 1.2), 0.06)
                                             : box(at, random.uniform(0.1, 0.4), random.uniform(0.1, 0.4));
        def.velocity = {random.uniform(-5, 5), random.uniform(-5, 5)};
        def.angularVelocity = random.uniform(-10, 10);
        add(world, def);
    }
    return world;
}

bool partsMeet(const WorldData& data, Slot a, std::uint32_t partA, Slot b, std::uint32_t partB) {
    return overlaps((*data.bodies.records[a].parts)[partA], data.bodies.pose(a), (*data.bodies.records[b].parts)[partB],
                    data.bodies.pose(b));
}

/// Whether all parts that meet are in the table of pairs.
bool holdsAllThatMeet(const WorldData& data) {
    const auto isListed = [&](const PairKey& key) {
        const std::vector<Pair>& pairs = data.contacts.table.pairs;
        const auto isBefore = [](const Pair& pair, const PairKey& other) { return pair.key() < other; };
        const auto found = std::lower_bound(pairs.begin(), pairs.end(), key, isBefore);
        return found != pairs.end() && !(key < found->key());
    };
    for (const Slot a : data.bodies.moving) {
        for (const Slot b : data.bodies.moving) {
            for (std::uint32_t i = 0; a < b && i < data.bodies.records[a].parts->size(); ++i) {
                for (std::uint32_t k = 0; k < data.bodies.records[b].parts->size(); ++k) {
                    if (partsMeet(data, a, i, b, k) && !isListed({a, b, i, k})) {
                        return false;
                    }
                }
            }
        }
    }
    return true;
}

bool isSortedAndUnique(const std::vector<Pair>& pairs) {
    for (std::size_t i = 1; i < pairs.size(); ++i) {
        if (!(pairs[i - 1].key() < pairs[i].key())) {
            return false;
        }
    }
    return true;
}

/// Whether what lies beside each pair is its own: its gate, and the contact that is listed for it.
bool belongTogether(const WorldData& data) {
    for (std::uint32_t i = 0; i < data.contacts.table.size(); ++i) {
        const Pair& pair = data.contacts.table.pairs[i];
        if (data.contacts.table.bounds[i].moverA != moverOf(pair.bodyA) ||
            data.contacts.table.bounds[i].moverB != moverOf(pair.bodyB)) {
            return false;
        }
        if (!data.flags.constraintsValid || !data.contacts.table.flags[i].inSolver) {
            continue;
        }
        const std::uint32_t place = data.contacts.pool[pair.contact].constraintIndex;
        const bool general = pair.kind == PairKind::General;
        if ((general ? pairOf(data.constraints.generalContacts[place])
                     : pairOf(data.constraints.circleContacts[place])) != i) {
            return false;
        }
    }
    return data.contacts.table.bounds.size() == data.contacts.table.size() &&
           data.contacts.table.flags.size() == data.contacts.table.size();
}

bool componentsAreThoseOfThePairs(const WorldData& data) {
    WorldData asTheyAre = data;
    WorldData anew = data;
    findComponents(asTheyAre);
    anew.flags.contactGraphStale = true;
    findComponents(anew);
    return asTheyAre.contactGraph.roots == anew.contactGraph.roots &&
           asTheyAre.contactGraph.componentRoots == anew.contactGraph.componentRoots &&
           asTheyAre.contactGraph.kinematicEdges == anew.contactGraph.kinematicEdges;
}

} // namespace

class PairTableTest : public QObject {
    Q_OBJECT

  private slots:
    void whatStaysInFrontOfALongPartNeverMeetsIt() {
        int clear = 0;
        for (std::uint64_t seed = 1; seed <= (isFullRun() ? 20000u : 2000u); ++seed) {
            Random random(seed);
            const Part part = boxPart(pointIn(random, {{-2, -2}, {2, 2}}), random.uniform(2, 10), 0.2);
            FatAabb fat;
            const Vec2 from = pointIn(random, {{-5, -5}, {5, 5}});
            fat.centers = {from, from + pointIn(random, {{0, 0}, {1, 1}})};
            fat.angleLeft = random.uniform(0, random.below(2) == 0 ? 0.1 : 1);
            const Rot rotation = Rot::fromAngle(random.uniform(-pi, pi));
            const Vec2 half = pointIn(random, {{0.05, 0.05}, {2, 2}});
            const Vec2 at = pointIn(random, {{-12, -12}, {12, 12}});
            if (!isInFrontOfFace({at - half, at + half}, std::get<ConvexPart>(part), rotation, fat)) {
                continue;
            }
            ++clear;
            for (int i = 0; i < 50; ++i) {
                const double turn = random.below(4) == 0 ? fat.angleLeft : random.uniform(0, fat.angleLeft);
                const Transform pose{pointIn(random, fat.centers),
                                     turned(rotation, random.below(2) == 0 ? turn : -turn)};
                QVERIFY2(!overlaps(part, pose, boxPart(at, half.x(), half.y()), {}), seedText(seed));
            }
        }
        QVERIFY(clear > 400);
    }

    void onlyLongPartsAreSlender() {
        QVERIFY(!isSlender(boxPart({0, 0}, 1, 1)) && !isSlender(boxPart({3, 0}, 2, 1)));
        QVERIFY(!isSlender(Circle{{0, 0}, 1}));
        QVERIFY(isSlender(boxPart({3, 0}, 10, 1)) && isSlender(boxPart({0, 7}, 0.5, 20)));
    }

    void theTableHoldsWhatMeetsAndStaysInOrder() {
        std::size_t changes = 0;
        for (std::uint64_t seed = 1; seed <= (isFullRun() ? 100u : 10u); ++seed) {
            Random random(seed);
            World world = randomHeap(random);
            for (int i = 0; i < 120; ++i) {
                world.update();
                const WorldData& data = world.data();
                QVERIFY2(isSortedAndUnique(data.contacts.table.pairs), seedText(seed));
                QVERIFY2(belongTogether(data), seedText(seed));
                QVERIFY2(holdsAllThatMeet(data), seedText(seed));
                QVERIFY2(componentsAreThoseOfThePairs(data), seedText(seed));
                changes += data.scratch.changes.runs.size();
            }
        }
        QVERIFY(changes > 1000);
    }
};

SPACETOW_TEST(PairTableTest)
#include "pair_table_test.moc"
