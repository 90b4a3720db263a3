#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

#include "core/base/random.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Something about the origin, at most 0.6 m from it, that a path through the origin has to cross.
BodyDef zoneOf(const QString& shape) {
    if (shape == "circle") {
        return {.shapes = {Circle{{0, 0}, 0.5}}};
    }
    if (shape == "edge") {
        return {.shapes = {Edge{{0, -0.6}, {0, 0.6}, 0.1}}};
    }
    if (shape == "line") {
        return {.shapes = {Line{{0, -0.6}, {0, 0.6}}}};
    }
    if (shape == "polygon") {
        return {.shapes = {Polygon{regularPolygon(6, 0.5)}}};
    }
    if (shape == "concave polygon") {
        return {
            .shapes = {Polygon{{Vec2(-0.4, -0.4), Vec2(0.4, -0.4), Vec2(0.4, 0.4), Vec2(0, 0.1), Vec2(-0.4, 0.4)}}}};
    }
    return {.shapes = {Circle{{-0.2, 0}, 0.25}, Circle{{0.2, 0}, 0.25}, Line{{0, -0.5}, {0, 0.5}}}};
}

const char* const zones[] = {"circle", "edge", "line", "polygon", "concave polygon", "several shapes"};

struct Counts {
    int began = 0, ended = 0;

    void add(const World& world) {
        began += static_cast<int>(world.events().began.size());
        ended += static_cast<int>(world.events().ended.size());
    }
};

bool isSameMotion(const BodyState& a, const BodyState& b) {
    return a.velocity == b.velocity && a.angularVelocity == b.angularVelocity && a.massCenter == b.massCenter &&
           a.angle == b.angle;
}

} // namespace

class ZonesTest : public QObject {
    Q_OBJECT

  private slots:
    void whatCrossesAZoneBeginsAndEndsOnce_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<QString>("what");
        QTest::addColumn<int>("iterations");
        for (const char* shape : zones) {
            for (const char* what : {"ball", "box", "ship"}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s through %s, %d iterations", what, shape, iterations)
                        << shape << what << iterations;
                }
            }
        }
    }
    /// From every side, against a zone of every kind; beside it an equal body in a world without a zone.
    void whatCrossesAZoneBeginsAndEndsOnce() {
        QFETCH(QString, shape);
        QFETCH(QString, what);
        QFETCH(int, iterations);
        for (int step = 0; step < 24; ++step) {
            World world(withIterations(iterations, {0.1, -0.2}));
            World empty = world;
            BodyDef zone = zoneOf(shape);
            zone.kind = static_cast<BodyKind>(step % 3);
            zone.tangible = false;
            zone.angularVelocity = 0.5;
            const BodyId gate = add(world, zone);
            const BodyId alone = add(empty, zone);
            BodyDef def = dropped(what, {0, 0});
            const Rot turn = Rot::fromAngle(step * pi / 12 + 0.01);
            def.position = turn * Vec2(-1.5, 0.03);
            def.velocity = turn * Vec2(3, 0) + zone.velocity;
            def.angularVelocity = 1.3;
            const BodyId id = add(world, def);
            World without = empty;
            without.removeBody(alone);
            const BodyId free = add(without, def);
            Counts counts;
            for (int i = 0; i < 60; ++i) {
                world.update();
                without.update();
                empty.update();
                counts.add(world);
                for (const TouchEvent& event : world.events().began) {
                    QVERIFY(event.a == gate && event.b == id && !event.solid);
                }
                const QString where = QString("direction %1, update %2").arg(step).arg(i);
                QVERIFY2(isSameMotion(world.body(id), without.body(free)), qPrintable(where));
                QVERIFY2(isSameMotion(world.body(gate), empty.body(alone)), qPrintable(where));
            }
            QVERIFY2(
                counts.began == 1 && counts.ended == 1,
                qPrintable(QString("direction %1: %2 begins, %3 ends").arg(step).arg(counts.began).arg(counts.ended)));
        }
    }

    void aFastBodyIsFeltByWhatItCrosses_data() {
        QTest::addColumn<QString>("shape");
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("iterations");
        for (const char* shape : zones) {
            for (const double speed : {0.05, 1.0, 20.0, 50.0, 200.0, 1000.0}) {
                for (const int iterations : {4, 100}) {
                    QTest::addRow("%s at %g m/s, %d iterations", shape, speed, iterations)
                        << shape << speed << iterations;
                }
            }
        }
    }
    void aFastBodyIsFeltByWhatItCrosses() {
        QFETCH(QString, shape);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        World world(withIterations(iterations, {0, 0}));
        BodyDef zone = zoneOf(shape);
        zone.kind = BodyKind::Static;
        zone.tangible = false;
        add(world, zone);
        BodyDef def = ball({-1.5, 0.02}, 0.2);
        def.velocity = {speed, 0};
        add(world, def);
        Counts counts;
        const int updates = static_cast<int>(3 / speed / 0.02) + 2;
        for (int i = 0; i < updates; ++i) {
            world.update();
            counts.add(world);
        }
        QCOMPARE(counts.began, 1);
        QCOMPARE(counts.ended, 1);
    }

    void aBodyMayBeInSeveralZonesAtOnce() {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Random random(seed);
            World world(withIterations(20, {0, 0}));
            for (int i = 0; i < 8; ++i) {
                BodyDef zone = zoneOf(zones[random.below(6)]);
                zone.kind = BodyKind::Static;
                zone.tangible = false;
                zone.position = {random.uniform(-1, 1), random.uniform(-0.2, 0.2)};
                add(world, zone);
            }
            BodyDef def = ball({-3, 0}, 0.2);
            def.velocity = {3, 0};
            const BodyId id = add(world, def);
            std::vector<int> inside(world.bodies().size(), 0);
            for (int i = 0; i < 100; ++i) {
                world.update();
                for (const TouchEvent& event : world.events().began) {
                    QVERIFY2(event.b == id && ++inside[event.a.index] == 1, seedText(seed));
                }
                for (const TouchEvent& event : world.events().ended) {
                    QVERIFY2(event.b == id && --inside[event.a.index] == 0, seedText(seed));
                }
                QVERIFY2(world.body(id).velocity == Vec2(3, 0), seedText(seed));
            }
            QVERIFY2(std::all_of(inside.begin(), inside.end(), [](int n) { return n == 0; }), seedText(seed));
        }
    }
};

SPACETOW_TEST(ZonesTest)
#include "zones_test.moc"
