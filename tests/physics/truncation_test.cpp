#include "core/base/random.h"
#include "core/physics/def/truncation.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <cmath>

using namespace spacetow;

namespace {

double sign(double x) {
    return x < 0 ? -1 : 1;
}

/// The report's formulas, with the C library's tanh.
double expected(const Truncation& t, double x) {
    switch (t.rule) {
    case TruncationRule::Zero:
        return 0;
    case TruncationRule::Clamp:
        return std::clamp(x, -t.limit, t.limit);
    case TruncationRule::Tanh:
        return t.limit == 0 ? 0 : t.limit * std::tanh(x / t.limit);
    case TruncationRule::PartialTanh: {
        const double safe = t.limit * t.proportion;
        const double rest = t.limit - safe;
        if (std::abs(x) <= safe) {
            return x;
        }
        return sign(x) * (rest > 0 ? safe + rest * std::tanh((std::abs(x) - safe) / rest) : t.limit);
    }
    case TruncationRule::None:
    case TruncationRule::Custom:
        break;
    }
    return x;
}

void ruleRows() {
    QTest::addColumn<int>("rule");
    QTest::addColumn<double>("limit");
    QTest::addColumn<double>("proportion");
    QTest::newRow("zero") << int(TruncationRule::Zero) << 10.0 << 0.5;
    QTest::newRow("none") << int(TruncationRule::None) << 10.0 << 0.5;
    for (const double limit : {0.0, 1.0, 150.0}) {
        QTest::addRow("clamp at %g", limit) << int(TruncationRule::Clamp) << limit << 0.5;
        QTest::addRow("tanh to %g", limit) << int(TruncationRule::Tanh) << limit << 0.5;
        for (const double proportion : {0.0, 0.5, 0.75, 1.0}) {
            QTest::addRow("partial tanh to %g from %g of it", limit, proportion)
                << int(TruncationRule::PartialTanh) << limit << proportion;
        }
    }
}

} // namespace

class TruncationTest : public QObject {
    Q_OBJECT

  private slots:
    void everyRuleFollowsItsFormula_data() { ruleRows(); }
    void everyRuleFollowsItsFormula() {
        QFETCH(int, rule);
        QFETCH(double, limit);
        QFETCH(double, proportion);
        const Truncation t{static_cast<TruncationRule>(rule), limit, proportion, {}};
        Random random(7);
        for (int i = 0; i < 10000; ++i) {
            const double x = random.uniform(-5, 5) * std::max(limit, 1.0);
            QVERIFY2(std::abs(truncated(t, x) - expected(t, x)) <= 1e-12 * std::max(1.0, limit),
                     qPrintable(QString("at %1: %2, expected %3").arg(x).arg(truncated(t, x)).arg(expected(t, x))));
        }
    }

    void everyRuleIsOddMonotonicAndWithinItsLimit_data() { ruleRows(); }
    void everyRuleIsOddMonotonicAndWithinItsLimit() {
        QFETCH(int, rule);
        QFETCH(double, limit);
        QFETCH(double, proportion);
        const Truncation t{static_cast<TruncationRule>(rule), limit, proportion, {}};
        double before = truncated(t, -2000);
        for (double x = -2000; x <= 2000; x += 0.37) {
            const double y = truncated(t, x);
            QCOMPARE(truncated(t, -x), -y);
            QVERIFY(y >= before);
            QVERIFY(t.rule == TruncationRule::None || std::abs(y) <= limit);
            before = y;
        }
    }

    void theWorkIsTheIntegralOfTheTension_data() { ruleRows(); }
    void theWorkIsTheIntegralOfTheTension() {
        QFETCH(int, rule);
        QFETCH(double, limit);
        QFETCH(double, proportion);
        const Truncation t{static_cast<TruncationRule>(rule), limit, proportion, {}};
        const double end = 6 * std::max(limit, 1.0);
        constexpr int steps = 20000;
        double work = 0;
        for (int i = 0; i < steps; ++i) {
            work += expected(t, (i + 0.5) * end / steps) * end / steps;
            const double at = (i + 1) * end / steps;
            if (i % 997 == 0 || i + 1 == steps) {
                QVERIFY2(std::abs(truncatedWork(t, at) - work) <= 1e-6 * std::max(1.0, work),
                         qPrintable(QString::number(at)));
                QCOMPARE(truncatedWork(t, -at), truncatedWork(t, at));
            }
        }
        Truncation custom{TruncationRule::Custom, limit, proportion, [t](double x) { return truncated(t, x); }};
        QVERIFY(std::abs(truncatedWork(custom, end) - work) <= 0.01 * std::max(1.0, work));
        QVERIFY(std::abs(truncatedWork(custom, -end) - work) <= 0.01 * std::max(1.0, work));
    }

    void aKnownValueOfPartialTanhIsMet() {
        const Truncation t{TruncationRule::PartialTanh, 150, 0.75, {}};
        QVERIFY(std::abs(truncated(t, 120) - 119.9016) < 1e-4);
        QVERIFY(truncated(t, 1e6) < 150 + 1e-12);
    }

    void aFunctionOfTheCallersOwnIsUsed() {
        const Truncation t{TruncationRule::Custom, 0, 0, [](double x) { return 0.5 * x; }};
        QCOMPARE(truncated(t, 8), 4.0);
    }
};

SPACETOW_TEST(TruncationTest)
#include "truncation_test.moc"
