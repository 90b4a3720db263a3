#pragma once
// Sine, cosine, arctangent, exponential and hyperbolic tangent from + − × ÷ and exact IEEE operations alone, so that
// every compiler and processor computes the same bits. Angles in radians.

#include <cmath>

namespace spacetow {

struct SinCos {
    double sin = 0;
    double cos = 1;
};

/// Within 1e-15 for |x| ≤ 1e4 and exact at zero; the error grows in proportion beyond. NaN unless x is finite.
SinCos sinCos(double x);
/// Odd, within 1e-15, and strictly between −1 and 1 for every number.
double tanhExact(double x);
/// The angle of the point (c, s) in (−π, π], within 1e-15; 0 for the origin. NaN when either is.
double arcTangent(double s, double c);
/// eˣ, within 2 units in the last place for −700 ≤ x ≤ 700; 0 below and infinite above.
double expExact(double x);

} // namespace spacetow
