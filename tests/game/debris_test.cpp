#include "tests/support/test_main.h"

#include "core/game/debris.h"
#include "core/game/ship.h"

#include <set>

using namespace spacetow;

namespace {

constexpr double pi = 3.14159265358979323846;

BodyState wreck() {
    World world;
    BodyDef def = shipBody(Vec2(3, -2), 0.5);
    def.velocity = Vec2(1, 2);
    return world.body(world.addBody(def).value());
}

} // namespace

class DebrisTest : public QObject {
    Q_OBJECT

  private slots:
    void everyPieceIsWithinItsRangesAndTheRangesAreUsed() {
        const std::uint64_t seed = 3;
        Random random(seed);
        const BodyState source = wreck();
        std::set<std::size_t> sides, counts;
        double slowest = 1e9, fastest = 0, nearest = 1e9, farthest = 0;
        for (int i = 0; i < 2000; ++i) {
            const std::vector<DebrisPiece> pieces = debrisOf(source, debris::fromShip, random);
            counts.insert(pieces.size());
            for (const DebrisPiece& piece : pieces) {
                const auto& polygon = std::get<Polygon>(piece.def.shapes.at(0));
                sides.insert(polygon.vertices.size());
                const double radius = polygon.vertices[0].norm();
                QVERIFY(radius >= debris::minRadius && radius < debris::maxRadius);
                for (const Vec2& vertex : polygon.vertices) {
                    QVERIFY(std::abs(vertex.norm() - radius) < 1e-12);
                }
                QVERIFY(*piece.def.mass >= debris::minMass && *piece.def.mass < debris::maxMass);
                QVERIFY(piece.life >= debris::minLife && piece.life < debris::maxLife);
                const double offset = (piece.def.position - source.massCenter).norm();
                const double speed = (piece.def.velocity - source.velocity).norm();
                slowest = std::min(slowest, speed);
                fastest = std::max(fastest, speed);
                nearest = std::min(nearest, offset);
                farthest = std::max(farthest, offset);
                QVERIFY(std::abs(piece.def.angle - source.angle) <= pi);
                QVERIFY(std::abs(piece.def.angularVelocity) <= 2 * pi);
            }
        }
        QVERIFY(sides == (std::set<std::size_t>{3, 4, 5, 6}));
        QVERIFY(counts == (std::set<std::size_t>{2, 3, 4, 5, 6}));
        QVERIFY(slowest >= debris::minSpeed - 1e-12 && slowest < debris::minSpeed + 0.01);
        QVERIFY(fastest < debris::maxSpeed + 1e-12 && fastest > debris::maxSpeed - 0.01);
        QVERIFY(nearest < 0.005);
        QVERIFY(farthest < debris::maxOffset + 1e-12 && farthest > debris::maxOffset - 0.005);
    }
    void chipsAreRegularAndAnticlockwise() {
        Random random(11);
        const BodyState source = wreck();
        for (int i = 0; i < 200; ++i) {
            for (const DebrisPiece& piece : debrisOf(source, debris::fromPayload, random)) {
                const std::vector<Vec2>& v = std::get<Polygon>(piece.def.shapes.at(0)).vertices;
                const double side = (v[1] - v[0]).norm();
                for (std::size_t k = 0; k < v.size(); ++k) {
                    const Vec2& next = v[(k + 1) % v.size()];
                    QVERIFY(std::abs((next - v[k]).norm() - side) < 1e-12);
                    QVERIFY(cross(v[k], next) > 0);
                }
            }
        }
    }
    void equalSeedsGiveEqualPieces() {
        Random one(9), same(9), other(10);
        const BodyState source = wreck();
        const auto first = debrisOf(source, 2, one);
        const auto second = debrisOf(source, 2, same);
        const auto third = debrisOf(source, 2, other);
        QCOMPARE(first.size(), second.size());
        QVERIFY(first[0].def.position == second[0].def.position);
        QVERIFY(first[0].def.position != third[0].def.position);
    }
};

SPACETOW_TEST(DebrisTest)
#include "debris_test.moc"
