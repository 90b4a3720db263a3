#include "editor/editing/rectangle_tool.h"

#include "core/math/affine.h"
#include "editor/editing/drawn_body.h"
#include "editor/editing/measure.h"
#include "editor/editing/snap_point.h"

#include <cmath>

namespace spacetow {

namespace {

/// Ctrl makes squares here; Alt turns snapping off and on in its place.
Pointer snapping(Pointer pointer) {
    pointer.modifiers.ctrl = pointer.modifiers.alt;
    return pointer;
}

/// A corner of a square cannot be made to reach a point, only a grid line.
Vec2 cornerAt(const ToolContext& context, const Pointer& pointer) {
    return pointer.modifiers.ctrl ? snapped(context.snap, snapping(pointer)) : snapped(context, snapping(pointer));
}

Aabb rectangleTo(const ToolContext& context, const Vec2& start, const Pointer& pointer) {
    Vec2 reach = cornerAt(context, pointer) - start;
    if (pointer.modifiers.ctrl) {
        const double side = reach.cwiseAbs().maxCoeff();
        reach = {std::copysign(side, reach.x()), std::copysign(side, reach.y())};
    }
    // A square takes the one number for both.
    const double whole = pointer.modifiers.shift ? 0.5 : 1;
    const TypedValues& typed = context.typed;
    const auto width = !typed.first && pointer.modifiers.ctrl ? typed.second : typed.first;
    const auto height = !typed.second && pointer.modifiers.ctrl ? typed.first : typed.second;
    reach = {width ? std::copysign(whole * *width, reach.x()) : reach.x(),
             height ? std::copysign(whole * *height, reach.y()) : reach.y()};
    const Vec2 from = pointer.modifiers.shift ? Vec2(start - reach) : start;
    Aabb box;
    box.include(tidied(from));
    box.include(tidied(Vec2(start + reach)));
    return box;
}

/// Only where the corner goes where the point does.
std::optional<SnapAnswer> cornerSnap(const ToolContext& context, const Pointer& pointer) {
    return pointer.modifiers.ctrl ? std::nullopt : std::optional(snapOf(context, snapping(pointer)));
}

bool hasArea(const Aabb& box) {
    return box.size().minCoeff() > 0;
}

std::vector<Vec2> rectangleCorners(const Aabb& box) {
    return {box.min, {box.max.x(), box.min.y()}, box.max, {box.min.x(), box.max.y()}};
}

Edit withRectangle(const ToolContext& context, const Aabb& box, BodyKind kind) {
    return hasArea(box) ? withDrawnPolygon(context, rectangleCorners(box), kind) : context.edit;
}

Overlay rectangleOverlay(const Vec2& start, const Aabb& box, const Vec2& pointer) {
    const Vec2 size = box.size();
    Overlay overlay;
    overlay.lines.push_back({OverlayStyle::Draft, rectangleCorners(box), true});
    overlay.points.push_back({OverlayStyle::Handle, start});
    const Vec2 corner(pointer.x() < start.x() ? box.min.x() : box.max.x(),
                      pointer.y() < start.y() ? box.min.y() : box.max.y());
    overlay.points.push_back({OverlayStyle::Snap, corner});
    overlay.texts.push_back({corner, lengthText(size.x()) + " × " + lengthText(size.y()) + " m"});
    return overlay;
}

Hint rectangleHint(const Aabb& box) {
    return {"draw-rectangle.size", {lengthText(box.size().x()), lengthText(box.size().y())}};
}

class RectangleGesture : public Gesture {
  public:
    RectangleGesture(const ToolContext& context, const Vec2& start, BodyKind kind)
        : m_context(context), m_start(start), m_kind(kind) {}

    Edit at(const Pointer& pointer) const override {
        return withRectangle(m_context, rectangleTo(m_context, m_start, pointer), m_kind);
    }
    Label label() const override {
        return {m_kind == BodyKind::Kinematic ? LabelCode("draw-kinematic") : "draw-rectangle", 1};
    }
    Overlay overlay(const Pointer& pointer) const override {
        return rectangleOverlay(m_start, rectangleTo(m_context, m_start, pointer), pointer.world);
    }
    Hint hint(const Pointer& pointer) const override {
        const Aabb box = rectangleTo(m_context, m_start, pointer);
        return hasArea(box) ? rectangleHint(box) : Hint{"draw-rectangle.too-small", {}};
    }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override { return cornerSnap(m_context, pointer); }

  private:
    ToolContext m_context;
    Vec2 m_start;
    BodyKind m_kind;
};

} // namespace

std::unique_ptr<Gesture> dragOfRectangle(const ToolContext& context, const Pointer& start, BodyKind kind) {
    return std::make_unique<RectangleGesture>(context, snapped(context, snapping(start)), kind);
}

std::unique_ptr<Gesture> RectangleTool::press(const ToolContext& context, const Pointer& pointer) {
    return m_start ? nullptr : dragOfRectangle(context, pointer, context.solids);
}

std::optional<FinishedEdit> RectangleTool::click(const ToolContext& context, const Pointer& pointer) {
    if (!m_start) {
        m_start = snapped(context, snapping(pointer));
        return {};
    }
    const Aabb box = rectangleTo(context, *m_start, pointer);
    m_tooSmall = !hasArea(box);
    if (m_tooSmall) {
        return {};
    }
    cancel();
    return FinishedEdit{{"draw-rectangle", 1}, withRectangle(context, box, context.solids)};
}

std::optional<FinishedEdit> RectangleTool::key(const ToolContext& context, ToolKey key, const Pointer& pointer) {
    if (key == ToolKey::Enter && m_start) {
        return click(context, pointer);
    }
    if (key == ToolKey::Backspace || key == ToolKey::Delete) {
        cancel();
    }
    return {};
}

std::optional<TypedMeasures> RectangleTool::measures(const ToolContext& context, const Pointer& pointer) const {
    if (!m_start) {
        return {};
    }
    const Vec2 size = rectangleTo(context, *m_start, pointer).size();
    return TypedMeasures{TypedKind::WidthHeight, size.x(), size.y()};
}

void RectangleTool::hover(const ToolContext& context, const Pointer& pointer) {
    m_tooSmall = m_tooSmall && m_start && !hasArea(rectangleTo(context, *m_start, pointer));
}

void RectangleTool::cancel() {
    m_start.reset();
    m_tooSmall = false;
}

Overlay RectangleTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    if (m_start) {
        return rectangleOverlay(*m_start, rectangleTo(context, *m_start, pointer), pointer.world);
    }
    Overlay overlay;
    overlay.points.push_back({OverlayStyle::Snap, snapped(context, snapping(pointer))});
    return overlay;
}

std::optional<SnapAnswer> RectangleTool::snapAt(const ToolContext& context, const Pointer& pointer) const {
    return m_start ? cornerSnap(context, pointer) : snapOf(context, snapping(pointer));
}

Hint RectangleTool::hint(const ToolContext& context, const Pointer& pointer) const {
    if (m_tooSmall) {
        return {"draw-rectangle.too-small", {}};
    }
    return m_start ? rectangleHint(rectangleTo(context, *m_start, pointer)) : Hint{"draw-rectangle.start", {}};
}

} // namespace spacetow
