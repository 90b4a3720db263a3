#include "editor/panels/nodes_panel.h"

#include "core/level/node_edits.h"
#include "editor/editing/node_pick.h"
#include "editor/panels/list_keys.h"

#include <QHeaderView>
#include <QScopedValueRollback>

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

constexpr int many = 2000; // nodes; a table of more waits for the end of a drag

/// Whether the key opens a cell: F2 or Enter, or the first sign of what is to be typed.
bool opensCell(const QKeyEvent& key) {
    if ((key.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier) {
        return false;
    }
    const QString text = key.text();
    const bool isStart = text.size() == 1 && (text[0].isDigit() || QStringLiteral("+-*/.,(").contains(text[0]));
    return isStart || key.key() == Qt::Key_F2 || key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
}

} // namespace

NodesPanel::NodesPanel(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_model(document), m_delegate(m_model), m_column(this) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(2);
    m_table.setModel(&m_model);
    m_table.setAccessibleName(tr("Nodes of the objects in edit"));
    m_table.setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table.setFrameShape(QFrame::NoFrame);
    m_table.verticalHeader()->hide();
    m_table.horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_table.setTabKeyNavigation(true);
    m_table.setItemDelegate(&m_delegate);
    m_table.setToolTip(tr("Double click or type to change a coordinate; with several rows selected, in all of them"));
    m_table.installEventFilter(this);
    m_table.viewport()->installEventFilter(this);
    m_column.addWidget(&m_table);
    m_fault.setContentsMargins(6, 0, 6, 0);
    m_column.addWidget(&m_fault);
    connect(&m_delegate, &NodesDelegate::faultShown, &m_fault, &FaultLabel::say);
    m_insert.setText(tr("Insert"));
    m_insert.setToolTip(tr("Insert a node halfway to the next one"));
    m_remove.setText(tr("Delete"));
    m_remove.setToolTip(tr("Delete the selected nodes"));
    m_buttons.setContentsMargins(4, 0, 4, 4);
    m_buttons.addWidget(&m_insert);
    m_buttons.addWidget(&m_remove);
    m_buttons.addStretch();
    m_column.addLayout(&m_buttons);
    connect(&m_insert, &QToolButton::clicked, this, &NodesPanel::insertNode);
    connect(&m_remove, &QToolButton::clicked, this, &NodesPanel::removeSelectedNodes);
    connect(m_table.selectionModel(), &QItemSelectionModel::selectionChanged, this, &NodesPanel::takeSelection);
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
    showSelection();
}

NodesPanel::~NodesPanel() {
    m_document.changed.disconnect(m_listener);
}

void NodesPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

bool NodesPanel::eventFilter(QObject* watched, QEvent* event) {
    const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
    if (watched == &m_table && isKey && opensCell(static_cast<const QKeyEvent&>(*event))) {
        if (event->type() == QEvent::KeyPress) {
            return editByKey(static_cast<const QKeyEvent&>(*event));
        }
        event->accept();
        return true;
    }
    if (watched == &m_table && keepsListKey(*event)) {
        return true;
    }
    if (watched == m_table.viewport() && event->type() == QEvent::MouseButtonPress) {
        m_selectedBefore = m_document.selection().nodes();
    }
    if (watched == m_table.viewport() && event->type() == QEvent::MouseButtonDblClick) {
        return editSeveral(static_cast<const QMouseEvent&>(*event));
    }
    return QWidget::eventFilter(watched, event);
}

/// What is typed goes on to the field that the table opens for it.
bool NodesPanel::editByKey(const QKeyEvent& key) {
    const QModelIndex cell = m_table.currentIndex();
    const bool isTyped = !key.text().isEmpty() && key.text()[0].isPrint();
    if (isTyped || !cell.isValid()) {
        return false;
    }
    m_table.edit(cell.column() == NodesModel::Name ? cell.siblingAtColumn(NodesModel::X) : cell);
    return true;
}

/// The first click of a double click has selected one row: those of before are taken back when it was one of them.
bool NodesPanel::editSeveral(const QMouseEvent& mouse) {
    const QModelIndex cell = m_table.indexAt(mouse.position().toPoint());
    const std::vector<NodeRef> nodes = std::exchange(m_selectedBefore, {});
    const bool isOfSeveral = cell.isValid() && cell.column() != NodesModel::Name && nodes.size() > 1 &&
                             std::ranges::binary_search(nodes, m_model.node(cell.row()));
    if (!isOfSeveral || mouse.button() != Qt::LeftButton) {
        return false;
    }
    m_document.select(m_document.selection().withNodes(nodes));
    m_table.selectionModel()->setCurrentIndex(cell, QItemSelectionModel::NoUpdate);
    m_table.edit(cell);
    return true;
}

void NodesPanel::refresh() {
    if (!isVisible() || (m_document.hasPreview() && m_model.rowCount() > many)) {
        return;
    }
    const QScopedValueRollback<bool> guard(m_showing, true);
    m_model.refresh();
    showSelection();
}

void NodesPanel::showSelection() {
    const QScopedValueRollback<bool> guard(m_showing, true);
    QItemSelection rows;
    // Neighbouring rows as one range, or thousands would take long.
    int first = -1;
    int last = -1;
    const auto flush = [&] {
        if (first >= 0) {
            rows.append(QItemSelectionRange(m_model.index(first, 0), m_model.index(last, NodesModel::Y)));
        }
    };
    for (const NodeRef& node : m_document.selection().nodes()) {
        const int row = m_model.rowOf(node);
        if (row < 0) {
            continue;
        }
        if (row != last + 1 || first < 0) {
            flush();
            first = row;
        }
        last = row;
    }
    flush();
    if (m_table.selectionModel()->selection() != rows) {
        m_table.selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
        if (first >= 0 && !m_table.hasFocus()) {
            m_table.scrollTo(m_model.index(last, 0));
        }
    }
    m_insert.setEnabled(first >= 0);
    m_remove.setEnabled(first >= 0);
}

void NodesPanel::takeSelection() {
    if (m_showing) {
        return;
    }
    std::vector<NodeRef> nodes;
    for (const QModelIndex& index : m_table.selectionModel()->selectedRows()) {
        nodes.push_back(m_model.node(index.row()));
    }
    const Edit& edit = m_document.current();
    m_document.select(Selection(keysInEdit(edit), std::move(nodes)).entering(edit.selection.entered()));
}

void NodesPanel::insertNode() {
    const Edit& edit = m_document.current();
    if (edit.selection.nodes().empty()) {
        return;
    }
    const NodeRef node = edit.selection.nodes().back();
    const std::vector<NodeRef> ends = endsOf(*edit.level, {HitKind::Segment, node.key, node.shape, node.vertex});
    const auto from = nodePosition(*edit.level, ends[0]);
    const auto to = nodePosition(*edit.level, ends[1]);
    if (!from || !to) {
        return;
    }
    NodeEdit inserted = withNode(*edit.level, node, 0.5 * (*from + *to));
    m_document.commit({"insert-nodes", 1}, {std::make_shared<const Level>(std::move(inserted.level)),
                                            Selection(edit.selection.keys(), std::move(inserted.nodes))});
}

void NodesPanel::removeSelectedNodes() {
    const Edit& edit = m_document.current();
    const std::vector<NodeRef>& nodes = edit.selection.nodes();
    if (!nodes.empty()) {
        const auto level = std::make_shared<const Level>(withoutNodes(*edit.level, nodes));
        m_document.commit({"delete-nodes", static_cast<int>(nodes.size())},
                          {level, edit.selection.withNodes({}).within(*level)});
    }
}

} // namespace spacetow
