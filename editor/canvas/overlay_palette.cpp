#include "editor/canvas/overlay_palette.h"

#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"
#include "editor/canvas/theme.h"

namespace spacetow {

namespace {

/// What marks an overlay, and what stands side by side in one, is told apart with any colour vision: found by a search
/// for colours at least 20 ΔE from each other, from the walls and from the theme's own (tests/widgets/colors_test).
/// Connectors have the report's hues.
DebugColors standardColors(Shade shade) {
    const bool dark = shade == Shade::Dark;
    const auto choose = [dark](const Color& onDark, const Color& onLight) { return dark ? onDark : onLight; };
    const Theme& theme = editingTheme(shade);
    DebugColors colors;
    colors.box = toColor(theme.overlayBox);
    colors.incircle = toColor(theme.overlayIncircle);
    colors.velocity = toColor(theme.overlayVelocity);
    colors.orientation = toColor(theme.overlayOrientation);
    colors.normal = toColor(theme.overlayNormal);
    colors.staticCell = toColor(theme.overlayCell);
    colors.name = toColor(theme.text);
    colors.touchPoint = choose({241, 134, 25}, {224, 65, 255});
    colors.trail = choose({86, 68, 253}, {78, 0, 152});
    colors.massCenter = choose({251, 155, 225}, {126, 45, 147});
    colors.asleep = choose({74, 107, 135}, {183, 128, 133});
    colors.risky = choose({174, 28, 182}, {187, 53, 134});
    colors.meets = choose({197, 90, 255}, {65, 4, 85});
    colors.fatBox = choose({74, 107, 190}, {90, 110, 200});
    colors.depth = choose({150, 166, 196}, {84, 98, 160});
    colors.movingCell = choose({238, 150, 60}, {170, 90, 0});
    colors.nearPoint = choose({132, 145, 144}, {23, 14, 10});
    colors.contactNormal = choose({142, 255, 174}, {10, 150, 182});
    colors.impulse = choose({255, 225, 80}, {120, 100, 0});
    colors.passes = choose({132, 145, 144}, {130, 140, 150});
    colors.safe = choose({142, 255, 174}, {100, 150, 4});
    if (!dark) { // the same hues, as dark as ink
        colors.pressed = {200, 0, 0};
        colors.natural = {176, 140, 0};
        colors.pulled = {0, 140, 0};
        colors.islands = {{{190, 80, 20}, {0, 100, 190}, {30, 130, 30}, {150, 120, 0}, {160, 40, 160}, {0, 130, 130}}};
    }
    return colors;
}

/// Eight colours are fewer than there are overlays: those that share one differ in form.
DebugColors okabeItoColors(Shade shade) {
    constexpr Color orange{230, 159, 0};
    constexpr Color skyBlue{86, 180, 233};
    constexpr Color green{0, 158, 115};
    constexpr Color yellow{240, 228, 66};
    constexpr Color blue{0, 114, 178};
    constexpr Color vermilion{213, 94, 0};
    constexpr Color purple{204, 121, 167};
    const bool dark = shade == Shade::Dark;
    const Color ink = dark ? Color{255, 255, 255} : Color{0, 0, 0};
    const Color cool = dark ? skyBlue : blue;
    DebugColors colors;
    colors.box = ink;
    colors.fatBox = cool;
    colors.incircle = purple;
    colors.velocity = vermilion;
    colors.orientation = cool;
    colors.normal = dark ? yellow : vermilion;
    colors.depth = green;
    colors.staticCell = green;
    colors.movingCell = orange;
    colors.touchPoint = vermilion;
    colors.nearPoint = ink;
    colors.contactNormal = cool;
    colors.impulse = dark ? yellow : purple;
    colors.pressed = vermilion;
    colors.natural = ink;
    colors.pulled = cool;
    colors.trail = dark ? skyBlue : blue;
    colors.massCenter = purple;
    colors.name = ink;
    colors.asleep = dark ? blue : green;
    colors.islands = {orange, skyBlue, green, yellow, blue, purple};
    colors.meets = vermilion;
    colors.passes = cool;
    colors.safe = cool;
    colors.risky = vermilion;
    return colors;
}

} // namespace

DebugColors overlayColors(const OverlayPalette& palette, Shade shade) {
    DebugColors colors = palette.set == OverlayColorSet::OkabeIto ? okabeItoColors(shade) : standardColors(shade);
    for (const OverlayInk& ink : overlayInks()) {
        if (const auto own = palette.own.find(ink.name); own != palette.own.end()) {
            colors.*ink.color = own->second;
        }
    }
    return colors;
}

} // namespace spacetow
