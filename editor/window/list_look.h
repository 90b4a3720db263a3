#pragma once
// How a panel looks that lists what has changed: a sentence above, rows that wrap, buttons below.

class QHBoxLayout;
class QLabel;
class QListView;
class QVBoxLayout;

namespace spacetow {

/// The parts of such a panel, from above; the panel owns them.
struct ListPanelParts {
    QVBoxLayout& column;
    QLabel& title;
    QListView& rows;
    QHBoxLayout& buttons;
};

/// Puts the parts into the column.
void layOutListPanel(const ListPanelParts& parts);

} // namespace spacetow
