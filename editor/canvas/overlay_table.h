#pragma once
// The debug overlays, each in one row: what it is called, its key, and what its colours mean. Actions, legend, colours
// of one's own, settings, the names that levelc knows and the lists in its help are made from these rows.

#include "core/physics/query/debug_draw.h"

#include <optional>
#include <span>
#include <string_view>

namespace spacetow {

/// One of an overlay's colours.
struct OverlayInk {
    const char* name; // in settings; small letters
    Color DebugColors::*color;
    const char* meaning; // translate in the context "Legend"
};

struct OverlayRow {
    const char* name; // in settings and on the command line; small letters
    bool OverlayFlags::*flag;
    const char* text; // with mnemonic; translate in the context "Actions"
    const char* icon;
    const char* keys;
    const char* tip; // a sentence; likewise
    std::span<const OverlayInk> inks;
    const char* remark = ""; // what the legend says beside the colours; translate in the context "Legend"
    bool onMainBar = false;
    bool ofRuns = false; // of what has run alone: a level has none
};

/// In the order of their keys.
std::span<const OverlayRow> overlayRows();
/// All colours of all rows.
std::span<const OverlayInk> overlayInks();

/// The overlay of that name, which levels have, switched on as well; nothing when there is none.
std::optional<OverlayFlags> withOverlay(OverlayFlags flags, std::string_view name);

} // namespace spacetow
