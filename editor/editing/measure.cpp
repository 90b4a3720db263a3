#include "editor/editing/measure.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

/// Not printf, whose decimal point depends on the language of the desktop.
std::string fixed(double value, int decimals) {
    const double unit = std::pow(10.0, decimals);
    const double rounded = std::round(value * unit) / unit + 0.0;
    std::array<char, 400> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

} // namespace

std::string lengthText(double metres) {
    const bool small = metres != 0 && std::abs(metres) < 0.1;
    return fixed(metres, small ? 3 : 2);
}

int placeDecimals(double pixel, double step) {
    constexpr int least = 2, most = 5, mostOfStep = 4;
    int decimals = least;
    while (decimals < most && std::pow(10.0, -decimals) > pixel) {
        ++decimals;
    }
    const auto isWhole = [](double value) { return std::abs(value - std::round(value)) < 1e-6; };
    while (decimals < mostOfStep && !isWhole(step * std::pow(10.0, decimals))) {
        ++decimals;
    }
    return decimals;
}

std::string degreesText(double radians) {
    const double tenths = std::round(std::remainder(radians * 180 / std::numbers::pi, 360.0) * 10);
    const double degrees = tenths == -1800 ? 180 : tenths / 10;
    return fixed(degrees, degrees == std::round(degrees) ? 0 : 1);
}

std::string wayText(const Vec2& way) {
    return "Δx " + lengthText(way.x()) + "  Δy " + lengthText(way.y()) + " m\n" + lengthText(way.norm()) + " m  " +
           degreesText(directionOf(way)) + "°";
}

double directionOf(const Vec2& vector) {
    return std::atan2(vector.y(), vector.x());
}

} // namespace spacetow
