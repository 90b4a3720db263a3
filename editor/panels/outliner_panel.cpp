#include "editor/panels/outliner_panel.h"

#include "editor/canvas/icons.h"
#include "editor/editing/outline_verbs.h"
#include "editor/panels/history_keys.h"

#include <QAction>
#include <QColorDialog>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QScopedValueRollback>
#include <QToolButton>

#include <algorithm>
#include <array>
#include <map>

namespace spacetow {

namespace {

constexpr int manyRanges = 500; // of selected rows; the selection model compares each with each
constexpr int manyLive = 2000;  // selected objects; the tree then waits for the end of a gesture

/// The rows as ranges of neighbours.
QItemSelection rowsOf(const OutlinerModel& model, std::span<const Key> keys) {
    std::map<Key, std::vector<int>> rows; // by parent
    for (const Key key : keys) {
        const QModelIndex index = model.indexOf(key);
        if (index.isValid()) {
            rows[OutlinerModel::keyOf(index.parent())].push_back(index.row());
        }
    }
    QItemSelection selection;
    for (auto& [group, places] : rows) {
        std::ranges::sort(places);
        const QModelIndex parent = model.indexOf(group);
        for (std::size_t first = 0, next = 0; first < places.size(); first = next) {
            while (next < places.size() && places[next] - places[first] == static_cast<int>(next - first)) {
                ++next;
            }
            selection.append(
                QItemSelectionRange(model.index(places[first], 0, parent),
                                    model.index(places[next - 1], OutlinerModel::ColumnCount - 1, parent)));
        }
    }
    return selection;
}

constexpr std::array filterWords{
    QT_TRANSLATE_NOOP("ObjectFilter", "wall"),      QT_TRANSLATE_NOOP("ObjectFilter", "line"),
    QT_TRANSLATE_NOOP("ObjectFilter", "polygon"),   QT_TRANSLATE_NOOP("ObjectFilter", "circle"),
    QT_TRANSLATE_NOOP("ObjectFilter", "static"),    QT_TRANSLATE_NOOP("ObjectFilter", "kinematic"),
    QT_TRANSLATE_NOOP("ObjectFilter", "dynamic"),   QT_TRANSLATE_NOOP("ObjectFilter", "ship"),
    QT_TRANSLATE_NOOP("ObjectFilter", "payload"),   QT_TRANSLATE_NOOP("ObjectFilter", "finish"),
    QT_TRANSLATE_NOOP("ObjectFilter", "connector"), QT_TRANSLATE_NOOP("ObjectFilter", "group"),
    QT_TRANSLATE_NOOP("ObjectFilter", "layer"),     QT_TRANSLATE_NOOP("ObjectFilter", "hidden"),
    QT_TRANSLATE_NOOP("ObjectFilter", "locked")};

/// In the language of the user; the filter has the English one.
QString shownWord(const QString& word) {
    const auto known = std::ranges::find_if(filterWords, [&](const char* each) { return QLatin1String(each) == word; });
    return known == filterWords.end() ? word : QCoreApplication::translate("ObjectFilter", *known);
}

/// As scrollTo does by itself, but not while a drag ends.
bool unfoldGroupsOf(QTreeView& view, const QModelIndex& index) {
    bool wasFolded = false;
    for (QModelIndex group = index.parent(); group.isValid(); group = group.parent()) {
        wasFolded = wasFolded || !view.isExpanded(group);
        view.expand(group);
    }
    return wasFolded;
}

} // namespace

OutlinerPanel::OutlinerPanel(Document& document, Toolbox& toolbox, QWidget* parent)
    : QWidget(parent), m_document(document), m_toolbox(toolbox), m_model(document, toolbox), m_column(this),
      m_view(m_model) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(2);
    makeFilter();
    m_column.addWidget(&m_filter);
    m_column.addWidget(&m_view, 1);
    m_column.addLayout(&m_buttons);
    m_buttons.setContentsMargins(4, 0, 4, 2);
    m_buttons.setSpacing(0);
    m_buttons.addStretch();
    m_model.setPalette(palette());
    connect(m_view.selectionModel(), &QItemSelectionModel::selectionChanged, this, &OutlinerPanel::takeSelection);
    connect(&m_model, &QAbstractItemModel::rowsInserted, this, [this] { m_hasNewRows = true; });
    connect(&m_model, &QAbstractItemModel::layoutChanged, this, [this] { m_hasNewRows = true; });
    connect(&m_model, &QAbstractItemModel::modelReset, this, [this] {
        m_hasNewRows = true;
        unfoldAgain();
    });
    connect(&m_model, &OutlinerModel::dropRefused, this,
            [this] { Q_EMIT said(tr("What is locked stays where it is; unlock it to move it.")); });
    connect(&m_view, &QTreeView::expanded, this, [this](const QModelIndex& index) {
        if (!m_model.isFiltered()) {
            m_unfolded.insert(OutlinerModel::keyOf(index));
        }
    });
    connect(&m_view, &QTreeView::collapsed, this, [this](const QModelIndex& index) {
        if (!m_model.isFiltered()) {
            m_unfolded.erase(OutlinerModel::keyOf(index));
        }
    });
    connect(&m_view, &OutlinerView::switchWanted, this, &OutlinerPanel::flip);
    connect(&m_view, &OutlinerView::objectWanted, this, &OutlinerPanel::viewWanted);
    connect(&m_view, &OutlinerView::allFoundWanted, this,
            [this] { m_document.select(selectionOf(*m_document.current().level, m_model.foundKeys())); });
    connect(&m_view, &OutlinerView::stepWanted, this, &OutlinerPanel::step);
    connect(&m_view, &QWidget::customContextMenuRequested, this,
            [this](const QPoint& at) { Q_EMIT menuWanted(m_view.viewport()->mapToGlobal(at)); });
    m_listener = m_document.changed.connect([this](const Change&) { refresh(); });
}

OutlinerPanel::~OutlinerPanel() {
    m_document.changed.disconnect(m_listener);
    m_showing = true; // nobody selects any more
}

void OutlinerPanel::makeFilter() {
    m_filter.setPlaceholderText(tr("Find: name, kind:wall, tag:ice"));
    m_filter.setAccessibleName(tr("Filter of the objects"));
    m_filter.setToolTip(
        tr("Shows the objects whose name holds these words, with their groups.\n"
           "kind:wall, tag:ice, is:hidden and is:locked ask for other things; a minus before a word "
           "turns it round. Enter selects all that is found.\nThe list shows what is drawn on top first."));
    m_filter.setClearButtonEnabled(true);
    m_filter.installEventFilter(this);
    m_choose = m_filter.addAction(icon(QStringLiteral("filter"), palette()), QLineEdit::LeadingPosition);
    m_choose->setToolTip(tr("Choose what to find"));
    connect(m_choose, &QAction::triggered, this, [this] {
        QMenu menu(this);
        fillFilterMenu(menu);
        menu.exec(m_filter.mapToGlobal(QPoint(0, m_filter.height())));
    });
    connect(&m_filter, &QLineEdit::textChanged, this, &OutlinerPanel::applyFilter);
}

void OutlinerPanel::addButtons(const QList<QAction*>& actions) {
    for (QAction* action : actions) {
        auto* const button = new QToolButton(this); // owned by the panel
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setIconSize(QSize(16, 16));
        button->setFocusPolicy(Qt::TabFocus);
        m_buttons.insertWidget(m_buttons.count() - 1, button);
    }
}

void OutlinerPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

void OutlinerPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        m_model.setPalette(palette());
        m_choose->setIcon(icon(QStringLiteral("filter"), palette()));
    }
    QWidget::changeEvent(event);
}

bool OutlinerPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_filter && isHistoryOfLevel(*event, !m_filter.text().isEmpty())) {
        return true;
    }
    if (watched == &m_filter && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape && !m_filter.text().isEmpty()) {
            m_filter.clear();
            return true;
        }
        const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
        if (isEnter && m_model.isFiltered()) {
            m_view.setFocus();
            Q_EMIT m_view.allFoundWanted();
            return true;
        }
        if (key == Qt::Key_Down || isEnter) {
            m_view.setFocus();
            if (!m_view.currentIndex().isValid() || m_view.selectionModel()->selectedRows().isEmpty()) {
                m_view.setCurrentIndex(m_model.index(0, 0));
            }
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void OutlinerPanel::refresh() {
    if (!isVisible() || (m_document.hasPreview() && m_document.selection().size() > manyLive)) {
        return;
    }
    const QScopedValueRollback<bool> guard(m_showing, true);
    m_model.refresh();
    if (m_hasNewRows || m_document.selection().keys() != m_shownKeys) {
        showSelection();
    }
}

void OutlinerPanel::showSelection() {
    const QScopedValueRollback<bool> guard(m_showing, true);
    m_hasNewRows = false;
    m_shownKeys = m_document.selection().keys();
    const QItemSelection rows = rowsOf(m_model, m_shownKeys);
    QItemSelectionModel& shown = *m_view.selectionModel();
    if (rows.size() > manyRanges) {
        shown.clearSelection();
        shown.select(rows, QItemSelectionModel::Select);
    } else {
        shown.select(rows, QItemSelectionModel::ClearAndSelect);
    }
    const QModelIndex current = m_view.currentIndex();
    if (rows.isEmpty()) {
        return;
    }
    if (!std::ranges::binary_search(m_shownKeys, OutlinerModel::keyOf(current))) {
        const QModelIndex first = rows.front().topLeft();
        shown.setCurrentIndex(first, QItemSelectionModel::NoUpdate);
        unfoldGroupsOf(m_view, first);
        m_view.scrollTo(first);
    } else if (unfoldGroupsOf(m_view, current)) {
        m_view.scrollTo(current); // it has come into another group
    }
}

void OutlinerPanel::takeSelection() {
    if (m_showing) {
        return;
    }
    std::vector<Key> keys;
    for (const QModelIndex& index : m_view.selectionModel()->selectedRows()) {
        keys.push_back(OutlinerModel::keyOf(index));
    }
    std::ranges::sort(keys);
    m_shownKeys = keys;
    m_document.select(selectionOf(*m_document.current().level, std::move(keys)));
}

void OutlinerPanel::applyFilter() {
    const QScopedValueRollback<bool> guard(m_showing, true);
    m_model.setFilter(ObjectFilter(m_filter.text()));
    unfoldAgain();
    showSelection();
    m_view.viewport()->update();
}

void OutlinerPanel::unfoldAgain() {
    if (m_model.isFiltered()) {
        m_view.expandAll(); // what is found is to be seen
        return;
    }
    const std::set<Key> unfolded = m_unfolded;
    m_view.collapseAll();
    for (const Key key : unfolded) {
        m_view.expand(m_model.indexOf(key));
    }
    m_unfolded = unfolded;
}

void OutlinerPanel::renameSelected() {
    const std::vector<Key>& keys = m_document.selection().keys();
    if (!keys.empty()) {
        rename(keys.front());
    }
}

void OutlinerPanel::rename(Key key) {
    if (!m_model.indexOf(key).isValid()) {
        m_filter.clear();
    }
    const QModelIndex index = m_model.indexOf(key);
    if (index.isValid()) {
        m_view.rename(index);
    }
}

void OutlinerPanel::flip(const QModelIndex& index) {
    const Object* const object = m_model.objectOf(index);
    if (object == nullptr) {
        return;
    }
    if (index.column() == OutlinerModel::Color) {
        chooseColor(*object);
        return;
    }
    const Edit edit = m_document.current();
    const std::vector<Key> keys =
        edit.selection.contains(object->key) ? edit.selection.keys() : std::vector{object->key};
    m_toolbox.finish(index.column() == OutlinerModel::Eye ? showObjects(edit, keys, !object->visible)
                                                          : lockObjects(edit, keys, !object->locked));
}

void OutlinerPanel::chooseColor(const Object& object) {
    const auto* const group = std::get_if<GroupObject>(&object.data);
    if (group == nullptr) {
        return;
    }
    const Key key = object.key;
    const QColor color = QColorDialog::getColor(group->color ? QColor::fromRgb(*group->color) : QColor(Qt::gray), this,
                                                tr("Color of the Group"));
    if (color.isValid()) {
        m_toolbox.finish(colorGroup(m_document.current(), key, color.rgb() & 0xffffffU));
    }
}

void OutlinerPanel::step(int by) {
    const QModelIndex parent = m_view.currentIndex().parent();
    std::vector<Key> keys;
    std::vector<int> rows;
    for (const QModelIndex& index : m_view.selectionModel()->selectedRows()) {
        if (index.parent() == parent) {
            keys.push_back(OutlinerModel::keyOf(index));
            rows.push_back(index.row());
        }
    }
    if (rows.empty() && m_view.currentIndex().isValid()) { // what is hidden is not selected
        keys.push_back(OutlinerModel::keyOf(m_view.currentIndex()));
        rows.push_back(m_view.currentIndex().row());
    }
    if (rows.empty()) {
        return;
    }
    const auto [top, bottom] = std::ranges::minmax(rows);
    const int row = by < 0 ? top - 1 : bottom + 2; // below which gap they come to stand
    if (row >= 0 && row <= m_model.rowCount(parent)) {
        m_toolbox.finish(regroup(m_document.current(), keys, m_model.placeAt(parent, row)));
    }
}

void OutlinerPanel::fillFilterMenu(QMenu& menu) {
    const auto add = [this](QMenu& to, const QString& text, const QString& term) {
        QAction* const action = to.addAction(QString(text).replace(QLatin1Char('&'), QStringLiteral("&&")));
        action->setCheckable(true);
        action->setChecked(m_filter.text().contains(term));
        connect(action, &QAction::triggered, this, [this, term] { toggleTerm(term); });
    };
    QMenu* const kinds = menu.addMenu(tr("Kind"));
    for (const QString& kind : ObjectFilter::kinds()) {
        add(*kinds, shownWord(kind), ObjectFilter::term(QStringLiteral("kind"), kind));
    }
    QMenu* const tags = menu.addMenu(tr("Tag"));
    for (int i = 0; i < TagTable::size; ++i) {
        const QString name = QString::fromStdString(m_document.level().tags[i].name);
        if (!name.isEmpty()) {
            add(*tags, name, ObjectFilter::term(QStringLiteral("tag"), name));
        }
    }
    for (const QString& state : ObjectFilter::states()) {
        add(menu, shownWord(state), ObjectFilter::term(QStringLiteral("is"), state));
    }
}

void OutlinerPanel::toggleTerm(const QString& term) {
    QString text = m_filter.text();
    if (text.contains(term)) {
        text.remove(term);
    } else {
        text += QLatin1Char(' ') + term;
    }
    m_filter.setText(text.simplified());
}

} // namespace spacetow
