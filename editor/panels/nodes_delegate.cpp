#include "editor/panels/nodes_delegate.h"

#include "core/level/fields.h"
#include "editor/panels/number_field.h"

#include <QKeyEvent>
#include <QPersistentModelIndex>

namespace spacetow {

namespace {

QAbstractItemDelegate::EndEditHint hintOf(int key) {
    return key == Qt::Key_Tab       ? QAbstractItemDelegate::EditNextItem
           : key == Qt::Key_Backtab ? QAbstractItemDelegate::EditPreviousItem
                                    : QAbstractItemDelegate::NoHint;
}

} // namespace

NodesDelegate::NodesDelegate(NodesModel& model, QObject* parent) : QStyledItemDelegate(parent), m_model(model) {}

QWidget* NodesDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const {
    auto* field = new NumberField(parent); // owned by it
    field->setSpec({.unit = QStringLiteral("m"), .min = -limits::coordinate, .max = limits::coordinate, .step = 0.05});
    field->words = words;
    const QPersistentModelIndex at(index);
    field->enter = [this, at](const NumberEntry& entry) {
        if (entry.change && at.isValid()) {
            m_model.place(at, applied(*entry.change, m_model.coordinate(at)), entry.isStep);
        }
        return QString();
    };
    connect(field, &NumberField::faultChanged, this, [this, field] { Q_EMIT faultShown(field->fault()); });
    return field;
}

void NodesDelegate::destroyEditor(QWidget* editor, const QModelIndex& index) const {
    Q_EMIT faultShown({});
    QStyledItemDelegate::destroyEditor(editor, index);
}

void NodesDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    static_cast<NumberField*>(editor)->setValue(m_model.coordinate(index));
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
