#include "editor/window/key_editor.h"

#include "editor/window/keys_dialog.h"
#include "tests/support/game_levels.h"
#include "tests/support/keyboards.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QFile>

#include <memory>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct OpenEditor {
    TestWindow test;
    std::unique_ptr<KeyEditor> editor = std::make_unique<KeyEditor>(test.window.get());

    OpenEditor() {
        editor->show();
        QApplication::processEvents();
    }
    /// Chooses the action and presses the key for it.
    void press(const char* code, Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        editor->choose(QLatin1String(code));
        QTest::keyClick(&editor->recorder(), key, modifiers);
    }
    QAction& action(ActionId id) { return test.window->actions()[id]; }
};

int visibleRows(const QTreeWidget& tree) {
    int rows = 0;
    for (int i = 0; i < tree.topLevelItemCount(); ++i) {
        for (int j = 0; j < tree.topLevelItem(i)->childCount(); ++j) {
            rows += tree.topLevelItem(i)->child(j)->isHidden() ? 0 : 1;
        }
    }
    return rows;
}

} // namespace

class KeyEditorTest : public QObject {
    Q_OBJECT

  private slots:
    void theKeysOfTheFirstActionAreShownAtOnce() {
        OpenEditor open;
        QCOMPARE(open.editor->keyButtons().size(), 1); // Ctrl+N of New
        QVERIFY(open.editor->recorder().isEnabled());
    }

    void aFreeKeyIsGivenByPressingIt() {
        OpenEditor open;
        open.press("view/grid", Qt::Key_F13);
        QAction& grid = open.action(Act::Grid);
        const QString shown = QKeySequence("F13").toString(QKeySequence::NativeText);
        QCOMPARE(grid.shortcut(), QKeySequence("F13"));
        QVERIFY(grid.toolTip().contains(shown));
        QVERIFY(open.editor->note().contains("Grid"));
        // Palette and help say the same.
        QVERIFY(KeysDialog::overview(open.test.window->files().preferences.keyBindings()).contains(shown));
        const FinderRows rows(*open.test.window);
        QCOMPARE(rows.row(*rows.withCode("view/grid")).key, shown);
        // And so does the program when it starts again.
        open.editor.reset();
        open.test.reopen();
        QCOMPARE(open.action(Act::Grid).shortcut(), QKeySequence("F13"));
    }

    void aKeyThatIsTakenNamesItsOwnerAndCanBeTakenOver() {
        OpenEditor open;
        open.press("view/grid", Qt::Key_S, Qt::ControlModifier);
        QVERIFY2(open.editor->note().contains("Save") && open.editor->note().contains("File"),
                 qPrintable(open.editor->note()));
        QCOMPARE(open.action(Act::Save).shortcut(), QKeySequence("Ctrl+S"));
        QVERIFY(open.editor->takeOver().isVisible());
        open.editor->takeOver().click();
        QCOMPARE(open.action(Act::Grid).shortcut(), QKeySequence("Ctrl+S"));
        QVERIFY(open.action(Act::Save).shortcuts().isEmpty());
        QVERIFY(!open.editor->takeOver().isVisible());
    }

    void aKeyOfTheBoardOrTheGameIsRefused() {
        OpenEditor open;
        open.press("view/grid", Qt::Key_Space);
        QVERIFY(open.editor->note().contains("drawing board"));
        open.press("play/stop", Qt::Key_W);
        QVERIFY(open.editor->note().contains("Stop"));
        QVERIFY(open.editor->bindings().areUsual());
    }

    void aKeyIsTakenAwayAndGivenBack() {
        OpenEditor open;
        open.editor->choose("insert/select");
        QCOMPARE(open.editor->keyButtons().size(), 2); // S and Q
        open.editor->keyButtons().front()->click();
        QApplication::processEvents();
        QCOMPARE(open.action(ToolId::Select).shortcut(), QKeySequence("Q"));
        QVERIFY(open.editor->resetOne().isEnabled());
        open.editor->resetOne().click();
        QCOMPARE(open.action(ToolId::Select).shortcut(), QKeySequence("S"));
        QVERIFY(!open.editor->resetOne().isEnabled());
        open.editor->undo().click();
        QCOMPARE(open.action(ToolId::Select).shortcut(), QKeySequence("Q"));
        open.editor->undo().click();
        QVERIFY(open.editor->bindings().areUsual() && !open.editor->undo().isEnabled());
    }

    void aPresetHoldsAtOnceAndCanBeUndone() {
        OpenEditor open;
        QCOMPARE(open.editor->presets().currentIndex(), 0);
        QComboBox& presets = open.editor->presets();
        presets.setCurrentIndex(2);
        Q_EMIT presets.activated(2);
        QCOMPARE(open.action(ToolId::Circle).shortcut(), QKeySequence("E"));
        open.press("view/grid", Qt::Key_F13);
        QCOMPARE(presets.currentIndex(), presets.count() - 1); // one's own
        open.editor->undo().click();
        QCOMPARE(presets.currentIndex(), 2);
        open.editor->undo().click();
        QCOMPARE(open.action(ToolId::Circle).shortcut(), QKeySequence("C"));
    }

    void actionsAreFoundByNameAndByKey() {
        OpenEditor open;
        const int all = visibleRows(open.editor->tree());
        QVERIFY(all > 120);
        open.editor->filter().setText("zoom in");
        QVERIFY(visibleRows(open.editor->tree()) >= 1 && visibleRows(open.editor->tree()) < 10);
        open.editor->filter().setText("Ctrl+Shift+R");
        QVERIFY(visibleRows(open.editor->tree()) >= 1);
        open.editor->filter().setText("qxqxqx");
        QCOMPARE(visibleRows(open.editor->tree()), 0);
    }

    void everyActionAndPanelStandsInItAndTheKeysOfTheGame() {
        OpenEditor open;
        for (const ActionRow& row : actionRows()) {
            open.editor->choose(codeOf(row));
            QVERIFY2(open.editor->tree().currentItem()->text(0) == plainText(row), row.text);
        }
        const QTreeWidget& tree = open.editor->tree();
        const QTreeWidgetItem& game = *tree.topLevelItem(tree.topLevelItemCount() - 1);
        QCOMPARE(game.child(0)->text(0), QString("Thrust"));
        QVERIFY(game.child(0)->text(1).startsWith("W"));
        QCOMPARE(game.child(game.childCount() - 1)->text(1), QKeySequence("Esc").toString(QKeySequence::NativeText));
    }

    void theKeysOfTheGameAreChangedLikeTheOthers() {
        OpenEditor open;
        open.press("game/tow", Qt::Key_K, Qt::ShiftModifier);
        QVERIFY2(open.editor->note().contains("K leads to"), qPrintable(open.editor->note()));
        open.press("game/tow", Qt::Key_W);
        QVERIFY2(open.editor->note().contains("Thrust"), qPrintable(open.editor->note()));
        QVERIFY(open.editor->takeOver().isVisible());
        open.editor->takeOver().click();
        const KeyBindings bindings = open.test.window->files().preferences.keyBindings();
        QCOMPARE(playKeysOf(bindings).shown(PlayKey::Tow), QString("W"));
        QCOMPARE(playKeysOf(bindings).shown(PlayKey::Thrust), QKeySequence("Up").toString(QKeySequence::NativeText));
        const QString help = KeysDialog::overview(bindings);
        QVERIFY(help.contains("In the game") && help.contains("W · K"));
        QVERIFY(help.indexOf("In the game") < help.indexOf("Save As")); // what players look for comes first
        // The game that is started now listens to them.
        open.test.document().reset(openSpace());
        open.test.trigger(Act::Play);
        QTest::keyPress(&open.test.canvas(), Qt::Key_Up);
        QTRY_COMPARE(open.test.window->liveRun().phase(), Phase::Flying);
        open.test.window->stopPlaying();
    }

    void keysGoIntoAFileAndBack() {
        OpenEditor open;
        const QString path = open.test.file("keys.json");
        open.editor->questions = {[&] { return path; }, [&] { return path; }};
        open.press("view/grid", Qt::Key_F13);
        open.editor->exportKeys();
        QVERIFY(QFile::exists(path));
        open.editor->undo().click();
        QVERIFY(open.editor->bindings().areUsual());
        open.editor->importKeys();
        QCOMPARE(open.action(Act::Grid).shortcut(), QKeySequence("F13"));
    }

    void aBadFileChangesNothingAndSaysWhy() {
        OpenEditor open;
        const QString path = open.test.file("keys.json");
        open.editor->questions = {[&] { return path; }, [&] { return path + "/no/where"; }};
        open.editor->importKeys();
        QVERIFY(open.editor->note().contains("keys.json"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"keys\": {\"file/save\": [\"Ctrl+O\"]}}");
        file.close();
        open.editor->importKeys();
        QVERIFY2(open.editor->note().contains("Open"), qPrintable(open.editor->note()));
        QVERIFY(open.editor->bindings().areUsual());
        open.editor->exportKeys();
        QVERIFY(open.editor->note().contains("cannot be written"));
    }

    void aKeyIsSpelledAsShortcutsAre_data() {
        QTest::addColumn<QString>("keyboard");
        QTest::addColumn<char>("place");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<QString>("spelled");
        QTest::newRow("letter") << "us" << 'K' << int(Qt::ShiftModifier) << "Shift+K";
        QTest::newRow("sign") << "us" << '1' << int(Qt::ShiftModifier) << "!";
        QTest::newRow("german sign") << "de" << '7' << int(Qt::ControlModifier | Qt::ShiftModifier) << "Ctrl+/";
        QTest::newRow("russian letter") << "ru" << 'S' << int(Qt::ControlModifier) << "Ctrl+S";
        QTest::newRow("french letter") << "fr" << 'Q' << int(Qt::ControlModifier) << "Ctrl+A";
    }
    void aKeyIsSpelledAsShortcutsAre() {
        QFETCH(QString, keyboard);
        QFETCH(char, place);
        QFETCH(int, modifiers);
        QFETCH(QString, spelled);
        const Stroke stroke = keyboardNamed(keyboard).press(place, Qt::KeyboardModifiers(modifiers));
        QCOMPARE(keyOfStroke(stroke.event()), QKeySequence(spelled));
    }

    void modifiersAloneAreNoKeyAndTabLeadsOut() {
        OpenEditor open;
        open.press("view/grid", Qt::Key_Shift, Qt::ShiftModifier);
        QVERIFY(open.editor->recorder().key().isEmpty());
        open.editor->recorder().setFocus();
        QTest::keyClick(&open.editor->recorder(), Qt::Key_Tab);
        QVERIFY(!open.editor->recorder().hasFocus());
    }

    void thePresetIsWhatTheWindowListensTo() {
        OpenEditor open;
        Q_EMIT open.editor->presets().activated(2);
        const Actions& actions = open.test.window->actions();
        QCOMPARE(actions.withKey(QKeyCombination(Qt::Key_E)), &open.action(ToolId::Circle));
        QCOMPARE(actions.withKey(QKeyCombination(Qt::Key_P)), &open.action(ToolId::Edge));
        QVERIFY(actions.withKey(QKeyCombination(Qt::Key_C)) == nullptr);
    }

    void nothingIsCutOff() {
        OpenEditor open;
        open.press("view/grid", Qt::Key_S, Qt::ControlModifier);
        open.editor->resize(700, 480);
        QApplication::processEvents();
        QCOMPARE(cutOffTexts(*open.editor), QStringList());
    }
};

SPACETOW_TEST(KeyEditorTest)
#include "key_editor_test.moc"
