#pragma once
// Paints the debug overlays over a level or a snapshot, and what a tool shows while it is at work.

#include "core/game/snapshot.h"
#include "core/level/level.h"
#include "editor/canvas/label_painter.h"
#include "editor/canvas/level_cells.h"
#include "editor/canvas/overlay_flags.h"
#include "editor/canvas/stage.h"
#include "editor/editing/overlay.h"

#include <span>

namespace spacetow {

/// What the physics would make of the level at its start. The cells are those of `levelCells`, for the quadtree.
void paintLevelOverlays(const Stage& stage, const Level& level, const OverlayFlags& overlays,
                        std::span<const QuadtreeCell> cells);
/// Called by paintSnapshot.
void paintSnapshotOverlays(const Stage& stage, const Snapshot& snapshot, const OverlayFlags& overlays);

/// Drafts, handles, rubber band, snap marks and measurements.
void paintToolOverlay(const Stage& stage, const Overlay& overlay, LabelPainter& labels);

} // namespace spacetow
