#pragma once
// From the JSON tree to the level. Everything that cannot be understood without guessing is an error with its line
// and JSON pointer; what is merely unknown is kept for the next save. Nothing is repaired in silence.

#include "core/level/adopt_tags.h"
#include "core/level/json_tree.h"
#include "core/level/problem.h"

#include <optional>
#include <vector>

namespace spacetow {

/// More problems than this are not listed one by one.
constexpr std::size_t maxProblems = 1000;

struct LevelReading {
    std::optional<Level> level; // none when there is an error
    std::vector<Problem> problems;
    std::size_t unlisted = 0; // problems that there are beside
};

LevelReading readTree(const JsonTree& tree);

/// The "objects" of a tree, for the clipboard, with what the tree says of their tags: an object with an error, or
/// that says a field twice, is left out and reported. A tag that is only named is given a place.
ForeignObjects readObjects(const JsonTree& tree, std::vector<Problem>& problems);

} // namespace spacetow
