#include "editor/canvas/figure_text.h"

#include "tests/support/test_main.h"

#include <QLocale>

using namespace spacetow;

class FigureTextTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale::c()); }

    void aReadingHasFewDigitsAndNoExponent_data() {
        QTest::addColumn<double>("number");
        QTest::addColumn<QString>("text");
        for (const auto& [number, text] :
             {std::pair(0.0, "0"), std::pair(-1e-12, "0"), std::pair(1.5, "1.5"), std::pair(25.234, "25.23"),
              std::pair(-0.123456, "-0.1235"), std::pair(999.96, "1000"), std::pair(1216.44, "1216"),
              std::pair(1234567.8, "1234568"), std::pair(0.00012345, "0.0001235")}) {
            QTest::newRow(text) << number << QString(text);
        }
    }
    void aReadingHasFewDigitsAndNoExponent() {
        QFETCH(double, number);
        QFETCH(QString, text);
        QCOMPARE(figureText(number), text);
    }

    void largeOnesArePartedAsTheLocaleDoes() {
        QLocale::setDefault(QLocale("en_US"));
        QCOMPARE(figureText(12345.6), QString("12,346"));
        QLocale::setDefault(QLocale::c());
    }
};

SPACETOW_TEST(FigureTextTest)
#include "figure_text_test.moc"
