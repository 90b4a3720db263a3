#pragma once
// Paints bodies and what the game is made of: ship, payload, finish and connectors. World coordinates, metres.

#include "core/level/level.h"
#include "core/math/transform.h"
#include "editor/canvas/stage.h"

#include <cstdint>
#include <span>

namespace spacetow {

/// What decides how a shape of a body is painted.
struct BodyStyle {
    BodyKind kind = BodyKind::Static;
    bool tangible = true; // what cannot be touched is dashed and hollow
};

/// One shape; one-way walls without their rim.
void paintShape(const Stage& stage, const Shape& shape, const Transform& pose, const BodyStyle& style);
/// A disc without its spoke; pixels.
void paintDisc(const Stage& stage, const QPointF& center, double radius, const BodyStyle& style);
/// By which one sees a disc roll, where it is large enough for that.
void paintSpoke(const Stage& stage, const Circle& circle, const Transform& pose, const BodyStyle& style);
enum class WallKind : std::uint8_t { OneWay, TwoWay };
struct ChainStyle {
    BodyStyle body;
    WallKind kind = WallKind::OneWay;
};
void paintChain(const Stage& stage, std::span<const Vec2> world, bool closed, const ChainStyle& style);
/// The cross of arrows that marks a body moved by rails, not by forces.
void paintKinematicMark(const Stage& stage, const Vec2& at);

void paintShip(const Stage& stage, const Transform& pose);
void paintPayload(const Stage& stage, const Vec2& center, double radius);
void paintFinish(const Stage& stage, const Vec2& a, const Vec2& b);
void paintConnector(const Stage& stage, const Vec2& a, const Vec2& b, double length);

} // namespace spacetow
