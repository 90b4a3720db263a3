// What lies at one corner and is struck turns about that: its other corners, which had no contact before, go no deeper
// than those that have one.

#include "core/physics/def/tolerances.h"
#include "tests/support/contact_scenes.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double barHalfLength = 0.25;
constexpr double barHalfHeight = 0.1;

/// A bar with its lower left corner at the origin, turned about that by the angle.
BodyDef leaningBar(double angle) {
    BodyDef bar = box(Rot::fromAngle(angle) * Vec2(barHalfLength, barHalfHeight), barHalfLength, barHalfHeight);
    bar.angle = angle;
    bar.mass = 1;
    return bar;
}

/// Comes down on the end of the bar that is raised by as much, within the first update.
BodyDef strikerAbove(double raised, double speed) {
    BodyDef striker = ball({1.8 * barHalfLength, 2 * barHalfHeight + raised + 0.1 + 0.3 * speed * 0.02}, 0.1);
    striker.mass = 2;
    striker.velocity = {0, -speed};
    return striker;
}

/// What the bar lies on: a floor, or something that is not static and has its top at y = 0.
BodyDef supportOf(const QString& what) {
    if (what != "kinematic" && what != "dynamic") {
        return floorOf(what);
    }
    BodyDef support = box({0, -1}, 3, 1);
    support.kind = what == "kinematic" ? BodyKind::Kinematic : BodyKind::Dynamic;
    support.mass = 1000;
    return support;
}

} // namespace

class StruckTest : public QObject {
    Q_OBJECT

  private slots:
    void aBarThatIsStruckAtItsRaisedEndGoesNotIntoWhatItLiesOn_data() {
        QTest::addColumn<QString>("on");
        QTest::addColumn<int>("iterations");
        QTest::addColumn<double>("speed");
        for (const char* on : {"edge", "thin edge", "line", "polygon", "kinematic", "dynamic"}) {
            for (const int iterations : iterationCounts) {
                for (const double speed : {1.0, 4.5, 12.0}) {
                    QTest::addRow("%s, %d iterations, at %g m/s", on, iterations, speed) << on << iterations << speed;
                }
            }
        }
    }
    /// The end is further up than the speculative margin of what rests, so that only the lower corner has a contact.
    void aBarThatIsStruckAtItsRaisedEndGoesNotIntoWhatItLiesOn() {
        QFETCH(QString, on);
        QFETCH(int, iterations);
        QFETCH(double, speed);
        const bool isFree = on == "dynamic"; // then nothing has weight
        for (const double raised : {0.002, 0.005, 0.01, 0.02, 0.05}) {
            World world(withIterations(iterations, isFree ? Vec2(0, 0) : Vec2(0, -9.81)));
            const BodyId support = add(world, supportOf(on));
            const BodyId bar = add(world, leaningBar(raised / (2 * barHalfLength)));
            add(world, strikerAbove(raised, speed));
            double depth = 0;
            for (int i = 0; i < 12; ++i) {
                world.update();
                const double top = isFree ? world.body(support).pose.position.y() + 1 : 0;
                depth = std::max(depth, top - lowestPoint(world, bar));
            }
            QVERIFY2(depth <= 2 * linearSlop,
                     qPrintable(QString("%1 mm deep, the end raised by %2 mm").arg(1000 * depth).arg(1000 * raised)));
        }
    }
};

SPACETOW_TEST(StruckTest)
#include "struck_test.moc"
