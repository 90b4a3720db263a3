#include "editor/panels/number_field.h"

#include "editor/panels/number_text.h"
#include "tests/support/number_fixture.h"
#include "tests/support/test_main.h"

#include <QLocale>

#include <array>
#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

class NumberFieldTest : public QObject {
    Q_OBJECT

  private slots:
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void everyLocaleReadsItsOwnText() {
        constexpr std::array numbers{0.0,   1.0,  -1.5,    0.25,   1234.5,     -1234567.25,   1e7,    1.25e12,
                                     -3e-7, 0.05, 1.0 / 3, 1e-300, 123456.789, 6.02214076e23, -0.0001};
        const QList<QLocale> locales =
            QLocale::matchingLocales(QLocale::AnyLanguage, QLocale::AnyScript, QLocale::AnyCountry);
        QVERIFY(locales.size() > 300);
        for (const QLocale& locale : locales) {
            QLocale::setDefault(locale);
            for (const double number : numbers) {
                const QString exact = exactNumberText(number);
                const Result<double> read = evaluated(withPlainDigits(exact).toStdString(), "");
                QVERIFY2(read && read.value() == number, qPrintable(locale.name() + ": " + exact));
                const QString brief = shortNumberText(number);
                const Result<double> rounded = evaluated(withPlainDigits(brief).toStdString(), "");
                QVERIFY2(rounded && std::abs(rounded.value() - number) <= std::max(5e-5, 1e-5 * std::abs(number)),
                         qPrintable(locale.name() + ": " + brief));
            }
            // What people write everywhere.
            for (const char* text : {"1.5", "1,5"}) {
                const Result<double> read = evaluated(withPlainDigits(text).toStdString(), "");
                QVERIFY2(read && read.value() == 1.5, qPrintable(locale.name()));
            }
        }
    }

    void fieldsInAnyLocaleKeepWhatIsTypedAsShown() {
        for (const char* name : {"fa_IR", "ar_EG", "sv_SE", "de_DE", "ne_NP", "my_MM", "ccp_BD", "he_IL", "en_US"}) {
            QLocale::setDefault(QLocale(name));
            NumberFixture test({-1234.5678}, metres());
            test.field->setSpec({});
            test.field->setFocus();
            const QString shown = test.field->text();
            test.field->selectAll();
            QTest::keyClick(test.field, Qt::Key_Delete);
            test.field->insert(shown);
            test.field->setModified(true);
            QTest::keyClick(test.field, Qt::Key_Return);
            QVERIFY2(test.field->fault().isEmpty(), qPrintable(QString(name) + ": " + test.field->fault()));
            QCOMPARE(test.values.front(), -1234.5678);
        }
    }

    void ofALongNumberTheBeginningIsSeen() {
        NumberFixture test({-1.1904122252265}, metres());
        for (const Qt::FocusReason reason : {Qt::TabFocusReason, Qt::BacktabFocusReason, Qt::ShortcutFocusReason}) {
            test.field->clearFocus();
            test.field->setFocus(reason);
            QCOMPARE(test.field->selectedText(), QString("-1.1904122252265"));
            QCOMPARE(test.field->cursorPosition(), 0);
        }
        QTest::keyClicks(test.field, "2"); // replaces it all
        QCOMPARE(test.field->text(), QString("2"));
    }

    void whatIsShownIsNeverRoundedIntoTheValue() {
        NumberFixture test({1.23456789}, metres());
        QCOMPARE(test.field->text(), QString("1.2346"));
        QVERIFY(test.field->toolTip().contains("1.23456789"));
        test.field->setFocus();
        QCOMPARE(test.field->text(), QString("1.23456789"));
        QTest::keyClick(test.field, Qt::Key_Up);
        QCOMPARE(test.values.front(), 1.33456789);
        QTest::keyClick(test.field, Qt::Key_Down);
        QCOMPARE(test.values.front(), 1.23456789);
        test.other->setFocus();
        QCOMPARE(test.values.front(), 1.23456789);
        QCOMPARE(test.field->text(), QString("1.2346"));
        QCOMPARE(test.entries, 2);
    }

    void asManyStepsBackAsThereAreTheNumberIsTheSameToTheBit_data() {
        QTest::addColumn<double>("number");
        for (const double number : {1.0 / 3, 0.1 + 0.2, std::sqrt(2.0), 1e-9, 123456.78901234567, -0.7}) {
            QTest::addRow("%.17g", number) << number;
        }
    }
    void asManyStepsBackAsThereAreTheNumberIsTheSameToTheBit() {
        QFETCH(double, number);
        NumberFixture test({number});
        test.field->setFocus();
        const std::array modifiers{Qt::KeyboardModifiers(Qt::NoModifier), Qt::KeyboardModifiers(Qt::ShiftModifier),
                                   Qt::KeyboardModifiers(Qt::ControlModifier)};
        for (const auto& modifier : modifiers) {
            for (int i = 0; i < 7; ++i) {
                QTest::keyClick(test.field, Qt::Key_Up, modifier);
            }
        }
        QVERIFY(test.values.front() > number + 7);
        for (const auto& modifier : modifiers) {
            for (int i = 0; i < 7; ++i) {
                QTest::keyClick(test.field, Qt::Key_Down, modifier);
            }
        }
        QCOMPARE(test.values.front(), number);
        QVERIFY(test.values.front() == number);
    }

    void tenStepsOfATenthMakeOne() {
        NumberFixture test({0});
        test.field->setFocus();
        for (int i = 0; i < 10; ++i) {
            QTest::keyClick(test.field, Qt::Key_Up);
        }
        QVERIFY(test.values.front() == 1.0);
    }

    void expressionsAndUnitsAreTaken_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("value");
        QTest::newRow("expression") << "2*pi/3" << 2 * M_PI / 3;
        QTest::newRow("unit") << "20 cm" << 0.2;
        QTest::newRow("comma") << "1,25" << 1.25;
        QTest::newRow("added") << "+=0.5" << 2.5;
        QTest::newRow("multiplied") << "*=2" << 4.0;
        QTest::newRow("Persian") << QString::fromUtf8("۱٫۵") << 1.5;
        QTest::newRow("Arabic") << QString::fromUtf8("٣٫٥") << 3.5;
        QTest::newRow("Swedish") << QString::fromUtf8("1,5×10^2") << 150.0;
    }
    void expressionsAndUnitsAreTaken() {
        QFETCH(QString, text);
        QFETCH(double, value);
        NumberFixture test({2}, metres());
        test.enter(text);
        QCOMPARE(test.field->fault(), QString());
        QCOMPARE(test.values.front(), value);
    }

    void whatIsNoNumberChangesNothingAndStaysToBeMended_data() {
        QTest::addColumn<QString>("text");
        QTest::newRow("word") << "abc";
        QTest::newRow("unfinished") << "1+";
        QTest::newRow("out of range") << "1001";
        QTest::newRow("other unit") << "2 kg";
        QTest::newRow("division by zero") << "1/0";
        QTest::newRow("too much added") << "+=2000";
        QTest::newRow("empty") << " ";
    }
    void whatIsNoNumberChangesNothingAndStaysToBeMended() {
        QFETCH(QString, text);
        NumberFixture test({2}, metres());
        test.enter(text);
        QVERIFY(!test.field->fault().isEmpty());
        QVERIFY(test.field->fault().endsWith('.'));
        QCOMPARE(test.field->text(), text);
        test.other->setFocus();
        QCOMPARE(test.field->text(), text);
        QVERIFY(!test.field->fault().isEmpty());
        QCOMPARE(test.entries, 0);
        // The same number again, as when another field changes, leaves it; another number replaces it.
        test.field->setValue(2);
        QCOMPARE(test.field->text(), text);
        test.field->setFocus();
        QTest::keyClick(test.field, Qt::Key_Escape);
        QCOMPARE(test.field->text(), QString("2"));
        QVERIFY(test.field->fault().isEmpty());
        QCOMPARE(test.values.front(), 2.0);
    }

    void anObjectionFromTheLevelIsShownAtTheField() {
        NumberFixture test({2, 3}, metres());
        test.objection = "No.";
        test.enter("+=1");
        QCOMPARE(test.field->fault(), QString("No."));
        QCOMPARE(test.field->text(), QString("+=1"));
    }

    void severalNumbersAreChangedEachByItself() {
        NumberFixture test({1, 2.5}, metres());
        QVERIFY(test.field->text().isEmpty());
        QCOMPARE(test.field->placeholderText(), QString("mixed"));
        test.enter("*=2");
        QCOMPARE(test.values, (std::vector<double>{2, 5}));
        QVERIFY(test.field->text().isEmpty());
        QTest::keyClick(test.field, Qt::Key_Up);
        QCOMPARE(test.values, (std::vector<double>{2.1, 5.1}));
        test.enter("7");
        QCOMPARE(test.values, (std::vector<double>{7, 7}));
        QCOMPARE(test.field->text(), QString("7"));
    }

    void severalNumbersThatNobodyTypesOverStay() {
        NumberSpec spec = metres();
        spec.mayBeEmpty = true;
        NumberFixture test({1, 2.5}, spec);
        test.type("4");
        QTest::keyClick(test.field, Qt::Key_Backspace);
        test.other->setFocus();
        QCOMPARE(test.entries, 0);
        QVERIFY(test.field->fault().isEmpty());
    }

    void anEmptyLineMeansNoneWhereThatIsPossible() {
        NumberSpec spec = metres();
        spec.mayBeEmpty = true;
        spec.none = "no back";
        NumberFixture test({1}, spec);
        test.type("4");
        QTest::keyClick(test.field, Qt::Key_Backspace);
        QTest::keyClick(test.field, Qt::Key_Return);
        QCOMPARE(test.entries, 1);
        QVERIFY(!test.last.change);
    }

    void leavingEntersOnceAndLookingNever() {
        NumberFixture test({1}, metres());
        test.type("3");
        test.other->setFocus();
        QCOMPARE(test.entries, 1);
        test.field->setFocus();
        QTest::keyClick(test.field, Qt::Key_End);
        QTest::keyClick(test.field, Qt::Key_Return);
        test.other->setFocus();
        QCOMPARE(test.entries, 1);
        test.enter("4");
        test.other->setFocus();
        QCOMPARE(test.entries, 2);
    }

    void undoIsOfTheTextWhileTypingAndOfTheLevelAfterwards() {
        NumberFixture test({1}, metres());
        const auto leftToWindow = [&test](int key) {
            QKeyEvent event(QEvent::ShortcutOverride, key, Qt::ControlModifier);
            event.ignore();
            QApplication::sendEvent(test.field, &event);
            return !event.isAccepted();
        };
        test.type("42");
        QVERIFY(!leftToWindow(Qt::Key_Z));
        QTest::keyClick(test.field, Qt::Key_Return);
        QVERIFY(leftToWindow(Qt::Key_Z));
        QTest::keyClick(test.field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(test.field->text(), QString("42"));
        test.values = {1}; // as undoing in the level does
        test.show();
        QCOMPARE(test.field->text(), QString("1"));
        test.other->setFocus();
        QCOMPARE(test.entries, 1);
    }
};

SPACETOW_TEST(NumberFieldTest)
#include "number_field_test.moc"
