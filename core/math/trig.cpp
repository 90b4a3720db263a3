#include "core/math/trig.h"

#include <initializer_list>
#include <limits>

namespace spacetow {

namespace {

// π/2 in three pieces of 31 bits and more: multiples up to 2²² of the first two are exact (Cody and Waite, 1980).
constexpr double halfPiHigh = 0x1.921fb544p+0;
constexpr double halfPiMiddle = 0x1.0b4611a4p-34;
constexpr double halfPiLow = 0x1.13198a2e03707p-65;
constexpr double twoOverPi = 0x1.45f306dc9c883p-1;

// ln 2 in two pieces, the first of 32 bits.
constexpr double ln2High = 0x1.62e42feep-1;
constexpr double ln2Low = 0x1.a39ef35793c76p-33;

constexpr double largestBelowOne = 0x1.fffffffffffffp-1;

/// Taylor series about 0, |x| ≤ π/4: the first term left out is below 1e-19.
double sinNearZero(double x) {
    const double z = x * x;
    double sum = 1.0 / 355687428096000;
    sum = sum * z - 1.0 / 1307674368000;
    sum = sum * z + 1.0 / 6227020800;
    sum = sum * z - 1.0 / 39916800;
    sum = sum * z + 1.0 / 362880;
    sum = sum * z - 1.0 / 5040;
    sum = sum * z + 1.0 / 120;
    sum = sum * z - 1.0 / 6;
    return x + x * z * sum;
}

double cosNearZero(double x) {
    const double z = x * x;
    double sum = 1.0 / 20922789888000;
    sum = sum * z - 1.0 / 87178291200;
    sum = sum * z + 1.0 / 479001600;
    sum = sum * z - 1.0 / 3628800;
    sum = sum * z + 1.0 / 40320;
    sum = sum * z - 1.0 / 720;
    sum = sum * z + 1.0 / 24;
    const double half = 0.5 * z;
    const double one = 1 - half;
    return one + (((1 - one) - half) + z * z * sum); // what 1 − z/2 lost is put back
}

constexpr double pi = 0x1.921fb54442d18p+1;
constexpr double halfPi = 0x1.921fb54442d18p+0;

/// For 0 ≤ t ≤ 1: atan t = atan k/8 + atan (t − k/8)/(1 + t k/8), the rest by its Taylor series.
double arcTangentOfShare(double t) {
    constexpr double eighths[] = {0.0,
                                  0.12435499454676144,
                                  0.24497866312686414,
                                  0.35877067027057225,
                                  0.4636476090008061,
                                  0.5585993153435624,
                                  0.6435011087932844,
                                  0.7188299996216245,
                                  0.7853981633974483};
    const double k = std::nearbyint(8 * t);
    const double r = (t - k / 8) / (1 + t * (k / 8));
    const double z = r * r;
    double sum = 1.0 / 17;
    for (const double odd : {15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) {
        sum = 1.0 / odd - sum * z;
    }
    return eighths[static_cast<int>(k)] + (r - r * z * sum);
}

/// e^r − 1 for |r| ≤ ln 2 / 2, Taylor series.
double expMinusOneNearZero(double r) {
    double sum = 1.0 / 87178291200;
    for (const double factorial :
         {6227020800.0, 479001600.0, 39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0}) {
        sum = sum * r + 1.0 / factorial;
    }
    return r + r * r * (0.5 + r * sum);
}

} // namespace

SinCos sinCos(double x) {
    if (!std::isfinite(x)) {
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    }
    double quarters = std::nearbyint(x * twoOverPi);
    const double reduced = ((x - quarters * halfPiHigh) - quarters * halfPiMiddle) - quarters * halfPiLow;
    const double r = std::fabs(reduced) <= 1 ? reduced : 0; // angles so large that they have lost their meaning
    quarters -= 4 * std::floor(0.25 * quarters);
    const double s = sinNearZero(r);
    const double c = cosNearZero(r);
    switch (static_cast<int>(quarters)) {
    case 0:
        return {s, c};
    case 1:
        return {c, -s};
    case 2:
        return {-s, -c};
    default:
        return {-c, s};
    }
}

double arcTangent(double s, double c) {
    if (std::isnan(s) || std::isnan(c)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const double x = std::fabs(c);
    const double y = std::fabs(s);
    const bool steep = y > x;
    const double diagonal = x == 0 ? 0 : 1; // nothing over nothing, or infinity over infinity
    const double t = x == y ? diagonal : (steep ? x / y : y / x);
    double angle = arcTangentOfShare(t);
    if (steep) {
        angle = halfPi - angle;
    }
    if (c < 0) {
        angle = pi - angle;
    }
    return s < 0 ? -angle : angle;
}

double tanhExact(double x) {
    const double size = std::fabs(x);
    if (!(size < 19.0625)) { // from here on it rounds to one
        return std::isnan(x) ? x : std::copysign(largestBelowOne, x);
    }
    // tanh x = (e²ˣ − 1) / (e²ˣ + 1) with e²ˣ = 2ᵏ eʳ.
    const double twice = 2 * size;
    const double k = std::nearbyint(twice / 0x1.62e42fefa39efp-1);
    const double r = (twice - k * ln2High) - k * ln2Low;
    const double small = expMinusOneNearZero(r);
    const double power = std::ldexp(1.0, static_cast<int>(k));
    const double expMinusOne = power * small + (power - 1);
    // Where the result is near one, what is missing of it is computed instead: that keeps the curve monotonic.
    const double value = k < 2 ? expMinusOne / (expMinusOne + 2) : 1 - 2 / (expMinusOne + 2);
    return std::copysign(value < largestBelowOne ? value : largestBelowOne, x);
}

double expExact(double x) {
    if (std::isnan(x)) {
        return x;
    }
    if (std::fabs(x) > 700) {
        return x < 0 ? 0 : std::numeric_limits<double>::infinity();
    }
    const double k = std::nearbyint(x / 0x1.62e42fefa39efp-1);
    const double r = (x - k * ln2High) - k * ln2Low;
    return std::ldexp(1 + expMinusOneNearZero(r), static_cast<int>(k));
}

} // namespace spacetow
