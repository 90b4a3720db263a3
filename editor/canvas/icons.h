#pragma once
// The program's icons: line drawings from the resources in the colours of the palette, drawn when they are needed and
// for the display they are shown on, so that they are sharp at every scale and read on light and on dark panels.

#include <QIcon>
#include <QPalette>

namespace spacetow {

/// The icon ":/icons/NAME.svg" in the text colours of the palette; an empty icon when there is none of that name.
QIcon icon(const QString& name, const QPalette& palette);
/// In those of the application, whatever they are when it is drawn: for who is not told that they have changed.
QIcon livingIcon(const QString& name);
/// In one colour, for marks such as warnings.
QIcon icon(const QString& name, const QColor& color);
/// The same in a list, where a row that is selected has a colour of its own behind it.
QIcon icon(const QString& name, const QColor& color, const QColor& onSelection);
/// The picture of the program itself, in its own colours.
QIcon applicationIcon();

} // namespace spacetow
