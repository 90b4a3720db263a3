#include "core/physics/query/explain.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// An elastic body flies at 2 m/s at a row of equal ones that touch each other.
struct ElasticRow {
    World world;
    BodyId flying;
    double energy = 0;

    ElasticRow(const QString& what, int count, bool atWall, int iterations)
        : world(withIterations(iterations, {0, 0})) {
        if (atWall) {
            BodyDef floor = floorOf("edge");
            floor.restitution = 1;
            add(world, floor);
        }
        for (int i = 0; i <= count; ++i) {
            BodyDef def = what == "ball" ? ball({0, 0}, 0.1) : box({0, 0}, 0.1, 0.1);
            def.position = {0, 0.1 + 0.2 * i + (i == count ? 0.5 : 0)};
            def.velocity = {0, i == count ? -2 : 0};
            def.restitution = 1;
            def.friction = 0;
            flying = add(world, def);
        }
        energy = totals(world).energy();
    }
};

} // namespace

class ElasticRowsTest : public QObject {
    Q_OBJECT

  private slots:
    void aHitOnARowKeepsItsEnergy_data() {
        QTest::addColumn<QString>("what");
        QTest::addColumn<int>("count");
        QTest::addColumn<bool>("atWall");
        QTest::addColumn<int>("iterations");
        for (const char* what : {"ball", "box"}) {
            for (const int count : what == std::string("ball") ? std::vector{1, 2, 5, 10} : std::vector{1}) {
                for (const bool atWall : {true, false}) {
                    for (const int iterations : {1, 4, 20, 100}) {
                        QTest::addRow("%d of %s, %s, %d iterations", count, what, atWall ? "at a wall" : "free",
                                      iterations)
                            << what << count << atWall << iterations;
                    }
                }
            }
        }
    }
    void aHitOnARowKeepsItsEnergy() {
        QFETCH(QString, what);
        QFETCH(int, count);
        QFETCH(bool, atWall);
        QFETCH(int, iterations);
        ElasticRow scene(what, count, atWall, iterations);
        run(scene.world, 1.2);
        const double share = totals(scene.world).energy() / scene.energy;
        QVERIFY2(share > 0.99 && share < 1 + 1e-6, qPrintable(QString::number(share)));
        const double speed = scene.world.body(scene.flying).velocity.y();
        QVERIFY2(!atWall || speed > 1.9, qPrintable(QString("%1 m/s").arg(speed)));
    }
};

SPACETOW_TEST(ElasticRowsTest)
#include "elastic_rows_test.moc"
