#pragma once
// Lengths below which a difference does not count.

namespace spacetow {

/// Penetration that position correction leaves, so that resting contacts persist, m.
constexpr double linearSlop = 0.0004;

} // namespace spacetow
