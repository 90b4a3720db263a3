// A world whose static bodies are changed a few at a time is to the bit the world in which all are made anew each time.

#include "core/base/random.h"
#include "core/physics/broad_phase/statics.h"
#include "core/physics/state/world_data.h"
#include "tests/support/contact_scenes.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double grid = 0.5; // m

Vec2 randomGridPoint(Random& random) {
    const double x = grid * random.below(24);
    return {x, grid * random.below(12)};
}

/// Walls that often meet others end to end, tiles that share faces with others, and stones.
BodyDef randomFixture(Random& random) {
    const Vec2 at = randomGridPoint(random);
    BodyDef def{.kind = BodyKind::Static, .shapes = {}, .position = at};
    const int right = static_cast<int>(random.below(2));
    const Vec2 along = grid * Vec2(right, right == 1 ? static_cast<int>(random.below(2)) : 1);
    switch (random.below(5)) {
    case 0:
        def.shapes = {Line{{0, 0}, along}};
        break;
    case 1:
        def.shapes = {Polygon{{{0, 0}, {grid, 0}, {grid, grid}, {0, grid}}}};
        break;
    case 2:
        def.shapes = {Circle{{0, 0}, random.uniform(0.05, 0.3)}};
        break;
    case 3:
        def.shapes = {Edge{{0, 0}, along, 0.1}, Edge{along, 2 * along, noBack}, Line{along, along + Vec2(0, grid)}};
        break;
    default:
        def.shapes = {random.below(2) == 0 ? Edge{{0, 0}, along, random.below(2) == 0 ? 0 : noBack}
                                           : Edge{along, {0, 0}, noBack}};
    }
    def.restitution = random.below(3) == 0 ? 0.6 : 0;
    def.friction = 0.25 * random.below(3);
    return def;
}

BodyDef randomMover(Random& random) {
    const Vec2 at(random.uniform(0, 12), random.uniform(0, 8));
    BodyDef def = random.below(2) == 0 ? ball(at, random.uniform(0.05, 0.3)) : box(at, random.uniform(0.1, 0.4), 0.15);
    def.velocity = {random.uniform(-4, 4), random.uniform(-4, 4)};
    def.reportsTouches = random.below(4) == 0;
    return def;
}

/// The same is done to both; in one all static geometry is made anew whenever any has changed.
struct Twins {
    World patched, anew;
    Random random;
    std::vector<BodyId> fixtures;

    explicit Twins(std::uint64_t seed) : patched(withIterations(seed % 2 == 0 ? 4 : 20)), anew(patched), random(seed) {
        const bool sleeps = random.below(2) == 0;
        for (World* world : {&patched, &anew}) {
            world->setSleeping(sleeps);
        }
        for (int i = 0; i < 200; ++i) {
            addFixture();
        }
        for (int i = 0; i < 20; ++i) {
            const BodyDef mover = randomMover(random);
            add(patched, mover);
            add(anew, mover);
        }
    }

    void addFixture() {
        const BodyDef def = randomFixture(random);
        fixtures.push_back(add(patched, def));
        add(anew, def);
    }

    void change() {
        const std::size_t index = random.below(static_cast<std::uint32_t>(fixtures.size()));
        const BodyId id = fixtures[index];
        const Vec2 to = randomGridPoint(random);
        const double angle = random.below(3) == 0 ? random.uniform(-1, 1) : 0;
        const bool on = random.below(2) == 0;
        const std::uint32_t kind = random.below(5);
        if (kind == 0) {
            addFixture();
            return;
        }
        for (World* world : {&patched, &anew}) {
            if (kind == 1) {
                world->removeBody(id);
            } else if (kind == 2) {
                world->setActive(id, on);
            } else {
                world->setPose(id, to, angle);
            }
        }
        if (kind == 1) {
            fixtures.erase(fixtures.begin() + static_cast<std::ptrdiff_t>(index));
        }
    }

    void update() {
        auto& data = const_cast<WorldData&>(anew.data()); // NOLINT(cppcoreguidelines-pro-type-const-cast)
        if (data.flags.staticsChanged || !data.bodies.pending.empty()) {
            data.broadPhase.statics = nullptr;
        }
        patched.update();
        anew.update();
    }
};

bool isSameWall(const Part& a, const Part& b) {
    const auto* wallA = std::get_if<WallPart>(&a);
    const auto* wallB = std::get_if<WallPart>(&b);
    return wallA == nullptr ||
           (wallA->a == wallB->a && wallA->b == wallB->b && wallA->joinedAtA == wallB->joinedAtA &&
            wallA->joinedAtB == wallB->joinedAtB && wallA->beforeA == wallB->beforeA && wallA->afterB == wallB->afterB);
}

bool isSameConvex(const Part& a, const Part& b) {
    const auto* convexA = std::get_if<ConvexPart>(&a);
    const auto* convexB = std::get_if<ConvexPart>(&b);
    if (convexA == nullptr) {
        return true;
    }
    bool same = convexA->count == convexB->count && convexA->outerFaces == convexB->outerFaces;
    const auto corners = static_cast<unsigned>(convexA->count);
    for (unsigned i = 0; same && i < corners; ++i) {
        // Between two inner faces nothing is asked for.
        const bool hidden = ((convexA->outerFaces >> i | convexA->outerFaces >> (i + corners - 1) % corners) & 1) == 0;
        same = convexA->corners[i] == convexB->corners[i] &&
               (hidden || convexA->normalsBeyond[i] == convexB->normalsBeyond[i]);
    }
    return same;
}

/// Each part of each static body that is there, by index in the geometry of both.
bool haveSameParts(const Twins& twins) {
    const WorldData& patched = twins.patched.data();
    const WorldData& anew = twins.anew.data();
    for (const StaticGeometry::Collider& expected : anew.broadPhase.statics->colliders) {
        const StaticGeometry::Collider& got = patched.broadPhase.staticCollider(
            staticIndex(patched.bodies, patched.broadPhase, expected.body, expected.part));
        if (got.body != expected.body || got.part != expected.part || got.bounds != expected.bounds ||
            !isSameWall(got.shape, expected.shape) || !isSameConvex(got.shape, expected.shape)) {
            return false;
        }
    }
    return true;
}

std::vector<std::pair<Slot, std::uint32_t>> solidIn(const World& world, const Aabb& box) {
    std::vector<std::uint32_t> found;
    findStatics(world.data().broadPhase, box, found);
    std::vector<std::pair<Slot, std::uint32_t>> parts;
    for (const std::uint32_t i : found) {
        parts.emplace_back(world.data().broadPhase.staticCollider(i).body,
                           world.data().broadPhase.staticCollider(i).part);
    }
    std::sort(parts.begin(), parts.end());
    return parts;
}

bool answerAlike(Twins& twins) {
    const double x = twins.random.uniform(-2, 14);
    const Vec2 at(x, twins.random.uniform(-2, 8));
    const double width = twins.random.uniform(0, 3);
    const Aabb box{at, at + Vec2(width, twins.random.uniform(0, 3))};
    return solidIn(twins.patched, box) == solidIn(twins.anew, box);
}

} // namespace

class StaticChangesTest : public QObject {
    Q_OBJECT

  private slots:
    void changedAFewAtATimeItIsTheSameWorld() {
        int patches = 0;
        int rebuilt = 0;
        for (std::uint64_t seed = 1; seed <= (isFullRun() ? 200u : usualOrThin(16u, 3u)); ++seed) {
            Twins twins(seed);
            for (int i = 0; i < 60; ++i) {
                for (std::uint32_t k = twins.random.below(4); k > 0; --k) {
                    twins.change();
                }
                const auto before = twins.patched.data().broadPhase.statics;
                twins.update();
                const WorldData& data = twins.patched.data();
                patches += data.broadPhase.statics == before && data.broadPhase.staticChanges ? 1 : 0;
                rebuilt += before && data.broadPhase.statics != before ? 1 : 0;
                const QByteArray where = QByteArray::number(seed) + ", update " + QByteArray::number(i);
                QVERIFY2(haveSameParts(twins), where);
                QVERIFY2(answerAlike(twins), where);
                QVERIFY2(twins.patched.hash() == twins.anew.hash(), where);
                QVERIFY2(twins.patched.events().began.size() == twins.anew.events().began.size(), where);
            }
        }
        QVERIFY(patches > 100);
        QVERIFY(rebuilt > 3); // there comes a time when making all anew costs less
    }

    void aNewWorldOfTheSameBodiesHasTheSameStatics() {
        for (std::uint64_t seed = 1; seed <= usualOrThin(10u, 2u); ++seed) {
            Twins twins(seed);
            twins.update();
            for (int i = 0; i < 20; ++i) {
                twins.change();
                twins.update();
            }
            World made(twins.patched.parameters());
            for (const BodyId id : twins.patched.bodies()) {
                const BodyState state = twins.patched.body(id);
                if (state.kind == BodyKind::Static && state.active) {
                    add(made, {.kind = BodyKind::Static,
                               .shapes = twins.patched.shapes(id),
                               .position = state.pose.position,
                               .angle = state.angle});
                }
            }
            made.update();
            std::vector<std::uint32_t> found, expected;
            for (int i = 0; i < 100; ++i) {
                const Vec2 from = randomGridPoint(twins.random) + Vec2(0.1, 0.2);
                const Aabb box{from, from + Vec2(twins.random.uniform(0, 2), 1)};
                findStatics(twins.patched.data().broadPhase, box, found);
                findStatics(made.data().broadPhase, box, expected);
                QCOMPARE(found.size(), expected.size());
            }
        }
    }

    void aCopyKeepsItsStaticsWhenTheOriginalIsChanged() {
        Twins twins(1);
        twins.update();
        const BodyId wall = add(twins.patched, edgeBody({-5, -5}, {-4, -5}));
        twins.patched.update();
        const World copy = twins.patched;
        twins.patched.removeBody(wall);
        twins.patched.update();
        const Aabb around{{-4.5, -5.1}, {-4.4, -4.9}};
        const auto hasWall = [&](const World& world) { // beside walls that are solid without end
            return std::ranges::count(solidIn(world, around), std::pair(wall.index, 0u)) == 1;
        };
        QVERIFY(hasWall(copy));
        QVERIFY(!hasWall(twins.patched));
    }

    void whatStandsInASlotThatMovedBeforeStandsStill() {
        World world(withIterations(20));
        BodyDef fast = ball({100, 100}, 0.2);
        fast.velocity = {50, 0};
        const BodyId gone = add(world, fast);
        add(world, edgeBody({99, 99.8}, {130, 99.8})); // so that the solver has had the fast one, too
        run(world, 0.2);
        world.removeBody(gone);
        world.update();
        const BodyId table = add(world, lineBody({-5, 0}, {5, 0}));
        QCOMPARE(table.index, gone.index);
        const BodyId top = add(world, box({0, 0.2}, 0.2, 0.2));
        run(world, 1);
        QVERIFY(std::abs(world.body(top).pose.position.x()) < 1e-9);
        QVERIFY(world.body(top).velocity.norm() < 1e-6);
    }
};

SPACETOW_TEST(StaticChangesTest)
#include "static_changes_test.moc"
