#pragma once
// A small random generator whose sequence is the same on every platform (PCG32: M. O'Neill, "PCG: A Family of
// Simple Fast Space-Efficient Statistically Good Algorithms for Random Number Generation", 2014).

#include "core/base/contract.h"

#include <cstdint>

namespace spacetow {

class Random {
  public:
    explicit Random(std::uint64_t seed = 1) : m_state(seed + increment) { next(); }

    /// Uniform over all 32-bit numbers.
    std::uint32_t next() {
        const std::uint64_t old = m_state;
        m_state = old * 6364136223846793005ull + increment;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
        const auto turn = static_cast<std::uint32_t>(old >> 59u);
        return (shifted >> turn) | (shifted << ((32u - turn) & 31u));
    }
    /// Uniform in [0, 1).
    double unit() { return next() * 0x1p-32; }
    /// Uniform in [low, high).
    double uniform(double low, double high) { return low + (high - low) * unit(); }
    /// Uniform in 0 … count − 1; `count` is positive. The bias is below count / 2³².
    std::uint32_t below(std::uint32_t count) {
        EXPECTS(count > 0);
        return static_cast<std::uint32_t>((std::uint64_t{next()} * count) >> 32);
    }

    bool operator==(const Random&) const = default;

  private:
    static constexpr std::uint64_t increment = 1442695040888963407ull;
    std::uint64_t m_state;
};

} // namespace spacetow
