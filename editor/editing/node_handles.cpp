#include "editor/editing/node_handles.h"

#include "editor/editing/measure.h"
#include "editor/editing/node_pick.h"
#include "editor/editing/snap_point.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double handleOutside = 14; // px, of a handle from the bounds
constexpr double handleReach = 7;    // px, from a handle to a pointer that means it
constexpr double flatBounds = 1e-9;  // m; what is no longer than this cannot be scaled

Vec2 sideOf(const Aabb& box, int x, int y) {
    return box.center() + 0.5 * box.size().cwiseProduct(Vec2(x, y));
}

class NodeTransformGesture : public Gesture {
  public:
    NodeTransformGesture(const ToolContext& context, const NodeHandle& handle, bool turns, const Pointer& start)
        : m_edit(context.edit), m_settings(context.snap), m_handle(handle), m_turns(turns), m_start(start.world),
          m_box(boundsOfNodes(*m_edit.level, m_edit.selection.nodes())),
          m_nodes(withCompany(*m_edit.level, m_edit.selection.nodes())),
          m_snap(context, {.nodes = m_nodes}, sideOf(m_box, handle.x, handle.y)) {}

    Edit at(const Pointer& pointer) const override {
        const Affine map = mapAt(pointer);
        if (map.x == Vec2(1, 0) && map.y == Vec2(0, 1)) {
            return m_edit;
        }
        return {std::make_shared<const Level>(withMappedNodes(*m_edit.level, m_nodes, map)), m_edit.selection};
    }
    Label label() const override {
        return {m_turns ? LabelCode("rotate-nodes") : "scale-nodes", static_cast<int>(m_edit.selection.nodes().size())};
    }
    Overlay overlay(const Pointer& pointer) const override {
        const Affine map = mapAt(pointer);
        OverlayLine frame{OverlayStyle::Measure, {}, true};
        for (const Vec2& side : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
            frame.points.push_back(map(sideOf(m_box, static_cast<int>(side.x()), static_cast<int>(side.y()))));
        }
        Overlay overlay;
        overlay.nodes = OverlayNodes{keysInEdit(m_edit), {}, {}};
        overlay.lines.push_back(std::move(frame));
        return overlay;
    }
    Hint hint(const Pointer& pointer) const override {
        if (m_turns) {
            return {"nodes.turning", {degreesText(angleAt(pointer))}};
        }
        const Vec2 size = m_box.size().cwiseProduct(factorsAt(pointer));
        return {"nodes.scaling", {lengthText(size.x()), lengthText(size.y())}};
    }
    CursorShape cursor(const Pointer&) const override { return CursorShape::Pointing; }
    /// Where the dragged side lands. Nodes that keep their proportions cannot be made to reach a point.
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override {
        if (m_turns || pointer.modifiers.ctrl) {
            return {};
        }
        const Vec2 way = pointer.world - m_start;
        Vec2 target = sideOf(m_box, m_handle.x, m_handle.y);
        target.x() += m_handle.x != 0 ? way.x() : 0;
        target.y() += m_handle.y != 0 ? way.y() : 0;
        std::optional<Vec2> along;
        if (m_handle.x == 0 || m_handle.y == 0) {
            along = m_handle.x != 0 ? Vec2(1, 0) : Vec2(0, 1);
        }
        return m_snap.to(target, plain(pointer), along);
    }

  private:
    /// Ctrl has another meaning here, Alt takes its part.
    static Pointer plain(Pointer pointer) {
        pointer.modifiers = {false, pointer.modifiers.alt, false};
        return pointer;
    }
    Vec2 targetAt(const Pointer& pointer) const {
        if (const std::optional<SnapAnswer> answer = snapAt(pointer)) {
            return answer->point;
        }
        const Vec2 target = sideOf(m_box, m_handle.x, m_handle.y) + pointer.world - m_start;
        return snaps(m_settings, plain(pointer).modifiers) ? onGrid(m_settings, target) : target;
    }
    Vec2 pivot() const { return m_edit.selection.pivot().value_or(m_box.center()); }
    Vec2 fixedPoint(const Pointer& pointer) const {
        return pointer.modifiers.shift ? m_box.center() : sideOf(m_box, -m_handle.x, -m_handle.y);
    }
    double angleAt(const Pointer& pointer) const {
        const Vec2 from = m_start - pivot();
        const Vec2 to = pointer.world - pivot();
        const double angle = std::atan2(cross(from, to), from.dot(to));
        constexpr double step = std::numbers::pi / 12;
        return pointer.modifiers.ctrl ? step * std::round(angle / step) : angle;
    }
    /// Never down to nothing, and not through it: walls stay solid on the same side.
    Vec2 factorsAt(const Pointer& pointer) const {
        const bool onSteps = snaps(m_settings, plain(pointer).modifiers);
        const Vec2 fixed = fixedPoint(pointer);
        const Vec2 grabbed = sideOf(m_box, m_handle.x, m_handle.y);
        const Vec2 target = targetAt(pointer);
        const int sides[] = {m_handle.x, m_handle.y};
        Vec2 factors(1, 1);
        for (int axis = 0; axis < 2; ++axis) {
            const double span = grabbed[axis] - fixed[axis];
            if (sides[axis] != 0 && std::abs(span) > flatBounds) {
                const double least = std::fmin(1, (onSteps ? m_settings.fineStep() : pointer.pixel) / std::abs(span));
                factors[axis] = std::fmax((target[axis] - fixed[axis]) / span, least);
            }
        }
        if (pointer.modifiers.ctrl) {
            const bool byWidth =
                sides[1] == 0 || (sides[0] != 0 && std::abs(factors.x() - 1) >= std::abs(factors.y() - 1));
            factors.setConstant(factors[byWidth ? 0 : 1]);
        }
        return factors;
    }
    Affine mapAt(const Pointer& pointer) const {
        return m_turns ? Affine::rotation(pivot(), angleAt(pointer))
                       : Affine::scaling(fixedPoint(pointer), factorsAt(pointer));
    }

    Edit m_edit;
    SnapSettings m_settings;
    NodeHandle m_handle;
    bool m_turns;
    Vec2 m_start;
    Aabb m_box;
    std::vector<NodeRef> m_nodes;
    DraggedSnap m_snap;
};

} // namespace

std::vector<NodeHandle> nodeHandles(const Edit& edit, bool turns, double pixel) {
    std::vector<NodeHandle> handles;
    if (edit.selection.nodes().size() < 2) {
        return handles;
    }
    const Aabb box = boundsOfNodes(*edit.level, edit.selection.nodes());
    if (box.isEmpty()) {
        return handles;
    }
    const Aabb around = box.grown(handleOutside * pixel);
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            const bool stretches = (x == 0 || box.size().x() > flatBounds) && (y == 0 || box.size().y() > flatBounds);
            if ((x != 0 || y != 0) && (turns ? x != 0 && y != 0 : stretches)) {
                handles.push_back({x, y, sideOf(around, x, y)});
            }
        }
    }
    return handles;
}

std::optional<NodeHandle> nodeHandleAt(const Edit& edit, bool turns, const Pointer& pointer) {
    for (const NodeHandle& handle : nodeHandles(edit, turns, pointer.pixel)) {
        if ((handle.at - pointer.world).norm() <= handleReach * pointer.pixel) {
            return handle;
        }
    }
    return {};
}

std::unique_ptr<Gesture> dragOfNodeHandle(const ToolContext& context, const NodeHandle& handle, bool turns,
                                          const Pointer& start) {
    return std::make_unique<NodeTransformGesture>(context, handle, turns, start);
}

} // namespace spacetow
