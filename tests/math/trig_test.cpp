#include "core/math/trig.h"

#include "core/base/random.h"
#include "tests/support/test_main.h"

#include <limits>
#include <numbers>

using namespace spacetow;

class TrigTest : public QObject {
    Q_OBJECT

  private slots:
    void sineAndCosineAreThoseOfTheLibrary();
    void sineAndCosineLieOnTheUnitCircle();
    void sineIsOddAndCosineEven();
    void multiplesOfAQuarterTurnAreExactEnough();
    void whatIsNotFiniteGivesNoNumber();
    void hugeAnglesStayBounded();
    void tanhIsThatOfTheLibrary();
    void tanhIsOddAndMonotonicAndInsideItsLimits();
    void theArctangentIsThatOfTheLibraryInEveryDirection();
    void theExponentialIsThatOfTheLibrary();
};

void TrigTest::sineAndCosineAreThoseOfTheLibrary() {
    Random random(1);
    for (int i = 0; i < 400000; ++i) {
        const double reach = i % 2 == 0 ? 7 : 1e4;
        const double x = random.uniform(-reach, reach);
        const SinCos found = sinCos(x);
        QVERIFY2(std::fabs(found.sin - std::sin(x)) <= 3e-16, QByteArray::number(x, 'g', 17));
        QVERIFY2(std::fabs(found.cos - std::cos(x)) <= 3e-16, QByteArray::number(x, 'g', 17));
    }
    for (double x = 1e-300; x < 1; x *= 1.7) { // small angles keep their relative precision
        QVERIFY(std::fabs(sinCos(x).sin - std::sin(x)) <= 3e-16 * x);
    }
}

void TrigTest::sineAndCosineLieOnTheUnitCircle() {
    Random random(2);
    for (int i = 0; i < 100000; ++i) {
        const SinCos found = sinCos(random.uniform(-100, 100));
        QVERIFY(std::fabs(found.sin * found.sin + found.cos * found.cos - 1) < 5e-16);
    }
}

void TrigTest::sineIsOddAndCosineEven() {
    Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const double x = random.uniform(0, 1000);
        QCOMPARE(sinCos(-x).sin, -sinCos(x).sin);
        QCOMPARE(sinCos(-x).cos, sinCos(x).cos);
    }
    QCOMPARE(sinCos(0).sin, 0.0);
    QCOMPARE(sinCos(0).cos, 1.0);
}

void TrigTest::multiplesOfAQuarterTurnAreExactEnough() {
    for (int i = -2000; i <= 2000; ++i) {
        const double x = i * std::numbers::pi / 2;
        QVERIFY(std::fabs(sinCos(x).sin - std::sin(x)) <= 3e-16);
        QVERIFY(std::fabs(sinCos(x).cos - std::cos(x)) <= 3e-16);
    }
}

void TrigTest::whatIsNotFiniteGivesNoNumber() {
    for (const double x : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
        QVERIFY(std::isnan(sinCos(x).sin));
        QVERIFY(std::isnan(sinCos(x).cos));
    }
    const double none = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(std::isnan(tanhExact(none)));
    QVERIFY(std::isnan(arcTangent(none, 1)));
    QVERIFY(std::isnan(arcTangent(1, none)));
    QVERIFY(std::isnan(arcTangent(none, none)));
    QVERIFY(std::isnan(arcTangent(none, std::numeric_limits<double>::infinity())));
}

void TrigTest::hugeAnglesStayBounded() {
    for (double x = 1e4; x < 1e308; x *= 3.7) {
        const SinCos found = sinCos(x);
        QVERIFY(std::fabs(found.sin) <= 1.0000001 && std::fabs(found.cos) <= 1.0000001);
    }
}

void TrigTest::tanhIsThatOfTheLibrary() {
    Random random(4);
    for (int i = 0; i < 400000; ++i) {
        const double reach = i % 2 == 0 ? 1 : 25;
        const double x = random.uniform(-reach, reach);
        QVERIFY2(std::fabs(tanhExact(x) - std::tanh(x)) <= 1e-15 * std::fabs(std::tanh(x)),
                 QByteArray::number(x, 'g', 17));
    }
    for (double x = 1e-300; x < 1; x *= 1.7) {
        QVERIFY(std::fabs(tanhExact(x) - std::tanh(x)) <= 1e-15 * x);
    }
}

void TrigTest::tanhIsOddAndMonotonicAndInsideItsLimits() {
    double before = -1;
    for (int i = -300000; i <= 300000; ++i) {
        const double x = i * 1e-4;
        const double y = tanhExact(x);
        QVERIFY(y > -1 && y < 1);
        QVERIFY2(y >= before, QByteArray::number(x, 'g', 17));
        QCOMPARE(tanhExact(-x), -y);
        before = y;
    }
    for (const double x : {1e3, 1e300, std::numeric_limits<double>::infinity()}) {
        QVERIFY(tanhExact(x) < 1 && tanhExact(x) > 0.999999);
        QVERIFY(tanhExact(-x) > -1);
    }
}

void TrigTest::theArctangentIsThatOfTheLibraryInEveryDirection() {
    Random random(3);
    for (int i = 0; i < 200000; ++i) {
        const double y = random.uniform(-1, 1);
        const double x = random.uniform(-1, 1);
        QVERIFY2(std::fabs(arcTangent(y, x) - std::atan2(y, x)) <= 1e-15, QByteArray::number(std::atan2(y, x)));
    }
    QCOMPARE(arcTangent(0, 1), 0.0);
    QCOMPARE(arcTangent(0, 0), 0.0);
    QCOMPARE(arcTangent(1, 0), std::numbers::pi / 2);
    QCOMPARE(arcTangent(-1, 0), -std::numbers::pi / 2);
    QCOMPARE(arcTangent(0, -1), std::numbers::pi);
    QCOMPARE(arcTangent(-0.0, -1), std::numbers::pi);
    const double infinite = std::numeric_limits<double>::infinity();
    for (const double y : {-infinite, -1.0, 0.0, 1.0, infinite}) {
        for (const double x : {-infinite, 1.0, infinite}) {
            QVERIFY(std::fabs(arcTangent(y, x) - std::atan2(y, x)) <= 1e-15);
        }
    }
}

void TrigTest::theExponentialIsThatOfTheLibrary() {
    Random random(4);
    for (int i = 0; i < 200000; ++i) {
        const double x = random.uniform(-700, 700);
        QVERIFY2(std::fabs(expExact(x) / std::exp(x) - 1) <= 1e-15, QByteArray::number(x));
    }
    QCOMPARE(expExact(0), 1.0);
    QCOMPARE(expExact(-1000), 0.0);
    QVERIFY(std::isinf(expExact(1000)));
    QVERIFY(std::isnan(expExact(std::numeric_limits<double>::quiet_NaN())));
}

SPACETOW_TEST(TrigTest)
#include "trig_test.moc"
