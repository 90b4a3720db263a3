#include "editor/panels/outliner_view.h"

#include "editor/panels/list_keys.h"

#include <QApplication>
#include <QDropEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>

namespace spacetow {

namespace {

constexpr int switchWidth = 24; // logical pixels, of a column

/// Alt and an arrow move rows.
bool isOfTree(const QKeyEvent& key) {
    const bool isStep = key.key() == Qt::Key_Up || key.key() == Qt::Key_Down;
    return isForLists(key) || (key.modifiers() == Qt::AltModifier && isStep);
}

/// Of what a filter leaves, while there is one.
bool isSelectAll(const QKeyEvent& key, const OutlinerModel& model) {
    return model.isFiltered() && key.matches(QKeySequence::SelectAll);
}

} // namespace

OutlinerView::OutlinerView(OutlinerModel& model, QWidget* parent) : QTreeView(parent), m_model(model) {
    setModel(&model);
    setAccessibleName(tr("Objects of the level"));
    setFrameShape(QFrame::NoFrame);
    setUniformRowHeights(true); // else each row would be measured
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    setDragDropMode(QAbstractItemView::DragDrop); // the model takes nothing but its own
    setDefaultDropAction(Qt::MoveAction);
    setDropIndicatorShown(true);
    setAutoExpandDelay(600); // ms over a group while something is dragged
    setContextMenuPolicy(Qt::CustomContextMenu);
    setIconSize(QSize(16, 16));
    setIndentation(14);
    setHeaderHidden(true);
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(switchWidth);
    header()->setSectionResizeMode(OutlinerModel::Name, QHeaderView::Stretch);
    for (const int column : {OutlinerModel::Color, OutlinerModel::Eye, OutlinerModel::Lock}) {
        header()->setSectionResizeMode(column, QHeaderView::Fixed);
        header()->resizeSection(column, switchWidth);
    }
}

void OutlinerView::rename(const QModelIndex& index) {
    m_backTo = QApplication::focusWidget();
    setFocus();
    selectionModel()->setCurrentIndex(index, QItemSelectionModel::NoUpdate);
    scrollTo(index);
    edit(index);
}

void OutlinerView::closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) {
    QTreeView::closeEditor(editor, hint);
    const bool goesOn = hint == QAbstractItemDelegate::EditNextItem || hint == QAbstractItemDelegate::EditPreviousItem;
    if (!goesOn && m_backTo != nullptr && hasFocus()) {
        m_backTo->setFocus();
    }
    m_backTo = goesOn ? m_backTo : nullptr;
}

bool OutlinerView::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (isOfTree(key) || isSelectAll(key, m_model)) {
            event->accept();
            return true;
        }
    }
    return QTreeView::event(event);
}

void OutlinerView::keyPressEvent(QKeyEvent* event) {
    const QModelIndex current = currentIndex();
    if (isSelectAll(*event, m_model)) {
        Q_EMIT allFoundWanted();
    } else if (!current.isValid() || !isOfTree(*event) || state() == EditingState) { // which passes its keys on
        QTreeView::keyPressEvent(event);
    } else if (event->modifiers() == Qt::AltModifier) {
        Q_EMIT stepWanted(event->key() == Qt::Key_Up ? -1 : 1);
    } else if (event->key() == Qt::Key_Space) {
        Q_EMIT switchWanted(current.siblingAtColumn(OutlinerModel::Eye));
    } else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        Q_EMIT objectWanted();
    } else {
        QTreeView::keyPressEvent(event);
    }
}

bool OutlinerView::isSwitched(const QMouseEvent& event) {
    const QModelIndex index = indexAt(event.pos());
    if (event.button() != Qt::LeftButton || !index.isValid() || index.column() == OutlinerModel::Name) {
        return false;
    }
    Q_EMIT switchWanted(index);
    return true;
}

void OutlinerView::mousePressEvent(QMouseEvent* event) {
    if (!isSwitched(*event)) {
        QTreeView::mousePressEvent(event);
    }
}

void OutlinerView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (!isSwitched(*event)) {
        QTreeView::mouseDoubleClickEvent(event);
    }
}

void OutlinerView::dropEvent(QDropEvent* event) {
    const QModelIndex under = indexAt(event->position().toPoint());
    // The line below an unfolded group is above its first member.
    if (dropIndicatorPosition() == BelowItem && isExpanded(under.siblingAtColumn(OutlinerModel::Name)) &&
        m_model.hasChildren(under.siblingAtColumn(OutlinerModel::Name))) {
        m_model.dropMimeData(event->mimeData(), Qt::MoveAction, 0, 0, under.siblingAtColumn(OutlinerModel::Name));
        event->setDropAction(Qt::MoveAction);
        event->accept();
        stopAutoScroll();
        setState(NoState);
        viewport()->update();
        return;
    }
    QTreeView::dropEvent(event);
}

void OutlinerView::paintEvent(QPaintEvent* event) {
    QTreeView::paintEvent(event);
    if (m_model.rowCount() == 0) {
        QPainter painter(viewport());
        painter.setPen(palette().color(QPalette::Disabled, QPalette::Text));
        painter.drawText(viewport()->rect().adjusted(8, 8, -8, -8), Qt::AlignHCenter | Qt::TextWordWrap,
                         m_model.isFiltered() ? tr("No object matches the filter.") : tr("The level has no objects."));
    }
}

} // namespace spacetow
