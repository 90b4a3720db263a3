#pragma once
// The menus that open at the pointer, and at the selection by their key: what can be done with what lies there. Their
// entries are actions of the table; what is not possible is left out.

class QMenu;

namespace spacetow {

class MainWindow;

/// What lies at the pointer is selected, unless something there is already; the menu is about nodes while nodes are
/// edited and the pointer is at one, about the ground where there is nothing.
void fillMenuAtPointer(MainWindow& window, QMenu& menu);
/// About what is selected, wherever the pointer is.
void fillMenuOfSelection(MainWindow& window, QMenu& menu);
/// About the rows that are selected in the outliner.
void fillMenuOfOutliner(MainWindow& window, QMenu& menu);

} // namespace spacetow
