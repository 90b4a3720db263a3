#include "core/base/random.h"

#include "tests/support/test_main.h"

#include <array>

using namespace spacetow;

class RandomTest : public QObject {
    Q_OBJECT

  private slots:
    void theSequenceBelongsToTheSeed();
    void numbersStayInTheirRange_data();
    void numbersStayInTheirRange();
    void belowReachesEveryNumberAboutAsOften();
    void aCopyContinuesTheSequence();
};

void RandomTest::theSequenceBelongsToTheSeed() {
    Random a(5);
    Random b(5);
    Random c(6);
    int different = 0;
    for (int i = 0; i < 100; ++i) {
        const std::uint32_t number = a.next();
        QCOMPARE(number, b.next());
        different += number != c.next() ? 1 : 0;
    }
    QVERIFY(different > 95);
}

void RandomTest::numbersStayInTheirRange_data() {
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::newRow("a minimum above zero") << 0.2 << 0.5;
    QTest::newRow("across zero") << -3.0 << 2.0;
    QTest::newRow("negative") << -7.0 << -6.0;
}

void RandomTest::numbersStayInTheirRange() {
    QFETCH(double, low);
    QFETCH(double, high);
    Random random(1);
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double x = random.uniform(low, high);
        QVERIFY(low <= x && x < high);
        sum += x;
    }
    QVERIFY(std::abs(sum / 10000 - 0.5 * (low + high)) < 0.02 * (high - low));
}

void RandomTest::belowReachesEveryNumberAboutAsOften() {
    Random random(2);
    std::array<int, 7> counts{};
    for (int i = 0; i < 70000; ++i) {
        const std::uint32_t n = random.below(7);
        QVERIFY(n < 7);
        ++counts[n];
    }
    for (const int count : counts) {
        QVERIFY(count > 9500 && count < 10500);
    }
    QCOMPARE(random.below(1), 0u);
}

void RandomTest::aCopyContinuesTheSequence() {
    Random random(3);
    random.next();
    Random copy = random;
    QVERIFY(copy == random);
    QCOMPARE(copy.next(), random.next());
    copy.next();
    QVERIFY(!(copy == random));
}

SPACETOW_TEST(RandomTest)
#include "random_test.moc"
