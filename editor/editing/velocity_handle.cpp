#include "editor/editing/velocity_handle.h"

#include "core/level/edits.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "editor/editing/measure.h"

#include <cmath>

namespace spacetow {

namespace {

constexpr double tipPixels = 8;         // about the handle, for the hand
constexpr double leastArrowPixels = 30; // from the body's middle to the handle
constexpr double barbPixels = 9;        // of the head of an arrow

const BodyObject* movingBody(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    const auto* body = object != nullptr ? std::get_if<BodyObject>(&object->data) : nullptr;
    return body != nullptr && body->kind != BodyKind::Static ? body : nullptr;
}

void addArrow(Overlay& overlay, const Vec2& from, const Vec2& to, double pixel) {
    const Vec2 way = to - from;
    const double length = way.norm();
    if (length <= pixel) {
        return;
    }
    overlay.lines.push_back({OverlayStyle::Velocity, {from, to}});
    const Vec2 along = way * (std::min(barbPixels * pixel, length) / length);
    const Vec2 aside = 0.45 * leftOf(along);
    overlay.lines.push_back({OverlayStyle::Velocity, {to - along + aside, to, to - along - aside}});
}

OverlayText speedText(const Vec2& at, const Vec2& velocity) {
    return {at, lengthText(velocity.norm()) + " m/s  " + degreesText(directionOf(velocity)) + "°"};
}

class VelocityGesture : public Gesture {
  public:
    VelocityGesture(const ToolContext& context, const VelocityArrow& arrow, const Pointer& start)
        : m_context(context), m_arrow(arrow), m_grip(start.world - arrow.from - arrow.velocity) {}

    Edit at(const Pointer& pointer) const override {
        return withVelocity(m_context.edit, m_arrow.key, velocityAt(pointer));
    }
    Label label() const override { return {"set-velocity", 1}; }
    Overlay overlay(const Pointer& pointer) const override {
        return velocityDraft(m_arrow.from, velocityAt(pointer), pointer.pixel);
    }
    Hint hint(const Pointer& pointer) const override { return velocityHint("velocity.dragging", velocityAt(pointer)); }

  private:
    Vec2 velocityAt(Pointer pointer) const {
        pointer.world -= m_grip;
        return velocityTo(m_context, m_arrow.from, pointer);
    }

    ToolContext m_context;
    VelocityArrow m_arrow;
    Vec2 m_grip; // from the tip of the arrow to where it was grabbed
};

} // namespace

std::optional<Vec2> velocityOrigin(const Level& level, Key key) {
    const BodyObject* body = movingBody(level, key);
    if (body == nullptr) {
        return {};
    }
    const Aabb& box = levelIndex(level).boundsOf(level.objects.indexOf(key));
    return body->kind == BodyKind::Kinematic || box.isEmpty() ? body->position : box.center();
}

std::optional<VelocityArrow> velocityArrow(const Edit& edit, double pixel) {
    if (edit.selection.size() != 1 || !edit.selection.nodes().empty()) {
        return {};
    }
    const Key key = edit.selection.keys().front();
    const BodyObject* body = movingBody(*edit.level, key);
    if (body == nullptr || (body->kind == BodyKind::Dynamic && body->velocity == Vec2(0, 0))) {
        return {};
    }
    const GroupTree tree(*edit.level);
    const Object& object = *edit.level->objects.find(key);
    if (tree.isLocked(object) || !tree.isVisible(object)) {
        return {};
    }
    VelocityArrow arrow{key, *velocityOrigin(*edit.level, key), body->velocity, {}};
    const double least = leastArrowPixels * pixel;
    const double speed = body->velocity.norm();
    arrow.handle = speed > 0 ? Vec2(arrow.from + body->velocity * std::max(1.0, least / speed))
                             : Vec2(arrow.from + Vec2(least, 0));
    return arrow;
}

bool isOnVelocity(const VelocityArrow& arrow, const Pointer& pointer) {
    return (pointer.world - arrow.handle).norm() <= tipPixels * pointer.pixel;
}

Overlay velocityOverlay(const VelocityArrow& arrow, double pixel, bool hot) {
    Overlay overlay;
    addArrow(overlay, arrow.from, arrow.from + arrow.velocity, pixel);
    overlay.lines.push_back({OverlayStyle::Measure, {arrow.from + arrow.velocity, arrow.handle}});
    overlay.points.push_back({hot ? OverlayStyle::HotHandle : OverlayStyle::TurnHandle, arrow.handle});
    if (hot && arrow.velocity != Vec2(0, 0)) {
        overlay.texts.push_back(speedText(arrow.handle, arrow.velocity));
    }
    return overlay;
}

std::unique_ptr<Gesture> dragOfVelocity(const ToolContext& context, const VelocityArrow& arrow, const Pointer& start) {
    return std::make_unique<VelocityGesture>(context, arrow, start);
}

Vec2 velocityTo(const ToolContext& context, const Vec2& from, const Pointer& pointer) {
    // Seen from the body, so that what snaps is the velocity, wherever the body stands.
    Pointer relative = pointer;
    relative.world = pointer.world - from;
    const double step = snaps(context.snap, pointer.modifiers) ? context.snap.fineStep() : 0;
    return typedPoint(context.typed, Vec2(0, 0), snappedFrom(context.snap, relative, Vec2(0, 0)), step);
}

Edit withVelocity(const Edit& edit, Key key, const Vec2& velocity) {
    if (movingBody(*edit.level, key) == nullptr) {
        return edit;
    }
    Object object = *edit.level->objects.find(key);
    std::get<BodyObject>(object.data).velocity = velocity;
    return {std::make_shared<const Level>(withObject(*edit.level, std::move(object))), edit.selection};
}

Overlay velocityDraft(const Vec2& from, const Vec2& velocity, double pixel) {
    const Vec2 tip = from + velocity;
    Overlay overlay;
    addArrow(overlay, from, tip, pixel);
    overlay.points.push_back({OverlayStyle::Handle, from});
    overlay.points.push_back({OverlayStyle::Snap, tip});
    overlay.texts.push_back(speedText(tip, velocity));
    return overlay;
}

Hint velocityHint(const char* code, const Vec2& velocity) {
    return {code, {lengthText(velocity.norm()), degreesText(directionOf(velocity))}};
}

} // namespace spacetow
