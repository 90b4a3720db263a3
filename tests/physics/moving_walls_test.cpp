#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/random_shapes.h"
#include "tests/support/rows.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double halfWall = 10; // m

const char* const movingWalls[] = {"line", "edge", "plate", "free plate", "free line"};

BodyDef movingWall(const QString& kind) {
    BodyDef wall = box({0, 0}, kind == "free plate" ? 1 : halfWall, 0.0005);
    if (kind == "line" || kind == "free line") {
        wall.shapes = {Line{{-halfWall, 0}, {halfWall, 0}}};
    } else if (kind == "edge") {
        wall.shapes = {Edge{{-halfWall, 0}, {halfWall, 0}, 0}};
    }
    wall.kind = kind.startsWith("free") ? BodyKind::Dynamic : BodyKind::Kinematic;
    return wall;
}

/// Something slender or small, which comes down on a wall.
struct Slender {
    World world;
    BodyId wall, body;
    double reach = 0; // m, around the centre of the body
    double halfLength = 0;
    double speed = 0; // m/s, at which they meet
    double energy = 0;
};

Slender slender(const QString& kind, const QString& what, int iterations, Random& random) {
    Slender s{World(withIterations(iterations, {0, 0}))};
    const double size = random.uniform(0.01, 0.05);
    const Polygon shape = what == "bar"      ? std::get<Polygon>(box({0, 0}, 0.2, 0.02).shapes[0])
                          : what == "convex" ? smallConvex(random, size)
                                             : smallStar(random, size);
    s.reach = what == "bar" ? 0.201 : 1.5 * size;
    s.speed = std::pow(10, random.uniform(-0.3, 3.3));
    const double restitution = random.below(2) == 0 ? 0 : random.unit();
    BodyDef wall = movingWall(kind);
    wall.velocity = {random.uniform(-1, 1), random.below(2) == 0 ? 0.001 : random.uniform(-5, 5)};
    wall.restitution = restitution;
    wall.mass = random.uniform(0.01, 10);
    s.halfLength = kind == "free plate" ? 1 : halfWall;
    s.wall = add(s.world, wall);
    BodyDef body{.shapes = {shape}};
    body.position = {random.uniform(-0.3, 0.3), s.reach + 0.001 + random.unit() * std::min(0.02 * s.speed, 5.0)};
    body.velocity = wall.velocity + s.speed * Vec2(random.uniform(-0.5, 0.5), -1);
    body.angle = random.uniform(-pi, pi);
    body.angularVelocity = random.below(2) == 0 ? 0 : random.uniform(-50, 50);
    body.restitution = restitution;
    s.body = add(s.world, body);
    s.energy = totals(s.world).energy();
    return s;
}

/// Whether the body has gone through the wall before it was out of its reach.
bool goesThrough(Slender& s) {
    const int updates = std::min(static_cast<int>(12 / (0.02 * s.speed)) + 6, 60);
    for (int i = 0; i < updates; ++i) {
        s.world.update();
        const Vec2 at = s.world.body(s.wall).pose.toLocal(s.world.body(s.body).massCenter);
        if (std::abs(at.x()) > s.halfLength - 2 * s.reach || at.y() > 30) {
            return false;
        }
        if (at.y() < 0) {
            return true;
        }
    }
    return false;
}

} // namespace

class MovingWallsTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingSlenderGoesThroughAMovingWall_data() {
        QTest::addColumn<QString>("wall");
        QTest::addColumn<QString>("what");
        QTest::addColumn<int>("iterations");
        for (const char* wall : movingWalls) {
            for (const char* what : {"bar", "convex", "star"}) {
                for (const int iterations : {1, 2, 4, 20}) {
                    QTest::addRow("%s on %s, %d iterations", what, wall, iterations) << wall << what << iterations;
                }
            }
        }
    }
    void nothingSlenderGoesThroughAMovingWall() {
        QFETCH(QString, wall);
        QFETCH(QString, what);
        QFETCH(int, iterations);
        for (std::uint64_t seed = 1; seed <= fullOrQuick(3000U, usualOrThin(40U, 10U)); ++seed) {
            Random random(seed);
            Slender s = slender(wall, what, iterations, random);
            QVERIFY2(!goesThrough(s), seedText(seed));
            const bool free = wall.startsWith("free");
            QVERIFY2(!free || totals(s.world).energy() <= s.energy * (1 + 1e-6), seedText(seed));
        }
    }

    /// The least of them: it was let through only where the wall moved, however slowly.
    void aBarIsStoppedByALineThatMovesAsByOneThatDoesNot() {
        for (const int iterations : {1, 4}) {
            for (const double speed : {0.0, 0.001, 1.0}) {
                for (int step = 0; step < 24; ++step) {
                    World world(withIterations(iterations, {0, 0}));
                    BodyDef wall = lineBody({-10, 0}, {10, 0});
                    wall.kind = speed == 0 ? BodyKind::Static : BodyKind::Kinematic;
                    wall.velocity = {0, speed};
                    const BodyId line = add(world, wall);
                    BodyDef bar = box({0, 0.211}, 0.2, 0.02);
                    bar.velocity = {0, speed - (iterations == 1 ? 5 : 10)};
                    bar.angle = step * pi / 12 + 0.03;
                    const BodyId id = add(world, bar);
                    for (int i = 0; i < 60; ++i) {
                        world.update();
                        const Vec2 at = world.body(line).pose.toLocal(world.body(id).massCenter);
                        QVERIFY2(at.y() > 0, qPrintable(QString("%1 m/s, direction %2").arg(speed).arg(step)));
                    }
                }
            }
        }
    }
};

SPACETOW_TEST(MovingWallsTest)
#include "moving_walls_test.moc"
