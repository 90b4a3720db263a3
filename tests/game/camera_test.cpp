#include "core/base/random.h"
#include "core/game/camera.h"
#include "tests/support/test_main.h"

using namespace spacetow;

class CameraTest : public QObject {
    Q_OBJECT

  private slots:
    void approachesWithoutOvershootHoweverFarTheJump_data() {
        QTest::addColumn<double>("distance");
        for (const double distance : {1.1, 5.0, 11.4, 21.9, 50.0, 1e3, 1e9}) {
            QTest::addRow("%g m", distance) << distance;
        }
    }
    void approachesWithoutOvershootHoweverFarTheJump() {
        QFETCH(double, distance);
        const Vec2 way(0.6, -0.8);
        const Vec2 target = distance * way;
        Camera camera(Vec2(0, 0));
        double left = distance;
        for (int i = 0; i < 300; ++i) {
            camera.follow(target, 0.02);
            const Vec2 gap = target - camera.position();
            const double now = gap.norm();
            QVERIFY2(now < left || now <= Camera::freeRadius * (1 + 1e-6), qPrintable(QString::number(now)));
            QVERIFY(gap.dot(way) > 0);
            QVERIFY(std::abs(cross(gap, way)) <= 1e-9 * distance);
            left = now;
        }
        QVERIFY(left >= Camera::freeRadius * (1 - 1e-6));
        QVERIFY(left < Camera::freeRadius + 1e-9 * distance);
    }
    void theWayDependsOnTimeAndNotOnTheFrameRate() {
        const std::uint64_t seed = 5;
        Random random(seed);
        for (int i = 0; i < 1000; ++i) {
            const Vec2 target(random.uniform(-30, 30), random.uniform(-30, 30));
            const double seconds = random.uniform(0.001, 1);
            const int frames = 1 + static_cast<int>(random.below(60));
            Camera once(Vec2(1, 2)), often(Vec2(1, 2));
            once.follow(target, seconds);
            for (int frame = 0; frame < frames; ++frame) {
                often.follow(target, seconds / frames);
            }
            QVERIFY2((once.position() - often.position()).norm() < 1e-9, qPrintable(QString("seed 5, case %1").arg(i)));
        }
    }
    void staysWhileTheTargetIsNear() {
        Camera camera(Vec2(3, 4));
        camera.follow(Vec2(3 + 0.99 * Camera::freeRadius, 4), 10);
        QCOMPARE(camera.position().x(), 3.0);
        QCOMPARE(camera.position().y(), 4.0);
    }
    void ignoresTargetsThatAreNotFinite() {
        Camera camera(Vec2(3, 4));
        const double bad = std::numeric_limits<double>::quiet_NaN();
        const double huge = std::numeric_limits<double>::infinity();
        camera.follow(Vec2(bad, 0), 0.02);
        camera.follow(Vec2(0, huge), 0.02);
        camera.snapTo(Vec2(bad, bad));
        QVERIFY(camera.position() == Vec2(3, 4));
        camera.snapTo(Vec2(-8, 1));
        QVERIFY(camera.position() == Vec2(-8, 1));
    }
};

SPACETOW_TEST(CameraTest)
#include "camera_test.moc"
