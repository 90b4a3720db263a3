#pragma once
// The colours of panels, fields and marks, light and dark: neutral greys with a trace of blue, so that the level has
// the strong colours, and one accent. Every text can be read on its ground at 4.5 : 1, except what is disabled.

#include <QPalette>

#include <cstdint>

namespace spacetow {

enum class Shade : std::uint8_t { Light, Dark };

QPalette panelPalette(Shade shade);
/// Which of the two a palette is, whoever made it.
Shade shadeOf(const QPalette& palette);

/// Colours that say how things stand; always beside a sign or a word that says the same. Read on window and base.
struct MarkColors {
    QColor error;
    QColor warning;
    QColor good;
};
MarkColors markColors(Shade shade);

/// `share` of the way from one colour to the other.
QColor mixed(const QColor& from, const QColor& to, double share);

} // namespace spacetow
