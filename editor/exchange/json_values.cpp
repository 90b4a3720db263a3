#include "editor/exchange/json_values.h"

#include <bit>
#include <charconv>
#include <cmath>

namespace spacetow {

namespace {

std::optional<double> floatFromBits(const std::string& text) {
    std::uint32_t bits = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bits, 16);
    if (text.size() != 8 || error != std::errc{} || end != text.data() + text.size()) {
        return {};
    }
    return std::bit_cast<float>(bits);
}

} // namespace

std::optional<JsonView> jsonMember(const JsonView& object, std::string_view name) {
    if (object.isObject()) {
        for (const JsonView member : object) {
            if (member.name() == name) {
                return member;
            }
        }
    }
    return {};
}

std::optional<double> jsonNumberIn(const JsonView& value) {
    const std::optional<double> number = value.isNumber() ? std::optional(value.number())
                                         : value.isText() ? floatFromBits(value.text())
                                                          : std::nullopt;
    return number && std::isfinite(*number) ? number : std::nullopt;
}

double jsonNumber(const JsonView& object, std::string_view name, double otherwise) {
    const std::optional<JsonView> member = jsonMember(object, name);
    return member ? jsonNumberIn(*member).value_or(otherwise) : otherwise;
}

bool jsonFlag(const JsonView& object, std::string_view name, bool otherwise) {
    const std::optional<JsonView> member = jsonMember(object, name);
    return member && member->isBool() ? member->kind() == JsonKind::True : otherwise;
}

std::string jsonText(const JsonView& object, std::string_view name) {
    const std::optional<JsonView> member = jsonMember(object, name);
    return member && member->isText() ? member->text() : std::string();
}

Vec2 jsonPoint(const JsonView& object, std::string_view name) {
    const std::optional<JsonView> member = jsonMember(object, name);
    return member ? Vec2(jsonNumber(*member, "x"), jsonNumber(*member, "y")) : Vec2(0, 0);
}

} // namespace spacetow
