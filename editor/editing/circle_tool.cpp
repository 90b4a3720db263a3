#include "editor/editing/circle_tool.h"

#include "editor/editing/drawn_body.h"
#include "editor/editing/measure.h"
#include "editor/editing/snap_point.h"

namespace spacetow {

namespace {

/// What the rim is to go through, if anything but the grid.
std::optional<SnapAnswer> rimSnap(const ToolContext& context, const Pointer& pointer, const Vec2& center) {
    const SnapAnswer answer = snapFrom(context, pointer, center);
    const bool onThing = answer.kind != SnapKind::None && answer.kind != SnapKind::Grid;
    return onThing && answer.point != center ? std::optional(answer) : std::nullopt;
}

/// Else whole grid steps while the grid is on, unless it has been typed. Zero when the pointer is too near the centre.
double radiusAt(const ToolContext& context, const Pointer& pointer, const Vec2& center) {
    if (context.typed.first) {
        return *context.typed.first;
    }
    if (const std::optional<SnapAnswer> rim = rimSnap(context, pointer, center)) {
        return (rim->point - center).norm();
    }
    const double distance = (pointer.world - center).norm();
    return snaps(context.snap, pointer.modifiers) ? onGrid(context.snap, distance) : distance;
}

Overlay circleOverlay(const Vec2& center, double radius) {
    const Vec2 rim = center + Vec2(radius, 0);
    Overlay overlay;
    overlay.circles.push_back({OverlayStyle::Draft, center, radius});
    overlay.lines.push_back({OverlayStyle::Measure, {center, rim}});
    overlay.points.push_back({OverlayStyle::Handle, center});
    overlay.texts.push_back({0.5 * (center + rim), lengthText(radius) + " m"});
    return overlay;
}

Hint radiusHint(double radius) {
    return {"draw-circle.radius", {lengthText(radius)}};
}

class CircleGesture : public Gesture {
  public:
    CircleGesture(const ToolContext& context, const Vec2& center) : m_context(context), m_center(center) {}

    Edit at(const Pointer& pointer) const override {
        const double radius = radiusAt(m_context, pointer, m_center);
        return radius > 0 ? withDrawnBody(m_context, Circle{{0, 0}, radius}, m_center, m_context.solids)
                          : m_context.edit;
    }
    Label label() const override { return {"draw-circle", 1}; }
    Overlay overlay(const Pointer& pointer) const override {
        return circleOverlay(m_center, radiusAt(m_context, pointer, m_center));
    }
    Hint hint(const Pointer& pointer) const override { return radiusHint(radiusAt(m_context, pointer, m_center)); }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override {
        return rimSnap(m_context, pointer, m_center);
    }

  private:
    ToolContext m_context;
    Vec2 m_center;
};

} // namespace

std::unique_ptr<Gesture> CircleTool::press(const ToolContext& context, const Pointer& pointer) {
    if (m_center) {
        return nullptr;
    }
    return std::make_unique<CircleGesture>(context, snapped(context, pointer));
}

std::optional<FinishedEdit> CircleTool::click(const ToolContext& context, const Pointer& pointer) {
    if (!m_center) {
        m_center = snapped(context, pointer);
        return {};
    }
    const double radius = radiusAt(context, pointer, *m_center);
    m_tooSmall = !(radius > 0);
    if (m_tooSmall) {
        return {};
    }
    Edit drawn = withDrawnBody(context, Circle{{0, 0}, radius}, *m_center, context.solids);
    cancel();
    return FinishedEdit{{"draw-circle", 1}, std::move(drawn)};
}

std::optional<FinishedEdit> CircleTool::key(const ToolContext& context, ToolKey key, const Pointer& pointer) {
    if (key == ToolKey::Enter && m_center) {
        return click(context, pointer);
    }
    if (key == ToolKey::Backspace || key == ToolKey::Delete) {
        cancel();
    }
    return {};
}

std::optional<TypedMeasures> CircleTool::measures(const ToolContext& context, const Pointer& pointer) const {
    if (!m_center) {
        return {};
    }
    return TypedMeasures{TypedKind::Radius, radiusAt(context, pointer, *m_center), 0};
}

void CircleTool::hover(const ToolContext& context, const Pointer& pointer) {
    m_tooSmall = m_tooSmall && !(radiusAt(context, pointer, *m_center) > 0);
}

std::optional<SnapAnswer> CircleTool::snapAt(const ToolContext& context, const Pointer& pointer) const {
    return m_center ? rimSnap(context, pointer, *m_center) : snapOf(context, pointer);
}

void CircleTool::cancel() {
    m_center.reset();
    m_tooSmall = false;
}

Overlay CircleTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    if (m_center) {
        return circleOverlay(*m_center, radiusAt(context, pointer, *m_center));
    }
    Overlay overlay;
    overlay.points.push_back({OverlayStyle::Snap, snapped(context, pointer)});
    return overlay;
}

Hint CircleTool::hint(const ToolContext& context, const Pointer& pointer) const {
    if (m_tooSmall) {
        return {"draw-circle.too-small", {}};
    }
    return m_center ? radiusHint(radiusAt(context, pointer, *m_center)) : Hint{"draw-circle.start", {}};
}

} // namespace spacetow
