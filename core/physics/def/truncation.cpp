#include "core/physics/def/truncation.h"

#include "core/math/trig.h"

#include <algorithm>
#include <cmath>

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

} // namespace spacetow
