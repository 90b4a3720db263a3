#include "editor/window/key_bindings.h"

#include "editor/window/actions.h"
#include "tests/support/keyboards.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

const KeyOwner& ownerNamed(const char* code) {
    return *keyOwner(QLatin1String(code));
}

QString firstKey(const KeyBindings& bindings, const char* code) {
    const QList<QKeySequence> keys = bindings.keys(ownerNamed(code));
    return keys.isEmpty() ? QString() : keys.front().toString();
}

void addPresets() {
    QTest::addColumn<int>("preset");
    for (int i = 0; i < static_cast<int>(keyPresets().size()); ++i) {
        QTest::newRow(keyPresets()[static_cast<std::size_t>(i)].name) << i;
    }
}

const KeyOwner* ownerInGame(PlayKey meaning) {
    const auto found = std::ranges::find(keyOwners(), meaning, &KeyOwner::inGame);
    return meaning == PlayKey::None || found == keyOwners().end() ? nullptr : &*found;
}

/// What some stroke on the keyboard leads to, as toolkit and window find it.
std::set<QString> ownersReached(const Keyboard& board, const Actions& actions, const KeyBindings& bindings) {
    std::set<QString> reached;
    const auto addAll = [&](const QKeySequence& key) {
        bool any = false;
        for (const KeyOwner& owner : keyOwners()) { // one in the editor, one in the game
            if (bindings.keys(owner).contains(key)) {
                reached.insert(owner.code);
                any = true;
            }
        }
        return any;
    };
    const auto add = [&](const Stroke& stroke) {
        for (const QKeyCombination& candidate : stroke.candidates) {
            if (addAll(QKeySequence(candidate))) {
                return;
            }
        }
        if (const KeyOwner* const inGame = ownerInGame(playKeysOf(bindings).meaningOf(stroke.event()))) {
            reached.insert(inGame->code);
        }
        if (const std::optional<QKeyCombination> key = actions.keyByPlace(stroke.event())) {
            addAll(QKeySequence(*key));
        }
    };
    for (const char place : usPlaces) {
        for (int bits = 0; bits < 8; ++bits) {
            add(board.press(place, Qt::KeyboardModifiers((bits & 1 ? Qt::ShiftModifier : Qt::NoModifier) |
                                                         (bits & 2 ? Qt::ControlModifier : Qt::NoModifier) |
                                                         (bits & 4 ? Qt::AltModifier : Qt::NoModifier))));
        }
        if (board.has(place, KeyLevel::AltGr)) {
            add(board.press(place, {}, true));
        }
    }
    return reached;
}

} // namespace

class KeyBindingsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsNotChangedHasItsUsualKeys() {
        const KeyBindings bindings;
        QVERIFY(bindings.areUsual());
        QCOMPARE(firstKey(bindings, "file/save"), QString("Ctrl+S"));
        QCOMPARE(firstKey(bindings, "panels/outliner"), QString("Ctrl+Shift+O"));
        QCOMPARE(bindings.ownerOf(QKeySequence("Ctrl+S"))->code, QString("file/save"));
        QVERIFY(bindings.ownerOf(QKeySequence("Ctrl+Alt+F12")) == nullptr);
    }

    void aKeyThatIsGivenIsTakenFromWhoHadIt() {
        KeyBindings bindings;
        bindings.give(ownerNamed("view/grid"), QKeySequence("Ctrl+S"));
        QCOMPARE(firstKey(bindings, "view/grid"), QString("Ctrl+S"));
        QVERIFY(bindings.keys(ownerNamed("file/save")).isEmpty());
        bindings.reset(ownerNamed("file/save")); // takes it back
        QCOMPARE(firstKey(bindings, "file/save"), QString("Ctrl+S"));
        QVERIFY(bindings.areUsual());
    }

    void theUsualKeysMeetTheirOwnRules() {
        for (const KeyOwner& owner : keyOwners()) {
            for (const QKeySequence& key : owner.usual) {
                QCOMPARE(objectionTo(key, owner), QString());
            }
        }
    }

    void someKeysBelongToBoardAndGame() {
        for (const char* key : {"Esc", "Space", "Return", "B", "Left", "Shift+Up", "Alt+Down", "Backspace", "Tab"}) {
            QVERIFY2(!objectionTo(QKeySequence(key), ownerNamed("view/grid")).isEmpty(), key);
        }
        QVERIFY(objectionTo(QKeySequence("Q"), ownerNamed("view/grid")).isEmpty());
        // What works while a game is running.
        QVERIFY(objectionTo(QKeySequence("Q"), ownerNamed("play/stop")).contains("Stop"));
        QVERIFY(objectionTo(QKeySequence("F2"), ownerNamed("play/stop")).isEmpty());
        QVERIFY(!objectionTo(QKeySequence("Ctrl+K, Ctrl+S"), ownerNamed("view/grid")).isEmpty());
    }

    void thePresetsHaveNoConflicts_data() { addPresets(); }
    void thePresetsHaveNoConflicts() {
        QFETCH(int, preset);
        const KeyBindings bindings = keyPresets()[static_cast<std::size_t>(preset)].make();
        for (const KeyOwner& owner : keyOwners()) {
            for (const QKeySequence& key : bindings.keys(owner)) {
                const KeyOwner& first = *bindings.ownerBeside(owner, key);
                QVERIFY2(first.code == owner.code, qPrintable(key.toString() + " " + first.code + " " + owner.code));
                QCOMPARE(objectionTo(key, owner), QString());
            }
        }
    }

    void aKeyOfTheEditorMayBeAnotherOneOfTheGame() {
        const KeyOwner& reload = ownerNamed("file/reload");
        const KeyOwner& restart = ownerNamed("play/restart");
        QVERIFY(!meet(reload, restart));
        KeyBindings bindings;
        bindings.give(reload, QKeySequence("F12"));
        bindings.give(restart, QKeySequence("F12"));
        QCOMPARE(firstKey(bindings, "file/reload"), QString("F12"));
        QCOMPARE(firstKey(bindings, "play/restart"), QString("F12"));
        bindings.give(ownerNamed("view/grid"), QKeySequence("F12"));
        QVERIFY(firstKey(bindings, "file/reload") != QString("F12"));
        QCOMPARE(firstKey(bindings, "play/restart"), QString("F12"));
        bindings.give(ownerNamed("view/full-screen"), QKeySequence("F12")); // works in both
        QVERIFY(firstKey(bindings, "play/restart") != QString("F12"));
    }

    void theGameHasKeysOfItsOwnThatMeetNoneOfTheEditors() {
        KeyBindings bindings;
        const KeyOwner& tow = ownerNamed("game/tow");
        bindings.give(tow, QKeySequence("S")); // the select tool's as well, which rests meanwhile
        QCOMPARE(firstKey(bindings, "insert/select"), QString("S"));
        QCOMPARE(playKeysOf(bindings).shown(PlayKey::Tow), QString("S"));
        QCOMPARE(bindings.ownerBeside(tow, QKeySequence("W"))->code, QString("game/thrust"));
        bindings.give(tow, QKeySequence("W"));
        QCOMPARE(firstKey(bindings, "game/thrust"), QString("Up"));
        bindings.reset(ownerNamed("game/thrust"));
        QCOMPARE(firstKey(bindings, "game/thrust"), QString("W"));
        QVERIFY(!bindings.keys(tow).contains(QKeySequence("W")));
    }

    void theGameTakesPlainKeysOnly() {
        const KeyOwner& tow = ownerNamed("game/tow");
        for (const char* key : {"Q", "Return", "Space", "Backspace", "Down", "B", "!"}) {
            QCOMPARE(objectionTo(QKeySequence(key), tow), QString());
        }
        for (const char* key : {"Ctrl+Q", "Alt+Q", "F6", "Esc", "Tab"}) {
            QVERIFY2(!objectionTo(QKeySequence(key), tow).isEmpty(), key);
        }
        QCOMPARE(spelledFor(tow, QKeySequence("Shift+K")), QKeySequence("K"));
        QCOMPARE(spelledFor(tow, QKeySequence("Num+4")), QKeySequence("4"));
        QCOMPARE(spelledFor(ownerNamed("view/grid"), QKeySequence("Shift+K")), QKeySequence("Shift+K"));
    }

    void theKeysOfTheGameGoIntoAFileAndBack() {
        KeyBindings bindings;
        bindings.give(ownerNamed("game/thrust"), QKeySequence("I"));
        const ReadKeys read = readKeys(keysText(bindings, false));
        QVERIFY2(read.bindings, qPrintable(read.faults.join('\n')));
        QVERIFY(*read.bindings == bindings);
        const ReadKeys twice = readKeys("{\"keys\": {\"game/left\": [\"X\"], \"game/right\": [\"Shift+X\"]}}");
        QVERIFY(!twice.bindings);
        QVERIFY2(twice.faults.join('\n').contains("Turn right"), qPrintable(twice.faults.join('\n')));
    }

    void everyActionKeepsAKeyInEveryPreset_data() { addPresets(); }
    void everyActionKeepsAKeyInEveryPreset() {
        QFETCH(int, preset);
        const KeyBindings bindings = keyPresets()[static_cast<std::size_t>(preset)].make();
        for (const ActionRow& row : actionRows()) {
            const KeyOwner& owner = *keyOwner(codeOf(row));
            QVERIFY2(owner.usual.isEmpty() || !bindings.keys(owner).isEmpty(), qPrintable(owner.code));
        }
    }

    void thePresetsAreReachedOnEveryKeyboard_data() { addPresets(); }
    void thePresetsAreReachedOnEveryKeyboard() {
        QFETCH(int, preset);
        TestWindow test;
        const KeyBindings bindings = keyPresets()[static_cast<std::size_t>(preset)].make();
        test.window->files().preferences.setKeyBindings(bindings);
        test.window->updateKeys();
        for (const Keyboard& board : keyboards()) {
            const std::set<QString> reached = ownersReached(board, test.window->actions(), bindings);
            for (const KeyOwner& owner : keyOwners()) {
                const QList<QKeySequence> keys = bindings.keys(owner);
                const bool anywhere = std::any_of(keys.begin(), keys.end(), [](const QKeySequence& key) {
                    return key[0].key() == Qt::Key_Space || key[0].key() > 0x01000000; // no character stands on it
                });
                QVERIFY2(keys.isEmpty() || anywhere || reached.contains(owner.code),
                         qPrintable(owner.code + " on " + board.name));
            }
        }
    }

    void thePresetsHaveTheKeysOfTheirPrograms() {
        const auto preset = [](std::size_t i) { return keyPresets()[i].make(); };
        QVERIFY(preset(0).areUsual());
        QCOMPARE(firstKey(preset(1), "insert/select"), QString("S"));
        QCOMPARE(firstKey(preset(1), "insert/nodes"), QString("O"));
        QCOMPARE(firstKey(preset(1), "view/grid"), QString("Ctrl+G"));
        QCOMPARE(firstKey(preset(2), "insert/nodes"), QString("N"));
        QCOMPARE(firstKey(preset(2), "insert/circle"), QString("E"));
        QCOMPARE(firstKey(preset(2), "path/union"), QString("Ctrl++"));
        QCOMPARE(firstKey(preset(3), "edit/delete"), QString("X"));
        QCOMPARE(firstKey(preset(3), "edit/select-all"), QString("A"));
    }

    void whatIsWrittenIsReadBackTheSame_data() { addPresets(); }
    void whatIsWrittenIsReadBackTheSame() {
        QFETCH(int, preset);
        const KeyBindings bindings = keyPresets()[static_cast<std::size_t>(preset)].make();
        for (const bool all : {true, false}) {
            const ReadKeys read = readKeys(keysText(bindings, all));
            QVERIFY2(read.bindings && read.faults.isEmpty(), qPrintable(read.faults.join(' ')));
            QVERIFY(*read.bindings == bindings);
        }
    }

    void aBadFileIsRefusedInASentence_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("words");
        QTest::newRow("no json") << QByteArray("{\n\"keys\": nonsense}") << "Line 2";
        QTest::newRow("a list") << QByteArray("[1]") << "no keys in it";
        QTest::newRow("empty") << QByteArray() << "The file is empty.";
        QTest::newRow("newer") << QByteArray("{\"schema\": 9, \"keys\": {}}") << "newer";
        QTest::newRow("no list") << QByteArray("{\"keys\": {\"file/save\": \"Ctrl+S\"}}") << "file/save";
        QTest::newRow("no key") << QByteArray("{\"keys\": {\"file/save\": [\"Ctrl+Foo\"]}}") << "Ctrl+Foo";
        QTest::newRow("a number") << QByteArray("{\"keys\": {\"file/save\": [7]}}") << "file/save";
        QTest::newRow("chord") << QByteArray("{\"keys\": {\"file/save\": [\"Ctrl+K, S\"]}}") << "Ctrl+K, S";
        QTest::newRow("board's") << QByteArray("{\"keys\": {\"file/save\": [\"Esc\"]}}") << "drawing board";
        QTest::newRow("twice") << QByteArray("{\"keys\": {\"file/save\": [\"Ctrl+O\"]}}") << "Open";
    }
    void aBadFileIsRefusedInASentence() {
        QFETCH(QByteArray, text);
        QFETCH(QString, words);
        const ReadKeys read = readKeys(text);
        QVERIFY(!read.bindings);
        QVERIFY2(read.faults.join('\n').contains(words), qPrintable(read.faults.join('\n')));
    }

    void actionsOfOtherVersionsAreLeftOut() {
        const ReadKeys read = readKeys("{\"keys\": {\"file/teleport\": [\"Ctrl+S\"], \"view/grid\": [\"F13\"]}}");
        QVERIFY(read.bindings);
        QCOMPARE(read.unknown, QStringList{"file/teleport"});
        QCOMPARE(firstKey(*read.bindings, "view/grid"), QString("F13"));
    }
};

SPACETOW_TEST(KeyBindingsTest)
#include "key_bindings_test.moc"
