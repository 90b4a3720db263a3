#include "editor/window/difference_panel.h"

#include "core/level/arrange.h"
#include "core/level/bounds.h"
#include "editor/canvas/icons.h"
#include "editor/panels/number_text.h"
#include "editor/window/list_look.h"

#include <QEvent>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int afterEdit = 150; // ms

} // namespace

void DifferenceList::setLines(std::vector<DifferenceLine> lines) {
    beginResetModel();
    m_lines = std::move(lines);
    endResetModel();
}

void DifferenceList::setMarks(const MarkColors& colors, const QColor& selected) {
    m_added = icon(QStringLiteral("diff-added"), colors.good, selected);
    m_removed = icon(QStringLiteral("diff-removed"), colors.error, selected);
    m_changed = icon(QStringLiteral("diff-changed"), colors.warning, selected);
    if (!m_lines.empty()) {
        Q_EMIT dataChanged(index(0), index(rowCount() - 1), {Qt::DecorationRole});
    }
}

int DifferenceList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

QVariant DifferenceList::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    const DifferenceLine& line = m_lines[static_cast<std::size_t>(index.row())];
    switch (role) {
    case Qt::DisplayRole:
        return line.text;
    case Qt::DecorationRole:
        return line.change == ObjectChange::Added     ? m_added
               : line.change == ObjectChange::Removed ? m_removed
                                                      : m_changed;
    default:
        return {};
    }
}

DifferencePanel::DifferencePanel(Document& document, Canvas& canvas, QWidget* parent)
    : QWidget(parent), m_document(document), m_canvas(canvas), m_column(this), m_choose(tr("&Compare With…")),
      m_takeOver(tr("Ta&ke Over")), m_end(tr("&End")) {
    layOutListPanel({m_column, m_title, m_view, m_buttons});
    m_view.setModel(&m_list);
    m_view.setLayoutMode(QListView::Batched);
    m_view.setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view.setAccessibleName(tr("Differences"));
    m_buttons.addWidget(&m_choose);
    m_buttons.addStretch(1);
    m_buttons.addWidget(&m_takeOver);
    m_buttons.addWidget(&m_end);
    m_takeOver.setToolTip(tr("Makes the selected objects as they are in the other level"));
    m_end.setToolTip(tr("Ends comparing; the level stays as it is"));
    connect(&m_choose, &QPushButton::clicked, this, &DifferencePanel::levelWanted);
    connect(&m_takeOver, &QPushButton::clicked, this, &DifferencePanel::takeOver);
    connect(&m_end, &QPushButton::clicked, this, &DifferencePanel::end);
    connect(&m_view, &QListView::clicked, this, &DifferencePanel::showObject);
    connect(&m_view, &QListView::activated, this, &DifferencePanel::showObject);
    connect(m_view.selectionModel(), &QItemSelectionModel::selectionChanged, this, &DifferencePanel::updateTexts);
    m_soon.setSingleShot(true);
    m_soon.setInterval(afterEdit);
    connect(&m_soon, &QTimer::timeout, this, &DifferencePanel::lookBeside);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (m_other && change.before.level != change.after.level) {
            m_soon.start();
        }
    });
    tint();
    updateTexts();
}

DifferencePanel::~DifferencePanel() {
    m_document.changed.disconnect(m_listener);
}

void DifferencePanel::compareWith(std::shared_ptr<const Level> other, const QString& name) {
    m_other = std::move(other);
    m_name = name;
    m_looked = nullptr;
    lookBeside();
    updateTexts();
}

void DifferencePanel::end() {
    m_other = nullptr;
    m_looked = nullptr;
    m_list.setLines({});
    m_canvas.setDifference(nullptr);
    updateTexts();
}

void DifferencePanel::finish() {
    m_soon.stop();
    m_task.finish();
    lookBeside();
    m_task.finish();
}

void DifferencePanel::lookBeside() {
    const std::shared_ptr<const Level> level = m_document.current().level;
    if (!m_other || level == m_looked) {
        return;
    }
    if (m_document.hasPreview() || m_task.isRunning()) {
        m_soon.start(); // when the gesture, or the look at an older level, is over
        return;
    }
    m_task.start([this, level, other = m_other](const std::stop_token&) -> BackgroundTask::Then {
        const LevelDifference difference = differenceBetween(*other, *level);
        const auto lines = std::make_shared<std::vector<DifferenceLine>>(differenceLines(*other, *level, difference));
        const auto shown = std::make_shared<const ShownDifference>(other, difference);
        return [this, level, other, lines, shown] {
            if (other == m_other) {
                take(level, std::move(*lines), shown);
            }
        };
    });
}

void DifferencePanel::take(const std::shared_ptr<const Level>& level, std::vector<DifferenceLine> lines,
                           std::shared_ptr<const ShownDifference> shown) {
    m_looked = level;
    m_list.setLines(std::move(lines));
    m_canvas.setDifference(std::move(shown));
    updateTexts();
}

void DifferencePanel::updateTexts() {
    if (!m_other) {
        m_title.setText(tr("Nothing is compared. Choose a level file to see what is different from it."));
    } else if (!m_looked) {
        m_title.setText(tr("Comparing with %1…").arg(m_name));
    } else if (m_list.lines().empty()) {
        m_title.setText(tr("Nothing is different from %1.").arg(m_name));
    } else {
        m_title.setText(
            counted(tr("%n differences from %1", nullptr, m_list.rowCount()), m_list.rowCount()).arg(m_name));
    }
    m_view.setVisible(m_other != nullptr);
    m_takeOver.setVisible(m_other != nullptr);
    m_end.setVisible(m_other != nullptr);
    m_takeOver.setEnabled(!selectedKeys().empty());
    // Keeps what there is at the top.
    m_column.setStretchFactor(&m_title, m_other ? 0 : 1);
    m_title.setAlignment(Qt::AlignTop | Qt::AlignLeft);
}

std::vector<Key> DifferencePanel::selectedKeys() const {
    std::vector<Key> keys;
    for (const QModelIndex& row : m_view.selectionModel()->selectedIndexes()) {
        if (const Key key = m_list.lines()[static_cast<std::size_t>(row.row())].object; key != 0) {
            keys.push_back(key);
        }
    }
    return keys;
}

void DifferencePanel::takeOver() {
    const std::vector<Key> keys = selectedKeys();
    if (!m_other || keys.empty() || m_document.hasPreview()) {
        return;
    }
    auto level = std::make_shared<const Level>(takenOver(*m_document.current().level, *m_other, keys));
    std::vector<Key> there;
    std::ranges::copy_if(keys, std::back_inserter(there), [&](Key key) { return level->objects.find(key) != nullptr; });
    m_document.commit({"take-over", static_cast<int>(keys.size())}, {level, Selection(there)});
    lookBeside();
}

void DifferencePanel::showObject(const QModelIndex& row) {
    if (!row.isValid() || !m_other) {
        return;
    }
    const Key key = m_list.lines()[static_cast<std::size_t>(row.row())].object;
    const Level& level = m_document.level();
    const bool there = level.objects.find(key) != nullptr;
    const Aabb box = boundsOf(there ? level : *m_other, std::vector<Key>{key});
    if (there) {
        m_document.select(Selection({key}));
    }
    if (!box.isEmpty()) {
        m_canvas.setView(m_canvas.view().showing(box.grown(0.5 * box.size().maxCoeff())));
    }
}

void DifferencePanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
    QWidget::changeEvent(event);
}

void DifferencePanel::tint() {
    m_list.setMarks(markColors(shadeOf(palette())), palette().color(QPalette::HighlightedText));
}

} // namespace spacetow
