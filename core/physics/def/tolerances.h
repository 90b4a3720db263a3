#pragma once
// Lengths that count as nothing.

namespace spacetow {

/// Penetration that is left alone so that resting contacts persist, m.
constexpr double linearSlop = 0.0004;

} // namespace spacetow
