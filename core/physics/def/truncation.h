#pragma once
// How a connector limits its tension. Every rule is an odd function. Clamp, Tanh and PartialTanh stay within `limit`.

#include <cstdint>
#include <functional>

namespace spacetow {

enum class TruncationRule : std::uint8_t { Zero, None, Clamp, Tanh, PartialTanh, Custom };

struct Truncation {
    TruncationRule rule = TruncationRule::None;
    double limit = 0;                     // N, ≥ 0; read by Clamp, Tanh and PartialTanh
    double proportion = 0.5;              // 0 … 1; PartialTanh changes no tension below this share of the limit
    std::function<double(double)> custom; // N → N; must be pure, should be odd and monotonic; read by Custom
};

/// The truncated tension, N. `tension` is the untruncated one, N.
double truncated(const Truncation& truncation, double tension);

/// Energy of a spring of 1 N/m at this untruncated tension, J: the integral of `truncated` from 0 to `tension`, for
/// `Custom` by Simpson's rule. Never use the value in the step: the C library's logarithm differs between platforms.
double truncatedWork(const Truncation& truncation, double tension);

} // namespace spacetow
