#include "editor/play/key_map.h"

#include "editor/canvas/key_place.h"
#include "tests/support/keyboards.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

Q_DECLARE_METATYPE(spacetow::PlayKey)

class KeyMapTest : public QObject {
    Q_OBJECT

  private slots:
    void whatSteersLiesInTheSamePlaceOnEveryKeyboard_data() {
        QTest::addColumn<QString>("keyboard");
        for (const Keyboard& keyboard : keyboards()) {
            QTest::newRow(keyboard.name) << QString(keyboard.name);
        }
    }
    void whatSteersLiesInTheSamePlaceOnEveryKeyboard() {
        QFETCH(QString, keyboard);
        const Keyboard& board = keyboardNamed(keyboard);
        QCOMPARE(playKey(board.press('W').event()), PlayKey::Thrust);
        QCOMPARE(playKey(board.press('A').event()), PlayKey::Left);
        QCOMPARE(playKey(board.press('D').event()), PlayKey::Right);
    }

    void theLettersSteerAsWellWhereverTheyLie() {
        const Keyboard& french = keyboardNamed("fr"); // A in the place of Q, W in that of Z
        QCOMPARE(playKey(french.press('Q').event()), PlayKey::Left);
        QCOMPARE(playKey(french.press('Z').event()), PlayKey::Thrust);
    }

    void commandsGoByTheirLetter_data() { whatSteersLiesInTheSamePlaceOnEveryKeyboard_data(); }
    void commandsGoByTheirLetter() {
        QFETCH(QString, keyboard);
        const Keyboard& board = keyboardNamed(keyboard);
        QCOMPARE(playKey(board.press('P').event()), PlayKey::Pause);
        QCOMPARE(playKey(board.press('O').event()), PlayKey::Step);
        QCOMPARE(playKey(board.press('R').event()), PlayKey::Restart);
        QCOMPARE(playKey(board.press('F').event()), PlayKey::Follow);
    }

    void whatIsHeldIsLetGoThoughTheLayoutChangedMeanwhile() {
        HeldKeys held;
        QVERIFY(held.press(keyboardNamed("us").press('W').event()));
        held.release(keyboardNamed("ru").press('W').event());
        QVERIFY(held.controls() == Controls{});
    }

    void aKeyThatWasChosenIsTheOneWithThatOnIt() {
        const Keyboard& french = keyboardNamed("fr");
        PlayKeys keys;
        keys.set(PlayKey::Tow, {QKeySequence("Q")}); // where A is on a US keyboard
        QCOMPARE(keys.meaningOf(french.press('A').event()), PlayKey::Tow);
        QCOMPARE(keys.meaningOf(french.press('Q').event()), PlayKey::Left); // by its letter, A
        QCOMPARE(keys.meaningOf(keyboardNamed("us").press('A').event()), PlayKey::Left);
        QCOMPARE(keys.meaningOf(keyboardNamed("ru").press('Q').event()), PlayKey::Tow);
    }

    void aSignIsTheSameKeyWithShiftHeld() {
        PlayKeys keys;
        keys.set(PlayKey::Tow, {QKeySequence("1")});
        QCOMPARE(keys.meaningOf(keyboardNamed("us").press('1').event()), PlayKey::Tow);
        QCOMPARE(keys.meaningOf(keyboardNamed("us").press('1', Qt::ShiftModifier).event()), PlayKey::Tow);
    }

    void escAlwaysShowsTheMenu() {
        const QKeyEvent event(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
        QCOMPARE(playKey(event), PlayKey::Menu);
    }

    void withoutScanCodesLettersDo() {
        const QKeyEvent event(QEvent::KeyPress, Qt::Key_W, Qt::NoModifier, "w");
        QVERIFY(!keyAtPlace(event));
        QCOMPARE(playKey(event), PlayKey::Thrust);
    }

    void keysWithModifiersAreTheEditors() {
        QCOMPARE(playKey(keyboardNamed("ru").press('W', Qt::ControlModifier).event()), PlayKey::None);
    }
};

SPACETOW_TEST(KeyMapTest)
#include "key_map_test.moc"
