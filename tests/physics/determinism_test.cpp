// The same hashes on every compiler, at every optimisation and under sanitizers. A change of the physics changes them:
// record them anew, and say in the commit what changed.

#include "core/physics/world/world.h"
#include "tests/support/scenes.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

class DeterminismTest : public QObject {
    Q_OBJECT

  private slots:
    void aSceneEndsWithItsGoldenHash_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("n");
        QTest::addColumn<int>("updates");
        QTest::addColumn<QString>("hash");
        QTest::newRow("balls") << "balls" << 300 << 200 << "b5c080c4e9339ecf";
        QTest::newRow("pyramid") << "pyramid" << 12 << 200 << "d24f88476a2251ea";
        QTest::newRow("tumbler") << "tumbler" << 200 << 100 << "1ec46312e5612ccc";
        QTest::newRow("tow") << "tow" << 1 << 100 << "755868d89ee64c3a";
        QTest::newRow("mesh") << "mesh" << 10 << 60 << "7b7c2e12b9fb5ca2";
    }
    void aSceneEndsWithItsGoldenHash() {
        QFETCH(QString, name);
        QFETCH(int, n);
        QFETCH(int, updates);
        QFETCH(QString, hash);
        World world = worldOf(*makeScene(name.toStdString(), n));
        for (int i = 0; i < updates; ++i) {
            world.update();
        }
        QCOMPARE(QString::number(world.hash(), 16).rightJustified(16, '0'), hash);
    }

    void runningASceneTwiceGivesTheSameHashAfterEveryUpdate() {
        World first = worldOf(*makeScene("tumbler", 60));
        World second = worldOf(*makeScene("tumbler", 60));
        for (int i = 0; i < 100; ++i) {
            first.update();
            second.update();
            QCOMPARE(first.hash(), second.hash());
        }
    }
};

SPACETOW_TEST(DeterminismTest)
#include "determinism_test.moc"
