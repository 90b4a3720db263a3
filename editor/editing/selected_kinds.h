#pragma once
// What there is among what is selected, as far as it decides what could be done with it.

#include "editor/editing/document.h"

namespace spacetow {

/// Members of groups that are selected count. Of a crowd only the beginning is looked at, and of the rest everything
/// is taken for possible, so that it costs little however much is selected.
struct SelectedKinds {
    bool copyable = false;   // bodies and groups; of the other kinds a level has one each, or they go with bodies
    bool reversible = false; // walls and lines, which have a direction
    bool groups = false;
    bool nodes = false;    // something whose nodes can be edited
    bool unlocked = false; // something that may be changed
};
SelectedKinds selectedKinds(const Edit& edit);

} // namespace spacetow
