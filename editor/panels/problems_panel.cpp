#include "editor/panels/problems_panel.h"

#include "core/level/lint.h"
#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"
#include "editor/panels/names.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr int soon = 120; // ms after an edit

QIcon markFor(Severity severity, const QPalette& palette) {
    const MarkColors colors = markColors(shadeOf(palette));
    return severity == Severity::Error ? icon(QStringLiteral("error"), colors.error)
                                       : icon(QStringLiteral("warning"), colors.warning);
}

} // namespace

ProblemsPanel::ProblemsPanel(Document& document, Sentence sentence, QWidget* parent)
    : QWidget(parent), m_document(document), m_sentence(std::move(sentence)), m_column(this) {
    m_column.setContentsMargins(0, 0, 0, 0);
    m_column.addWidget(&m_list);
    m_list.setFrameShape(QFrame::NoFrame);
    m_list.setWordWrap(true);
    m_list.setTextElideMode(Qt::ElideNone);
    m_list.setIconSize(QSize(16, 16));
    m_list.setSpacing(1);
    m_list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list.setAccessibleName(tr("Problems of the level"));
    connect(&m_list, &QListWidget::itemClicked, this, [this] { choose(m_list.currentRow()); });
    connect(&m_list, &QListWidget::itemActivated, this, [this] { choose(m_list.currentRow()); });
    m_soon.setSingleShot(true);
    m_soon.setInterval(soon);
    connect(&m_soon, &QTimer::timeout, this, &ProblemsPanel::check);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (change.before.level != change.after.level) {
            m_soon.start();
        }
    });
    check();
}

ProblemsPanel::~ProblemsPanel() {
    m_document.changed.disconnect(m_listener);
}

void ProblemsPanel::check() {
    m_soon.stop();
    if (m_document.hasPreview()) {
        m_soon.start(); // when the gesture is over
        return;
    }
    if (m_document.current().level == m_checked) {
        return;
    }
    m_checked = m_document.current().level;
    std::vector<Problem> problems = lint(*m_checked);
    if (problems != m_problems || m_list.count() == 0) {
        m_problems = std::move(problems);
        fill();
        Q_EMIT problemsChanged();
    }
}

void ProblemsPanel::fill() {
    m_list.clear();
    for (const Problem& problem : m_problems) {
        const Object* object = problem.object != 0 ? m_checked->objects.find(problem.object) : nullptr;
        // There is but one ship, payload and finish; of the others one must say which.
        const bool oneOfMany = object != nullptr && (std::holds_alternative<BodyObject>(object->data) ||
                                                     std::holds_alternative<ConnectorObject>(object->data));
        const QString text = m_sentence(problem);
        m_list.addItem(oneOfMany ? tr("%1: %2").arg(listedName(*m_checked, *object), text) : text);
        QListWidgetItem* const item = m_list.item(m_list.count() - 1);
        item->setIcon(markFor(problem.severity, palette()));
    }
    if (m_problems.empty()) {
        m_list.addItem(tr("Nothing to complain about."));
        m_list.item(0)->setFlags(Qt::ItemIsEnabled);
    }
}

void ProblemsPanel::tint() {
    fill();
}

int ProblemsPanel::errors() const {
    return static_cast<int>(std::ranges::count(m_problems, Severity::Error, &Problem::severity));
}

int ProblemsPanel::warnings() const {
    return static_cast<int>(std::ranges::count(m_problems, Severity::Warning, &Problem::severity));
}

void ProblemsPanel::choose(int row) {
    if (row >= 0 && row < static_cast<int>(m_problems.size())) {
        Q_EMIT objectWanted(m_problems[static_cast<std::size_t>(row)].object);
    }
}

void ProblemsPanel::go(int by) {
    check();
    const int count = static_cast<int>(m_problems.size());
    if (count > 0) {
        const int row = m_list.currentRow() < 0 && by < 0 ? count - 1 : (m_list.currentRow() + by + count) % count;
        m_list.setCurrentRow(row);
        choose(row);
    }
}

} // namespace spacetow
