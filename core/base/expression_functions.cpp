#include "core/base/expression_functions.h"

#include "core/base/codes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace spacetow {

namespace {

constexpr double pi = std::numbers::pi;
constexpr Dimension angleDimension{0, 0, 0, 1};

bool isAngle(const Quantity& q) {
    return q.dimension.isNone() || q.dimension == angleDimension;
}

/// Whole multiples of 30° have the sine that everybody knows; π is only nearly π.
double sineOf(const Quantity& q, double quarterTurns) {
    const double degrees = q.dimension.isNone() ? 0.5 : q.in({1, pi, 180, angleDimension}) + 90 * quarterTurns;
    if (degrees == std::floor(degrees) && std::fmod(degrees, 30) == 0 && std::abs(degrees) < 1e9) {
        constexpr std::array exact{0.0, 0.5, 2.0, 1.0, 2.0, 0.5, 0.0, -0.5, 2.0, -1.0, 2.0, -0.5};
        const double value = exact[static_cast<std::size_t>((static_cast<long long>(degrees) / 30 % 12 + 12) % 12)];
        if (value <= 1) {
            return value;
        }
    }
    return quarterTurns == 0 ? std::sin(q.si()) : std::cos(q.si());
}

double tangentOf(const Quantity& q) {
    const double degrees = q.dimension.isNone() ? 0.5 : q.in({1, pi, 180, angleDimension});
    if (std::fmod(degrees, 45) == 0 && std::abs(degrees) < 1e9) {
        const long long eighths = (static_cast<long long>(degrees) / 45 % 4 + 4) % 4;
        return std::array{0.0, 1.0, std::numeric_limits<double>::infinity(), -1.0}[static_cast<std::size_t>(eighths)];
    }
    return std::tan(q.si());
}

Result<Quantity> checked(const Quantity& q) {
    return std::isfinite(q.number) ? Result<Quantity>(q)
                                   : Result<Quantity>(Error{BaseCode("expression-not-finite"), {}});
}

using Arguments = std::span<const Quantity>;

Result<Quantity> ofAngle(double value) {
    return checked({value, 1, 1, angleDimension});
}

Result<Quantity> trigonometry(std::string_view name, const Quantity& q) {
    if (!isAngle(q)) {
        return Error{BaseCode("expression-units-differ"), {}};
    }
    return checked(plainNumber(name == "sin" ? sineOf(q, 0) : name == "cos" ? sineOf(q, 1) : tangentOf(q)));
}

Result<Quantity> ofPlainNumber(std::string_view name, const Quantity& q) {
    if (!q.dimension.isNone()) {
        return Error{BaseCode("expression-units-differ"), {}};
    }
    const double x = q.si();
    if (name == "asin" || name == "acos" || name == "atan") {
        return ofAngle(name == "asin" ? std::asin(x) : name == "acos" ? std::acos(x) : std::atan(x));
    }
    return checked(plainNumber(name == "exp" ? std::exp(x) : name == "ln" ? std::log(x) : std::log10(x)));
}

Result<Quantity> squareRoot(const Quantity& q) {
    const auto isEven = [](int n) { return n % 2 == 0; };
    const Dimension& d = q.dimension;
    if (!isEven(d.metre) || !isEven(d.kilogram) || !isEven(d.second) || !isEven(d.radian)) {
        return Error{BaseCode("expression-units-differ"), {}};
    }
    const auto half = [](int n) { return static_cast<std::int8_t>(n / 2); };
    return checked({std::sqrt(q.si()), 1, 1, {half(d.metre), half(d.kilogram), half(d.second), half(d.radian)}});
}

/// Of the number as it is written, so that round(2.6 cm) is 3 cm.
Result<Quantity> rounded(std::string_view name, Quantity q) {
    q.number = name == "abs"     ? std::abs(q.number)
               : name == "round" ? std::round(q.number)
               : name == "floor" ? std::floor(q.number)
                                 : std::ceil(q.number);
    return checked(q);
}

Result<Quantity> ofTwo(std::string_view name, const Quantity& a, const Quantity& b) {
    if (!(a.dimension == b.dimension)) {
        return Error{BaseCode("expression-units-differ"), {}};
    }
    if (name == "atan2") {
        return ofAngle(std::atan2(a.si(), b.si()));
    }
    return (a.si() < b.si()) == (name == "min") ? a : b;
}

constexpr std::array<std::string_view, 14> ofOne{"sin", "cos", "tan",  "asin", "acos",  "atan",  "exp",
                                                 "ln",  "log", "sqrt", "abs",  "round", "floor", "ceil"};
constexpr std::array<std::string_view, 3> ofPairs{"min", "max", "atan2"};

} // namespace

bool isFunction(std::string_view name) {
    return std::ranges::find(ofOne, name) != ofOne.end() || std::ranges::find(ofPairs, name) != ofPairs.end();
}

Result<Quantity> functionValue(std::string_view name, Arguments arguments) {
    const std::size_t wanted = std::ranges::find(ofPairs, name) != ofPairs.end() ? 2 : 1;
    if (arguments.size() != wanted) {
        return Error{BaseCode("expression-arguments"), {std::string(name)}};
    }
    const Quantity& first = arguments[0];
    if (wanted == 2) {
        return ofTwo(name, first, arguments[1]);
    }
    if (name == "sin" || name == "cos" || name == "tan") {
        return trigonometry(name, first);
    }
    if (name == "sqrt") {
        return squareRoot(first);
    }
    const bool keepsUnit = name == "abs" || name == "round" || name == "floor" || name == "ceil";
    return keepsUnit ? rounded(name, first) : ofPlainNumber(name, first);
}

} // namespace spacetow
