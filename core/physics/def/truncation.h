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

/// What stretching to an untruncated tension has put into a spring of 1 N/m, in J: the integral of `truncated` from 0.
/// For telling, not for the step: it uses the C library's logarithm. By Simpson's rule where the rule is `Custom`.
double truncatedWork(const Truncation& truncation, double tension);

} // namespace spacetow
