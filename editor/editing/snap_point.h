#pragma once
// Snapping as tools call it: what the point under the pointer snaps to, with the keys that are held. Shift keeps to
// multiples of 15° from the point before, Ctrl suspends snapping.

#include "editor/editing/snap_search.h"
#include "editor/editing/tool.h"

#include <memory>
#include <optional>

namespace spacetow {

/// The pointer's position.
SnapAnswer snapOf(const ToolContext& context, const Pointer& pointer);
/// Likewise for what goes on from the point `from`.
SnapAnswer snapFrom(const ToolContext& context, const Pointer& pointer, const Vec2& from);
/// Where those land.
Vec2 snapped(const ToolContext& context, const Pointer& pointer);
Vec2 snappedFrom(const ToolContext& context, const Pointer& pointer, const Vec2& from);

/// Something that is dragged and does not snap to itself. Ask through `at`, which remembers the last answer.
class DraggedSnap {
  public:
    /// `start` is where what is dragged was before, by the point that is to land on the grid.
    DraggedSnap(const ToolContext& context, SnapSubject subject, const Vec2& start);

    /// Moved by `way`; along one axis only when Shift is held.
    SnapAnswer moved(const Vec2& way, const Pointer& pointer) const;
    /// Moved to `target`; `along`: the unit vector of the only way it may go.
    SnapAnswer to(const Vec2& target, const Pointer& pointer, const std::optional<Vec2>& along = {}) const;

  private:
    ToolContext m_context;
    std::shared_ptr<const SnapSubject> m_subject;
    Vec2 m_start;
};

/// What moves with these objects, and the points by which they snap: those nearest to the pointer. `reference` is the
/// point that is placed; the other points are seen from it.
SnapSubject subjectOf(const Level& level, std::vector<Key> keys, const Pointer& pointer, const Vec2& reference);

/// The last answer given, so that one movement of the pointer makes one search, however often it is asked.
struct SnapMemo;
std::shared_ptr<SnapMemo> makeSnapMemo();

} // namespace spacetow
