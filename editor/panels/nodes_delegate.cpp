#include "editor/panels/nodes_delegate.h"

#include "core/level/fields.h"
#include "editor/panels/number_field.h"
#include "editor/panels/number_text.h"

#include <QAbstractItemView>
#include <QKeyEvent>

#include <algorithm>

namespace spacetow {

namespace {

QAbstractItemDelegate::EndEditHint hintOf(int key) {
    return key == Qt::Key_Tab       ? QAbstractItemDelegate::EditNextItem
           : key == Qt::Key_Backtab ? QAbstractItemDelegate::EditPreviousItem
                                    : QAbstractItemDelegate::NoHint;
}

/// The rows that an entry into the cell changes, ascending.
std::vector<int> rowsFor(const QWidget* view, const QModelIndex& index) {
    std::vector<int> rows;
    const auto* table = qobject_cast<const QAbstractItemView*>(view);
    if (table != nullptr && table->selectionModel()->isRowSelected(index.row())) {
        for (const QModelIndex& row : table->selectionModel()->selectedRows()) {
            rows.push_back(row.row());
        }
    }
    std::ranges::sort(rows);
    return rows.empty() ? std::vector<int>{index.row()} : rows;
}

class NodeField : public NumberField {
  public:
    NodeField(std::vector<int> changed, QWidget* parent) : NumberField(parent), rows(std::move(changed)) {}

    const std::vector<int> rows; // of a table that is filled anew when they are others
};

} // namespace

NodesDelegate::NodesDelegate(NodesModel& model, QObject* parent) : QStyledItemDelegate(parent), m_model(model) {}

QWidget* NodesDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                     const QModelIndex& index) const {
    auto* field = new NodeField(rowsFor(option.widget, index), parent); // owned by it
    field->setSpec({.unit = QStringLiteral("m"), .min = -limits::coordinate, .max = limits::coordinate, .step = 0.05});
    field->words = words;
    field->enter = [this, field, column = index.column()](const NumberEntry& entry) {
        const bool isThere = !field->rows.empty() && field->rows.back() < m_model.rowCount();
        if (!entry.change || !isThere || m_model.change(field->rows, column, *entry.change, entry.isStep)) {
            return QString();
        }
        return tr("That would leave the map, which ends %1 m from the origin.")
            .arg(shortNumberText(limits::coordinate));
    };
    connect(field, &NumberField::faultChanged, this, [this, field] { Q_EMIT faultShown(field->fault()); });
    return field;
}

void NodesDelegate::destroyEditor(QWidget* editor, const QModelIndex& index) const {
    Q_EMIT faultShown({});
    QStyledItemDelegate::destroyEditor(editor, index);
}

void NodesDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    auto* field = static_cast<NodeField*>(editor);
    if (m_model.isAlike(field->rows, index.column())) {
        field->setValue(m_model.coordinate(index));
    } else {
        field->setMixed();
    }
}

void NodesDelegate::setModelData(QWidget*, QAbstractItemModel*, const QModelIndex&) const {
    // The field has made its edits already.
}

bool NodesDelegate::eventFilter(QObject* watched, QEvent* event) {
    auto* field = qobject_cast<NumberField*>(watched);
    if (field != nullptr && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Tab || key == Qt::Key_Backtab) {
            if (field->enterTyped()) {
                Q_EMIT closeEditor(field, hintOf(key));
            }
            return true;
        }
    }
    const bool isLeft = field != nullptr && event->type() == QEvent::FocusOut &&
                        static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason;
    if (isLeft && !field->enterTyped()) {
        return false; // it stays open
    }
    return QStyledItemDelegate::eventFilter(watched, event);
}

} // namespace spacetow
