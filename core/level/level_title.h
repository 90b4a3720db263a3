#pragma once
// The name that a level calls itself by, without reading all of its file.

#include <optional>
#include <string>
#include <string_view>

namespace spacetow {

constexpr std::size_t titleBytes = 4096; // of a file, in which a level that we have written has it

/// From the beginning of its file, which may end anywhere; none where it is not in there.
std::optional<std::string> titleIn(std::string_view beginning);

} // namespace spacetow
