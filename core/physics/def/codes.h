#pragma once
// The error codes of World.

#include "core/base/codes.h"

namespace spacetow {

inline constexpr std::string_view physicsCodes[] = {
    "not-finite", "out-of-range", "no-shape", "bad-mass", "bad-shape", "no-such-body", "same-body",
};

using PhysicsCode = BaseCode::And<physicsCodes>;

} // namespace spacetow
