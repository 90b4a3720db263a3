#include "core/base/expression.h"

#include "core/base/decimal.h"
#include "core/base/random.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <limits>
#include <numbers>

using namespace spacetow;

namespace {

constexpr double pi = std::numbers::pi;

void addRow(const char* text, const char* unit, double value) {
    QTest::newRow(text) << QByteArray(text) << QByteArray(unit) << value;
}

void addFault(const char* text, const char* unit, const char* code) {
    QTest::newRow(*text == '\0' ? "nothing" : text) << QByteArray(text) << QByteArray(unit) << QByteArray(code);
}

} // namespace

class ExpressionTest : public QObject {
    Q_OBJECT

  private slots:
    void anExpressionHasItsValue_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<double>("value");
        addRow("1.5", "", 1.5);
        addRow("1,5", "", 1.5);
        addRow(".5", "", 0.5);
        addRow(",5", "", 0.5);
        addRow("5.", "", 5);
        addRow("1e-3", "", 0.001);
        addRow("2E+3", "", 2000);
        addRow("1e-999", "", 0);
        addRow("−2", "", -2);
        addRow("--2", "", 2);
        addRow("2*pi/3", "", 2 * pi / 3);
        addRow("2·π", "", 2 * pi);
        addRow("tau", "", 2 * pi);
        addRow("sqrt(2)", "", std::sqrt(2));
        addRow("1+2*3", "", 7);
        addRow("(1+2)*3", "", 9);
        addRow("7-2-1", "", 4);
        addRow("8/4/2", "", 1);
        addRow("2^3^2", "", 512);
        addRow("-2^2", "", -4);
        addRow("2^-1", "", 0.5);
        addRow("3²", "", 9);
        addRow("0.1+0.2", "", 0.3);
        addRow("1.1-0.1", "", 1);
        addRow("abs(-3)", "", 3);
        addRow("round(2.5)+floor(2.5)+ceil(2.5)", "", 8);
        addRow("min(1,5; 2)", "", 1.5);
        addRow("max(1,5; 2)", "", 2);
        addRow("exp(0)+ln(e)+log(1000)", "", 5);
        addRow("50%", "", 0.5);
        addRow("50%", "%", 50);
        addRow("50", "%", 50);
        addRow("10 cm / 1 m", "", 0.1);
        addRow("sin(30°)", "", 0.5);
        addRow("cos(60°)", "", 0.5);
        addRow("sin(180°)", "", 0);
        addRow("cos(90°)", "", 0);
        addRow("sin(-30°)", "", -0.5);
        addRow("tan(45°)", "", 1);
        addRow("tan(135°)", "", -1);
        addRow("sin(1)", "", std::sin(1));
        addRow("sin(1 rad)", "", std::sin(1));
        addRow("sin(31°)", "", std::sin(31 * pi / 180));
        addRow("2", "m", 2);
        addRow("20 cm", "m", 0.2);
        addRow("35cm", "m", 0.35);
        addRow("1 + 20 cm", "m", 1.2);
        addRow("20 cm + 1", "m", 1.2);
        addRow("1/2 m", "m", 0.5);
        addRow("1/2 m + 1/4 m", "m", 0.75);
        addRow("1 m / 20 cm * 1 m", "m", 5);
        addRow("(1+2) m", "m", 3);
        addRow("sqrt(4 m^2)", "m", 2);
        addRow("sqrt(4 m²)", "m", 2);
        addRow("1 in", "m", 0.0254);
        addRow("round(2.6 cm)", "m", 0.03);
        addRow("250 ms", "s", 0.25);
        addRow("1 min", "s", 60);
        addRow("2 kN", "N", 2000);
        addRow("2 kg * 3 m/s²", "N", 6);
        addRow("5 N s/m", "N s/m", 5);
        addRow("3 N/mm", "N/m", 3000);
        addRow("36 km/h", "m/s", 10);
        addRow("9,81 m/s^2", "m/s²", 9.81);
        addRow("2 Hz", "1/s", 2);
        addRow("300 g/m²", "kg/m²", 0.3);
        addRow("45°", "°", 45);
        addRow("45° + 45°", "°", 90);
        addRow("90 + 45°", "°", 135);
        addRow("45", "°", 45);
        addRow("0.5 rad", "°", 0.5 * 180 / pi);
        addRow("2*pi/3 rad", "°", 120);
        addRow("1/4 turn", "°", 90);
        addRow("atan(1)", "°", 45);
        addRow("90°/s", "°/s", 90);
        addRow("pi rad/s", "°/s", 180);
        addRow("45°", "rad", pi / 4);
    }
    void anExpressionHasItsValue() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, unit);
        QFETCH(double, value);
        const Result<double> result = evaluated(text.toStdString(), unit.toStdString());
        QVERIFY2(static_cast<bool>(result), result ? "" : result.error().code.text().data());
        QVERIFY2(std::abs(result.value() - value) <= 4e-16 * std::abs(value),
                 qPrintable(QString::number(result.value(), 'g', 17)));
    }

    void decimalsComeOutToTheBit() {
        QCOMPARE(evaluated("35 cm", "m").value(), 0.35);
        QCOMPARE(evaluated("29 mm", "m").value(), 0.029);
        QCOMPARE(evaluated("0.1+0.2", "m").value(), 0.3);
        QCOMPARE(evaluated("20 ms", "s").value(), 0.02);
        QCOMPARE(evaluated("15° + 15°", "°").value(), 30.0);
    }

    void whatIsNoExpressionSaysWhy_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<QByteArray>("code");
        addFault("", "", "expression-empty");
        addFault("  ", "", "expression-empty");
        addFault("abc", "", "expression-unknown");
        addFault("inf", "", "expression-unknown");
        addFault("nan", "", "expression-unknown");
        addFault("sin", "", "expression-unknown");
        addFault("2 apples", "m", "expression-unexpected");
        addFault("1+", "", "expression-unfinished");
        addFault("(1", "", "expression-unclosed");
        addFault("sin(1", "", "expression-unclosed");
        addFault("1)", "", "expression-unexpected");
        addFault("()", "", "expression-unexpected");
        addFault("1 2", "", "expression-unexpected");
        addFault("1.234,5", "", "expression-unexpected");
        addFault("1.2.3", "", "expression-unexpected");
        addFault("2pi", "", "expression-unexpected");
        addFault(".", "", "expression-unexpected");
        addFault("1 $", "", "expression-unexpected");
        addFault("*2", "", "expression-unexpected");
        addFault("1/0", "", "expression-divided-by-zero");
        addFault("1/(2-2)", "", "expression-divided-by-zero");
        addFault("1e999", "", "expression-not-finite");
        addFault("1e300*1e300", "", "expression-not-finite");
        addFault("sqrt(-1)", "", "expression-not-finite");
        addFault("(-8)^(1/3)", "", "expression-not-finite");
        addFault("tan(90°)", "", "expression-not-finite");
        addFault("0^-1", "", "expression-not-finite");
        addFault("sqrt()", "", "expression-unexpected");
        addFault("sqrt(1;2)", "", "expression-arguments");
        addFault("min(1)", "", "expression-arguments");
        addFault("1 m + 1 s", "m", "expression-units-differ");
        addFault("sin(1 m)", "", "expression-units-differ");
        addFault("sqrt(1 m)", "m", "expression-units-differ");
        addFault("2^(1 m)", "", "expression-units-differ");
        addFault("1 kg", "m", "expression-wrong-unit");
        addFault("1 m²", "m", "expression-wrong-unit");
        addFault("45°", "m", "expression-wrong-unit");
        addFault("1 m", "", "expression-needs-no-unit");
    }
    void whatIsNoExpressionSaysWhy() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, unit);
        QFETCH(QByteArray, code);
        const Result<double> result = evaluated(text.toStdString(), unit.toStdString());
        QVERIFY2(!result, qPrintable(QString::number(result ? result.value() : 0)));
        QCOMPARE(QByteArray::fromStdString(std::string(result.error().code.text())), code);
    }

    void theWordThatIsWrongIsNamed() {
        QCOMPARE(evaluated("2 * foo", "").error().arguments, std::vector<std::string>{"foo"});
        QCOMPARE(evaluated("1 €", "").error().arguments, std::vector<std::string>{"€"});
        QCOMPARE(evaluated("1 kg", "m/s").error().arguments, std::vector<std::string>{"m/s"});
    }

    void relativeEntriesChangeWhatIsThere_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("unit");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        const auto row = [](const char* text, const char* unit, double from, double to) {
            QTest::newRow(text) << QByteArray(text) << QByteArray(unit) << from << to;
        };
        row("+=0.5", "m", 1.25, 1.75);
        row("+= 0,2", "m", 0.1, 0.3);
        row("-=0.1", "m", 0.3, 0.2);
        row("−=0.1", "m", 0.3, 0.2);
        row("*=2", "m", 1.5, 3);
        row("×=2", "m", 1.5, 3);
        row("/=4", "m", 1, 0.25);
        row("*=50%", "m", 3, 1.5);
        row("*=2*(1+1)", "m", 1, 4);
        row("+=20 cm", "m", 1, 1.2);
        row("+=45°", "°", 45, 90);
        row("-=-1", "", 1, 2);
        row("7", "", 1, 7);
    }
    void relativeEntriesChangeWhatIsThere() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, unit);
        QFETCH(double, from);
        QFETCH(double, to);
        const Result<NumberChange> change = numberChange(text.toStdString(), unit.toStdString());
        QVERIFY2(static_cast<bool>(change), change ? "" : change.error().code.text().data());
        QCOMPARE(applied(change.value(), from), to);
        QCOMPARE(change.value().isRelative(), text != "7");
    }

    void aFactorHasNoUnitAndIsNotZeroBelow() {
        QCOMPARE(numberChange("*=2 m", "m").error().code.text(), std::string("expression-needs-no-unit"));
        QCOMPARE(numberChange("/=0", "m").error().code.text(), std::string("expression-divided-by-zero"));
        QCOMPARE(numberChange("+=", "m").error().code.text(), std::string("expression-empty"));
        QCOMPARE(numberChange("^=2", "m").error().code.text(), std::string("expression-unexpected"));
        QCOMPARE(numberChange("=2", "m").error().code.text(), std::string("expression-unexpected"));
    }

    void decimalNumbersAddAsTheyAreWritten() {
        QCOMPARE(decimalSum(0.1, 0.2), 0.3);
        QCOMPARE(decimalSum(1.23456789, 0.1), 1.33456789);
        QCOMPARE(decimalSum(decimalSum(1.0 / 3, 0.1), -0.1), 1.0 / 3);
        QCOMPARE(decimalSum(1e300, 1e-300), 1e300);
        QCOMPARE(decimalMultiple(0.1, 3), 0.3);
        QCOMPARE(decimalMultiple(0.01, -7), -0.07);
        QCOMPARE(decimalMultiple(1e300, 2), 2e300);
        QVERIFY(!std::signbit(decimalSum(0.1, -0.1)));
        QVERIFY(!std::isfinite(decimalSum(std::numeric_limits<double>::max(), std::numeric_limits<double>::max())));
    }

    void deepNestingIsRefusedAndStopsNothing() {
        for (const char* piece : {"(", "-", "2^", "sqrt("}) {
            std::string text;
            for (int i = 0; i < 200; ++i) {
                text += piece;
            }
            QCOMPARE(evaluated(text + "1", "").error().code.text(), std::string("expression-too-deep"));
        }
        QCOMPARE(evaluated(std::string(1'000'000, '1'), "").error().code.text(), std::string("expression-too-deep"));
    }

    void anyTextIsAFiniteNumberOrAnError() {
        constexpr std::uint64_t seed = 20261201;
        Random random(seed);
        constexpr std::array<const char*, 28> pieces{"1",   "2.5", ",",    ".", "e",  "+",    "-",     "*",    "/", "^",
                                                     "(",   ")",   "sin(", "m", "cm", "°",    "rad",   "kN",   "s", "²",
                                                     "min", ";",   "=",    " ", "pi", "\xff", "sqrt(", "1e308"};
        for (int i = 0; i < 20'000; ++i) {
            std::string text;
            for (std::uint32_t length = random.next() % 12; length > 0; --length) {
                text += pieces[random.next() % pieces.size()];
            }
            const Result<NumberChange> change = numberChange(text, i % 2 == 0 ? "m" : "°");
            QVERIFY2(!change || std::isfinite(change.value().operand),
                     (text + ", seed " + std::to_string(seed)).c_str());
        }
    }
};

SPACETOW_TEST(ExpressionTest)
#include "expression_test.moc"
