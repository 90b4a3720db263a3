#pragma once
// Values as Tiled spells them.

#include <cstdint>
#include <optional>
#include <string_view>

namespace spacetow {

/// `otherwise` for what is no finite number.
double tiledNumber(std::string_view text, double otherwise = 0);
/// "#RRGGBB" or "#AARRGGBB", also without the "#".
std::optional<std::uint32_t> tiledColor(std::string_view text);

} // namespace spacetow
