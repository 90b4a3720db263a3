#include "editor/editing/measure.h"

#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;

class MeasureTest : public QObject {
    Q_OBJECT

  private slots:
    void lengthsAreShort_data();
    void lengthsAreShort();
    void placesHaveAsManyDecimalsAsCanBeToldApart();
    void anglesAreShort_data();
    void anglesAreShort();
};

void MeasureTest::lengthsAreShort_data() {
    QTest::addColumn<double>("metres");
    QTest::addColumn<QString>("text");

    QTest::newRow("zero") << 0.0 << "0.00";
    QTest::newRow("minus nothing") << -0.0001 << "0.000";
    QTest::newRow("rounded") << 1.256 << "1.26";
    QTest::newRow("negative") << -12.5 << "-12.50";
    QTest::newRow("small") << 0.0754 << "0.075";
    QTest::newRow("large") << 1e20 << "100000000000000000000.00";
}

void MeasureTest::lengthsAreShort() {
    QFETCH(double, metres);
    QFETCH(QString, text);
    QCOMPARE(QString::fromStdString(lengthText(metres)), text);
}

void MeasureTest::anglesAreShort_data() {
    QTest::addColumn<double>("degrees");
    QTest::addColumn<QString>("text");

    QTest::newRow("zero") << 0.0 << "0";
    QTest::newRow("whole") << 45.0 << "45";
    QTest::newRow("tenths") << -22.5 << "-22.5";
    QTest::newRow("rounded to whole") << 30.02 << "30";
    QTest::newRow("half turn") << 180.0 << "180";
    QTest::newRow("half turn the other way") << -180.0 << "180";
    QTest::newRow("just under half a turn") << -179.99 << "180";
    QTest::newRow("more than a turn") << 450.0 << "90";
}

void MeasureTest::anglesAreShort() {
    QFETCH(double, degrees);
    QFETCH(QString, text);
    QCOMPARE(QString::fromStdString(degreesText(degrees * std::numbers::pi / 180)), text);
}

void MeasureTest::placesHaveAsManyDecimalsAsCanBeToldApart() {
    QCOMPARE(placeDecimals(1 / 66.0, 0), 2);
    QCOMPARE(placeDecimals(1000, 0), 2);
    QCOMPARE(placeDecimals(0.01, 0), 2);
    QCOMPARE(placeDecimals(0.002, 0), 3);
    QCOMPARE(placeDecimals(1 / 20000.0, 0), 5);
    QCOMPARE(placeDecimals(1 / 66.0, 0.25), 2);
    QCOMPARE(placeDecimals(1 / 66.0, 0.125), 3);
    QCOMPARE(placeDecimals(1 / 66.0, 0.25 / 3), 4);
}

SPACETOW_TEST(MeasureTest)
#include "measure_test.moc"
