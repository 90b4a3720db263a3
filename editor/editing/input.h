#pragma once
// The mouse and the keys as the tools see them: world coordinates, no toolkit.

#include "core/math/aabb.h"

#include <cstdint>

namespace spacetow {

struct Modifiers {
    bool shift = false;
    bool ctrl = false;
    bool alt = false;

    bool operator==(const Modifiers&) const = default;
};

struct Pointer {
    Vec2 world{0, 0};  // m
    Vec2 screen{0, 0}; // logical pixels, y down
    Modifiers modifiers;
    double pixel = 0.01; // size of one logical pixel, m
    Aabb view = {};      // the part of the world that can be seen; empty when nobody knows
};

/// Keys a tool may react to while it is at work.
enum class ToolKey : std::uint8_t { Enter, Backspace, Escape, Delete };

} // namespace spacetow
