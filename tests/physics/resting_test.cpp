#include "tests/support/contact_scenes.h"

using namespace spacetow;
using namespace spacetow::test;

class RestingTest : public QObject {
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
            QVERIFY2(world.energy() <= start * (1 + 1e-9),
                     qPrintable(QString("update %1: %2").arg(i).arg(world.energy())));
        }
        const double settled = world.energy();
        for (int i = 0; i < 200; ++i) {
            world.update();
            QVERIFY2(std::abs(world.energy() / settled - 1) < 1e-3, qPrintable(QString("update %1").arg(i)));
        }
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
};

SPACETOW_TEST(RestingTest)
#include "resting_test.moc"
