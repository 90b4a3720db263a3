#pragma once
// Which schemas of level files this version reads. A newer file is refused, since leaving out what it means would be
// guessing. Schema 1 is the first; when there is a second, its step from 1 to 2 belongs here, tree to tree.

#include "core/level/json_tree.h"

#include <optional>

namespace spacetow {

constexpr int newestSchema = 1;

/// Why the document cannot be read at all: it is no object, names no schema, or one that is not known here.
std::optional<Problem> schemaProblem(const JsonTree& tree);

} // namespace spacetow
