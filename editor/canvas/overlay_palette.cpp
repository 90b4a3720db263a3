#include "editor/canvas/overlay_palette.h"

#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"
#include "editor/canvas/theme.h"

#include <array>

namespace spacetow {

namespace {

/// What marks an overlay, and what stands side by side in one, is told apart with any colour vision: found by a search
/// for colours at least 20 ΔE from each other, from the walls and from the theme's own (tests/widgets/colors_test,
/// legend_test).
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
    colors.way = choose({146, 190, 255}, {130, 70, 180});
    colors.lostWay = choose({190, 200, 220}, {120, 110, 250});
    colors.massCenter = choose({251, 155, 225}, {126, 45, 147});
    colors.asleep = choose({74, 107, 135}, {183, 128, 133});
    colors.risky = choose({174, 28, 182}, {187, 53, 134});
    colors.meets = choose({197, 90, 255}, {65, 4, 85});
    colors.fatBox = choose({74, 107, 190}, {90, 110, 230});
    colors.depth = choose({150, 166, 196}, {84, 98, 160});
    colors.movingCell = choose({238, 150, 60}, {170, 90, 0});
    colors.nearPoint = choose({132, 145, 144}, {23, 14, 10});
    colors.contactNormal = choose({168, 79, 207}, {70, 36, 250});
    colors.impulse = choose({212, 254, 13}, {20, 84, 84});
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

/// The colours of Okabe and Ito that lines on this ground can have. On paper most of them would be too light, and are
/// as dark as ink. Without blue or green cones nobody tells green or orange from all of the others: lines of bodies, of
/// which there are seven, have violet beside.
struct SafeInks {
    Color ink, cool, vermilion, green, purple, violet;
    Color normal, cell, movingCell, trail, asleep;
    std::array<Color, 6> islands;
};

constexpr SafeInks safeOnDark{
    .ink = {255, 255, 255},
    .cool = {86, 180, 233},
    .vermilion = {213, 94, 0},
    .green = {0, 158, 115},
    .purple = {204, 121, 167},
    .violet = {143, 62, 253},
    .normal = {240, 228, 66},
    .cell = {0, 114, 178},
    .movingCell = {240, 228, 66},
    .trail = {0, 114, 178},
    .asleep = {80, 80, 80},
    .islands = {{{230, 159, 0}, {86, 180, 233}, {0, 158, 115}, {240, 228, 66}, {0, 114, 178}, {204, 121, 167}}}};
constexpr SafeInks safeOnLight{
    .ink = {0, 0, 0},
    .cool = {0, 114, 178},
    .vermilion = {213, 94, 0},
    .green = {0, 158, 115},
    .purple = {173, 103, 142},
    .violet = {117, 3, 234},
    .normal = {92, 64, 0},
    .cell = {0, 71, 52},
    .movingCell = {172, 119, 0},
    .trail = {0, 114, 178},
    .asleep = {70, 70, 70},
    .islands = {{{184, 127, 0}, {69, 144, 186}, {0, 158, 115}, {132, 125, 36}, {0, 114, 178}, {184, 109, 150}}}};

/// Eight colours are fewer than there are overlays: those that share one differ in form (tests/widgets/legend_test).
DebugColors okabeItoColors(Shade shade) {
    const bool dark = shade == Shade::Dark;
    const SafeInks& inks = dark ? safeOnDark : safeOnLight;
    DebugColors colors;
    colors.box = inks.ink;
    colors.fatBox = inks.cool;
    colors.incircle = inks.purple;
    colors.velocity = inks.vermilion;
    colors.orientation = dark ? inks.cool : inks.cell;
    colors.normal = inks.normal;
    colors.depth = inks.green;
    colors.staticCell = inks.cell;
    colors.movingCell = inks.movingCell;
    colors.touchPoint = inks.vermilion;
    colors.nearPoint = inks.cool;
    colors.contactNormal = inks.violet;
    colors.impulse = inks.ink;
    colors.pressed = inks.vermilion;
    colors.natural = inks.ink;
    colors.pulled = inks.cool;
    colors.trail = inks.trail;
    colors.way = dark ? inks.purple : inks.violet;
    colors.lostWay = inks.ink;
    colors.massCenter = inks.purple;
    colors.name = inks.ink;
    colors.asleep = inks.asleep;
    colors.islands = inks.islands;
    colors.meets = inks.vermilion;
    colors.passes = inks.cool;
    colors.safe = inks.cool;
    colors.risky = inks.vermilion;
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
