#pragma once
// Which schemas of level files this version reads. A newer file is refused, since leaving out what it means would be
// guessing. Schema 2 added groups, guides and the fields parent, visible and locked to schema 1, and changed nothing
// that was there: a file of schema 1 is read as it is. A later schema that changes something has its step here, tree
// to tree.

#include "core/level/json_tree.h"

#include <optional>

namespace spacetow {

constexpr int oldestSchema = 1;
constexpr int newestSchema = 2;

/// Why the document cannot be read at all: it is no object, names no schema, or one that is not known here.
std::optional<Problem> schemaProblem(const JsonTree& tree);

} // namespace spacetow
