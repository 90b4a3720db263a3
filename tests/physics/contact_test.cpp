#include "core/game/ship.h"
#include "core/geometry/polygon.h"
#include "core/physics/world.h"
#include "tests/support/scenes.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double pi = std::numbers::pi;

UpdateParameters withIterations(int iterations, const Vec2& gravity = {0, -9.81}) {
    return {.gravity = gravity, .iterations = iterations};
}

void run(World& world, double seconds) {
    const int updates = static_cast<int>(std::lround(seconds / world.parameters().seconds));
    for (int i = 0; i < updates; ++i) {
        world.update();
    }
}

BodyDef hexagon(const Vec2& at) {
    return {.shapes = {Polygon{regularPolygon(6, 0.25)}}, .position = at};
}

BodyDef dropped(const QString& what, const Vec2& at) {
    if (what == "ball") {
        return ball(at, 0.2);
    }
    if (what == "box") {
        return box(at, 0.2, 0.2);
    }
    if (what == "hexagon") {
        return hexagon(at);
    }
    BodyDef ship = shipBody(at, 0);
    ship.filter = {};
    ship.linearDamping = ship.angularDamping = 0;
    ship.restitution = 0;
    return ship;
}

/// The lowest point of a body's shapes, world coordinates.
double lowestPoint(const World& world, BodyId id) {
    double lowest = std::numeric_limits<double>::infinity();
    const Transform pose = world.body(id).pose;
    for (const Shape& shape : world.shapes(id)) {
        if (const auto* circle = std::get_if<Circle>(&shape)) {
            lowest = std::min(lowest, pose.toWorld(circle->center).y() - circle->radius);
        } else {
            for (const Vec2& v : std::get<Polygon>(shape).vertices) {
                lowest = std::min(lowest, pose.toWorld(v).y());
            }
        }
    }
    return lowest;
}

/// A static floor at y = 0 made of the given shape.
BodyDef floorOf(const QString& shape) {
    if (shape == "edge") {
        return edgeBody({-20, 0}, {20, 0});
    }
    if (shape == "thin edge") {
        return edgeBody({-20, 0}, {20, 0}, 0);
    }
    if (shape == "line") {
        return lineBody({-20, 0}, {20, 0});
    }
    BodyDef floor = box({0, -1}, 20, 1);
    floor.kind = BodyKind::Static;
    return floor;
}

const char* const floors[] = {"edge", "thin edge", "line", "polygon"};
const int iterationCounts[] = {4, 20, 100};

} // namespace

class ContactTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsDroppedComesToRestOnTheSurface_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<QString>("floor");
        QTest::addColumn<int>("iterations");
        for (const char* what : {"ball", "box", "hexagon", "ship"}) {
            for (const char* floor : floors) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s on %s, %d iterations", what, floor, iterations) << what << floor << iterations;
                }
            }
        }
    }
    void whatIsDroppedComesToRestOnTheSurface() {
        QFETCH(QString, what);
        QFETCH(QString, floor);
        QFETCH(int, iterations);
        for (int step = 0; step < 24; step += 5) {
            World world(withIterations(iterations));
            add(world, floorOf(floor));
            BodyDef def = dropped(what, {0, 1});
            def.angle = step * pi / 12;
            const BodyId id = add(world, def);
            run(world, 3);
            for (int i = 0; i < 100; ++i) {
                world.update();
                const double lowest = lowestPoint(world, id);
                QVERIFY2(std::abs(lowest) < 0.005,
                         qPrintable(QString("start angle %1°: lowest point %2").arg(step * 15).arg(lowest)));
            }
            const BodyState state = world.body(id);
            QVERIFY2(state.velocity.norm() < 0.005 && std::abs(state.angularVelocity) < 0.02,
                     qPrintable(QString("start angle %1°: speed %2, spin %3")
                                    .arg(step * 15)
                                    .arg(state.velocity.norm())
                                    .arg(state.angularVelocity)));
        }
    }

    void mirroredStartsEndMirrored_data() {
        QTest::addColumn<QString>("what");
        for (const char* what : {"ball", "box", "hexagon", "ship"}) {
            QTest::newRow(what) << what;
        }
    }
    void mirroredStartsEndMirrored() {
        QFETCH(QString, what);
        for (int step = 1; step < 24; step += 3) {
            BodyState ends[2];
            for (const int side : {0, 1}) {
                World world(withIterations(20));
                add(world, floorOf("edge"));
                BodyDef def = dropped(what, {0, 0.6});
                def.angle = (side == 0 ? 1 : -1) * (step * pi / 12 + 0.1);
                const BodyId id = add(world, def);
                run(world, 3);
                ends[side] = world.body(id);
            }
            QVERIFY2(std::abs(ends[0].pose.position.x() + ends[1].pose.position.x()) < 1e-3,
                     qPrintable(QString("%1 %2").arg(ends[0].pose.position.x()).arg(ends[1].pose.position.x())));
            QVERIFY(std::abs(std::remainder(ends[0].angle + ends[1].angle, 2 * pi)) < 1e-2);
        }
    }

    void aBallBouncesToItsShareOfTheHeight_data() {
        QTest::addColumn<QString>("floor");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<int>("iterations");
        for (const char* floor : floors) {
            for (const double e : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s, e %g, %d iterations", floor, e, iterations) << floor << e << iterations;
                }
            }
        }
    }
    void aBallBouncesToItsShareOfTheHeight() {
        QFETCH(QString, floor);
        QFETCH(double, restitution);
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef ground = floorOf(floor);
        ground.restitution = restitution;
        add(world, ground);
        BodyDef def = ball({0, 1.2}, 0.2);
        def.restitution = restitution;
        const BodyId id = add(world, def);
        double before = 0;
        double peak = 0;
        bool rising = false;
        bool bounced = false;
        for (int i = 0; i < 200; ++i) {
            world.update();
            const double speed = world.body(id).velocity.y();
            rising = speed > 0;
            bounced |= rising && before <= 0;
            if (bounced && !rising) {
                break;
            }
            // The peak lies between two updates; v²/2g from here is exact in free flight.
            peak = rising ? world.body(id).pose.position.y() - 0.2 + speed * speed / (2 * 9.81) : peak;
            before = speed;
        }
        const double expected = restitution * restitution;
        QVERIFY2(std::abs(peak - expected) <= 0.01 * expected + 1e-3, qPrintable(QString::number(peak)));
    }

    void anElasticBallKeepsItsEnergyForAMinute_data() {
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            QTest::addRow("%d iterations", iterations) << iterations;
        }
    }
    void anElasticBallKeepsItsEnergyForAMinute() {
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        BodyDef ground = floorOf("edge");
        ground.restitution = 1;
        add(world, ground);
        BodyDef def = ball({0, 1.2}, 0.2);
        def.restitution = 1;
        const BodyId id = add(world, def);
        const auto energy = [&] {
            return 0.5 * world.body(id).velocity.squaredNorm() + 9.81 * (world.body(id).pose.position.y() - 0.2);
        };
        const double start = energy();
        for (int i = 0; i < 3000; ++i) {
            world.update();
            QVERIFY2(std::abs(energy() / start - 1) < 0.01, qPrintable(QString::number(energy() / start)));
        }
    }

    void circlesCollideElasticallyFromEveryAngle_data() {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("offset");
        for (const double speed : {0.1, 1.0, 10.0, 100.0}) {
            for (const double offset : {0.0, 0.3, 0.6, 0.9}) {
                QTest::addRow("%g m/s, offset %g", speed, offset) << speed << offset;
            }
        }
    }
    void circlesCollideElasticallyFromEveryAngle() {
        QFETCH(double, speed);
        QFETCH(double, offset);
        for (int degrees = 0; degrees < 360; degrees += 5) {
            World world(withIterations(4, {0, 0}));
            const Rot turn = Rot::fromAngle(degrees * pi / 180);
            BodyDef a = ball(turn * Vec2(-1.5, offset * 0.5), 0.2);
            a.velocity = turn * Vec2(speed, 0);
            a.restitution = 1;
            a.friction = 0;
            BodyDef b = ball({0, 0}, 0.3);
            b.restitution = 1;
            b.friction = 0;
            const BodyId idA = add(world, a);
            const BodyId idB = add(world, b);
            const double massA = world.body(idA).mass;
            const double massB = world.body(idB).mass;
            run(world, 3 / speed < 0.02 ? 0.06 : 3 / speed);
            const BodyState sa = world.body(idA);
            const BodyState sb = world.body(idB);
            const QString where = QString("%1°").arg(degrees);
            QVERIFY2(sb.velocity.norm() > 0.01 * speed, qPrintable(where + " missed"));
            const Vec2 momentum = massA * sa.velocity + massB * sb.velocity;
            QVERIFY2((momentum - massA * a.velocity).norm() < 1e-9 * massA * speed, qPrintable(where));
            const double energy = massA * sa.velocity.squaredNorm() + massB * sb.velocity.squaredNorm();
            QVERIFY2(std::abs(energy / (massA * speed * speed) - 1) < 1e-6,
                     qPrintable(where + QString(" %1").arg(energy / (massA * speed * speed))));
            const double angular =
                massA * cross(sa.massCenter, sa.velocity) + massB * cross(sb.massCenter, sb.velocity);
            const double expected = massA * cross(a.position, a.velocity);
            QVERIFY2(std::abs(angular - expected) < 1e-9 * massA * speed,
                     qPrintable(where + QString(" %1").arg(angular - expected)));
        }
    }

    void aBallOnASlopeRolls_data() {
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            QTest::addRow("%d iterations", iterations) << iterations;
        }
    }
    void aBallOnASlopeRolls() {
        QFETCH(int, iterations);
        const double slope = 20 * pi / 180;
        World world(withIterations(iterations));
        const Rot turn = Rot::fromAngle(-slope);
        BodyDef ground = edgeBody(turn * Vec2(-5, 0), turn * Vec2(100, 0));
        ground.friction = 1;
        add(world, ground);
        BodyDef def = ball(turn * Vec2(0, 0.2), 0.2);
        def.friction = 1;
        const BodyId id = add(world, def);
        run(world, 2);
        const BodyState state = world.body(id);
        const double speed = state.velocity.norm();
        QVERIFY(std::abs(speed / (2 * 9.81 * std::sin(slope) / 1.5) - 1) < 0.01);
        QVERIFY(std::abs(-state.angularVelocity * 0.2 / speed - 1) < 0.01);
    }

    void aBoxOnASlopeHoldsOrSlidesAsFrictionSays_data() {
        QTest::addColumn<double>("friction");
        QTest::addColumn<int>("iterations");
        for (const double friction : {0.0, 0.1, 0.3, 0.5}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("friction %g, %d iterations", friction, iterations) << friction << iterations;
            }
        }
    }
    void aBoxOnASlopeHoldsOrSlidesAsFrictionSays() {
        QFETCH(double, friction);
        QFETCH(int, iterations);
        const double slope = 20 * pi / 180; // tan = 0.364
        World world(withIterations(iterations));
        const Rot turn = Rot::fromAngle(-slope);
        BodyDef ground = edgeBody(turn * Vec2(-5, 0), turn * Vec2(100, 0));
        ground.friction = friction;
        add(world, ground);
        BodyDef def = box(turn * Vec2(0, 0.2), 0.4, 0.2);
        def.angle = -slope;
        def.friction = friction;
        const BodyId id = add(world, def);
        run(world, 2);
        const double speed = world.body(id).velocity.norm();
        const double expected = 2 * 9.81 * std::max(std::sin(slope) - friction * std::cos(slope), 0.0);
        QVERIFY2(std::abs(speed - expected) <= 0.02 * expected + 0.01,
                 qPrintable(QString("%1, expected %2").arg(speed).arg(expected)));
    }

    void nothingFallsThroughAWedge_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<QString>("walls");
        for (const char* what : {"ball", "box", "ship"}) {
            for (const double e : {0.0, 0.5, 1.0}) {
                for (const char* walls : {"edges", "lines", "polygons"}) {
                    QTest::addRow("%s, e %g, %s", what, e, walls) << what << e << walls;
                }
            }
        }
    }
    void nothingFallsThroughAWedge() {
        QFETCH(QString, what);
        QFETCH(double, restitution);
        QFETCH(QString, walls);
        for (int opening = 10; opening <= 170; opening += 20) {
            for (const double shot : {0.0, 50.0}) {
                World world(withIterations(4));
                const double half = opening * pi / 360;
                const Vec2 left(-20 * std::sin(half), 20 * std::cos(half));
                const Vec2 right(20 * std::sin(half), 20 * std::cos(half));
                BodyDef wedge{.kind = BodyKind::Static};
                if (walls == "edges") {
                    wedge.shapes = {Edge{left, {0, 0}}, Edge{{0, 0}, right}};
                } else if (walls == "lines") {
                    wedge.shapes = {Line{left, {0, 0}}, Line{{0, 0}, right}};
                } else {
                    wedge.shapes = {Polygon{{left, left + Vec2(-1, -1), Vec2(0, -1), Vec2(0, 0)}},
                                    Polygon{{Vec2(0, 0), Vec2(0, -1), right + Vec2(1, -1), right}}};
                }
                wedge.restitution = restitution;
                add(world, wedge);
                BodyDef def = dropped(what, {0.02, 6});
                def.restitution = restitution;
                def.velocity = {0, -shot};
                const BodyId id = add(world, def);
                for (int i = 0; i < 500; ++i) {
                    world.update();
                    const Vec2 at = world.body(id).massCenter;
                    const bool inside = at.y() > std::abs(at.x()) / std::tan(half) - 0.1 || at.norm() > 19;
                    QVERIFY2(inside, qPrintable(QString("opening %1°, shot %2 m/s, update %3: at (%4, %5)")
                                                    .arg(opening)
                                                    .arg(shot)
                                                    .arg(i)
                                                    .arg(at.x())
                                                    .arg(at.y())));
                    if (at.norm() > 19) {
                        break;
                    }
                }
            }
        }
    }

    void bulletsNeverPassThrough_data() {
        QTest::addColumn<QString>("target");
        for (const char* target : {"edge without depth", "line", "thin polygon", "circle"}) {
            QTest::newRow(target) << target;
        }
    }
    void bulletsNeverPassThrough() {
        QFETCH(QString, target);
        for (const double speed : {1.0, 10.0, 100.0, 1000.0}) {
            for (int k = 0; k < 40; ++k) {
                World world(withIterations(k % 2 == 0 ? 4 : 20, {0, 0}));
                BodyDef wall = edgeBody({-3, 0}, {3, 0}, 0);
                if (target == "line") {
                    wall = lineBody({-3, 0}, {3, 0});
                } else if (target == "thin polygon") {
                    wall = box({0, -0.005}, 3, 0.005);
                } else if (target == "circle") {
                    wall = ball({0, -1}, 1);
                }
                wall.kind = BodyKind::Static;
                add(world, wall);
                BodyDef bullet = ball({0, 0.3 + 0.037 * k}, 0.05);
                bullet.velocity = {0.02 * speed, -speed};
                bullet.restitution = 0.5;
                const BodyId id = add(world, bullet);
                run(world, 2 / speed + 0.04);
                QVERIFY2(
                    world.body(id).massCenter.y() > 0,
                    qPrintable(QString("%1 m/s, shot %2: y %3").arg(speed).arg(k).arg(world.body(id).massCenter.y())));
                QVERIFY(world.body(id).velocity.y() > -0.5 * speed);
            }
        }
    }

    void anEdgeIsOneWay() {
        // From behind it lets pass; from the front it stops.
        World world(withIterations(20, {0, 0}));
        add(world, edgeBody({-5, 0}, {5, 0}, 0.1));
        BodyDef rising = ball({-2, -1}, 0.2);
        rising.velocity = {0, 2};
        BodyDef falling = ball({2, 1}, 0.2);
        falling.velocity = {0, -2};
        const BodyId up = add(world, rising);
        const BodyId down = add(world, falling);
        run(world, 2);
        QVERIFY2(world.body(up).massCenter.y() > 2.5, qPrintable(QString::number(world.body(up).massCenter.y())));
        QVERIFY(world.body(down).massCenter.y() > 0.19);
    }

    void aFreeEndStopsABall_data() {
        QTest::addColumn<Vec2>("start");
        QTest::newRow("at a") << Vec2(-3, 0);
        QTest::newRow("at b") << Vec2(3, 0);
    }
    void aFreeEndStopsABall() {
        QFETCH(Vec2, start);
        World world(withIterations(20, {0, 0}));
        add(world, edgeBody({-1, 0}, {1, 0}, 0.1));
        BodyDef def = ball(start, 0.2);
        def.velocity = -start;
        def.restitution = 1;
        const BodyId id = add(world, def);
        run(world, 1);
        QVERIFY(world.body(id).velocity.x() * start.x() >= 0);
        QVERIFY(std::abs(world.body(id).massCenter.x()) > 1.19);
    }

    void aBallRollsOverJointsAsOverOneWall_data() {
        QTest::addColumn<QString>("walls");
        for (const char* walls : {"edges", "lines", "boxes"}) {
            QTest::newRow(walls) << walls;
        }
    }
    void aBallRollsOverJointsAsOverOneWall() {
        QFETCH(QString, walls);
        for (const bool round : {true, false}) {
            double speeds[2];
            for (const int pieces : {1, 1000}) {
                World world(withIterations(4));
                for (int i = 0; i < pieces; ++i) {
                    const Vec2 a(-5 + 100.0 * i / pieces, 0);
                    const Vec2 b(-5 + 100.0 * (i + 1) / pieces, 0);
                    BodyDef piece = walls == "edges" ? edgeBody(a, b) : lineBody(a, b);
                    if (walls == "boxes") {
                        piece.shapes = {Polygon{{a, a - Vec2(0, 1), b - Vec2(0, 1), b}}};
                    }
                    piece.friction = 0;
                    add(world, piece);
                }
                BodyDef def = round ? ball({0, 0.2}, 0.2) : box({0, 0.2}, 0.2, 0.2);
                def.velocity = {5, 0};
                const BodyId id = add(world, def);
                double hop = 0;
                for (int i = 0; i < 500; ++i) {
                    world.update();
                    hop = std::max(hop, std::abs(world.body(id).velocity.y()));
                }
                QVERIFY2(hop < 1e-3, qPrintable(QString("%1 pieces: hop %2").arg(pieces).arg(hop)));
                speeds[pieces == 1 ? 0 : 1] = world.body(id).velocity.x();
            }
            QVERIFY2(std::abs(speeds[1] / speeds[0] - 1) < 1e-3, qPrintable(QString::number(speeds[1] / speeds[0])));
        }
    }

    void aStackOfTenBoxesStands_data() {
        QTest::addColumn<int>("iterations");
        for (const int iterations : iterationCounts) {
            QTest::addRow("%d iterations", iterations) << iterations;
        }
    }
    void aStackOfTenBoxesStands() {
        QFETCH(int, iterations);
        World world(withIterations(iterations));
        add(world, floorOf("edge"));
        std::vector<BodyId> boxes;
        for (int i = 0; i < 10; ++i) {
            BodyDef def = box({0, 0.5 + i}, 0.5, 0.5);
            def.friction = 0.6;
            boxes.push_back(add(world, def));
        }
        run(world, 20);
        for (int i = 0; i < 10; ++i) {
            const Vec2 at = world.body(boxes[static_cast<std::size_t>(i)]).massCenter;
            QVERIFY2((at - Vec2(0, 0.5 + i)).norm() < 0.02,
                     qPrintable(QString("box %1 at (%2, %3)").arg(i).arg(at.x()).arg(at.y())));
        }
    }

    void aPyramidStands() {
        World world(withIterations(4));
        add(world, floorOf("edge"));
        std::vector<std::pair<BodyId, Vec2>> boxes;
        for (int row = 0; row < 20; ++row) {
            for (int column = row; column < 20; ++column) {
                BodyDef def = box({1.1 * (column - row) + 0.55 * row - 11, 0.5 + row}, 0.5, 0.5);
                def.friction = 0.6;
                boxes.emplace_back(add(world, def), def.position);
            }
        }
        run(world, 10);
        for (const auto& [id, at] : boxes) {
            QVERIFY2((world.body(id).massCenter - at).norm() < 0.02,
                     qPrintable(QString("%1").arg((world.body(id).massCenter - at).norm())));
        }
    }

    void aRisingPlatformCarriesABall() {
        World world(withIterations(20));
        BodyDef platform = floorOf("edge");
        platform.kind = BodyKind::Kinematic;
        platform.velocity = {0, 0.5};
        const BodyId base = add(world, platform);
        const BodyId id = add(world, ball({0, 0.2}, 0.2));
        run(world, 2);
        QVERIFY(std::abs(world.body(base).pose.position.y() - 1) < 1e-9);
        QVERIFY(std::abs(world.body(id).massCenter.y() - 1.2) < 0.005);
    }

    void aKinematicCircleSendsAStillBallOffAtTwiceItsSpeed() {
        for (const double mass : {0.5, 5.0, 500.0}) {
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
            QVERIFY(std::abs(world.body(id).velocity.x() - 2) < 1e-9);
        }
    }

    void aFrozenBodyIsAWallToWhatHitsIt() {
        World world(withIterations(20, {0, 0}));
        BodyDef still = ball({0, 0}, 0.2);
        still.positionFrozen = still.rotationFrozen = true;
        still.restitution = 1;
        const BodyId frozen = add(world, still);
        BodyDef def = ball({-1, 0}, 0.2);
        def.velocity = {2, 0};
        def.restitution = 1;
        const BodyId id = add(world, def);
        run(world, 1);
        QVERIFY(std::abs(world.body(id).velocity.x() + 2) < 1e-9);
        QCOMPARE(world.body(frozen).massCenter.x(), 0.0);
        world.setFrozen(frozen, false);
        world.setVelocity(frozen, {0, 1}, 0);
        run(world, 0.1);
        QVERIFY(world.body(frozen).velocity.y() == 0); // the velocity was set while it was still frozen
        world.setVelocity(frozen, {0, 1}, 0);
        run(world, 0.1);
        QVERIFY(world.body(frozen).massCenter.y() > 0.09);
    }

    void anIntangibleBodyIsFeltOnceAndChangesNoVelocity() {
        World world(withIterations(20, {0, 0}));
        BodyDef zone = lineBody({0, -1}, {0, 1});
        zone.tangible = false;
        const BodyId gate = add(world, zone);
        BodyDef def = ball({-1, 0}, 0.2);
        def.velocity = {1, 0.1};
        def.reportsTouches = true;
        const BodyId id = add(world, def);
        int began = 0;
        int ended = 0;
        int reports = 0;
        for (int i = 0; i < 100; ++i) {
            world.update();
            began += static_cast<int>(world.events().began.size());
            ended += static_cast<int>(world.events().ended.size());
            reports += static_cast<int>(world.events().tagsTouched.size());
            for (const TouchEvent& event : world.events().began) {
                QVERIFY(event.a == gate && event.b == id && !event.solid);
            }
        }
        QCOMPARE(began, 1);
        QCOMPARE(ended, 1);
        QVERIFY(reports > 300 && reports < 500); // 0.4 s of 1,000 iterations a second
        QCOMPARE(world.body(id).velocity.x(), 1.0);
        QCOMPARE(world.body(id).velocity.y(), 0.1);
        QCOMPARE(world.body(id).touchedTags.bits, 0u);
    }

    void aPairMeetsWhenEachTouchesTheOthersTags() {
        for (int bit = 0; bit < 32; ++bit) {
            for (const bool mutual : {true, false}) {
                World world(withIterations(4, {0, -10}));
                BodyDef ground = floorOf("edge");
                ground.filter = {TagMask::bit(bit), TagMask::bit(3)};
                add(world, ground);
                BodyDef def = ball({0, 0.3}, 0.2);
                def.filter = {TagMask::bit(3), mutual ? TagMask::bit(bit) : TagMask::bit((bit + 1) % 32)};
                const BodyId id = add(world, def);
                run(world, 1);
                QCOMPARE(world.body(id).massCenter.y() > 0, mutual);
            }
        }
    }

    void staticBodiesMayBeMovedAndRemoved() {
        World world(withIterations(20));
        const BodyId ground = add(world, floorOf("edge"));
        const BodyId id = add(world, ball({0, 0.2}, 0.2));
        run(world, 1);
        world.setPose(ground, {0, -1}, 0);
        run(world, 2);
        QVERIFY(std::abs(world.body(id).massCenter.y() + 0.8) < 0.005);
        world.removeBody(ground);
        run(world, 1);
        QVERIFY(world.body(id).massCenter.y() < -4);
        QCOMPARE(world.bodyCount(), 1);
    }

    void aBallReachesTheShipsNotch() {
        World world(withIterations(20));
        BodyDef ship = shipBody({0, 0}, pi); // upside down, so that the notch opens upwards
        ship.kind = BodyKind::Static;
        ship.filter = {};
        add(world, ship);
        const BodyId id = add(world, ball({0, 0.5}, 0.02));
        run(world, 2);
        const double notch = -shipNotch().y();
        const double expected = notch + 0.02 / std::sin(std::atan2(0.2, 0.1)); // resting on both flanks
        QVERIFY2(std::abs(world.body(id).massCenter.y() - expected) < 0.005,
                 qPrintable(QString("%1, expected %2").arg(world.body(id).massCenter.y()).arg(expected)));
    }

    void aPileSettlesAndStaysSettled() {
        World world(withIterations(4));
        add(world, edgeBody({-2, 5}, {-2, 0}));
        add(world, edgeBody({-2, 0}, {2, 0}));
        add(world, edgeBody({2, 0}, {2, 5}));
        for (int i = 0; i < 60; ++i) {
            const Vec2 at(-1.5 + 0.4 * (i % 8), 0.3 + 0.5 * (i / 8));
            add(world, i % 2 == 0 ? ball(at, 0.15) : box(at, 0.15, 0.12));
        }
        const double start = world.energy();
        for (int i = 0; i < 400; ++i) {
            world.update();
            QVERIFY2(world.energy() <= start, qPrintable(QString("update %1: %2").arg(i).arg(world.energy())));
        }
        const double settled = world.energy();
        for (int i = 0; i < 200; ++i) {
            world.update();
            QVERIFY2(std::abs(world.energy() / settled - 1) < 1e-3, qPrintable(QString("update %1").arg(i)));
        }
    }
};

SPACETOW_TEST(ContactTest)
#include "contact_test.moc"
