#include "core/base/quantity.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace spacetow {

namespace {

struct Unit {
    std::string_view name;
    double over;
    double under;
    Dimension dimension;
};

constexpr Dimension none{};
constexpr Dimension length{1, 0, 0, 0};
constexpr Dimension mass{0, 1, 0, 0};
constexpr Dimension duration{0, 0, 1, 0};
constexpr Dimension angle{0, 0, 0, 1};
constexpr Dimension force{1, 1, -2, 0};
constexpr Dimension frequency{0, 0, -1, 0};
constexpr double halfTurn = std::numbers::pi; // rad

constexpr std::array units{
    Unit{"m", 1, 1, length},         Unit{"dm", 1, 10, length},         Unit{"cm", 1, 100, length},
    Unit{"mm", 1, 1e3, length},      Unit{"µm", 1, 1e6, length},        Unit{"um", 1, 1e6, length},
    Unit{"km", 1e3, 1, length},      Unit{"in", 254, 1e4, length},      Unit{"ft", 3048, 1e4, length},
    Unit{"kg", 1, 1, mass},          Unit{"g", 1, 1e3, mass},           Unit{"mg", 1, 1e6, mass},
    Unit{"t", 1e3, 1, mass},         Unit{"s", 1, 1, duration},         Unit{"ms", 1, 1e3, duration},
    Unit{"µs", 1, 1e6, duration},    Unit{"us", 1, 1e6, duration},      Unit{"min", 60, 1, duration},
    Unit{"h", 3600, 1, duration},    Unit{"rad", 1, 1, angle},          Unit{"mrad", 1, 1e3, angle},
    Unit{"°", halfTurn, 180, angle}, Unit{"deg", halfTurn, 180, angle}, Unit{"turn", 2 * halfTurn, 1, angle},
    Unit{"N", 1, 1, force},          Unit{"mN", 1, 1e3, force},         Unit{"kN", 1e3, 1, force},
    Unit{"MN", 1e6, 1, force},       Unit{"Hz", 1, 1, frequency},       Unit{"%", 1, 100, none},
};

constexpr std::int8_t sum(std::int8_t a, std::int8_t b, int sign) {
    return static_cast<std::int8_t>(std::clamp(a + sign * b, -100, 100));
}

constexpr Dimension joined(const Dimension& a, const Dimension& b, int sign) {
    return {sum(a.metre, b.metre, sign), sum(a.kilogram, b.kilogram, sign), sum(a.second, b.second, sign),
            sum(a.radian, b.radian, sign)};
}

} // namespace

double Quantity::in(const Quantity& unit) const {
    if (over == unit.over && under == unit.under) {
        return number / unit.number;
    }
    return number * (over * unit.under) / (under * unit.over * unit.number);
}

Quantity operator*(const Quantity& a, const Quantity& b) {
    return {a.number * b.number, a.over * b.over, a.under * b.under, joined(a.dimension, b.dimension, 1)};
}

Quantity operator/(const Quantity& a, const Quantity& b) {
    return {a.number / b.number, a.over * b.under, a.under * b.over, joined(a.dimension, b.dimension, -1)};
}

std::optional<Quantity> unitNamed(std::string_view name) {
    const auto found = std::ranges::find(units, name, &Unit::name);
    if (found == units.end()) {
        return {};
    }
    return Quantity{1, found->over, found->under, found->dimension};
}

} // namespace spacetow
