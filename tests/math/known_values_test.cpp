#include "tests/support/known_values.h"

#include "core/base/random.h"
#include "core/math/transform.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// The largest distance between a point and itself after the way to local coordinates and back.
double worstRoundTrip() {
    Random random(1);
    double worst = 0;
    for (int i = 0; i < 10000; ++i) {
        const double x = random.uniform(-50, 50);
        const Transform pose{Vec2(x, random.uniform(-50, 50)), Rot::fromAngle(random.uniform(-10, 10))};
        const double px = random.uniform(-50, 50);
        const Vec2 p(px, random.uniform(-50, 50));
        worst =
            std::max({worst, (pose.toWorld(pose.toLocal(p)) - p).norm(), (pose.toLocal(pose.toWorld(p)) - p).norm()});
    }
    return worst;
}

double leastOf(int count, double low, double high) {
    Random random(3);
    double least = high;
    for (int i = 0; i < count; ++i) {
        least = std::min(least, random.uniform(low, high));
    }
    return least;
}

} // namespace

class KnownValuesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyNumberIsWhatItsSentenceSays_data() {
        knownValueColumns();
        known("the squared distance of (0, 0) and (3, 4) is 25: both axes count",
              (Vec2(3, 4) - Vec2(0, 0)).squaredNorm(), 25, 0);
        known("what goes to local coordinates and back comes back, whatever the pose", worstRoundTrip(), 0, 1e-12);
        const Transform unturned{Vec2(3, 4), {}};
        known("(5, 4) lies 2 to the right of a body at (3, 4), not to its left", unturned.toLocal(Vec2(5, 4)).x(), 2);
        const Transform turned{Vec2(3, 4), Rot::fromAngle(1)};
        known("to local coordinates is turned back, not on: the body's own up is (0, 1)",
              (turned.toLocal(turned.position + turned.rotation.up()) - Vec2(0, 1)).norm(), 0);
        known("the point (1, 0) of a body that turns at 1 rad/s moves up, not down", cross(1.0, Vec2(1, 0)).y(), 1, 0);
        known("the point (0, 1) of a body that turns at 1 rad/s moves left, not right", cross(1.0, Vec2(0, 1)).x(), -1,
              0);
        known("rotations by 1 and by 0.5 make one by 1.5, whatever was computed before",
              (Rot::fromAngle(1) * Rot::fromAngle(0.5)).angle(), 1.5);
        const double least = leastOf(1000, 0.2, 0.5);
        known("no random number between 0.2 and 0.5 is below its minimum", std::min(least, 0.2), 0.2, 0);
        known("random numbers between 0.2 and 0.5 come near their minimum", least, 0.2, 0.01);
    }
    void everyNumberIsWhatItsSentenceSays() { checkKnownValue(); }
};

SPACETOW_TEST(KnownValuesTest)
#include "known_values_test.moc"
