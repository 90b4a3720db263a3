#include "editor/window/key_bindings.h"

#include "editor/panels/names.h"
#include "editor/window/actions.h"
#include "editor/window/panels.h"

#include <QCoreApplication>

#include <algorithm>

namespace spacetow {

namespace {

struct KeyTexts {
    Q_DECLARE_TR_FUNCTIONS(KeyTexts)
};

std::vector<KeyOwner> makeKeyOwners() {
    std::vector<KeyOwner> owners;
    for (const ActionRow& row : actionRows()) {
        owners.push_back({.code = codeOf(row),
                          .name = plainText(row),
                          .place = menuPath(row.menu),
                          .usual = keysOf(row),
                          .whileEditing = (row.flags & OnlyPlaying) == 0,
                          .whilePlaying = (row.flags & WhilePlaying) != 0,
                          .yieldsToGame = (row.flags & YieldsToGame) != 0});
    }
    for (const PanelRow& row : panelRows()) {
        owners.push_back({.code = codeOf(row),
                          .name = withoutMnemonic(QCoreApplication::translate("Panels", row.title)),
                          .place = menuPath(MenuId::Panels),
                          .usual = keysIn(row.keys)});
    }
    for (const PlayKeyRow& row : playKeyRows()) {
        owners.push_back({.code = QLatin1String(row.code),
                          .name = QCoreApplication::translate("Keys", row.text),
                          .place = KeyTexts::tr("In the game"),
                          .usual = PlayKeys().of(row.meaning),
                          .whileEditing = false,
                          .whilePlaying = true,
                          .inGame = row.meaning});
    }
    return owners;
}

/// What the drawing board does with a key, whatever the tool.
bool isCanvasKey(QKeyCombination stroke) {
    const Qt::KeyboardModifiers modifiers = stroke.keyboardModifiers() & ~Qt::KeypadModifier;
    const bool isPlain = (modifiers & ~Qt::ShiftModifier) == Qt::NoModifier;
    switch (stroke.key()) {
    case Qt::Key_Escape:
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
    case Qt::Key_Backspace:
        return isPlain;
    case Qt::Key_B: // held, it serves as Alt
        return modifiers == Qt::NoModifier;
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
        return isPlain || modifiers == Qt::AltModifier;
    default:
        return false;
    }
}

bool isPlainKey(QKeyCombination stroke) {
    const bool isFunctionKey = stroke.key() >= Qt::Key_F1 && stroke.key() <= Qt::Key_F35;
    return (stroke.keyboardModifiers() & ~Qt::ShiftModifier & ~Qt::KeypadModifier) == Qt::NoModifier && !isFunctionKey;
}

QString objectionInGame(QKeyCombination stroke, const QString& shown) {
    if (!isPlainKey(stroke) || stroke.keyboardModifiers() != Qt::NoModifier) {
        return KeyTexts::tr("%1 cannot be a key of the game: choose one without Ctrl and Alt that is no function key.")
            .arg(shown);
    }
    if (stroke.key() == Qt::Key_Escape) {
        return KeyTexts::tr("%1 always shows the menu of the game.").arg(shown);
    }
    return {};
}

} // namespace

const std::vector<KeyOwner>& keyOwners() {
    static std::vector<KeyOwner> owners;
    static QString language; // the names change with it
    const QString spoken = menuText(menuRows().front());
    if (owners.empty() || language != spoken) {
        owners = makeKeyOwners();
        language = spoken;
    }
    return owners;
}

const KeyOwner* keyOwner(const QString& code) {
    const auto found = std::ranges::find(keyOwners(), code, &KeyOwner::code);
    return found == keyOwners().end() ? nullptr : &*found;
}

bool meet(const KeyOwner& one, const KeyOwner& other) {
    const bool yields =
        (one.yieldsToGame && other.inGame != PlayKey::None) || (other.yieldsToGame && one.inGame != PlayKey::None);
    return (one.whileEditing && other.whileEditing) || (one.whilePlaying && other.whilePlaying && !yields);
}

QList<QKeySequence> KeyBindings::keys(const KeyOwner& owner) const {
    const auto found = m_changed.find(owner.code);
    return found == m_changed.end() ? owner.usual : found->second;
}

void KeyBindings::setKeys(const KeyOwner& owner, const QList<QKeySequence>& keys) {
    if (keys == owner.usual) {
        m_changed.erase(owner.code);
    } else {
        m_changed[owner.code] = keys;
    }
}

void KeyBindings::reset(const KeyOwner& owner) {
    setKeys(owner, {});
    for (const QKeySequence& key : owner.usual) {
        while (const KeyOwner* const before = ownerBeside(owner, key)) {
            take(*before, key);
        }
    }
    m_changed.erase(owner.code);
}

const KeyOwner* KeyBindings::ownerOf(const QKeySequence& key) const {
    const auto found =
        std::ranges::find_if(keyOwners(), [&](const KeyOwner& owner) { return keys(owner).contains(key); });
    return found == keyOwners().end() ? nullptr : &*found;
}

const KeyOwner* KeyBindings::ownerBeside(const KeyOwner& owner, const QKeySequence& key) const {
    const auto found = std::ranges::find_if(
        keyOwners(), [&](const KeyOwner& other) { return meet(owner, other) && keys(other).contains(key); });
    return found == keyOwners().end() ? nullptr : &*found;
}

void KeyBindings::give(const KeyOwner& owner, const QKeySequence& key) {
    while (const KeyOwner* const before = ownerBeside(owner, key)) {
        take(*before, key);
    }
    setKeys(owner, QList<QKeySequence>{key} + keys(owner));
}

void KeyBindings::take(const KeyOwner& owner, const QKeySequence& key) {
    QList<QKeySequence> left = keys(owner);
    left.removeAll(key);
    setKeys(owner, left);
}

PlayKeys playKeysOf(const KeyBindings& bindings) {
    PlayKeys keys;
    for (const KeyOwner& owner : keyOwners()) {
        if (owner.inGame != PlayKey::None) {
            keys.set(owner.inGame, bindings.keys(owner));
        }
    }
    return keys;
}

QKeySequence spelledFor(const KeyOwner& owner, const QKeySequence& key) {
    if (owner.inGame == PlayKey::None || key.count() != 1) {
        return key;
    }
    constexpr auto meansNothing = Qt::ShiftModifier | Qt::KeypadModifier; // to the game
    return QKeySequence(QKeyCombination(key[0].keyboardModifiers() & ~meansNothing, key[0].key()));
}

QString objectionTo(const QKeySequence& key, const KeyOwner& owner) {
    if (key.count() != 1 || key[0].key() == Qt::Key_unknown) {
        return KeyTexts::tr("That is no single key.");
    }
    const QString shown = key.toString(QKeySequence::NativeText);
    if (owner.inGame != PlayKey::None && key[0].key() != Qt::Key_Tab) {
        return objectionInGame(key[0], shown);
    }
    if (isCanvasKey(key[0])) {
        return KeyTexts::tr("%1 belongs to the drawing board and cannot be given away.").arg(shown);
    }
    if (key[0].key() == Qt::Key_Tab && key[0].keyboardModifiers() == Qt::NoModifier &&
        !owner.usual.contains(QKeySequence(Qt::Key_Tab))) {
        return KeyTexts::tr("%1 goes from field to field and cannot be given away.").arg(shown);
    }
    if (owner.whilePlaying && !owner.yieldsToGame && isPlainKey(key[0]) && !owner.usual.contains(key)) {
        return KeyTexts::tr(
                   "“%1” works while a game is running too, when plain keys are the game's: use Ctrl, Alt or a "
                   "function key with it.")
            .arg(owner.name);
    }
    return {};
}

} // namespace spacetow
