#include "core/physics/def/truncation.h"

#include "core/math/trig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

double partialTanh(double limit, double proportion, double tension) {
    const double safe = limit * proportion;
    const double rest = limit - safe;
    const double size = std::abs(tension);
    if (size <= safe) {
        return tension;
    }
    if (rest <= 0) {
        return std::copysign(limit, tension);
    }
    return std::copysign(safe + rest * tanhExact((size - safe) / rest), tension);
}

/// The integral of tanh from 0, without overflow.
double logCosh(double x) {
    const double size = std::abs(x);
    return size + std::log1p(std::exp(-2 * size)) - std::numbers::ln2;
}

/// Up to `safe` a spring, beyond it a limit to which the tension bends.
double partialTanhWork(double limit, double safe, double size) {
    const double rest = limit - safe;
    const double beyond = size - safe;
    if (beyond <= 0) {
        return size * size / 2;
    }
    return safe * safe / 2 + safe * beyond + (rest > 0 ? rest * rest * logCosh(beyond / rest) : rest * beyond);
}

double simpson(const Truncation& t, double end) {
    constexpr int halves = 64;
    double sum = truncated(t, 0) + truncated(t, end);
    for (int i = 1; i < halves; ++i) {
        sum += (i % 2 == 1 ? 4 : 2) * truncated(t, end * i / halves);
    }
    return sum * end / (3 * halves);
}

} // namespace

double truncated(const Truncation& t, double tension) {
    switch (t.rule) {
    case TruncationRule::Zero:
        return 0;
    case TruncationRule::None:
        return tension;
    case TruncationRule::Clamp:
        return std::clamp(tension, -t.limit, t.limit);
    case TruncationRule::Tanh:
        return t.limit > 0 ? t.limit * tanhExact(tension / t.limit) : 0;
    case TruncationRule::PartialTanh:
        return partialTanh(t.limit, std::clamp(t.proportion, 0.0, 1.0), tension);
    case TruncationRule::Custom:
        return t.custom ? t.custom(tension) : tension;
    }
    return tension;
}

double truncatedWork(const Truncation& t, double tension) {
    const double size = std::abs(tension);
    switch (t.rule) {
    case TruncationRule::Zero:
        return 0;
    case TruncationRule::None:
        break;
    case TruncationRule::Clamp:
        return size <= t.limit ? size * size / 2 : t.limit * (size - t.limit / 2);
    case TruncationRule::Tanh:
        return t.limit > 0 ? t.limit * t.limit * logCosh(size / t.limit) : 0;
    case TruncationRule::PartialTanh:
        return partialTanhWork(t.limit, t.limit * std::clamp(t.proportion, 0.0, 1.0), size);
    case TruncationRule::Custom:
        return t.custom ? simpson(t, tension) : size * size / 2;
    }
    return size * size / 2;
}

} // namespace spacetow
