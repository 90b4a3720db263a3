// Shortcuts on the keyboards of several countries.
#include "editor/window/actions.h"
#include "tests/support/keyboards.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QLineEdit>

#include <algorithm>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// What the stroke does in the window, as the toolkit and the window find it; null for nothing.
QAction* meantBy(const Actions& actions, const Stroke& stroke) {
    for (const QKeyCombination& candidate : stroke.candidates) {
        if (QAction* action = actions.withKey(candidate)) {
            return action;
        }
    }
    const std::optional<QKeyCombination> key = actions.keyByPlace(stroke.event());
    return key ? actions.withKey(*key) : nullptr;
}

/// Every stroke that a hand can make without a contortion.
std::vector<Stroke> allStrokes(const Keyboard& board) {
    std::vector<Stroke> strokes;
    for (const char place : usPlaces) {
        for (const Qt::KeyboardModifiers modifiers :
             {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ShiftModifier),
              Qt::KeyboardModifiers(Qt::ControlModifier), Qt::ControlModifier | Qt::ShiftModifier,
              Qt::KeyboardModifiers(Qt::AltModifier), Qt::AltModifier | Qt::ShiftModifier,
              Qt::ControlModifier | Qt::AltModifier}) {
            strokes.push_back(board.press(place, modifiers));
        }
        if (board.has(place, KeyLevel::AltGr)) {
            strokes.push_back(board.press(place, {}, true));
        }
    }
    return strokes;
}

/// Keys that no character stands on are the same on every keyboard.
bool hasKeyWithoutCharacter(const ActionRow& row) {
    const QList<QKeySequence> keys = keysOf(row);
    return std::any_of(keys.begin(), keys.end(), [](const QKeySequence& key) { return key[0].key() > 0x01000000; });
}

void addKeyboards() {
    QTest::addColumn<QString>("keyboard");
    for (const Keyboard& board : keyboards()) {
        QTest::newRow(board.name) << QString(board.name);
    }
}

/// As the toolkit does with a stroke that no shortcut was found for.
void sendTo(QWidget* widget, const Stroke& stroke) {
    QKeyEvent press = stroke.event();
    QApplication::sendEvent(widget, &press);
    QKeyEvent release = stroke.event(QEvent::KeyRelease);
    QApplication::sendEvent(widget, &release);
}

} // namespace

class ShortcutsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyActionIsReachedOnEveryKeyboard_data() { addKeyboards(); }
    void everyActionIsReachedOnEveryKeyboard() {
        QFETCH(QString, keyboard);
        TestWindow test;
        const Actions& actions = test.window->actions();
        std::set<QAction*> reached;
        for (const bool playing : {false, true}) { // a key may mean something else to a running game
            if (playing) {
                test.trigger(Act::Play);
            }
            for (const Stroke& stroke : allStrokes(keyboardNamed(keyboard))) {
                reached.insert(meantBy(actions, stroke));
            }
        }
        for (const ActionRow& row : actionRows()) {
            if (!keysOf(row).isEmpty() && !hasKeyWithoutCharacter(row)) {
                QVERIFY2(reached.contains(&actions[row.id]), row.text);
            }
        }
    }

    void lettersWithCtrlWorkOnEveryKeyboard_data() { addKeyboards(); }
    void lettersWithCtrlWorkOnEveryKeyboard() {
        QFETCH(QString, keyboard);
        TestWindow test;
        const Actions& actions = test.window->actions();
        const Keyboard& board = keyboardNamed(keyboard);
        // Where the letters are Latin ones, Z is the key with a Z on it, wherever it lies.
        const char z = keyboard == "de" ? 'Y' : keyboard == "fr" ? 'W' : 'Z';
        QCOMPARE(meantBy(actions, board.press(z, Qt::ControlModifier)), &actions[Act::Undo]);
        QCOMPARE(meantBy(actions, board.press(z, Qt::ControlModifier | Qt::ShiftModifier)), &actions[Act::Redo]);
        QCOMPARE(meantBy(actions, board.press('S', Qt::ControlModifier)), &actions[Act::Save]);
        QCOMPARE(meantBy(actions, board.press('E')), &actions[ToolId::Edge]);
        QCOMPARE(meantBy(actions, board.press('R', Qt::ShiftModifier)), &actions[Act::Reverse]);
    }

    void theRowOfDigitsWorksOnEveryKeyboard_data() { addKeyboards(); }
    void theRowOfDigitsWorksOnEveryKeyboard() {
        QFETCH(QString, keyboard);
        TestWindow test;
        const Actions& actions = test.window->actions();
        const Keyboard& board = keyboardNamed(keyboard);
        QCOMPARE(meantBy(actions, board.press('1', Qt::AltModifier)), &actions[Act::OverlayAabb]);
        QCOMPARE(meantBy(actions, board.press('6', Qt::AltModifier)), &actions[Act::OverlayQuadtree]);
        QCOMPARE(meantBy(actions, board.press('7', Qt::AltModifier)), &actions[Act::OverlayContacts]);
        QCOMPARE(meantBy(actions, board.press('8', Qt::AltModifier)), &actions[Act::OverlayTension]);
        QCOMPARE(meantBy(actions, board.press('9', Qt::AltModifier)), &actions[Act::OverlayTrails]);
        QCOMPARE(meantBy(actions, board.press('0', Qt::AltModifier)), &actions[Act::OverlaysOff]);
        QCOMPARE(meantBy(actions, board.press('0', Qt::ControlModifier)), &actions[Act::ZoomReset]);
    }

    void aLatinLetterStandsForNoOtherOne() {
        TestWindow test;
        const Actions& actions = test.window->actions();
        const Keyboard& french = keyboardNamed("fr");
        QCOMPARE(meantBy(actions, french.press('A', Qt::ControlModifier)), &actions[Act::Quit]); // Q is there
        QCOMPARE(meantBy(actions, french.press('Q', Qt::ControlModifier)), &actions[Act::SelectAll]);
    }

    void aRussianKeyboardUndoes() {
        TestWindow test;
        test.drawWalls();
        const Keyboard& board = keyboardNamed("ru");
        sendTo(&test.canvas(), board.press('Z', Qt::ControlModifier));
        QCOMPARE(test.level().objects.size(), 0);
        sendTo(&test.canvas(), board.press('P'));
        QCOMPARE(test.window->toolbox().current(), ToolId::Polygon);
    }

    void inAFieldAKeyByPlaceIsTheFields() {
        TestWindow test;
        test.drawWalls();
        auto* field = qobject_cast<QLineEdit*>(test.window->inspector().form().editor("name"));
        QVERIFY(field != nullptr);
        field->setFocus();
        field->setText(QStringLiteral("ab"));
        const Keyboard& board = keyboardNamed("ru");
        sendTo(field, board.press('A', Qt::ControlModifier));
        QCOMPARE(field->selectedText(), QStringLiteral("ab"));
        sendTo(field, board.press('P'));
        QCOMPARE(field->text(), QStringLiteral("з"));
        QCOMPARE(test.level().objects.size(), 1);
        QCOMPARE(test.window->toolbox().current(), ToolId::Select);
    }

    void aHeldKeyServesAsAlt_data() { addKeyboards(); }
    void aHeldKeyServesAsAlt() {
        QFETCH(QString, keyboard);
        TestWindow test;
        test.document().reset(test.twoBallsAtOneSpot());
        test.click(0, 0);
        const Selection first = test.document().selection();
        QCOMPARE(first.size(), 1);
        const Keyboard& board = keyboardNamed(keyboard);
        QKeyEvent press = board.press('B').event();
        QApplication::sendEvent(&test.canvas(), &press);
        test.click(0, 0);
        QCOMPARE(test.document().selection().size(), 1);
        QVERIFY(!(test.document().selection() == first)); // the one below
        test.drag(3, 3, 4, 3);                            // from anywhere
        QVERIFY(test.document().canUndo());
        QKeyEvent release = board.press('B').event(QEvent::KeyRelease);
        QApplication::sendEvent(&test.canvas(), &release);
        test.document().undo();
        test.drag(3, 3, 4, 4);
        QVERIFY(!test.document().canUndo());
    }
};

SPACETOW_TEST(ShortcutsTest)
#include "shortcuts_test.moc"
