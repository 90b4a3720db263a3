#include "editor/panels/level_check.h"

#include "core/level/lint.h"

#include <utility>

namespace spacetow {

namespace {

constexpr int shortly = 120; // ms after an edit

} // namespace

LevelCheck::LevelCheck(Document& document) : m_document(document) {
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &LevelCheck::checkBeside);
    m_listener = m_document.changed.connect([this](const Change& change) {
        if (change.before.level != change.after.level) {
            m_task.requestStop(); // what it finds is out of date
            m_soon.start(shortly);
        }
    });
}

LevelCheck::~LevelCheck() {
    m_document.changed.disconnect(m_listener);
}

void LevelCheck::check() {
    m_soon.stop();
    m_task.finish();
    checkBeside();
    m_task.finish();
}

void LevelCheck::hurry() {
    m_soon.start(0);
}

void LevelCheck::checkBeside() {
    if (m_document.hasPreview() || m_task.isRunning()) {
        m_soon.start(shortly); // when the gesture, or the check of an older level, is over
        return;
    }
    if (isUpToDate()) {
        Q_EMIT checked(); // for those who wait for it
        return;
    }
    ++m_checks;
    m_task.start([this, level = m_document.current().level](const std::stop_token& stop) -> BackgroundTask::Then {
        std::vector<Problem> problems = lint(*level, stop);
        if (stop.stop_requested()) {
            return [] {}; // another check follows
        }
        Found found{level, {}, std::make_shared<const Marks>(marksOf(*level, problems, hiddenAmong(*level, problems)))};
        found.problems = std::make_shared<const std::vector<Problem>>(std::move(problems));
        return [this, found] { take(found); };
    });
    Q_EMIT started();
}

void LevelCheck::take(Found found) {
    m_found = std::move(found);
    Q_EMIT checked();
}

} // namespace spacetow
