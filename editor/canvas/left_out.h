#pragma once
// What overlays do not draw of what there is, as the legend says.

namespace spacetow {

struct LeftOut {
    bool dots = false;  // marks that would be no more than dots
    bool names = false; // names that would lie on others

    bool operator==(const LeftOut&) const = default;
};

} // namespace spacetow
