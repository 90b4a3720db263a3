#pragma once
// What must hold for any bytes that are imported; see fuzz_targets.h.

#include "editor/exchange/import.h"
#include "tests/support/fuzz_targets.h"

namespace spacetow::test {

/// What can be imported can be saved, and comes back; what cannot is refused with a code.
inline void tryImport(std::string_view bytes) {
    const Result<Drawing> drawing = readDrawing(bytes);
    if (!drawing) {
        mustHold(!drawing.error().code.text().empty(), "what is refused says why");
        return;
    }
    for (const bool isPlain : {true, false}) {
        ImportOptions options;
        options.tolerance = isPlain ? 0.1 : 1;
        options.walls = isPlain ? ImportedWalls::TwoWay : ImportedWalls::OneWay;
        options.fillsAsWalls = !isPlain;
        Result<Import> import = importOf(drawing.value(), options);
        if (import) {
            const Imported result = imported(Level(), std::move(import).value().foreign, {.layer = "file", .seed = 1});
            mustHold(!result.keys.empty(), "what was imported is there");
            mustComeBack(result.level);
        }
    }
}

} // namespace spacetow::test
