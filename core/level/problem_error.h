#pragma once
// Errors whose reason is a problem in a line of a text: that of a file, or of a level within a file.

#include "core/level/json_tree.h"
#include "core/level/problem.h"

namespace spacetow {

/// Arguments: the line, and the code and the arguments of the problem.
Error errorOf(Code code, const Problem& problem);

/// The first line of a value that lies in more than so many lists and objects; 0 where none does.
int lineDeeperThan(JsonView value, int most);

} // namespace spacetow
