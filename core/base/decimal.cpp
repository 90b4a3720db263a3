#include "core/base/decimal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace spacetow {

namespace {

int decimalsOf(double number) {
    std::array<char, 400> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed).ptr;
    const std::string_view spelled(text.data(), static_cast<std::size_t>(end - text.data()));
    const std::size_t point = spelled.find('.');
    return point == std::string_view::npos ? 0 : static_cast<int>(spelled.size() - point - 1);
}

/// The double nearest to the decimal number with so many decimals.
double withDecimals(double number, int decimals) {
    std::array<char, 400> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, decimals).ptr;
    double result = number;
    std::from_chars(text.data(), end, result);
    return result == 0 ? 0 : result; // not −0
}

/// Whether a double holds so many decimals of a number of this size.
bool holds(double size, int decimals) {
    constexpr int digits = 17;
    return std::isfinite(size) && decimals + static_cast<int>(std::ceil(std::log10(std::abs(size) + 1))) <= digits;
}

} // namespace

double decimalSum(double a, double b) {
    const double sum = a + b;
    const int decimals = std::max(decimalsOf(a), decimalsOf(b));
    const double largest = std::max({std::abs(a), std::abs(b), std::abs(sum)});
    return holds(largest, decimals) ? withDecimals(sum, decimals) : sum;
}

double decimalMultiple(double number, int count) {
    const double product = number * count;
    const int decimals = decimalsOf(number);
    return holds(product, decimals) ? withDecimals(product, decimals) : product;
}

} // namespace spacetow
