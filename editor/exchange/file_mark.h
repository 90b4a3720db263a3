#pragma once
// What a file is, by what it begins with: names lie, and R.U.B.E. calls its scenes .json as we do our levels.

#include <cstdint>
#include <string_view>

namespace spacetow {

enum class FileMark : std::uint8_t {
    None, // nothing that is known, or too little of it
    Level,
    Replay,
    Foreign, // SVG, Tiled or R.U.B.E., which can be imported or say why not
};

/// Of text that may end anywhere: more of it can turn None into something else, but nothing into anything else.
FileMark markOf(std::string_view text);

} // namespace spacetow
