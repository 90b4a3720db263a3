#pragma once
// Snapping to chosen kinds of things only.

#include "editor/editing/snap.h"

#include <initializer_list>

namespace spacetow::test {

/// Nothing but these switches.
inline SnapSettings only(std::initializer_list<bool SnapSettings::*> switches) {
    SnapSettings settings;
    settings.grid = settings.vertices = settings.edges = settings.midpoints = settings.intersections =
        settings.perpendiculars = settings.guides = settings.alignment = settings.angles = false;
    for (const auto each : switches) {
        settings.*each = true;
    }
    return settings;
}

} // namespace spacetow::test
