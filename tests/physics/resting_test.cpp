#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/gaps.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

const char* const surfaces[] = {"edge", "thin edge", "line", "polygon", "two circles", "bowl"};

/// A concave static polygon with a round hollow: the inside of a regular 12-gon, a flat side below.
Polygon bowl() {
    constexpr double radius = 1.2;
    Polygon polygon{{Vec2(-2, -1), Vec2(2, -1), Vec2(2, 0.5)}};
    for (int i = 2; i >= -3; --i) {
        const double angle = (2 * i + 1) * pi / 12;
        polygon.vertices.emplace_back(radius * std::sin(angle), radius * (std::cos(pi / 12) - std::cos(angle)));
    }
    polygon.vertices.emplace_back(-2, 0.5);
    return polygon;
}

/// What a thing dropped at x = 0 can rest on. A single circle has nothing but a point of unstable balance, two form a
/// valley.
std::vector<BodyDef> surfaceOf(const QString& surface) {
    if (surface == "two circles") {
        std::vector<BodyDef> valley{ball({-1, -1}, 0.95), ball({1, -1}, 0.95)};
        for (BodyDef& side : valley) {
            side.kind = BodyKind::Static;
        }
        return valley;
    }
    if (surface == "bowl") {
        return {{.kind = BodyKind::Static, .shapes = {bowl()}}};
    }
    return {floorOf(surface)};
}

/// The signed distance from the nearest of these surfaces, m.
double gapTo(const std::vector<BodyDef>& ground, const World& world, BodyId id) {
    double gap = std::numeric_limits<double>::infinity();
    const Transform pose = world.body(id).pose;
    const Shape& shape = world.shapes(id).front();
    for (const BodyDef& piece : ground) {
        if (const auto* circle = std::get_if<Circle>(&piece.shapes.front()); circle != nullptr) {
            gap = std::min(gap, distanceTo(shape, pose, piece.position) - circle->radius);
        } else if (const auto* polygon = std::get_if<Polygon>(&piece.shapes.front());
                   polygon != nullptr && polygon->vertices.size() > 4) {
            for (std::size_t i = 3; i + 2 < polygon->vertices.size(); ++i) {
                const Vec2 a = polygon->vertices[i];
                const Vec2 along = (polygon->vertices[i + 1] - a).normalized();
                gap = std::min(gap, lowestAlong(shape, pose, a, -leftOf(along)));
            }
        } else {
            gap = std::min(gap, lowestPoint(world, id));
        }
    }
    return gap;
}

void restRows() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<QString>("surface");
    QTest::addColumn<int>("iterations");
    for (const char* what : {"ball", "box", "hexagon", "ship"}) {
        for (const char* surface : surfaces) {
            for (const int iterations : iterationCounts) {
                QTest::addRow("%s on %s, %d iterations", what, surface, iterations) << what << surface << iterations;
            }
        }
    }
}

void verifyStill(const World& world, BodyId id, const QString& when) {
    const BodyState state = world.body(id);
    QVERIFY2(
        state.velocity.norm() < 0.005 && std::abs(state.angularVelocity) < 0.02,
        qPrintable(QString("%1: speed %2, spin %3").arg(when).arg(state.velocity.norm()).arg(state.angularVelocity)));
}

} // namespace

class RestingTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsDroppedComesToRestOnTheSurface_data() { restRows(); }
    void whatIsDroppedComesToRestOnTheSurface() {
        QFETCH(QString, what);
        QFETCH(QString, surface);
        QFETCH(int, iterations);
        for (int step = 0; step < 24; step += fullOrQuick(1, 5)) {
            const QString start = QString("start angle %1°: ").arg(step * 15);
            World world(withIterations(iterations));
            const std::vector<BodyDef> ground = surfaceOf(surface);
            for (const BodyDef& piece : ground) {
                add(world, piece);
            }
            BodyDef def = dropped(what, {0, 1});
            def.angle = step * pi / 12;
            const BodyId id = add(world, def);
            run(world, 3);
            verifyStill(world, id, start + "after 3 s");
            for (int i = 0; i < fullOrQuick(2850, 100); ++i) {
                world.update();
                const double gap = gapTo(ground, world, id);
                QVERIFY2(std::abs(gap) < 0.005, qPrintable(start + QString("lowest point %1").arg(gap)));
            }
            verifyStill(world, id, start + "at the end");
        }
    }

    void mirroredStartsEndMirrored_data() { restRows(); }
    void mirroredStartsEndMirrored() {
        QFETCH(QString, what);
        QFETCH(QString, surface);
        QFETCH(int, iterations);
        for (int step = 1; step < 24; step += fullOrQuick(1, 6)) {
            BodyState ends[2];
            for (const int side : {0, 1}) {
                World world(withIterations(iterations));
                for (const BodyDef& piece : surfaceOf(surface)) {
                    add(world, piece);
                }
                BodyDef def = dropped(what, {0, 0.6});
                // Not on the angle of a corner, where it would stand until rounding tips it over.
                def.angle = (side == 0 ? 1 : -1) * (step * pi / 12 + 0.1);
                const BodyId id = add(world, def);
                run(world, 3);
                ends[side] = world.body(id);
                QVERIFY(ends[side].massCenter.y() > (surface == "two circles" ? -0.9 : 0));
            }
            const double shift = ends[0].pose.position.x() + ends[1].pose.position.x();
            const double turn = std::remainder(ends[0].angle + ends[1].angle, 2 * pi);
            QVERIFY2(std::abs(shift) < 1e-3 && std::abs(turn) < 1e-2,
                     qPrintable(QString("start angle %1°: %2 m and %3 rad apart").arg(step * 15).arg(shift).arg(turn)));
        }
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
        const double start = totals(world).energy();
        for (int i = 0; i < 400; ++i) {
            world.update();
            QVERIFY2(totals(world).energy() <= start * (1 + 1e-9),
                     qPrintable(QString("update %1: %2").arg(i).arg(totals(world).energy())));
        }
        const double settled = totals(world).energy();
        QVERIFY(settled > 0); // nothing fell through the floor
        for (int i = 0; i < 200; ++i) {
            world.update();
            QVERIFY2(std::abs(totals(world).energy() / settled - 1) < 1e-3, qPrintable(QString("update %1").arg(i)));
        }
    }
};

SPACETOW_TEST(RestingTest)
#include "resting_test.moc"
