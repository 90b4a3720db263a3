#pragma once
// The velocity of a body as an arrow, and the handle at its tip. It ends where the body would be a second later:
// a metre on the screen is a metre per second.

#include "editor/editing/tool.h"

#include <memory>
#include <optional>

namespace spacetow {

struct VelocityArrow {
    Key key = 0;
    Vec2 from{0, 0};     // world
    Vec2 velocity{0, 0}; // m/s
    Vec2 handle{0, 0};   // world; beside a body that rests, and never too near for the hand
};

/// The point of a body at which its arrow begins: the position of a kinematic one, about which it turns, the middle of
/// others. Nothing for static bodies and what is no body.
std::optional<Vec2> velocityOrigin(const Level& level, Key key);
/// Of the only object that is selected, when it is a kinematic body, or a dynamic one that starts with a velocity, and
/// is not locked. `pixel` is the size of one, m.
std::optional<VelocityArrow> velocityArrow(const Edit& edit, double pixel);
bool isOnVelocity(const VelocityArrow& arrow, const Pointer& pointer);
Overlay velocityOverlay(const VelocityArrow& arrow, double pixel, bool hot);
/// Changes by what the pointer moves. Snaps to whole grid steps a second, with Shift to multiples of 15°.
std::unique_ptr<Gesture> dragOfVelocity(const ToolContext& context, const VelocityArrow& arrow, const Pointer& start);

/// The velocity that an arrow to the pointer stands for, snapped likewise.
Vec2 velocityTo(const ToolContext& context, const Vec2& from, const Pointer& pointer);
Edit withVelocity(const Edit& edit, Key key, const Vec2& velocity);
/// The arrow alone, with speed and direction beside its tip.
Overlay velocityDraft(const Vec2& from, const Vec2& velocity, double pixel);
Hint velocityHint(const char* code, const Vec2& velocity);

} // namespace spacetow
