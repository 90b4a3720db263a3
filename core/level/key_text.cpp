#include "core/level/key_text.h"

#include <charconv>

namespace spacetow {

std::optional<Key> keyFromText(std::string_view text) {
    Key key = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), key, 16);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && text.size() == 8 && key != 0 ? std::optional(key) : std::nullopt;
}

std::string keyText(Key key) {
    std::string digits(8, '0');
    for (std::size_t i = 8; i-- > 0; key >>= 4u) {
        digits[i] = "0123456789abcdef"[key & 15u];
    }
    return digits;
}

int unnamedTag(std::string_view text) {
    int index = -1;
    if (text.size() < 2 || text.size() > 3 || text[0] != '#') {
        return -1;
    }
    const auto end = std::from_chars(text.data() + 1, text.data() + text.size(), index).ptr;
    return end == text.data() + text.size() && index < TagTable::size ? index : -1;
}

std::optional<std::uint32_t> colorFromText(std::string_view text) {
    std::uint32_t color = 0;
    if (text.size() != 7 || text[0] != '#') {
        return {};
    }
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), color, 16);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(color) : std::nullopt;
}

std::string colorText(std::uint32_t color) {
    return '#' + keyText(color & 0xffffffu).substr(2);
}

} // namespace spacetow
