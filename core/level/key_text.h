#pragma once
// How keys, colours and tags without a name are spelled in level files.

#include "core/level/level.h"

#include <optional>
#include <string>
#include <string_view>

namespace spacetow {

/// Eight hexadecimal digits.
std::string keyText(Key key);
/// None for anything but exactly eight hexadecimal digits, and for zero.
std::optional<Key> keyFromText(std::string_view text);

/// "#rrggbb".
std::string colorText(std::uint32_t color);
std::optional<std::uint32_t> colorFromText(std::string_view text);

/// Tag 17 without a name is spelled "#17". The index of the tag, or −1 for any other text.
int unnamedTag(std::string_view text);

} // namespace spacetow
