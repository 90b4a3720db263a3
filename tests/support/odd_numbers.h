#pragma once
// Numbers that no definition may hold.

#include <limits>

namespace spacetow::test {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

} // namespace spacetow::test
