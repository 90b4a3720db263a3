#pragma once
// Values of SVG's attributes: lengths with units, transforms, view boxes. Lengths come out in pixels, 96 to an inch.

#include "editor/exchange/svg_path.h"

#include <optional>
#include <string_view>

namespace spacetow {

/// What units are relative to.
struct LengthBase {
    double percentOf = 100; // px; what 100 % are
    double fontSize = 16;   // px
};
/// "2.5cm"; nothing for what is no length.
std::optional<double> lengthFromText(std::string_view text, const LengthBase& base = {});

/// "translate(1 2) rotate(30)"; a mistake ends the list, as browsers have it: nothing then.
std::optional<Affine> transformFromText(std::string_view text);

struct ViewBox {
    Vec2 corner{0, 0};
    Vec2 size{0, 0};
};
/// Nothing for what is no view box or has no size.
std::optional<ViewBox> viewBoxFromText(std::string_view text);

/// From the coordinates of a view box to a window of this size whose corner is the origin, as preserveAspectRatio
/// ("xMidYMid meet" when empty) tells.
Affine viewBoxMap(const ViewBox& box, const Vec2& window, std::string_view preserveAspectRatio);

/// Without blanks at its ends.
std::string_view trimmed(std::string_view text);

} // namespace spacetow
