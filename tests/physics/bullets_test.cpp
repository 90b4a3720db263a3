#include "tests/support/contact_scenes.h"

#include "core/base/random.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double bulletRadius = 0.05;
const char* const targets[] = {"edge without depth", "line", "thin polygon", "circle"};

/// A target whose surface passes the origin and looks along the turned y axis, 3 m to either side.
BodyDef targetOf(const QString& target, const Rot& turn, BodyKind kind) {
    BodyDef wall = edgeBody({-3, 0}, {3, 0}, 0);
    if (target == "line") {
        wall = lineBody({-3, 0}, {3, 0});
    } else if (target == "thin polygon") {
        wall = box({0, 0}, 3, 0.005);
        wall.position = turn * Vec2(0, -0.005);
    } else if (target == "circle") {
        wall = ball(turn * Vec2(0, -1), 1);
    }
    wall.kind = kind;
    wall.angle = turn.angle();
    return wall;
}

struct Shot {
    QString target;
    Vec2 normal{0, 1};   // of the surface where the bullet meets it, in the target's coordinates
    double along = 0;    // where on a straight target, m from its middle
    Vec2 way{0, -1};     // unit, there; downwards
    double distance = 1; // that the bullet flies
    double speed = 1;    // m/s
    double restitution = 0.5;
    double friction = 0.3;
    double turn = 0; // of the whole scene, rad
    int iterations = 4;
};

/// An empty text when the bullet hit and stayed on its side.
QString whatIsWrong(const Shot& shot) {
    World world(withIterations(shot.iterations, {0, 0}));
    const Rot turn = Rot::fromAngle(shot.turn);
    BodyDef wall = targetOf(shot.target, turn, BodyKind::Static);
    wall.restitution = shot.restitution;
    wall.friction = shot.friction;
    add(world, wall);
    const Vec2 impact =
        shot.target == "circle" ? Vec2(Vec2(0, -1) + (1 + bulletRadius) * shot.normal) : Vec2(shot.along, bulletRadius);
    BodyDef bullet = ball(turn * (impact - shot.way * shot.distance), bulletRadius);
    bullet.velocity = turn * Vec2(shot.way * shot.speed);
    bullet.restitution = shot.restitution;
    bullet.friction = shot.friction;
    const BodyId id = add(world, bullet);
    bool touched = false;
    const int updates = static_cast<int>(std::ceil(shot.distance / shot.speed / 0.02)) + 3;
    for (int i = 0; i < updates; ++i) {
        world.update();
        touched = touched || !world.events().began.empty();
        const Vec2 at = turn.inverse() * world.body(id).massCenter;
        const bool behind = shot.target == "circle" ? (at - Vec2(0, -1)).norm() < 1 + 0.5 * bulletRadius
                                                    : std::abs(at.x()) < 3 && at.y() < 0.5 * bulletRadius;
        if (behind) {
            return QString("behind the surface at (%1, %2)").arg(at.x()).arg(at.y());
        }
    }
    const double left = -(turn * shot.normal).dot(world.body(id).velocity);
    if (!touched || left > -0.5 * shot.speed * shot.way.dot(shot.normal)) {
        return QString("%1, still approaching at %2").arg(touched ? "touched" : "not touched").arg(left);
    }
    return {};
}

/// The place of a hit, `share` of the way from the target's middle to where it ends.
void aimAt(Shot& shot, double share) {
    if (shot.target == "circle") {
        shot.normal = {share, std::sqrt(1 - share * share)};
    } else {
        shot.along = 3 * share;
    }
}

} // namespace

class BulletsTest : public QObject {
    Q_OBJECT

  private slots:
    void bulletsNeverPassThrough_data() {
        QTest::addColumn<QString>("target");
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("iterations");
        for (const char* target : targets) {
            for (const double speed : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s, %g m/s, %d iterations", target, speed, iterations)
                        << target << speed << iterations;
                }
            }
        }
    }
    void bulletsNeverPassThrough() {
        QFETCH(QString, target);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        for (int k = 0; k < fullOrQuick(200, 20); ++k) {
            Shot shot{.target = target,
                      .distance = 0.3 + 0.0371 * (k % 40),
                      .speed = speed,
                      .restitution = 0.25 * (k % 5),
                      .turn = 0.1 * k,
                      .iterations = iterations};
            aimAt(shot, -0.9 + 1.8 * std::fmod(0.618 * k, 1));
            const QString wrong = whatIsWrong(shot);
            QVERIFY2(wrong.isEmpty(), qPrintable(QString("shot %1: %2").arg(k).arg(wrong)));
        }
    }

    void randomShotsNeverPassThrough() {
        constexpr std::uint64_t seed = 20240613;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (int k = 0; k < fullOrQuick(10000, 1000); ++k) {
            Shot shot;
            shot.target = targets[random.below(4)];
            aimAt(shot, random.uniform(-0.9, 0.9));
            const double slant = random.uniform(-80, 80) * pi / 180; // from the normal
            shot.way = Rot::fromAngle(slant) * -shot.normal;
            shot.speed = std::pow(10, random.uniform(0, 3));
            shot.distance = random.uniform(0.4, 2);
            shot.restitution = random.unit();
            shot.friction = random.unit();
            shot.turn = random.uniform(-pi, pi);
            shot.iterations = iterationCounts[random.below(static_cast<std::uint32_t>(iterationCounts.size()))];
            const QString wrong = whatIsWrong(shot);
            QVERIFY2(wrong.isEmpty(), qPrintable(QString("shot %1 at the %2, %3 m/s, %4 rad aslant, %5 iterations: %6")
                                                     .arg(k)
                                                     .arg(shot.target)
                                                     .arg(shot.speed)
                                                     .arg(slant)
                                                     .arg(shot.iterations)
                                                     .arg(wrong)));
        }
    }

    void aSpinningRodNeverPassesAPeg_data() {
        QTest::addColumn<bool>("held");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<int>("iterations");
        for (const bool held : {false, true}) {
            for (const double e : {0.0, 0.5, 1.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s, e %g, %d iterations", held ? "held in the middle" : "free", e, iterations)
                        << held << e << iterations;
                }
            }
        }
    }
    void aSpinningRodNeverPassesAPeg() {
        QFETCH(bool, held);
        QFETCH(double, restitution);
        QFETCH(int, iterations);
        for (int k = 0; k < fullOrQuick(60, 12); ++k) {
            World world(withIterations(iterations, {0, 0}));
            BodyDef rod = box({0, 0}, 5, 0.05);
            rod.angularVelocity = 100;
            rod.positionFrozen = held;
            rod.restitution = restitution;
            const BodyId id = add(world, rod);
            const double angle = 0.4 + pi * 0.8 * std::fmod(0.618 * k, 1);
            BodyDef peg = ball(Rot::fromAngle(angle) * Vec2(1 + 3.9 * std::fmod(0.414 * k, 1), 0), bulletRadius);
            peg.kind = BodyKind::Static;
            peg.restitution = restitution;
            add(world, peg);
            bool touched = false;
            for (int i = 0; i < 5 && !touched; ++i) {
                world.update();
                touched = !world.events().began.empty();
                const Vec2 seen = world.body(id).pose.toLocal(peg.position);
                QVERIFY2(seen.y() > 0, qPrintable(QString("peg %1, update %2: %3 past").arg(k).arg(i).arg(-seen.y())));
            }
            QVERIFY2(touched, qPrintable(QString("peg %1: not touched").arg(k)));
        }
    }

    void aRodThatTouchesWithOneEndStopsAtTheOther_data() {
        QTest::addColumn<double>("spin");
        QTest::addColumn<double>("angle");
        QTest::addColumn<int>("iterations");
        for (const double spin : {10.0, 30.0, 100.0}) {
            for (const double angle : {0.1, 0.3}) {
                for (const int iterations : {1, 4, 20, 100}) {
                    QTest::addRow("%g rad/s from %g rad, %d iterations", spin, angle, iterations)
                        << spin << angle << iterations;
                }
            }
        }
    }
    void aRodThatTouchesWithOneEndStopsAtTheOther() {
        QFETCH(double, spin);
        QFETCH(double, angle);
        QFETCH(int, iterations);
        World world(withIterations(iterations, {0, 0}));
        add(world, lineBody({-30, 0}, {30, 0}));
        BodyDef rod = box({0, 0}, 2, 0.05);
        rod.angle = angle;
        rod.position = -(Rot::fromAngle(angle) * Vec2(-2, -0.05)); // the corner is on the wall and stands still
        rod.angularVelocity = -spin;
        rod.velocity = cross(-spin, rod.position);
        const BodyId id = add(world, rod);
        for (int i = 0; i < 100; ++i) {
            world.update();
            const Vec2 at = world.body(id).massCenter;
            QVERIFY2(at.y() > 0, qPrintable(QString("update %1: at %2").arg(i).arg(at.y())));
        }
    }

    void aRodShotAtAWallStaysInFront_data() {
        QTest::addColumn<QString>("walls");
        QTest::addColumn<double>("speed");
        QTest::addColumn<int>("iterations");
        for (const char* walls : {"edge without depth", "line", "thin polygon"}) {
            for (const double speed : {30.0, 75.0, 200.0}) {
                for (const int iterations : iterationCounts) {
                    QTest::addRow("%s, %g m/s, %d iterations", walls, speed, iterations)
                        << walls << speed << iterations;
                }
            }
        }
    }
    void aRodShotAtAWallStaysInFront() {
        QFETCH(QString, walls);
        QFETCH(double, speed);
        QFETCH(int, iterations);
        constexpr std::uint64_t seed = 20240614;
        Random random(seed);
        for (int k = 0; k < fullOrQuick(2000, 100); ++k) {
            World world(withIterations(iterations, {0, 0}));
            for (const double x : {-3.0, 3.0}) {
                BodyDef wall = targetOf(walls, Rot{}, BodyKind::Static);
                wall.position += Vec2(x, 0);
                wall.restitution = 0;
                add(world, wall);
            }
            BodyDef rod = box({0, random.uniform(2.1, 4)}, 2, 0.05);
            rod.angle = random.uniform(-pi, pi);
            rod.velocity = {0, -speed};
            rod.angularVelocity = random.uniform(-30, 30);
            rod.restitution = 0;
            const BodyId id = add(world, rod);
            for (int i = 0; i < 10; ++i) {
                world.update();
                const Vec2 at = world.body(id).massCenter;
                QVERIFY2(at.y() > 0 || std::abs(at.x()) > 4,
                         seedText(seed) + QByteArray(", rod ") + QByteArray::number(k) + ", update " +
                             QByteArray::number(i) + ": at " + QByteArray::number(at.y()));
            }
        }
    }

    void aSpinningRodStaysInItsRoom_data() {
        QTest::addColumn<QString>("walls");
        QTest::addColumn<int>("iterations");
        for (const char* walls : {"edge without depth", "line", "thin polygon"}) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%s, %d iterations", walls, iterations) << walls << iterations;
            }
        }
    }
    void aSpinningRodStaysInItsRoom() {
        QFETCH(QString, walls);
        QFETCH(int, iterations);
        for (int k = 0; k < fullOrQuick(40, 8); ++k) {
            World world(withIterations(iterations, {0, 0}));
            for (int side = 0; side < 4; ++side) {
                const Rot turn = Rot::fromAngle(side * pi / 2);
                BodyDef wall = targetOf(walls, turn, BodyKind::Static);
                wall.position += turn * Vec2(0, -3);
                wall.restitution = 0.5;
                add(world, wall);
            }
            BodyDef rod = box({0.2 * (k % 5), 0.1 * (k % 3)}, 2, 0.05);
            rod.angle = 0.37 * k;
            rod.velocity = Rot::fromAngle(k) * Vec2(10 * (k % 7), 0);
            rod.angularVelocity = 100;
            rod.restitution = 0.25 * (k % 5);
            const BodyId id = add(world, rod);
            int touches = 0;
            for (int i = 0; i < 200; ++i) {
                world.update();
                touches += static_cast<int>(world.events().began.size());
                const Vec2 at = world.body(id).massCenter;
                QVERIFY2(at.cwiseAbs().maxCoeff() < 3,
                         qPrintable(QString("rod %1, update %2: at (%3, %4)").arg(k).arg(i).arg(at.x()).arg(at.y())));
            }
            QVERIFY(touches > 0 || k % 7 == 0);
        }
    }
};

SPACETOW_TEST(BulletsTest)
#include "bullets_test.moc"
