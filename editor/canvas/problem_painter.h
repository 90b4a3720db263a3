#pragma once
// Marks the places of problems on the canvas: a small sign each, and a line along what is wrong.

#include "core/level/problem_place.h"
#include "editor/canvas/palette.h"
#include "editor/canvas/stage.h"

#include <span>

namespace spacetow {

/// `current` is the place of the problem (not of the mark) that somebody looks at; −1 for none. Where many lie close
/// together the worst of them is shown.
void paintProblems(const Stage& stage, std::span<const ProblemMark> marks, int current, const MarkColors& colors);

} // namespace spacetow
