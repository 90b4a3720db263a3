#pragma once
// Lengths and angles as short text for hints and labels on the canvas.

#include "core/math/vec.h"

#include <string>

namespace spacetow {

/// With two decimals, three below ten centimetres: "1.25", "0.075".
std::string lengthText(double metres);
/// How many decimals tell neighbouring pixels of a place apart, and the places of a grid of this step, m; none for 0.
int placeDecimals(double pixel, double step);
/// Whole degrees where it is that, else one decimal, in (−180, 180]: "45", "-22.5".
std::string degreesText(double radians);
/// Direction of a vector, anticlockwise from the x axis, in radians.
double directionOf(const Vec2& vector);

/// What lies between two places, in two lines: how far across and upwards, and how far and in which direction.
std::string wayText(const Vec2& way);

} // namespace spacetow
