#pragma once
// What the player holds down during one update.

#include <cstdint>

namespace spacetow {

struct Controls {
    bool left = false;   // anticlockwise
    bool right = false;  // clockwise
    bool thrust = false; // along the nose
    bool tow = false;    // tow when in range; also "go on" after a crash or a win

    bool operator==(const Controls&) const = default;
};

constexpr std::uint8_t toBits(const Controls& c) {
    return static_cast<std::uint8_t>(c.left | c.right << 1 | c.thrust << 2 | c.tow << 3);
}
constexpr Controls controlsFromBits(std::uint8_t bits) {
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
}

} // namespace spacetow
