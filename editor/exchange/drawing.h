#pragma once
// What a file of another program draws, before it becomes part of a level: paths with their curves, circles, groups,
// and bodies that are one already. In units of the file; y is up. The importers make it, import.h makes objects of it.

#include "core/base/result.h"
#include "core/level/level.h"
#include "core/math/affine.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace spacetow {

struct LinePiece {
    Vec2 to;
};
struct CubicPiece {
    Vec2 control1, control2, to;
};
/// From center + cos t·u + sin t·v at t = `from` to t = `from` + `sweep`: part of an ellipse, exact under affine maps.
struct ArcPiece {
    Vec2 center, u, v;
    double from = 0, sweep = 0; // rad
    Vec2 to;
};
using PathPiece = std::variant<LinePiece, CubicPiece, ArcPiece>;

struct DrawnPath {
    Vec2 start{0, 0};
    std::vector<PathPiece> pieces;
    bool closed = false;
};

/// What one element draws.
struct Figure {
    std::vector<DrawnPath> paths;
    std::vector<Circle> circles;
    bool filled = true; // or else stroked only
    bool stroked = false;
    bool evenOdd = false; // which parts of a filled path are inside; else by winding
    std::vector<std::string> tags;
    std::optional<double> friction, restitution, density;
};

/// What holds the items that name it as their parent.
struct Folder {
    bool layer = false;
    std::optional<std::uint32_t> color; // 0xRRGGBB
};

/// An object as it is to be, in metres where a unit is one metre. Connectors name the items that they hold by their
/// places in the drawing, plus one; `tags` of the drawing say what the tags of bodies are called.
struct ReadyObject {
    ObjectData data;
};

struct DrawnItem {
    std::string name;
    int parent = -1; // place of a folder that comes before it; −1 at the top
    bool visible = true;
    bool locked = false;
    int line = 0; // of the file
    std::variant<Figure, Folder, ReadyObject> what;
};

struct Drawing {
    std::vector<DrawnItem> items; // in drawing order
    double metresPerUnit = 1;     // what is usual for such a file
    TagTable tags;                // of ready objects
    std::vector<Error> notes;     // what was not taken over; see report.h
};

Vec2 endOf(const DrawnPath& path);
DrawnPath mapped(const DrawnPath& path, const Affine& map);
/// A whole ellipse about `center` with these conjugate half axes.
DrawnPath ellipsePath(const Vec2& center, const Vec2& u, const Vec2& v);
DrawnPath polygonPath(std::vector<Vec2> points, bool closed);
/// By how much the map stretches, when it is no more than turn, mirror, move and scale: circles stay circles then.
std::optional<double> similarityOf(const Affine& map);

} // namespace spacetow
