#pragma once
// What a drawn figure is as shapes of a level: filled ones become polygons and circles, the others chains of walls.
// World coordinates, metres.

#include "editor/exchange/drawing.h"
#include "editor/exchange/report.h"

namespace spacetow {

enum class ImportedWalls : std::uint8_t { TwoWay, OneWay };

struct ShapeOptions {
    double scale = 1;        // m a unit
    double tolerance = 0.01; // m; how far a curve may stray
    ImportedWalls walls = ImportedWalls::TwoWay;
    bool fillsAsWalls = false; // filled figures become walls as well, solid from outside where one-way
};

/// Adds to the report what could not be made as it is drawn: "import-holes", "import-large-polygon",
/// "import-tangled", "import-flat". Codes: "import-too-far" (metres allowed), "import-too-many-vertices" (number
/// allowed).
Result<std::vector<LevelShape>> shapesOf(const DrawnItem& item, const Figure& figure, const ShapeOptions& options,
                                         Report& report);

/// How far from the origin something may come to lie, m: half of what a level allows, so that it may be moved about.
constexpr double farthestImport = 5e5;
bool isWithinReach(const Vec2& point);

/// On the micrometre.
Vec2 onMicrometres(const Vec2& point);

} // namespace spacetow
