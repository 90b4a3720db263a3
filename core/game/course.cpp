#include "core/game/course.h"

#include <algorithm>
#include <utility>

namespace spacetow {

Course::Course(std::shared_ptr<const Level> level, std::uint64_t seed)
    : m_seed(seed), m_level(std::move(level)), m_start(m_level, seed), m_session(m_start), m_timeline(m_start) {}

Session Course::shown() const {
    Session session = m_session;
    if (m_iteration > 0) {
        session.stepPartly(m_partial, m_iteration);
    } else if (m_edited) {
        session.adopt(m_edited);
    }
    return session;
}

void Course::setFocus(Key object) {
    m_focus = object;
    m_timeline.setFocus(object);
    m_paths = nullptr;
}

void Course::restart() {
    if (m_level != m_start.sharedLevel()) {
        m_start = Session(m_level, m_seed);
    }
    m_levelGiven = false;
    m_opened.reset();
    endFuture();
    m_session = m_start;
    m_timeline = Timeline(m_start);
    m_timeline.setFocus(m_focus);
    m_record.clear();
    countFuture();
    arrive();
}

void Course::endFuture() {
    m_future.reset();
    m_opening = false;
}

void Course::countFuture() {
    ++m_futures;
    m_begun = m_session.updates();
    m_paths = nullptr;
}

void Course::arrive() {
    m_iteration = 0;
    m_sought.reset();
    m_changedAt.reset();
    const bool behind = isAtEnd() && m_levelGiven && m_session.sharedLevel() != m_level;
    m_edited = behind ? m_level : nullptr;
}

void Course::beginOtherFuture(bool withGhost) {
    m_timeline.goOnFrom(m_session, withGhost && !m_future);
    endFuture();
    m_record.cutAt(m_session.updates());
    countFuture();
}

void Course::record(const StepInput& input) {
    if (m_record.updates() < maxReplayUpdates && m_record.updates() == m_session.updates() - 1) {
        m_record.append(input);
    }
}

void Course::step(const StepInput& input) {
    m_session.setExplains(m_explains);
    if (m_times != nullptr) {
        m_session.stepTimed(input, *m_times);
    } else {
        m_session.step(input);
    }
}

void Course::goOn(const StepInput& input) {
    if (!isAtEnd()) {
        beginOtherFuture(true);
    }
    StepInput whole = input;
    if (m_levelGiven && m_session.sharedLevel() != m_level) {
        whole.level = m_level;
    }
    step(whole);
    m_timeline.add(whole, m_session);
    m_paths = nullptr;
    record(whole);
    arrive();
}

bool Course::goAlong() {
    if (m_session.updates() >= m_timeline.last()) {
        return false;
    }
    step(m_timeline.input(m_session.updates()));
    arrive();
    return true;
}

void Course::seek(std::int64_t update) {
    const std::int64_t there = std::clamp(update, m_timeline.first(), m_timeline.last());
    if (there == m_session.updates() + 1) {
        goAlong();
    } else if (there != m_session.updates() || m_iteration > 0) {
        m_session = *m_timeline.at(there);
        arrive();
    }
    m_sought.reset();
    if (m_future && update > m_timeline.last()) {
        m_sought = std::min(update, m_future->goal());
    }
}

void Course::stepIteration(const StepInput& input) {
    if (m_iteration == 0) {
        const bool past = m_session.updates() < m_timeline.last();
        m_partial = past ? m_timeline.input(m_session.updates()) : input;
        if (m_edited) {
            m_partial.level = m_edited;
        }
    }
    Session whole = m_session;
    if (m_partial.level) {
        whole.adopt(m_partial.level);
    }
    if (m_future && m_session.updates() == m_timeline.last()) {
        simulate(1);
    }
    if (m_iteration + 1 < whole.world().parameters().iterations) {
        ++m_iteration;
    } else if (!goAlong()) {
        goOn(m_partial);
    }
}

void Course::setLevel(std::shared_ptr<const Level> level) {
    m_level = std::move(level);
    m_levelGiven = true;
    m_iteration = 0;
    m_edited = m_level == m_session.sharedLevel() ? nullptr : m_level;
    if (isAtEnd()) {
        return;
    }
    const std::int64_t now = m_session.updates();
    const InputRuns inputs = m_record.updates() > now ? m_record.after(now) : m_timeline.inputsFrom(now);
    const InputRuns again = inputs.withLevel(m_level);
    beginOtherFuture(m_changedAt != now); // it is compared with how it was before the first of several edits
    m_changedAt = now;
    m_sought.reset();
    m_future.emplace(m_session, again);
    if (m_record.updates() == now) {
        for (const InputRun& run : again.runs()) {
            m_record.append(run.input, run.count);
        }
    }
}

void Course::open(const Replay& recorded, const std::shared_ptr<const Level>& then) {
    restart();
    InputRuns inputs = inputsOf(recorded, m_start.level());
    const double seconds = static_cast<double>(inputs.updates()) * m_session.updateSeconds();
    m_timeline.setSeconds(std::max(secondsBack, seconds));
    m_record = inputs;
    if (then) {
        m_levelGiven = true;
        m_level = then;
        for (const InputRun& run : inputs.runs()) {
            m_level = run.input.level && *run.input.level == *then ? run.input.level : m_level; // taken over already
        }
        m_level = *m_start.sharedLevel() == *then ? m_start.sharedLevel() : m_level;
    }
    if (inputs.updates() > 0) {
        m_future.emplace(m_session, std::move(inputs));
        m_opening = true;
    } else {
        m_opened = m_session.hash();
    }
}

void Course::simulate(int updates) {
    if (!m_future) {
        return;
    }
    m_future->advance(m_timeline, updates);
    m_paths = nullptr;
    if (m_future->isDone()) {
        m_opened = m_opening ? std::optional(m_future->session().hash()) : m_opened;
        endFuture();
    }
    if (m_sought && *m_sought <= m_timeline.last()) {
        seek(*m_sought);
    }
}

void Course::stopSimulating() {
    endFuture();
    m_sought.reset();
    m_record.cutAt(m_timeline.last());
}

Replay Course::recording() {
    Replay replay;
    replay.seed = m_seed;
    setInputs(replay, m_record, m_start.level());
    if (!m_future && m_record.updates() == m_timeline.last()) {
        replay.ended = isAtEnd() ? m_session.flight() : m_timeline.at(m_timeline.last())->flight();
    }
    return replay;
}

std::shared_ptr<const TimelineSummary> Course::summary(bool withPaths) {
    if (withPaths && !m_paths && !m_future) {
        m_paths = std::make_shared<const std::vector<TracedPath>>(m_timeline.pathsFrom(m_timeline.first()));
    }
    TimelineSummary summary;
    summary.first = m_timeline.first();
    summary.last = m_timeline.last();
    summary.shown = m_session.updates();
    summary.goal = updates();
    summary.updateSeconds = m_session.updateSeconds();
    summary.opened = m_opened;
    summary.futures = m_futures;
    summary.begun = m_begun;
    summary.iteration = m_iteration;
    summary.iterations = m_session.world().parameters().iterations;
    summary.marks = m_timeline.marks();
    summary.ghosts = m_timeline.ghosts();
    summary.paths = withPaths ? m_paths : nullptr;
    return std::make_shared<const TimelineSummary>(std::move(summary));
}

} // namespace spacetow
