#include "core/base/random.h"
#include "core/game/pacer.h"
#include "tests/support/test_main.h"

#include <cmath>

using namespace spacetow;

class PacerTest : public QObject {
    Q_OBJECT

  private slots:
    void simulatedTimeIsWallTimeWithinOneUpdate() {
        Random random(4);
        Pacer pacer(0.02);
        double now = 1000;
        pacer.restart(now);
        int made = 0;
        for (int i = 0; i < 20000; ++i) {
            now += random.uniform(0, 0.09);
            made += pacer.due(now);
            const double behind = (now - 1000) - made * 0.02;
            QVERIFY2(behind >= -1e-6 && behind < 0.02 + 1e-6, qPrintable(QString("seed 4, call %1").arg(i)));
        }
    }
    void nothingIsDueBeforeTheFirstPeriodHasPassed() {
        Pacer pacer(0.02);
        pacer.restart(5);
        QCOMPARE(pacer.due(5), 0);
        QCOMPARE(pacer.due(5.0199), 0);
        QCOMPARE(pacer.due(5.0201), 1);
        QCOMPARE(pacer.due(5.0202), 0);
        QVERIFY(std::abs(pacer.next() - 5.04) < 1e-12);
    }
    void aLongHoldUpIsGivenUpInsteadOfCaughtUp() {
        Pacer pacer(0.02, 5);
        pacer.restart(0);
        QCOMPARE(pacer.due(60), 5);
        QCOMPARE(pacer.due(60.01), 0);
        QCOMPARE(pacer.due(60.021), 1);
    }
    void noTimePassesAcrossARestart() {
        Pacer pacer(0.02);
        pacer.restart(0);
        pacer.restart(100);
        QCOMPARE(pacer.due(100.01), 0);
        QCOMPARE(pacer.due(100.03), 1);
    }
};

SPACETOW_TEST(PacerTest)
#include "pacer_test.moc"
