#include "editor/panels/problems_panel.h"

#include "core/level/fixes.h"
#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"
#include "editor/panels/list_keys.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr int slow = 250;                  // ms after which people want to know that something is going on
constexpr int rowsAtOnce = 100;            // laid out before the window goes on with something else
constexpr int waitedFor = 2'000;           // objects of a level whose check one may wait for
constexpr int severityOrder[] = {2, 1, 0}; // errors first

} // namespace

ProblemsPanel::ProblemsPanel(LevelCheck& check, ProblemList::Sentence sentence, ProblemList::Words words,
                             QWidget* parent)
    : QWidget(parent), m_check(check), m_document(check.document()), m_problems(std::move(sentence), std::move(words)),
      m_column(this) {
    layOut();
    listen();
    tint();
    if (m_check.found().level == nullptr) {
        m_check.check();
    }
    take();
}

void ProblemsPanel::layOut() {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.setSpacing(0);
    m_column.addLayout(&m_row);
    m_row.setContentsMargins(2, 2, 2, 2);
    m_row.setSpacing(2);
    const std::array tips{tr("Show notes: what could be tidied"), tr("Show warnings"), tr("Show errors")};
    for (const int severity : severityOrder) {
        QToolButton& button = m_severities[static_cast<std::size_t>(severity)];
        button.setToolTip(tips[static_cast<std::size_t>(severity)]);
        button.setAccessibleName(tips[static_cast<std::size_t>(severity)]);
        button.setCheckable(true);
        button.setChecked(true);
        m_row.addWidget(&button);
    }
    m_row.addStretch(1);
    m_row.addWidget(&m_hidden);
    m_hidden.setCheckable(true);
    m_hidden.setToolTip(tr("Show the problems that are hidden in this level, too"));
    m_hidden.setAccessibleName(m_hidden.toolTip());
    for (QToolButton* button : {&m_severities[0], &m_severities[1], &m_severities[2], &m_hidden}) {
        button->setAutoRaise(true);
        button->setIconSize(QSize(16, 16));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    m_column.addWidget(&m_note);
    m_column.addWidget(&m_list, 1);
    m_column.addWidget(&m_fixAll);
    m_fixAll.setToolTip(tr("Cure all problems whose fix changes nothing that was meant"));
    m_note.setContentsMargins(8, 6, 8, 6);
    m_note.setWordWrap(true);
    m_note.setTextFormat(Qt::PlainText);
    m_list.setModel(&m_problems);
    m_list.setItemDelegate(&m_delegate);
    m_list.setFrameShape(QFrame::NoFrame);
    m_list.setWordWrap(true);
    m_list.setTextElideMode(Qt::ElideNone);
    m_list.setIconSize(QSize(16, 16));
    m_list.setSpacing(1);
    m_list.setLayoutMode(QListView::Batched);
    m_list.setBatchSize(rowsAtOnce);
    m_list.setResizeMode(QListView::Adjust);
    m_list.setMouseTracking(true);
    m_list.setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list.setContextMenuPolicy(Qt::CustomContextMenu);
    m_list.setAccessibleName(tr("Problems of the level"));
    m_list.installEventFilter(this);
}

void ProblemsPanel::listen() {
    for (const int severity : severityOrder) {
        connect(&m_severities[static_cast<std::size_t>(severity)], &QToolButton::toggled, this,
                [this, severity](bool on) {
                    ProblemFilter changed = filter();
                    changed.severities[static_cast<std::size_t>(severity)] = on;
                    setFilter(changed);
                });
    }
    connect(&m_hidden, &QToolButton::toggled, this, [this](bool on) {
        ProblemFilter changed = filter();
        changed.hidden = on;
        setFilter(changed);
    });
    connect(&m_list, &QListView::pressed, this, [this] { m_fixClicked = false; });
    connect(&m_list, &QListView::clicked, this, [this](const QModelIndex& row) {
        if (!std::exchange(m_fixClicked, false)) { // which is no wish to see the place
            choose(row);
        }
    });
    connect(&m_list, &QListView::activated, this, &ProblemsPanel::choose);
    connect(&m_list, &QListView::customContextMenuRequested, this, &ProblemsPanel::showMenu);
    connect(m_list.selectionModel(), &QItemSelectionModel::currentChanged, this, &ProblemsPanel::marksChanged);
    connect(&m_delegate, &ProblemDelegate::fixClicked, this, [this](const QModelIndex& row) {
        m_list.setCurrentIndex(row);
        m_fixClicked = true;
        fixCurrent();
    });
    connect(&m_fixAll, &QPushButton::clicked, this, &ProblemsPanel::fixAll);
    m_slow.setSingleShot(true);
    m_slow.setInterval(slow);
    connect(&m_slow, &QTimer::timeout, this, &ProblemsPanel::note);
    connect(&m_check, &LevelCheck::started, &m_slow, qOverload<>(&QTimer::start));
    connect(&m_check, &LevelCheck::checked, this, &ProblemsPanel::take);
}

bool ProblemsPanel::eventFilter(QObject* watched, QEvent* event) {
    return (watched == &m_list && keepsListKey(*event)) || QWidget::eventFilter(watched, event);
}

void ProblemsPanel::check() {
    m_check.check();
}

void ProblemsPanel::take() {
    m_slow.stop();
    if (m_check.found().level != m_checked) {
        showFound(m_check.found());
    }
    if (const int steps = std::exchange(m_steps, 0); steps != 0) {
        go(steps);
    }
}

void ProblemsPanel::showFound(const LevelCheck::Found& found) {
    const bool same = *found.problems == m_problems.problems() &&
                      (m_checked == nullptr || found.level->hiddenProblems == m_checked->hiddenProblems);
    const int row = m_list.currentIndex().row();
    m_checked = found.level;
    if (same) {
        m_problems.setLevel(m_checked);
    } else {
        m_problems.setProblems(m_checked, found.problems);
        m_list.setCurrentIndex(m_problems.index(std::min(row, m_problems.rowCount() - 1)));
    }
    countAll();
    note();
    Q_EMIT marksChanged();
    if (!same) {
        Q_EMIT problemsChanged();
    }
}

void ProblemsPanel::countAll() {
    for (const int severity : severityOrder) {
        m_severities[static_cast<std::size_t>(severity)].setText(
            QString::number(m_problems.count(static_cast<Severity>(severity))));
    }
    const int hidden = m_problems.hiddenCount();
    m_hidden.setText(tr("Hidden: %1").arg(hidden));
    m_hidden.setVisible(hidden > 0);
    m_safe = 0;
    for (std::size_t i = 0; i < problems().size(); ++i) {
        const Fix* const fix = m_problems.hidden()[i] ? nullptr : fixFor(problems()[i]);
        m_safe += fix != nullptr && fix->isSafe ? 1 : 0;
    }
    m_fixAll.setText(tr("Fix all that is safe: %1").arg(m_safe));
    m_fixAll.setVisible(m_safe > 1);
}

void ProblemsPanel::note() {
    const bool checking = m_check.isRunning() || m_fixing.isRunning();
    m_note.setText(checking             ? tr("Checking…")
                   : problems().empty() ? tr("Nothing to complain about.")
                                        : tr("Nothing else: the rest is filtered out or hidden."));
    m_note.setVisible(checking || m_problems.rowCount() == 0);
}

/// By itself: when the window hears of new colours, its panels may still have the old ones.
void ProblemsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        tint();
    }
    QWidget::changeEvent(event);
}

void ProblemsPanel::tint() {
    const MarkColors colors = markColors(shadeOf(palette()));
    const QColor selected = palette().color(QPalette::HighlightedText);
    const std::array icons{icon(QStringLiteral("info"), palette()),
                           icon(QStringLiteral("warning"), colors.warning, selected),
                           icon(QStringLiteral("error"), colors.error, selected)};
    m_problems.setMarks(icons, palette().color(QPalette::Disabled, QPalette::Text));
    for (std::size_t i = 0; i < icons.size(); ++i) {
        m_severities[i].setIcon(icons[i]);
    }
    m_hidden.setIcon(icon(QStringLiteral("eye-off"), palette()));
}

void ProblemsPanel::setFilter(const ProblemFilter& filter) {
    m_problems.setFilter(filter);
    for (std::size_t i = 0; i < filter.severities.size(); ++i) {
        m_severities[i].setChecked(filter.severities[i]);
    }
    m_hidden.setChecked(filter.hidden);
    note();
    Q_EMIT marksChanged();
}

const Problem* ProblemsPanel::currentProblem() const {
    const int place = current();
    return place < 0 ? nullptr : &problems()[static_cast<std::size_t>(place)];
}

void ProblemsPanel::choose(const QModelIndex& row) {
    const int place = row.isValid() ? m_problems.problemAt(row.row()) : -1;
    if (place >= 0) {
        const Problem problem = problems()[static_cast<std::size_t>(place)];
        Q_EMIT objectWanted(problem.object);
        Q_EMIT placeWanted(placeOf(*m_checked, problem));
        Q_EMIT marksChanged();
    }
}

std::vector<Problem> ProblemsPanel::shown() const {
    std::vector<Problem> result;
    for (std::size_t i = 0; i < problems().size(); ++i) {
        if (!m_problems.hidden()[i]) {
            result.push_back(problems()[i]);
        }
    }
    return result;
}

void ProblemsPanel::goTo(const Problem& problem) {
    const int rows = m_problems.rowCount();
    for (int row = 0; row < rows; ++row) {
        if (problems()[static_cast<std::size_t>(m_problems.problemAt(row))] == problem) {
            m_list.setCurrentIndex(m_problems.index(row));
            choose(m_problems.index(row));
            return;
        }
    }
    Q_EMIT objectWanted(problem.object);
}

void ProblemsPanel::go(int by) {
    if (!m_check.isUpToDate() && !m_document.hasPreview()) {
        if (m_document.current().level->objects.size() > waitedFor) {
            m_steps += by;
            m_check.hurry();
            return;
        }
        check();
    }
    const int count = m_problems.rowCount();
    if (count > 0) {
        const int row = m_list.currentIndex().row();
        const QModelIndex next = m_problems.index(row < 0 && by < 0 ? count - 1 : ((row + by) % count + count) % count);
        m_list.setCurrentIndex(next);
        choose(next);
    }
}

} // namespace spacetow
