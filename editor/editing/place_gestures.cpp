#include "editor/editing/place_gestures.h"

#include "core/level/edits.h"
#include "editor/editing/draw_overlay.h"
#include "editor/editing/measure.h"
#include "editor/editing/snap_point.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace spacetow {

namespace {

constexpr double quarterTurn = std::numbers::pi / 2; // from the x axis to the nose of a ship at angle 0

template <class T>
const Object* existing(const Level& level, const ObjectData& data) {
    return std::holds_alternative<T>(data) ? firstOf<T>(level) : nullptr;
}

class TurnShip : public Gesture {
  public:
    TurnShip(const ToolContext& context, const Vec2& position)
        : m_context(context), m_start(shipAt(*context.edit.level, position)) {}

    Edit at(const Pointer& pointer) const override { return withPlaced(m_context, turned(pointer)); }
    Label label() const override { return {"place-ship", 1}; }
    Overlay overlay(const Pointer& pointer) const override {
        Overlay overlay;
        overlay.lines.push_back({OverlayStyle::Measure, {m_start.position, pointer.world}});
        overlay.points.push_back({OverlayStyle::Handle, m_start.position});
        overlay.texts.push_back({pointer.world, degreesText(turned(pointer).angle) + "°"});
        return overlay;
    }
    Hint hint(const Pointer& pointer) const override {
        return {"place-ship.turning", {degreesText(turned(pointer).angle)}};
    }

  private:
    ShipObject turned(const Pointer& pointer) const {
        const Vec2 way = pointer.world - m_start.position;
        ShipObject ship = m_start;
        if (way != Vec2(0, 0)) {
            const Vec2 nose = pointer.modifiers.shift ? snappedDirection(way) : way;
            ship.angle = std::remainder(directionOf(nose) - quarterTurn, 2 * std::numbers::pi);
        }
        return ship;
    }

    ToolContext m_context;
    ShipObject m_start;
};

class CarryPayload : public Gesture {
  public:
    explicit CarryPayload(const ToolContext& context) : m_context(context) {}

    Edit at(const Pointer& pointer) const override {
        return withPlaced(m_context, payloadAt(*m_context.edit.level, snapAt(pointer)->point));
    }
    Label label() const override { return {"place-payload", 1}; }
    Overlay overlay(const Pointer& pointer) const override {
        Overlay overlay;
        overlay.points.push_back({OverlayStyle::Snap, snapAt(pointer)->point});
        return overlay;
    }
    Hint hint(const Pointer& pointer) const override {
        const Vec2 place = snapAt(pointer)->point;
        return {"place-payload.moving", {lengthText(place.x()), lengthText(place.y())}};
    }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override {
        return placeSnap<PayloadObject>(m_context, pointer);
    }

  private:
    ToolContext m_context;
};

class DrawFinish : public Gesture {
  public:
    DrawFinish(const ToolContext& context, const Vec2& start) : m_context(context), m_start(start) {}

    Edit at(const Pointer& pointer) const override {
        const Vec2 end = endAt(pointer);
        return end == m_start ? m_context.edit : withPlaced(m_context, FinishObject{m_start, end});
    }
    Label label() const override { return {"place-finish", 1}; }
    Overlay overlay(const Pointer& pointer) const override { return finishOverlay(m_start, endAt(pointer)); }
    Hint hint(const Pointer& pointer) const override { return finishHint(m_start, endAt(pointer)); }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override {
        return snapFrom(m_context, pointer, m_start);
    }

  private:
    Vec2 endAt(const Pointer& pointer) const { return snappedFrom(m_context, pointer, m_start); }

    ToolContext m_context;
    Vec2 m_start;
};

} // namespace

ShipObject shipAt(const Level& level, const Vec2& position) {
    const Object* old = firstOf<ShipObject>(level);
    ShipObject ship = old ? std::get<ShipObject>(old->data) : ShipObject{};
    ship.position = position;
    return ship;
}

PayloadObject payloadAt(const Level& level, const Vec2& position) {
    const Object* old = firstOf<PayloadObject>(level);
    PayloadObject payload = old ? std::get<PayloadObject>(old->data) : PayloadObject{};
    payload.position = position;
    return payload;
}

Edit withPlaced(const ToolContext& context, ObjectData data) {
    const Level& level = *context.edit.level;
    const Object* old = existing<ShipObject>(level, data);
    old = old ? old : existing<PayloadObject>(level, data);
    old = old ? old : existing<FinishObject>(level, data);
    Object object;
    object.key = freshKey(level, context.seed);
    object.data = std::move(data);
    const Key key = old ? old->key : object.key;
    return {std::make_shared<const Level>(added(level, std::move(object))), Selection({key})};
}

std::unique_ptr<Gesture> turnShip(const ToolContext& context, const Pointer& start) {
    return std::make_unique<TurnShip>(context, placeSnap<ShipObject>(context, start).point);
}

std::unique_ptr<Gesture> carryPayload(const ToolContext& context) {
    return std::make_unique<CarryPayload>(context);
}

std::unique_ptr<Gesture> drawFinish(const ToolContext& context, const Pointer& start) {
    return std::make_unique<DrawFinish>(context, placeSnap<FinishObject>(context, start).point);
}

Overlay finishOverlay(const Vec2& start, const Vec2& end) {
    Overlay overlay;
    overlay.lines.push_back({OverlayStyle::Draft, {start, end}});
    overlay.points.push_back({OverlayStyle::Handle, start});
    overlay.points.push_back({OverlayStyle::Snap, end});
    if (start != end) {
        overlay.texts.push_back(measureText(start, end));
    }
    return overlay;
}

Hint finishHint(const Vec2& start, const Vec2& end) {
    const Vec2 way = end - start;
    return {"place-finish.end", {lengthText(way.norm()), degreesText(directionOf(way))}};
}

} // namespace spacetow
