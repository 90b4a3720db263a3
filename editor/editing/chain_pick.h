#pragma once
// The end of an open chain under the pointer, from which drawing can go on.

#include "core/level/chain_ends.h"
#include "editor/editing/document.h"
#include "editor/editing/input.h"

#include <optional>

namespace spacetow {

enum class ChainKind : std::uint8_t { Edges, Lines };

/// The nearest; of several in one place that of a selected object, else of the one drawn last. None that is hidden or
/// locked. Looks at what is near only.
std::optional<ChainEnd> chainEndAt(const Edit& edit, const Pointer& pointer, ChainKind kind);

} // namespace spacetow
