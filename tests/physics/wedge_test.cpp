#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/gaps.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double length = 20; // m, of each side

struct Wedge {
    Vec2 left, right; // the upper ends; the tip is the origin
    BodyDef body{.kind = BodyKind::Static};

    Wedge(const QString& walls, int opening)
        : left(-length * std::sin(opening * pi / 360), length * std::cos(opening * pi / 360)),
          right(-left.x(), left.y()) {
        if (walls == "edges") {
            body.shapes = {Edge{left, {0, 0}}, Edge{{0, 0}, right}};
        } else if (walls == "thin edges") {
            body.shapes = {Edge{left, {0, 0}, 0}, Edge{{0, 0}, right, 0}};
        } else if (walls == "lines") {
            body.shapes = {Line{left, {0, 0}}, Line{{0, 0}, right}};
        } else {
            body.shapes = {Polygon{{left, left + Vec2(-1, -1), Vec2(0, -1), Vec2(0, 0)}},
                           Polygon{{Vec2(0, 0), Vec2(0, -1), right + Vec2(1, -1), right}}};
        }
    }

    /// Whether the body has come over one of the upper ends, where nothing holds it any more.
    bool isLeftBy(const BodyState& state) const {
        return state.massCenter.dot(left) > 0.95 * left.squaredNorm() ||
               state.massCenter.dot(right) > 0.95 * right.squaredNorm();
    }

    /// How far the centre of mass keeps from the nearer side.
    double clearanceOf(const Vec2& center) const {
        return std::min(leftOf(-left).normalized().dot(center), leftOf(right).normalized().dot(center));
    }

    /// How far all of the body keeps from the nearer side; negative when some of it is behind.
    double gapTo(const World& world, BodyId id) const {
        const Shape& shape = world.shapes(id).front();
        const Transform pose = world.body(id).pose;
        return std::min(lowestAlong(shape, pose, {0, 0}, leftOf(-left).normalized()),
                        lowestAlong(shape, pose, {0, 0}, leftOf(right).normalized()));
    }
};

} // namespace

class WedgeTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingGetsThroughAWedge_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<double>("restitution");
        QTest::addColumn<QString>("walls");
        QTest::addColumn<int>("iterations");
        for (const char* what : {"ball", "box", "ship"}) {
            for (const double e : {0.0, 0.5, 1.0}) {
                for (const char* walls : {"edges", "thin edges", "lines", "polygons"}) {
                    for (const int iterations : iterationCounts) {
                        QTest::addRow("%s, e %g, %s, %d iterations", what, e, walls, iterations)
                            << what << e << walls << iterations;
                    }
                }
            }
        }
    }
    void nothingGetsThroughAWedge() {
        QFETCH(QString, what);
        QFETCH(double, restitution);
        QFETCH(QString, walls);
        QFETCH(int, iterations);
        for (int opening = 10; opening <= 170; opening += fullOrQuick(5, usualOrThin(20, 40))) {
            for (const double shot : {0.0, 50.0}) {
                World world(withIterations(iterations));
                Wedge wedge(walls, opening);
                wedge.body.restitution = restitution;
                add(world, wedge.body);
                BodyDef def = dropped(what, {0.02, 6});
                def.angle = 0.3;
                def.restitution = restitution;
                def.velocity = {0, -shot};
                const BodyId id = add(world, def);
                const QString scene = QString("opening %1°, shot %2 m/s").arg(opening).arg(shot);
                const double start = totals(world).energy();
                bool touched = false;
                for (int i = 0; i < fullOrQuick(1500, iterations == 100 ? 150 : 500); ++i) {
                    world.update();
                    touched = touched || !world.events().began.empty();
                    const BodyState state = world.body(id);
                    QVERIFY2(
                        totals(world).energy() < 1.0001 * start,
                        qPrintable(
                            scene +
                            QString(", update %1: energy %2 of %3").arg(i).arg(totals(world).energy()).arg(start)));
                    if (wedge.isLeftBy(state)) {
                        break;
                    }
                    QVERIFY2(wedge.clearanceOf(state.massCenter) > 0,
                             qPrintable(scene + QString(", update %1: at (%2, %3)")
                                                    .arg(i)
                                                    .arg(state.massCenter.x())
                                                    .arg(state.massCenter.y())));
                }
                QVERIFY2(touched, qPrintable(scene + ": touched nothing"));
                const double gap = wedge.gapTo(world, id);
                QVERIFY2(gap > -0.02 || wedge.isLeftBy(world.body(id)),
                         qPrintable(scene + QString(": gap %1").arg(gap)));
            }
        }
    }
};

SPACETOW_TEST(WedgeTest)
#include "wedge_test.moc"
