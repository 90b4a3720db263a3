#include "editor/exchange/tiled_values.h"

#include "editor/exchange/svg_path.h"

#include <charconv>

namespace spacetow {

double tiledNumber(std::string_view text, double otherwise) {
    return NumberScanner(text).number().value_or(otherwise);
}

std::optional<std::uint32_t> tiledColor(std::string_view text) {
    if (text.starts_with('#')) {
        text.remove_prefix(1);
    }
    if (text.size() == 8) {
        text.remove_prefix(2); // how opaque it is
    }
    std::uint32_t color = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), color, 16);
    const bool isWhole = text.size() == 6 && error == std::errc{} && end == text.data() + text.size();
    return isWhole ? std::optional(color) : std::nullopt;
}

} // namespace spacetow
