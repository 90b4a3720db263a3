#pragma once
// Files of other programs as objects of a level: SVG, maps of Tiled (XML and JSON), scenes of R.U.B.E. First the bytes
// become a drawing, which takes time, then that becomes objects by options that may be changed. No file, however odd,
// does more than be refused. Metres.

#include "core/level/adopt_tags.h"
#include "editor/exchange/drawing.h"
#include "editor/exchange/figure_shapes.h"
#include "editor/exchange/watch.h"

#include <optional>
#include <string>
#include <string_view>

namespace spacetow {

constexpr double leastTolerance = 1e-4; // m

struct ImportOptions {
    std::optional<double> scale; // m a unit of the file, > 0; without it, what is usual for such a file
    double tolerance = 0.01;     // m, ≥ leastTolerance
    ImportedWalls walls = ImportedWalls::TwoWay;
    bool fillsAsWalls = false;
};

struct Import {
    ForeignObjects foreign;   // keys and parents are among themselves; groups come before their members
    std::vector<Error> notes; // what was not taken over; see report.h
    int vertices = 0;
    double scale = 1; // that was used
};

/// What the bytes draw; the kind of file is told by them alone. Codes: those of parseXml, "text-too-large" (bytes
/// allowed), "empty-file", "not-sound-json" (line, code and arguments of the problem there), "nested-too-deep",
/// "too-many-values" and "too-many-vertices" (number allowed), "import-compressed", "import-level", "import-tileset",
/// "import-unknown".
Result<Drawing> readDrawing(std::string_view bytes, const Watch& watch = {});

/// Codes: "import-too-far" (metres allowed), "import-too-many-vertices" (number allowed), "import-nothing",
/// "import-stopped". `leftOut` is told what was not taken over even where that is all there is.
Result<Import> importOf(const Drawing& drawing, const ImportOptions& options, const Watch& watch = {},
                        std::vector<Error>* leftOut = nullptr);

/// Where what comes is to be in a level.
struct ImportPlace {
    std::optional<Vec2> middle;       // m, of its bounds; without it, where the file has it
    double step = 0;                  // m; if not 0 it is moved by multiples of it
    std::optional<std::string> layer; // name of a new layer for all of it
    std::uint64_t seed = 0;           // for keys
};
struct Imported {
    Level level;
    std::vector<Key> keys;    // of what is at the top of what came
    std::vector<Error> notes; // on tags, and "import-one-only"
};
/// The objects in a level with their tags; in a new layer, layers among them become groups.
Imported imported(Level level, ForeignObjects foreign, const ImportPlace& place);

} // namespace spacetow
