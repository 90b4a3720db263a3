#pragma once
// What objects are called on the screen.

#include "core/level/level.h"

#include <QString>

namespace spacetow {

/// Number of the kind of the object, below kindCount(). Those of bodies of one shape are the places in LevelShape.
int kindOf(const Object& object);
int kindCount();
/// "One-way wall", "Ship", …
QString kindName(int kind);
QString kindName(const Object& object);
/// Of the picture for its kind; see editor/canvas/icons.h.
QString kindIcon(const Object& object);
/// Its own name, else what kind of thing it is.
QString displayName(const Object& object);
/// "floor (Polygon)", or for an object without a name "Polygon at 3; -2.5", so that it can be told from its like.
QString listedName(const Level& level, const Object& object);
/// For menus, where a single & would be the mark of a mnemonic.
QString menuSafe(const QString& name);
/// For tooltips, where a name with < in it would be taken for rich text.
QString plainToolTip(const QString& text);

/// The text of a menu as it reads elsewhere: without the mark of the letter that is pressed, and, as Chinese has it,
/// without that letter: "&Open…" and "打开(&O)…".
QString withoutMnemonic(QString text);
/// Its kind and where it is, as in "Circle at 1.5; 2", without its name; of connectors and groups only the kind.
QString placedKind(const Object& object);

} // namespace spacetow
