#pragma once
// Which key is meant, whatever the keyboard. Letters are not where the keyboard has no Latin ones, and digits and
// brackets ask for Shift or AltGr on many; the key in the same place still serves, as on a US keyboard.

#include <Qt>

#include <optional>

class QKeyEvent;

namespace spacetow {

/// What a US keyboard has, without Shift, in the place of the key that was pressed; nothing where the desktop does not
/// tell the place, and for keys that are the same everywhere.
std::optional<Qt::Key> keyAtPlace(const QKeyEvent& event);

/// The key that was pressed or, where that is no letter A to Z nor any other key of a US keyboard, the one in its
/// place.
int latinKey(const QKeyEvent& event);

/// A number for the key that stays the same from press to release, though layout or modifiers change in between.
quint32 keyNumber(const QKeyEvent& event);

} // namespace spacetow
