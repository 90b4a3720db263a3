#pragma once
// The colours of the debug overlays: sets, of which some are told apart by people who see fewer colours, and colours of
// one's own in place of some of a set.

#include "core/physics/query/debug_draw.h"
#include "editor/canvas/palette.h"

#include <cstddef>
#include <map>
#include <string>

namespace spacetow {

enum class OverlayColorSet : std::uint8_t {
    Standard, // those of the theme
    OkabeIto, // of M. Okabe and K. Ito, "Color Universal Design" (2008): safe without red, green or blue cones
};

/// A value: what the user has chosen.
struct OverlayPalette {
    OverlayColorSet set = OverlayColorSet::Standard;
    std::map<std::string, Color> own; // by the name of the ink

    bool operator==(const OverlayPalette&) const = default;
};

/// The colours on a dark or a light ground.
DebugColors overlayColors(const OverlayPalette& palette, Shade shade);

} // namespace spacetow
