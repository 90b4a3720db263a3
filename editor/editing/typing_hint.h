#pragma once
// What the status bar says while numbers are typed into a drawing.

#include "editor/editing/tool.h"

namespace spacetow {

Hint typingHint(const TypedEntry& entry);

} // namespace spacetow
