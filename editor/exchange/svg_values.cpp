#include "editor/exchange/svg_values.h"

#include "core/math/rot.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

namespace spacetow {

namespace {

constexpr double pixelsPerInch = 96;

double radiansOf(double degrees) {
    return std::fmod(degrees, 360) * std::numbers::pi / 180;
}

double tangent(double degrees) {
    const Rot turn = Rot::fromAngle(radiansOf(degrees));
    return turn.s / turn.c;
}

/// What a function of the transform list does; nothing when it has the wrong number of arguments.
std::optional<Affine> transformOf(std::string_view name, const std::vector<double>& n) {
    const std::size_t count = n.size();
    if (name == "matrix" && count == 6) {
        return Affine{{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}};
    }
    if (name == "translate" && (count == 1 || count == 2)) {
        return Affine::translation({n[0], count == 2 ? n[1] : 0});
    }
    if (name == "scale" && (count == 1 || count == 2)) {
        return Affine{{n[0], 0}, {0, count == 2 ? n[1] : n[0]}, {0, 0}};
    }
    if (name == "rotate" && (count == 1 || count == 3)) {
        return Affine::rotation(count == 3 ? Vec2(n[1], n[2]) : Vec2(0, 0), radiansOf(n[0]));
    }
    if (name == "skewX" && count == 1) {
        return Affine{{1, 0}, {tangent(n[0]), 1}, {0, 0}};
    }
    if (name == "skewY" && count == 1) {
        return Affine{{1, tangent(n[0])}, {0, 1}, {0, 0}};
    }
    return {};
}

/// Which share of the room that is left over goes before the box: "xMidYMax" for axis 1 is 1.
double alignment(std::string_view text, int axis) {
    const std::size_t at = axis == 0 ? 1 : 5;
    const std::string_view part = text.size() >= at + 3 ? text.substr(at, 3) : "Mid";
    return part == "Min" ? 0 : part == "Max" ? 1 : 0.5;
}

} // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\n\r\f";
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::optional<double> lengthFromText(std::string_view text, const LengthBase& base) {
    NumberScanner scanner(text);
    const std::optional<double> number = scanner.number();
    if (!number) {
        return {};
    }
    const std::string_view unit = scanner.word();
    scanner.skip();
    const std::array<std::pair<std::string_view, double>, 11> units{std::pair{std::string_view(), 1.0},
                                                                    {"px", 1},
                                                                    {"in", pixelsPerInch},
                                                                    {"cm", pixelsPerInch / 2.54},
                                                                    {"mm", pixelsPerInch / 25.4},
                                                                    {"Q", pixelsPerInch / 101.6},
                                                                    {"pt", pixelsPerInch / 72},
                                                                    {"pc", pixelsPerInch / 6},
                                                                    {"em", base.fontSize},
                                                                    {"ex", base.fontSize / 2},
                                                                    {"%", base.percentOf / 100}};
    const auto found = std::ranges::find(units, unit, &std::pair<std::string_view, double>::first);
    return found != units.end() && scanner.atEnd() ? std::optional(*number * found->second) : std::nullopt;
}

std::optional<Affine> transformFromText(std::string_view text) {
    Affine all;
    NumberScanner scanner(text);
    for (scanner.skip(); !scanner.atEnd(); scanner.skip()) {
        const std::string_view name = scanner.word();
        scanner.skip();
        if (name.empty() || scanner.atEnd() || scanner.take() != '(') {
            return {};
        }
        std::vector<double> numbers;
        while (const std::optional<double> number = scanner.number()) {
            numbers.push_back(*number);
        }
        scanner.skip();
        const std::optional<Affine> one = transformOf(name, numbers);
        if (!one || scanner.atEnd() || scanner.take() != ')') {
            return {};
        }
        all = all * *one;
    }
    return all;
}

std::optional<ViewBox> viewBoxFromText(std::string_view text) {
    NumberScanner scanner(text);
    std::array<double, 4> n{};
    for (double& value : n) {
        const std::optional<double> number = scanner.number();
        if (!number) {
            return {};
        }
        value = *number;
    }
    if (!(n[2] > 0 && n[3] > 0)) {
        return {};
    }
    return ViewBox{{n[0], n[1]}, {n[2], n[3]}};
}

Affine viewBoxMap(const ViewBox& box, const Vec2& window, std::string_view preserveAspectRatio) {
    const std::string_view how = trimmed(preserveAspectRatio);
    Vec2 scale = window.cwiseQuotient(box.size);
    Vec2 offset(0, 0);
    if (!how.starts_with("none")) {
        const double same = how.ends_with("slice") ? scale.maxCoeff() : scale.minCoeff();
        scale = Vec2(same, same);
        const Vec2 rest = window - same * box.size;
        offset = Vec2(alignment(how, 0) * rest.x(), alignment(how, 1) * rest.y());
    }
    return {{scale.x(), 0}, {0, scale.y()}, offset - box.corner.cwiseProduct(scale)};
}

} // namespace spacetow
