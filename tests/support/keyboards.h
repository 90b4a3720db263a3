#pragma once
// Key events as the keyboards of several countries send them: what is printed on the key in each place of a US
// keyboard, and what the toolkit makes of a stroke.

#include <QKeyCombination>
#include <QKeyEvent>
#include <QList>
#include <QString>

#include <span>

namespace spacetow::test {

struct Stroke {
    int key;
    Qt::KeyboardModifiers modifiers;
    quint32 scanCode;
    QString text;
    /// What is compared with shortcuts, the first that fits wins: the key itself, then with Shift used up.
    QList<QKeyCombination> candidates;

    QKeyEvent event(QEvent::Type type = QEvent::KeyPress) const {
        return QKeyEvent(type, key, modifiers, scanCode, 0, 0, text);
    }
};

/// AltGr chooses the third character of a key and is no modifier of the stroke.
enum class KeyLevel { Plain, Shift, AltGr };

struct Keyboard {
    const char* name;
    const char16_t* plain; // 47 characters, in the order of `usPlaces`
    const char16_t* shifted;
    const char16_t* third; // blank: none
    const char16_t* dead;  // those that wait for a letter to put an accent on

    /// The key in the place of one of the US keyboard.
    Stroke press(char place, Qt::KeyboardModifiers modifiers = {}, bool altGr = false) const;
    bool has(char place, KeyLevel level) const;
};

/// us, de, fr, ru, se; the Russian one without Latin letters anywhere.
std::span<const Keyboard> keyboards();
const Keyboard& keyboardNamed(const QString& name);
/// What stands on the keys of a US keyboard, without Shift.
extern const std::string_view usPlaces;

} // namespace spacetow::test
