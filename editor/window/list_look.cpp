#include "editor/window/list_look.h"

#include <QBoxLayout>
#include <QLabel>
#include <QListView>

namespace spacetow {

void layOutListPanel(const ListPanelParts& parts) {
    parts.column.setContentsMargins(0, 0, 0, 6);
    parts.column.setSpacing(4);
    parts.column.addWidget(&parts.title);
    parts.column.addWidget(&parts.rows, 1);
    parts.column.addLayout(&parts.buttons);
    parts.title.setWordWrap(true);
    parts.title.setTextFormat(Qt::PlainText);
    parts.title.setContentsMargins(8, 6, 8, 2);
    parts.rows.setFrameShape(QFrame::NoFrame);
    parts.rows.setWordWrap(true);
    parts.rows.setTextElideMode(Qt::ElideNone);
    parts.rows.setIconSize(QSize(16, 16));
    parts.rows.setSpacing(1);
    parts.rows.setResizeMode(QListView::Adjust);
    parts.rows.setEditTriggers(QAbstractItemView::NoEditTriggers);
    parts.rows.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    parts.buttons.setContentsMargins(8, 0, 8, 0);
}

} // namespace spacetow
