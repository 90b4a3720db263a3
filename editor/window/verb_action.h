#pragma once
// Makes what an action does from a verb of editor/editing: `.run = doing<removeSelected>`.

#include "editor/window/main_window.h"

namespace spacetow {

/// The verb takes a ToolContext, and the arguments given here, and answers with the finished edit or with none. When
/// level and selection are the same afterwards, the status bar says so.
template <auto verb, auto... arguments>
void doing(MainWindow& window) {
    const Edit before = window.document().current();
    window.toolbox().finish(verb(window.toolbox().context(), arguments...));
    const Edit& after = window.document().current();
    if (before.level == after.level && before.selection.keys() == after.selection.keys() &&
        before.selection.nodes() == after.selection.nodes()) {
        window.actions().sayNothingChanged();
    }
}

} // namespace spacetow
