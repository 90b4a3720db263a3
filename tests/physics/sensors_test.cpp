#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Something convex about the origin, or two halves that share a cut, in which nothing can leave and enter again.
std::vector<Shape> sensorShapes(Random& random, double size) {
    const Vec2 half(0.5 * size * random.uniform(0.01, 1), size);
    switch (random.below(5)) {
    case 0:
        return {Circle{{0, 0}, size}};
    case 1:
        return {Line{{-size, 0}, {size, 0}}};
    case 2:
        return {Edge{{size, 0}, {-size, 0}, 0}};
    case 3:
        return {Polygon{{-half, Vec2(half.x(), -half.y()), half, Vec2(-half.x(), half.y())}}};
    default:
        return {Polygon{{-half, Vec2(half.x(), -half.y()), Vec2(half.x(), 0), Vec2(-half.x(), 0)}},
                Polygon{{Vec2(-half.x(), 0), Vec2(half.x(), 0), half, Vec2(-half.x(), half.y())}}};
    }
}

struct Heard {
    int began = 0, ended = 0;
    bool inTurn = true; // never ended before it began

    void add(const World& world) {
        began += static_cast<int>(world.events().began.size());
        ended += static_cast<int>(world.events().ended.size());
        inTurn = inTurn && ended <= began;
    }
    QByteArray text() const { return QByteArray::number(began) + " begins, " + QByteArray::number(ended) + " ends"; }
};

Heard flown(World& world, int updates) {
    Heard heard;
    for (int i = 0; i < updates; ++i) {
        world.update();
        heard.add(world);
    }
    return heard;
}

/// How far shapes about the origin reach to both sides of it, m, in a direction seen from the body.
double reachAlong(const std::vector<Shape>& shapes, const Vec2& direction) {
    double reach = 0;
    const auto see = [&](const Vec2& point) { reach = std::max(reach, std::abs(direction.dot(point))); };
    for (const Shape& shape : shapes) {
        if (const auto* circle = std::get_if<Circle>(&shape)) {
            reach = std::max(reach, circle->radius);
        } else if (const auto* line = std::get_if<Line>(&shape)) {
            see(line->a);
        } else if (const auto* edge = std::get_if<Edge>(&shape)) {
            see(edge->a);
        } else {
            std::ranges::for_each(std::get<Polygon>(shape).vertices, see);
        }
    }
    return reach;
}

/// A sensor at the origin that moves with its own speed, or stands still, and something that passes it.
struct SensorPass {
    World world;
    int updates = 0;
    double speed = 0; // m/s, of each towards the other
    double reach = 0; // m, of both together across the way: two edges along it may pass beside each other
};

/// The centre of what passes comes by at the distance `aside`.
SensorPass passage(Random& random, double aside) {
    SensorPass p{World(withIterations(static_cast<int>(1 + random.below(4) * random.below(8)), {0, 0}))};
    p.speed = std::pow(10, random.uniform(-0.5, 3.5));
    const Vec2 along = Rot::fromAngle(random.uniform(-pi, pi)) * Vec2(1, 0);
    const Vec2 common(random.uniform(-50, 50), random.uniform(-50, 50));
    BodyDef sensor{.shapes = sensorShapes(random, 0.3)};
    sensor.kind = static_cast<BodyKind>(random.below(3));
    sensor.tangible = false;
    sensor.angle = random.uniform(-pi, pi);
    sensor.velocity = sensor.kind == BodyKind::Static ? Vec2(0, 0) : common;
    add(p.world, sensor);
    BodyDef body{.shapes = sensorShapes(random, random.uniform(0.01, 0.3))};
    const double start = random.uniform(1, 2 + 0.02 * p.speed);
    body.position = aside * leftOf(along) - start * along;
    body.velocity = sensor.velocity + p.speed * along;
    body.angle = random.uniform(-pi, pi);
    add(p.world, body);
    const auto across = [&](const BodyDef& def) {
        return reachAlong(def.shapes, Rot::fromAngle(def.angle).inverse() * leftOf(along));
    };
    p.reach = across(sensor) + across(body);
    p.updates = static_cast<int>((start + 1) / (0.02 * p.speed)) + 2;
    return p;
}

} // namespace

class SensorsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatPassesASensorBeginsAndEndsOnceHoweverFast() {
        for (std::uint64_t seed = 1; seed <= fullOrQuick(100000U, usualOrThin(2000U, 300U)); ++seed) {
            Random random(seed);
            const double aside = random.uniform(-0.004, 0.004);
            SensorPass p = passage(random, aside);
            const int times = p.reach > std::abs(aside) ? 1 : 0;
            const Heard heard = flown(p.world, p.updates);
            QVERIFY2(heard.began == times && heard.ended == times && heard.inTurn,
                     seedText(seed) + ": " + heard.text());
        }
    }

    void whatFliesPastASensorIsNotFelt() {
        for (std::uint64_t seed = 1; seed <= fullOrQuick(20000U, usualOrThin(500U, 100U)); ++seed) {
            Random random(seed);
            SensorPass p = passage(random, random.uniform(0.7, 0.9));
            const Heard heard = flown(p.world, p.updates);
            QVERIFY2(heard.began == 0 && heard.ended == 0, seedText(seed) + ": " + heard.text());
        }
    }

    /// With turns, which may bring the tips of a bar in and out again.
    void whatTumblesPastASensorEndsAsOftenAsItBegins() {
        for (std::uint64_t seed = 1; seed <= fullOrQuick(50000U, usualOrThin(1000U, 200U)); ++seed) {
            Random random(seed);
            SensorPass p = passage(random, 0);
            const std::vector<BodyId> bodies = p.world.bodies();
            const Vec2 velocity = p.world.body(bodies[1]).velocity;
            p.world.setVelocity(bodies[1], velocity, random.uniform(-100, 100));
            const Heard heard = flown(p.world, p.updates);
            QVERIFY2(heard.began >= 1 && heard.ended == heard.began && heard.inTurn,
                     seedText(seed) + ": " + heard.text());
        }
    }

    /// A bar of two-way wall falls flat through a level one.
    void parallelLinesFeelEachOther() {
        for (const int iterations : {1, 4, 20, 100}) {
            for (const double speed : {0.1, 1.0, 25.0, 700.0}) {
                World world(withIterations(iterations, {0, 0}));
                BodyDef zone = lineBody({-5, 0}, {5, 0});
                zone.tangible = false;
                add(world, zone);
                BodyDef bar{.shapes = {Line{{-1, 0}, {1, 0}}}, .position = {0, 0.5}, .velocity = {0, -speed}};
                add(world, bar);
                const Heard heard = flown(world, static_cast<int>(1 / (0.02 * speed)) + 2);
                QVERIFY2(heard.began == 1 && heard.ended == 1, heard.text());
            }
        }
    }

    void whatGoesBeforeASensorAndBackIsNotFelt() {
        World world(withIterations(1, {0, 0}));
        BodyDef zone = lineBody({-5, 0}, {5, 0});
        zone.tangible = false;
        add(world, zone);
        const BodyId id = add(world, box({0, 0.2 + 1e-10}, 0.2, 0.2));
        Heard heard;
        for (int i = 0; i < 100; ++i) {
            world.setVelocity(id, {0, i % 2 == 0 ? -1e-15 : 1e-15}, 0);
            world.update();
            heard.add(world);
        }
        QVERIFY2(heard.began == 0 && heard.ended == 0, heard.text());
    }

    /// The ship is made of two convex parts, one of which leaves the line first.
    void aBodyOfSeveralPartsEndsOnce() {
        for (const int iterations : {1, 4, 20}) {
            for (int k = 0; k < 200; ++k) {
                World world(withIterations(iterations, {0, 0}));
                BodyDef zone = lineBody({-50, 0}, {50, 0});
                zone.tangible = false;
                add(world, zone);
                BodyDef ship = dropped("ship", {0, 0.5 + 0.006 * k});
                ship.velocity = {0, -10};
                add(world, ship);
                const Heard heard = flown(world, 20);
                QVERIFY2(heard.began == 1 && heard.ended == 1, QByteArray::number(k) + ": " + heard.text());
            }
        }
    }

    /// What is within the depth of an edge touches it, also what comes and goes through its sides in one update.
    void whatFliesBehindAnEdgeIsFelt() {
        for (const int iterations : {1, 4, 20, 100}) {
            for (const double depth : {0.2, noBack}) {
                for (const double speed : {1.0, 20.0, 1000.0}) {
                    World world(withIterations(iterations, {0, 0}));
                    BodyDef zone = edgeBody({0.2, 0}, {-0.2, 0}, depth);
                    zone.tangible = false;
                    add(world, zone);
                    BodyDef body = ball({-1.003, 0.1}, 0.02);
                    body.velocity = {speed, 0};
                    add(world, body);
                    const Heard heard = flown(world, static_cast<int>(2 / (0.02 * speed)) + 2);
                    QVERIFY2(heard.began == 1 && heard.ended == 1, heard.text());
                }
            }
        }
    }

    void theTagsOfWhatIsPassedWithinAnIterationAreTold() {
        World world(withIterations(1, {0, 0}));
        BodyDef zone = lineBody({-5, 0}, {5, 0});
        zone.tangible = false;
        zone.filter.tags = TagMask{4};
        add(world, zone);
        BodyDef body = ball({0, 6}, 0.05);
        body.velocity = {0, -1000};
        body.reportsTouches = true;
        const BodyId id = add(world, body);
        world.update();
        QCOMPARE(world.events().tagsTouched.size(), std::size_t{1});
        QCOMPARE(world.events().tagsTouched[0].tags, TagMask{4});
        QCOMPARE(world.body(id).touchedTags, TagMask{4});
        world.update();
        QVERIFY(world.events().tagsTouched.empty());
        QCOMPARE(world.body(id).touchedTags, TagMask{});
    }
};

SPACETOW_TEST(SensorsTest)
#include "sensors_test.moc"
