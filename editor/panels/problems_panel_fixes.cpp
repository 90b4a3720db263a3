// What the problems panel does to the level: each one entry of the history.
#include "core/level/fixes.h"
#include "core/level/lint.h"
#include "editor/panels/names.h"
#include "editor/panels/problems_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>

namespace spacetow {

bool ProblemsPanel::canFixCurrent() const {
    const Problem* const problem = currentProblem();
    return problem != nullptr && fixFor(*problem) != nullptr;
}

void ProblemsPanel::fixCurrent() {
    const Problem* const problem = currentProblem();
    const Fix* const fix = problem == nullptr ? nullptr : fixFor(*problem);
    if (fix == nullptr || m_document.hasPreview()) {
        return;
    }
    // What was found in another level may be somewhere else in this one.
    const Edit& now = m_document.current();
    if (now.level != m_checked) {
        m_check.hurry();
        return;
    }
    auto level = std::make_shared<Level>(fixed(*now.level, *problem));
    if (*level == *now.level) {
        Q_EMIT said(tr("Nothing was found that would cure this by itself."));
        return;
    }
    Selection selection = now.selection.within(*level);
    const Key object = problem->object; // which the commit may have checked anew
    m_document.commit({fix->label, 1}, {std::move(level), std::move(selection)});
    Q_EMIT cured(object);
}

void ProblemsPanel::fixAll() {
    const std::shared_ptr<const Level> level = m_document.current().level;
    if (m_document.hasPreview() || m_fixing.isRunning()) {
        return;
    }
    m_slow.start();
    m_fixing.start([this, level](const std::stop_token& stop) -> BackgroundTask::Then {
        const auto result = std::make_shared<FixedLevel>(withSafeFixes(*level, stop));
        return [this, level, result] {
            m_slow.stop();
            note();
            // Whoever has gone on editing meanwhile does not lose that.
            if (m_document.current().level != level || m_document.hasPreview() || result->cured.empty()) {
                return;
            }
            auto cured = std::make_shared<Level>(std::move(result->level));
            Selection selection = m_document.current().selection.within(*cured);
            m_document.commit({"fix-all", static_cast<int>(result->cured.size())},
                              {std::move(cured), std::move(selection)});
        };
    });
}

void ProblemsPanel::hideCurrent() {
    const Problem* const problem = currentProblem();
    if (problem == nullptr || m_document.hasPreview()) {
        return;
    }
    const bool hides = !m_problems.hidden()[static_cast<std::size_t>(current())];
    const Edit& now = m_document.current();
    m_document.commit({hides ? LabelCode("hide-problem") : "show-problem", 1},
                      {std::make_shared<Level>(withProblemHidden(*now.level, *problem, hides)), now.selection});
}

void ProblemsPanel::fillMenu(QMenu& menu) {
    const Problem* const problem = currentProblem();
    if (problem == nullptr) {
        return;
    }
    if (const QString fix = m_problems.fixText(*problem); !fix.isEmpty()) {
        menu.addAction(tr("Fix: %1").arg(menuSafe(fix)), this, &ProblemsPanel::fixCurrent);
    }
    if (m_safe > 0) {
        menu.addAction(tr("Fix all that is safe: %1").arg(m_safe), this, &ProblemsPanel::fixAll);
    }
    menu.addSeparator();
    const bool isHidden = m_problems.hidden()[static_cast<std::size_t>(current())];
    menu.addAction(isHidden ? tr("Show it again") : tr("Hide it in this level"), this, &ProblemsPanel::hideCurrent);
    menu.addAction(tr("Copy text"), this,
                   [this] { QApplication::clipboard()->setText(m_list.currentIndex().data().toString()); });
}

void ProblemsPanel::showMenu(const QPoint& position) {
    const QModelIndex row = m_list.indexAt(position);
    if (row.isValid()) {
        m_list.setCurrentIndex(row);
        QMenu menu(this);
        fillMenu(menu);
        menu.exec(m_list.viewport()->mapToGlobal(position));
    }
}

} // namespace spacetow
