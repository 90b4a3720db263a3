#pragma once
// A number with a unit: its size, and which powers of metre, kilogram, second and radian it has.

#include <cstdint>
#include <optional>
#include <string_view>

namespace spacetow {

struct Dimension {
    std::int8_t metre = 0;
    std::int8_t kilogram = 0;
    std::int8_t second = 0;
    std::int8_t radian = 0;

    constexpr bool isNone() const { return *this == Dimension(); }
    constexpr bool operator==(const Dimension&) const = default;
};

/// The scale is kept apart as a fraction, so that 35 cm are 0.35 m to the bit and 45° + 45° are 90°.
struct Quantity {
    double number = 0;
    double over = 1; // the SI value is number · over / under
    double under = 1;
    Dimension dimension;

    double si() const { return over == under ? number : number * over / under; }
    /// How many of `unit` it is; only its scale counts.
    double in(const Quantity& unit) const;
};

constexpr Quantity plainNumber(double number) {
    return {number, 1, 1, {}};
}
Quantity operator*(const Quantity& a, const Quantity& b);
Quantity operator/(const Quantity& a, const Quantity& b);

/// One of the units "m", "cm", "kN", "ms", "°" and so on, upper and lower case apart; "%" is one without a dimension.
std::optional<Quantity> unitNamed(std::string_view name);

} // namespace spacetow
