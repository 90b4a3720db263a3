#include "tests/support/contact_scenes.h"
#include "tests/support/known_values.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

double heightOfAnInactiveBall() {
    World world(withIterations(20));
    BodyDef def = ball({0, 3}, 0.2);
    def.velocity = {0, 1};
    def.active = false;
    const BodyId id = add(world, def);
    run(world, 1);
    return world.body(id).pose.position.y();
}

int connectorsLeftAfterARemoval() {
    World world(withIterations(4));
    const BodyId middle = add(world, ball({0, 0}, 0.1));
    for (const double x : {-1.0, 1.0, 2.0}) {
        const BodyId other = add(world, ball({x, 0}, 0.1));
        static_cast<void>(world.addConnector({.a = middle, .b = other}).value());
    }
    world.removeBody(middle);
    world.update();
    return static_cast<int>(world.connectors().size());
}

/// Velocity of an elastic ball after it has met another one head-on at 2 m/s.
double reboundFrom(BodyDef other) {
    World world(withIterations(20, {0, 0}));
    other.restitution = 1;
    add(world, other);
    BodyDef def = ball({-1, 0}, 0.2);
    def.velocity = {2, 0};
    def.restitution = 1;
    const BodyId id = add(world, def);
    run(world, 1);
    return world.body(id).velocity.x();
}

BodyDef frozenBall() {
    BodyDef def = ball({0, 0}, 0.2);
    def.positionFrozen = def.rotationFrozen = true;
    return def;
}

/// Speed of a still elastic ball after a kinematic one of the given mass has met it at 1 m/s.
double drivenBy(double mass) {
    World world(withIterations(20, {0, 0}));
    BodyDef hammer = ball({-1, 0}, 0.2);
    hammer.kind = BodyKind::Kinematic;
    hammer.mass = mass;
    hammer.velocity = {1, 0};
    hammer.restitution = 1;
    add(world, hammer);
    BodyDef def = ball({0, 0}, 0.2);
    def.restitution = 1;
    const BodyId id = add(world, def);
    run(world, 1);
    return world.body(id).velocity.x();
}

double heightOnARisingEdge() {
    World world(withIterations(20));
    BodyDef platform = floorOf("edge");
    platform.kind = BodyKind::Kinematic;
    platform.velocity = {0, 0.5};
    add(world, platform);
    const BodyId id = add(world, ball({0, 0.2}, 0.2));
    run(world, 2);
    return world.body(id).massCenter.y();
}

/// Where a ball ends that rolls straight at an end of an edge from 3 m away, m from the middle of the edge.
double stoppedAtTheEnd(double side) {
    World world(withIterations(20, {0, 0}));
    add(world, edgeBody({-1, 0}, {1, 0}, 0.1));
    BodyDef def = ball({4 * side, 0}, 0.2);
    def.velocity = {-3 * side, 0};
    const BodyId id = add(world, def);
    run(world, 3);
    return side * world.body(id).massCenter.x();
}

/// Tags that a ball touches after it has been in a zone and has left it.
double tagsTouchedAfterAZone() {
    World world(withIterations(4, {0, 0}));
    BodyDef zone = ball({0, 0}, 0.3);
    zone.kind = BodyKind::Static;
    zone.tangible = false;
    add(world, zone);
    BodyDef def = ball({-1, 0}, 0.1);
    def.velocity = {1, 0};
    const BodyId id = add(world, def);
    double most = 0;
    for (int i = 0; i < 100; ++i) {
        world.update();
        most = std::max<double>(most, world.body(id).touchedTags.bits);
    }
    return most == 1 ? world.body(id).touchedTags.bits : -1; // −1: was never in it
}

/// A ball made when another one lands, falling from 5 m: its height half a second later.
double heightOfABallMadeInAnswer() {
    World world(withIterations(20));
    add(world, floorOf("edge"));
    add(world, ball({0, 0.5}, 0.2));
    for (int i = 0; i < 100 && world.events().began.empty(); ++i) {
        world.update();
    }
    if (world.events().began.empty()) {
        return -1;
    }
    const BodyId id = add(world, ball({0, 5}, 0.2));
    run(world, 0.5);
    return world.body(id).massCenter.y();
}

void staticRows() {
    World world(withIterations(20));
    const BodyId id = add(world, ball({0.5, 0.4}, 0.2));
    run(world, 0.1);
    BodyDef def = floorOf("polygon");
    def.user = 9;
    const BodyId ground = add(world, def);
    known("a static body is found by its id", static_cast<double>(world.body(ground).user), 9, 0);
    run(world, 1);
    known("a static body that was added in the middle of a run holds what falls on it", world.body(id).massCenter.y(),
          0.2, 0.005);
    world.setPose(ground, {0, -3}, 0);
    run(world, 2);
    known("a static body that was moved holds what falls on it at its new place", world.body(id).massCenter.y(), -1.8,
          0.005);
    world.removeBody(ground);
    run(world, 1);
    known("a static body that was removed holds nothing", world.body(id).massCenter.y(), -1.8 - 4.905, 0.01);
}

double placeOfTheLastOfManyBodies() {
    World world(withIterations(1, {0, 0}));
    BodyId last;
    for (int i = 0; i < 10000; ++i) {
        last = add(world, ball({0, 0}, 0.1));
        world.removeBody(last);
        world.update();
    }
    return last.index;
}

} // namespace

class SwitchesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyNumberIsWhatItsSentenceSays_data() {
        knownValueColumns();
        known("an inactive body is a second later where it was", heightOfAnInactiveBall(), 3, 0);
        known("a removed body takes all its connectors with it", connectorsLeftAfterARemoval(), 0, 0);
        known("a ball rebounds from a frozen ball as from a wall", reboundFrom(frozenBall()), -2, 1e-9);
        known("a ball that meets a free one of its size stays behind", reboundFrom(ball({0, 0}, 0.2)), 0, 1e-9);
        known("a light kinematic ball at 1 m/s sends a still ball off at 2 m/s", drivenBy(0.1), 2, 1e-9);
        known("a heavy kinematic ball at 1 m/s sends a still ball off at 2 m/s", drivenBy(1000), 2, 1e-9);
        known("a rising kinematic edge carries a still ball up", heightOnARisingEdge(), 1.2, 0.005);
        known("the end of an edge stops a ball", stoppedAtTheEnd(1), 1.2, 0.005);
        known("the start of an edge stops a ball", stoppedAtTheEnd(-1), 1.2, 0.005);
        known("a ball that has left a zone touches no tag any more", tagsTouchedAfterAZone(), 0, 0);
        known("a body made in answer to an event falls as every other", heightOfABallMadeInAnswer(), 5 - 0.125 * 9.81,
              1e-9);
        known("bodies that come and go use the same place again and again", placeOfTheLastOfManyBodies(), 0, 0);
        staticRows();
    }
    void everyNumberIsWhatItsSentenceSays() { checkKnownValue(); }
};

SPACETOW_TEST(SwitchesTest)
#include "switches_test.moc"
