#pragma once
// The basic shapes of SVG as paths, in their own coordinates, y as in the file.

#include "editor/exchange/svg_values.h"
#include "editor/exchange/xml_tree.h"

#include <optional>
#include <vector>

namespace spacetow {

struct SvgShape {
    std::vector<DrawnPath> paths;
    std::optional<Circle> circle; // instead
    bool whole = true;            // else there is a mistake in its data
    bool fillable = true;
};

bool isSvgShape(std::string_view element);
/// Lengths in percent are relative to a window of this size. Without paths and circle there is nothing to be drawn.
SvgShape svgShape(const XmlElement& element, const Vec2& window, double fontSize);

/// The attribute as a length along an axis of the window, or along its diagonal.
enum class LengthAxis { X, Y, Diagonal };
std::optional<double> svgLength(const XmlElement& element, const char* attribute, LengthAxis axis, const Vec2& window);

} // namespace spacetow
