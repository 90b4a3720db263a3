#pragma once
// Makes what an action does from a verb of editor/editing: `.run = doing<removeSelected>`.

#include "editor/window/main_window.h"

namespace spacetow {

/// The verb takes a ToolContext, and the arguments given here, and answers with the finished edit or with none.
template <auto verb, auto... arguments>
void doing(MainWindow& window) {
    window.toolbox().finish(verb(window.toolbox().context(), arguments...));
}

} // namespace spacetow
