#pragma once
// How strong the ship is: said here, so that lint knows it too. Figures chosen by playing.

namespace spacetow::ship {

constexpr double mass = 1;                                         // kg
constexpr double thrustToWeight = 2.5;                             // at the standard gravity of the game
constexpr double standardGravity = 0.95;                           // m/s²
constexpr double thrust = mass * standardGravity * thrustToWeight; // N
constexpr double linearDamping = 0.15;                             // 1/s

} // namespace spacetow::ship
