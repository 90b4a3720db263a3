#pragma once
// Paints the debug overlays over a level or a world, and what a tool shows while it is at work.

#include "core/level/level.h"
#include "core/physics/query/overlay_flags.h"
#include "editor/canvas/label_painter.h"
#include "editor/canvas/overlay_palette.h"
#include "editor/canvas/overlay_worlds.h"
#include "editor/canvas/painter_draw.h"
#include "editor/canvas/stage.h"
#include "editor/editing/overlay.h"

#include <span>
#include <vector>

namespace spacetow {

/// What is drawn over a world, and what the level adds to it.
struct OverlayRequest {
    OverlayFlags flags;
    OverlayPalette palette;
    const Level* level = nullptr;         // for names and tags; lives as long as the request
    std::span<const Key> selected;        // for what they collide with, and to be named first; ascending
    Key pointed = 0;                      // by the mouse: likewise
    std::span<const std::uint64_t> named; // whose names were to be seen last, and are to stay; ascending
    std::span<const DebugTrail> trails;   // likewise alive
};

/// What is not to be seen of overlays.
struct OverlayGaps {
    std::vector<Vec2> dots;           // world; at some of the places of marks that would be no more than dots
    bool names = false;               // some would lie on others
    std::vector<std::uint64_t> named; // whose names are to be seen; ascending
};

/// Over a world that runs or stands still: that of a session, say. Only what is in view costs time.
OverlayGaps paintWorldOverlays(const Stage& stage, const World& world, const OverlayRequest& request);
/// The same, to be painted later or part by part; and what it leaves out.
OverlayGaps gapsOf(const PainterDraw& marks, const Viewport& view);
PainterDraw worldOverlays(const Viewport& view, Shade shade, const World& world, const OverlayRequest& request);
/// Over a level while nothing runs: what the physics makes of it at its start.
OverlayGaps paintLevelOverlays(const Stage& stage, const OverlayWorlds& worlds, const OverlayRequest& request);

/// Drafts, handles, rubber band, snap marks and measurements.
void paintToolOverlay(const Stage& stage, const Overlay& overlay, LabelPainter& labels);

} // namespace spacetow
