#include "tests/support/contact_scenes.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct Floor {
    QString walls;
    bool oneBody;
    double friction;
};

/// From x = −5 to 95 at y = 0, in so many pieces.
void addFloor(World& world, const Floor& floor, int pieces) {
    BodyDef whole{.kind = BodyKind::Static, .friction = floor.friction};
    for (int i = 0; i < pieces; ++i) {
        const Vec2 a(-5 + 100.0 * i / pieces, 0);
        const Vec2 b(-5 + 100.0 * (i + 1) / pieces, 0);
        BodyDef piece = floor.walls == "lines" ? lineBody(a, b) : edgeBody(a, b, floor.walls == "edges" ? noBack : 0);
        if (floor.walls == "boxes") {
            piece.shapes = {Polygon{{a, a - Vec2(0, 1), b - Vec2(0, 1), b}}};
        }
        piece.friction = floor.friction;
        if (floor.oneBody) {
            whole.shapes.push_back(piece.shapes.front());
        } else {
            add(world, piece);
        }
    }
    if (floor.oneBody) {
        add(world, whole);
    }
}

} // namespace

class JointsTest : public QObject {
    Q_OBJECT

  private slots:
    void aThousandJointsAreNoDifferentFromOneWall_data() {
        QTest::addColumn<QString>("walls");
        QTest::addColumn<QString>("what");
        QTest::addColumn<bool>("oneBody");
        QTest::addColumn<int>("iterations");
        for (const char* walls : {"edges", "thin edges", "lines", "boxes"}) {
            for (const char* what : {"ball", "box"}) {
                for (const bool oneBody : {false, true}) {
                    for (const int iterations : iterationCounts) {
                        QTest::addRow("%s over %s of %s, %d iterations", what, walls, oneBody ? "one body" : "many",
                                      iterations)
                            << walls << what << oneBody << iterations;
                    }
                }
            }
        }
    }
    void aThousandJointsAreNoDifferentFromOneWall() {
        QFETCH(QString, walls);
        QFETCH(QString, what);
        QFETCH(bool, oneBody);
        QFETCH(int, iterations);
        for (const double friction : {0.0, 0.05}) {
            for (const double speed : {1.0, 5.0, 9.0}) {
                double speeds[2];
                double spins[2];
                for (const int pieces : {1, 1000}) {
                    World world(withIterations(iterations));
                    addFloor(world, {walls, oneBody, friction}, pieces);
                    BodyDef def = dropped(what, {0, 0.2});
                    def.friction = friction;
                    def.velocity = {speed, 0};
                    const BodyId id = add(world, def);
                    double hop = 0;
                    for (int i = 0; i < fullOrQuick(500, 200); ++i) {
                        world.update();
                        hop = std::max(hop, std::abs(world.body(id).velocity.y()));
                    }
                    QVERIFY2(hop < 1e-3, qPrintable(QString("friction %1, %2 m/s, %3 pieces: hop %4")
                                                        .arg(friction)
                                                        .arg(speed)
                                                        .arg(pieces)
                                                        .arg(hop)));
                    QVERIFY(std::abs(world.body(id).massCenter.y() - def.position.y()) < 0.005);
                    speeds[pieces == 1 ? 0 : 1] = world.body(id).velocity.x();
                    spins[pieces == 1 ? 0 : 1] = world.body(id).angularVelocity;
                }
                QVERIFY2(std::abs(speeds[1] - speeds[0]) <= 1e-3 * speed && std::abs(spins[1] - spins[0]) <= 0.01,
                         qPrintable(QString("friction %1: %2 m/s instead of %3, %4 rad/s instead of %5")
                                        .arg(friction)
                                        .arg(speeds[1])
                                        .arg(speeds[0])
                                        .arg(spins[1])
                                        .arg(spins[0])));
            }
        }
    }
};

SPACETOW_TEST(JointsTest)
#include "joints_test.moc"
