#pragma once
// How a connector limits its tension. All rules are odd; all but `None` stay within their limit (report, page 9).

#include <cstdint>
#include <functional>

namespace spacetow {

enum class TruncationRule : std::uint8_t { Zero, None, Clamp, Tanh, PartialTanh, Custom };

struct Truncation {
    TruncationRule rule = TruncationRule::None;
    double limit = 0;                     // N, ≥ 0; read by Clamp, Tanh and PartialTanh
    double proportion = 0.5;              // 0 … 1, PartialTanh: the share of the limit below which nothing is changed
    std::function<double(double)> custom; // Custom: N → N; should be odd, monotonic and free of side effects
};

/// The truncated tension, in N, of an untruncated one.
double truncated(const Truncation& truncation, double tension);

} // namespace spacetow
