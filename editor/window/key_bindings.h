#pragma once
// Which keys lead to which action, where somebody wants other ones than the program comes with. A value: the shortcut
// editor changes a copy and puts it on the windows.

#include "editor/play/key_map.h"
#include "editor/window/act.h"

#include <QKeySequence>
#include <QList>
#include <QString>

#include <map>
#include <optional>
#include <vector>

namespace spacetow {

/// Who can have keys: an action of the table, a panel, or what a key of the game does.
struct KeyOwner {
    QString code;              // by which it is remembered
    QString name;              // translated
    QString place;             // menu, translated
    QList<QKeySequence> usual; // the keys it comes with, the first is the one that is shown
    bool whileEditing = true;
    bool whilePlaying = false;
    bool yieldsToGame = false;      // a key that the game has too is the game's while a game is running
    PlayKey inGame = PlayKey::None; // of the game itself
};

/// Whether one key for both would leave open what it means: what rests while the other works is not in its way.
bool meet(const KeyOwner& one, const KeyOwner& other);

/// Of all actions, in the order of the menus, of all panels, and of the game.
const std::vector<KeyOwner>& keyOwners();
const KeyOwner* keyOwner(const QString& code);

class KeyBindings {
  public:
    QList<QKeySequence> keys(const KeyOwner& owner) const;
    bool isUsual(const KeyOwner& owner) const { return !m_changed.contains(owner.code); }
    bool areUsual() const { return m_changed.empty(); }
    void setKeys(const KeyOwner& owner, const QList<QKeySequence>& keys);
    /// Gives back the keys it came with; who has one of them now loses it.
    void reset(const KeyOwner& owner);

    /// Who has this key; null for nobody.
    const KeyOwner* ownerOf(const QKeySequence& key) const;
    /// Who has this key and would be in the way of this owner, which may be itself.
    const KeyOwner* ownerBeside(const KeyOwner& owner, const QKeySequence& key) const;
    /// Shown first among those of its owner, and taken from who has it now.
    void give(const KeyOwner& owner, const QKeySequence& key);
    void take(const KeyOwner& owner, const QKeySequence& key);

    bool operator==(const KeyBindings&) const = default;

  private:
    std::map<QString, QList<QKeySequence>> m_changed; // by code
};

/// Those of the game itself.
PlayKeys playKeysOf(const KeyBindings& bindings);

/// As the owner's keys are spelled: those of the game go without Shift and the keypad.
QKeySequence spelledFor(const KeyOwner& owner, const QKeySequence& key);
/// A sentence that says why no action, or not this one, may have the key; empty when it may.
QString objectionTo(const QKeySequence& key, const KeyOwner& owner);

/// The file of a shortcut editor, and what the preferences keep: every owner's keys, or only the changed ones.
QByteArray keysText(const KeyBindings& bindings, bool all);
struct ReadKeys {
    std::optional<KeyBindings> bindings; // none when something is wrong
    QStringList faults;                  // sentences
    QStringList unknown;                 // codes of nobody, which are left out
};
ReadKeys readKeys(const QByteArray& text);

/// The keys of other programs. What they do not have keeps our keys, unless these are needed for something else.
struct KeyPreset {
    const char* name; // of the program; not translated
    KeyBindings (*make)();
};
std::span<const KeyPreset> keyPresets();

} // namespace spacetow
