#pragma once
// SVG as a drawing. Units are CSS pixels, of which 96 make an inch; the page's lower left corner is the origin. Text,
// pictures, clips and what else is no shape is reported.

#include "editor/exchange/drawing.h"
#include "editor/exchange/xml_tree.h"

namespace spacetow {

/// Codes: "import-too-many" (number allowed), "import-stopped". The root is an <svg>.
Result<Drawing> readSvg(const XmlElement& root, const Watch& watch);

} // namespace spacetow
