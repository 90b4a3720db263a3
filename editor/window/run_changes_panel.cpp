#include "editor/window/run_changes_panel.h"

#include "core/level/bounds.h"
#include "editor/canvas/icons.h"
#include "editor/panels/list_keys.h"
#include "editor/panels/number_text.h"
#include "editor/window/list_look.h"
#include "editor/window/messages_compare.h"

#include <QEvent>

#include <algorithm>

namespace spacetow {

void RunChangesList::refresh() {
    QStringList texts;
    for (const LevelChange& change : m_changes.changes()) {
        texts << changeText(m_changes.before(), m_changes.after(), change);
    }
    if (texts == m_texts) {
        if (!texts.isEmpty()) {
            Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::CheckStateRole});
        }
        return;
    }
    beginResetModel();
    m_texts = std::move(texts);
    endResetModel();
}

void RunChangesList::setMarks(const MarkColors& colors, const QColor& selected) {
    m_added = icon(QStringLiteral("diff-added"), colors.good, selected);
    m_removed = icon(QStringLiteral("diff-removed"), colors.error, selected);
    m_changed = icon(QStringLiteral("diff-changed"), colors.warning, selected);
    if (!m_texts.isEmpty()) {
        Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
    }
}

int RunChangesList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_texts.size());
}

QVariant RunChangesList::markOf(const LevelChange& change) const {
    const ObjectChange kind = change.object == 0 ? ObjectChange::Changed : change.what.objects.front().change;
    return kind == ObjectChange::Added ? m_added : kind == ObjectChange::Removed ? m_removed : m_changed;
}

/// Names what is kept with it.
QString RunChangesList::needsText(const LevelChange& change) const {
    QStringList needed;
    for (const int place : change.needs) {
        needed << m_texts.value(place);
    }
    return needed.isEmpty() ? QString() : tr("Is kept only together with:\n%1").arg(needed.join(QLatin1Char('\n')));
}

QVariant RunChangesList::data(const QModelIndex& index, int role) const {
    // The changes may be gone already while the rows still are.
    if (!index.isValid() || index.row() >= rowCount() || index.row() >= std::ssize(m_changes.changes())) {
        return {};
    }
    const LevelChange& change = m_changes.changes()[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return m_texts[index.row()];
    case Qt::CheckStateRole:
        return m_changes.isTicked(index.row()) ? Qt::Checked : Qt::Unchecked;
    case Qt::DecorationRole:
        return markOf(change);
    case Qt::ToolTipRole:
        return needsText(change);
    default:
        return {};
    }
}

bool RunChangesList::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::CheckStateRole || !index.isValid() || index.row() >= std::ssize(m_changes.changes())) {
        return false;
    }
    m_changes.setTicked(index.row(), value.toInt() == Qt::Checked);
    return true;
}

Qt::ItemFlags RunChangesList::flags(const QModelIndex& index) const {
    return QAbstractListModel::flags(index) | Qt::ItemIsUserCheckable;
}

bool RunChangesView::event(QEvent* event) {
    return keepsListKey(*event) || QListView::event(event);
}

RunChangesPanel::RunChangesPanel(RunChanges& changes, Document& document, Canvas& canvas, QWidget* parent)
    : QWidget(parent), m_changes(changes), m_document(document), m_canvas(canvas), m_column(this), m_list(changes),
      m_keepAll(tr("Keep &All")), m_keepTicked(tr("Keep &Ticked")), m_discard(tr("&Discard All")) {
    layOutListPanel({m_column, m_title, m_view, m_buttons});
    m_view.setModel(&m_list);
    m_view.setAccessibleName(tr("Changes made in this run"));
    m_buttons.addWidget(&m_keepAll);
    m_buttons.addWidget(&m_keepTicked);
    m_buttons.addStretch(1);
    m_buttons.addWidget(&m_discard);
    m_keepTicked.setToolTip(tr("Makes those that are ticked in the level, and forgets the others"));
    m_discard.setToolTip(tr("Leaves the level as it was before the run; Undo brings the changes back"));
    connect(&m_keepAll, &QPushButton::clicked, this, [this] { m_changes.keepAll(); });
    connect(&m_keepTicked, &QPushButton::clicked, this, [this] { m_changes.keepTicked(); });
    connect(&m_discard, &QPushButton::clicked, this, [this] { m_changes.discard(); });
    connect(&m_view, &QListView::clicked, this, &RunChangesPanel::showObject);
    connect(&m_view, &QListView::activated, this, &RunChangesPanel::showObject);
    m_listener = m_changes.changed.connect([this] { follow(); });
    tint();
    follow();
}

RunChangesPanel::~RunChangesPanel() {
    m_changes.changed.disconnect(m_listener);
}

void RunChangesPanel::follow() {
    m_list.refresh();
    updateTexts();
    const bool waiting = m_changes.areWaiting();
    const bool told = waiting || m_changes.isEndUndone();
    const bool wereWaiting = std::exchange(m_wereWaiting, waiting);
    const bool wereTold = std::exchange(m_wereTold, told);
    if (waiting && !wereWaiting) {
        Q_EMIT wanted();
    } else if (wereTold && !told) {
        Q_EMIT settled();
    }
}

void RunChangesPanel::updateTexts() {
    const bool waiting = m_changes.areWaiting();
    m_title.setText(
        waiting ? counted(tr("%n changes were made in this run. The level is as before; keep what you like.", nullptr,
                             m_list.rowCount()),
                          m_list.rowCount())
        : m_changes.isEndUndone()
            ? tr("The end of the run is undone: what was changed in it is in the level again. Redo takes it "
                 "out, and lists it to be kept.")
            : tr("Nothing waits to be kept. What is changed in a level while it runs is listed here "
                 "when the run ends."));
    for (QWidget* const widget : {static_cast<QWidget*>(&m_view), static_cast<QWidget*>(&m_keepAll),
                                  static_cast<QWidget*>(&m_keepTicked), static_cast<QWidget*>(&m_discard)}) {
        widget->setVisible(waiting);
    }
    m_keepTicked.setEnabled(m_changes.ticked() > 0);
    m_keepAll.setToolTip(m_changes.changes().size() > RunChanges::mostSteps
                             ? tr("Makes all of these changes in the level, as one step that can be undone")
                             : tr("Makes all of these changes in the level, each as one step that can be undone"));
    // Keeps what there is at the top.
    m_column.setStretchFactor(&m_title, waiting ? 0 : 1);
    m_title.setAlignment(Qt::AlignTop | Qt::AlignLeft);
}

/// Where it is, or where it would come to be.
void RunChangesPanel::showObject(const QModelIndex& row) {
    if (!row.isValid() || row.row() >= std::ssize(m_changes.changes())) {
        return;
    }
    const Key key = m_changes.changes()[static_cast<std::size_t>(row.row())].object;
    const bool there = m_document.level().objects.find(key) != nullptr;
    const Aabb box =
        key == 0 ? Aabb() : boundsOf(there ? m_document.level() : m_changes.after(), std::vector<Key>{key});
    if (there) {
        m_document.select(Selection({key}));
    }
    if (!box.isEmpty()) {
        m_canvas.setView(m_canvas.view().showing(box.grown(0.5 * box.size().maxCoeff())));
    }
}

void RunChangesPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
    QWidget::changeEvent(event);
}

void RunChangesPanel::tint() {
    m_list.setMarks(markColors(shadeOf(palette())), palette().color(QPalette::HighlightedText));
}

} // namespace spacetow
