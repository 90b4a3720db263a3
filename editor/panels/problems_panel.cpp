#include "editor/panels/problems_panel.h"

#include "core/level/lint.h"
#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"
#include "editor/panels/list_keys.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr int soon = 120;       // ms after an edit
constexpr int slow = 250;       // ms after which people want to know that something is going on
constexpr int rowsAtOnce = 100; // laid out before the window goes on with something else

} // namespace

ProblemsPanel::ProblemsPanel(Document& document, ProblemList::Sentence sentence, QWidget* parent)
    : QWidget(parent), m_document(document), m_problems(std::move(sentence)), m_column(this) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(0);
    m_column.addWidget(&m_note);
    m_column.addWidget(&m_list, 1);
    m_note.setContentsMargins(8, 6, 8, 6);
    m_note.setWordWrap(true);
    m_note.setTextFormat(Qt::PlainText);
    m_list.setModel(&m_problems);
    m_list.setFrameShape(QFrame::NoFrame);
    m_list.setWordWrap(true);
    m_list.setTextElideMode(Qt::ElideNone);
    m_list.setIconSize(QSize(16, 16));
    m_list.setSpacing(1);
    m_list.setLayoutMode(QListView::Batched);
    m_list.setBatchSize(rowsAtOnce);
    m_list.setResizeMode(QListView::Adjust);
    m_list.setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list.setAccessibleName(tr("Problems of the level"));
    m_list.installEventFilter(this);
    connect(&m_list, &QListView::clicked, this, &ProblemsPanel::choose);
    connect(&m_list, &QListView::activated, this, &ProblemsPanel::choose);
    m_soon.setSingleShot(true);
    m_soon.setInterval(soon);
    connect(&m_soon, &QTimer::timeout, this, &ProblemsPanel::checkBeside);
    m_slow.setSingleShot(true);
    m_slow.setInterval(slow);
    connect(&m_slow, &QTimer::timeout, this, &ProblemsPanel::note);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (change.before.level != change.after.level) {
            m_soon.start();
        }
    });
    tint();
    check();
}

ProblemsPanel::~ProblemsPanel() {
    m_document.changed.disconnect(m_listener);
}

bool ProblemsPanel::eventFilter(QObject* watched, QEvent* event) {
    return (watched == &m_list && keepsListKey(*event)) || QWidget::eventFilter(watched, event);
}

void ProblemsPanel::check() {
    m_soon.stop();
    m_task.finish();
    checkBeside();
    m_task.finish();
}

void ProblemsPanel::checkBeside() {
    const std::shared_ptr<const Level> level = m_document.current().level;
    if (m_document.hasPreview() || m_task.isRunning()) {
        m_soon.start(); // when the gesture, or the check of an older level, is over
    } else if (level != m_checked) {
        m_slow.start();
        m_task.start([this, level](const std::stop_token& stop) -> BackgroundTask::Then {
            const auto found = std::make_shared<std::vector<Problem>>(lint(*level, stop));
            return [this, level, found] { take(level, std::move(*found)); };
        });
    }
}

void ProblemsPanel::take(const std::shared_ptr<const Level>& level, std::vector<Problem> problems) {
    m_slow.stop();
    m_checked = level;
    const bool same = problems == m_problems.problems();
    if (same) {
        m_problems.setLevel(level);
    } else {
        m_problems.setProblems(level, std::move(problems));
    }
    note();
    if (!same) {
        Q_EMIT problemsChanged();
    }
}

void ProblemsPanel::note() {
    const bool checking = m_task.isRunning();
    m_note.setText(checking ? tr("Checking…") : tr("Nothing to complain about."));
    m_note.setVisible(checking || m_problems.problems().empty());
}

void ProblemsPanel::tint() {
    const MarkColors colors = markColors(shadeOf(palette()));
    m_problems.setMarks(icon(QStringLiteral("error"), colors.error), icon(QStringLiteral("warning"), colors.warning));
}

int ProblemsPanel::errors() const {
    return static_cast<int>(std::ranges::count(problems(), Severity::Error, &Problem::severity));
}

int ProblemsPanel::warnings() const {
    return static_cast<int>(std::ranges::count(problems(), Severity::Warning, &Problem::severity));
}

void ProblemsPanel::choose(const QModelIndex& row) {
    if (row.isValid() && row.row() < std::ssize(problems())) {
        Q_EMIT objectWanted(problems()[static_cast<std::size_t>(row.row())].object);
    }
}

void ProblemsPanel::go(int by) {
    check();
    const int count = static_cast<int>(problems().size());
    if (count > 0) {
        const int current = m_list.currentIndex().row();
        const QModelIndex row = m_problems.index(current < 0 && by < 0 ? count - 1 : (current + by + count) % count);
        m_list.setCurrentIndex(row);
        choose(row);
    }
}

} // namespace spacetow
