#include "core/game/timeline.h"

#include <algorithm>
#include <cmath>

namespace spacetow {
namespace {

constexpr std::size_t mostGhosts = 3;
constexpr std::int64_t touchPause = 10; // updates, between two marks of touches

/// Ship or payload has begun to touch something solid.
bool touchesBegan(const Session& session) {
    const std::vector<TouchEvent>& began = session.world().events().began;
    return std::ranges::any_of(began, [&](const TouchEvent& touch) {
        return touch.solid && (touch.a == session.shipBody() || touch.b == session.shipBody() ||
                               touch.a == session.payloadBody() || touch.b == session.payloadBody());
    });
}

std::optional<MarkKind> markOf(Phase before, Phase after) {
    const bool wasOver = before == Phase::Crashed || before == Phase::GameOver;
    switch (after) {
    case Phase::Towing:
        return MarkKind::Tow;
    case Phase::Flying:
        return before == Phase::Towing ? std::optional(MarkKind::LetGo) : std::nullopt;
    case Phase::Crashed:
    case Phase::GameOver:
        return MarkKind::Crash;
    case Phase::Won:
        return MarkKind::Win;
    case Phase::AwaitingInput:
        return wasOver ? std::optional(MarkKind::Attempt) : std::nullopt;
    case Phase::Sandbox:
        break;
    }
    return {};
}

} // namespace

Timeline::Timeline(const Session& start, const Limits& limits)
    : m_limits(limits), m_last(start.updates()), m_updateSeconds(start.updateSeconds()), m_phase(start.phase()) {
    save(start);
    m_tracks.add(start);
}

Timeline::Saved Timeline::saved(const Session& session) {
    return {session.updates(), session.copyBytes(), std::make_shared<const Session>(session)};
}

std::int64_t Timeline::interval() const {
    const double updates = m_limits.seconds / m_updateSeconds;
    const double all = updates * static_cast<double>(m_saved.back().bytes);
    const auto affordable = static_cast<std::int64_t>(all / static_cast<double>(m_limits.bytes)) + 1;
    return std::max(m_limits.leastInterval, affordable);
}

void Timeline::add(const StepInput& input, const Session& after) {
    EXPECTS(after.updates() == m_last + 1);
    if (m_inputs.empty() || !(m_inputs.back().input == input)) {
        m_inputs.push_back({m_last, input});
    }
    m_last = after.updates();
    m_updateSeconds = after.updateSeconds();
    mark(input, after);
    m_phase = after.phase();
    m_tracks.add(after);
    m_looked = m_last;
    if (m_last - m_saved.back().update >= interval()) {
        save(after);
        forgetOld();
    } else if (stride() > 1 && m_last % stride() == 0) {
        keepNear(after); // the first step back from here is to be as quick as the next ones
    }
}

void Timeline::save(const Session& session) {
    m_saved.push_back(saved(session));
}

/// One saved session stays from before the time that can be gone back.
void Timeline::forgetOld() {
    const std::int64_t window = std::llround(m_limits.seconds / m_updateSeconds);
    const std::int64_t before = first();
    while (m_saved.size() > 1 && m_saved[1].update <= m_last - window) {
        m_saved.pop_front();
    }
    if (first() == before) {
        return;
    }
    while (m_inputs.size() > 1 && m_inputs[1].from <= first()) {
        m_inputs.pop_front();
    }
    std::erase_if(m_near, [this](const Saved& one) { return one.update < first(); });
    m_tracks.forgetBefore(first());
    m_marks.dropBefore(first());
    std::erase_if(m_ghosts, [this](const auto& ghost) { return ghost->from < first(); });
}

void Timeline::setFocus(Key object) {
    if (object == m_focus) {
        return;
    }
    m_focus = object;
    m_lastFocus = m_last - touchPause - 1;
    m_tracks.setFocus(object);
    m_marks.eraseIf(
        [](const TimelineMark& mark) { return mark.kind == MarkKind::FocusTouch || mark.kind == MarkKind::FocusPart; });
}

/// Of ship and payload there are marks in any case.
std::optional<MarkKind> Timeline::focusMark(const Session& after) const {
    const std::optional<BodyId> body = m_focus != 0 ? after.bodyOf(m_focus) : std::nullopt;
    if (!body || m_lastFocus + touchPause >= m_last || body == after.shipBody() || body == after.payloadBody()) {
        return {};
    }
    const auto isOfIt = [&](const TouchEvent& touch) { return touch.solid && (touch.a == *body || touch.b == *body); };
    const Events& events = after.world().events();
    return std::ranges::any_of(events.began, isOfIt)   ? std::optional(MarkKind::FocusTouch)
           : std::ranges::any_of(events.ended, isOfIt) ? std::optional(MarkKind::FocusPart)
                                                       : std::nullopt;
}

void Timeline::mark(const StepInput& input, const Session& after) {
    const std::optional<MarkKind> happened = after.phase() != m_phase ? markOf(m_phase, after.phase()) : std::nullopt;
    if (input.level) {
        m_marks.append({m_last, MarkKind::Edit});
    }
    if (happened) {
        m_marks.append({m_last, *happened});
    } else if (m_lastTouch + touchPause < m_last && touchesBegan(after)) {
        m_marks.append({m_last, MarkKind::Touch});
        m_lastTouch = m_last;
    }
    if (const std::optional<MarkKind> touch = focusMark(after)) {
        m_marks.append({m_last, *touch});
        m_lastFocus = m_last;
    }
}

std::size_t Timeline::runAt(std::int64_t update) const {
    const auto next = std::ranges::upper_bound(m_inputs, update, {}, &Run::from);
    EXPECTS(next != m_inputs.begin());
    return static_cast<std::size_t>(next - m_inputs.begin()) - 1;
}

const StepInput& Timeline::input(std::int64_t update) const {
    EXPECTS(update >= first() && update < m_last);
    return m_inputs[runAt(update)].input;
}

InputRuns Timeline::inputsFrom(std::int64_t update) const {
    InputRuns inputs;
    if (update >= m_last) {
        return inputs;
    }
    for (std::size_t i = runAt(update); i < m_inputs.size(); ++i) {
        const std::int64_t end = i + 1 < m_inputs.size() ? m_inputs[i + 1].from : m_last;
        inputs.append(m_inputs[i].input, end - std::max(update, m_inputs[i].from));
    }
    return inputs;
}

const Timeline::Saved& Timeline::nearest(std::int64_t update) const {
    const auto byUpdate = [](const auto& list, std::int64_t at) {
        return std::ranges::upper_bound(list, at, {}, &Saved::update);
    };
    const auto saved = byUpdate(m_saved, update);
    EXPECTS(saved != m_saved.begin());
    const auto near = byUpdate(m_near, update);
    const Saved& far = *(saved - 1);
    return near == m_near.begin() || (near - 1)->update < far.update ? far : *(near - 1);
}

std::shared_ptr<const Session> Timeline::at(std::int64_t update) {
    EXPECTS(update >= first() && update <= m_last);
    const Saved& from = nearest(update);
    if (from.update == update) {
        return from.session;
    }
    m_looked = update;
    Session session = *from.session;
    simulate(session, update);
    return nearest(update).session;
}

/// Of sessions that are kept near the moment that is looked at.
std::int64_t Timeline::stride() const {
    return std::max<std::int64_t>(1, interval() / 5);
}

void Timeline::simulate(Session& session, std::int64_t until) {
    const std::int64_t every = stride();
    while (session.updates() < until) {
        session.step(input(session.updates()));
        if (session.updates() % every == 0 || session.updates() == until) {
            keepNear(session);
        }
    }
}

bool Timeline::prepareBackFrom(std::int64_t update, int updates) {
    const auto next = std::ranges::upper_bound(m_saved, update, {}, &Saved::update);
    const auto from = next - m_saved.begin() - 1;
    if (from < 1) {
        return true;
    }
    const std::int64_t end = m_saved[static_cast<std::size_t>(from)].update - 1;
    if (nearest(end).update == end) {
        return true;
    }
    m_looked = update;
    Session session = *nearest(end).session;
    const std::int64_t every = stride();
    const std::int64_t strides = std::max<std::int64_t>(1, updates / every);
    simulate(session, std::min(end, (session.updates() / every + strides) * every));
    return session.updates() == end;
}

void Timeline::keepNear(const Session& session) {
    const auto place = std::ranges::lower_bound(m_near, session.updates(), {}, &Saved::update);
    if (place != m_near.end() && place->update == session.updates()) {
        return;
    }
    m_near.insert(place, saved(session));
    if (m_near.size() > mostNear) { // those after the moment are of no use for going back from there
        m_near.erase(m_near.back().update > m_looked ? m_near.end() - 1 : m_near.begin());
    }
}

void Timeline::goOnFrom(const Session& session, bool withGhost) {
    const std::int64_t now = session.updates();
    EXPECTS(now >= first() && now <= m_last);
    if (withGhost && now < m_last) {
        std::vector<TracedPath> paths = pathsFrom(now);
        if (!paths.empty()) {
            m_ghosts.push_back(std::make_shared<const Ghost>(Ghost{now, std::move(paths)}));
            m_ghosts.erase(m_ghosts.begin(),
                           m_ghosts.end() - static_cast<std::ptrdiff_t>(std::min(mostGhosts, m_ghosts.size())));
        }
    }
    const auto later = [now](const Saved& one) { return one.update > now; };
    std::erase_if(m_saved, later);
    std::erase_if(m_near, later);
    while (!m_inputs.empty() && m_inputs.back().from >= now) {
        m_inputs.pop_back();
    }
    m_tracks.forgetAfter(now);
    m_marks.dropAfter(now);
    m_last = now;
    m_lastTouch = m_lastFocus = now - touchPause - 1;
    m_phase = session.phase();
    m_updateSeconds = session.updateSeconds();
}

std::size_t Timeline::bytes() const {
    std::size_t sum = m_inputs.size() * sizeof(Run) + m_tracks.bytes();
    for (const Saved& one : m_saved) {
        sum += one.bytes;
    }
    for (const Saved& one : m_near) {
        sum += one.bytes;
    }
    return sum + m_marks.size() * sizeof(TimelineMark);
}

void Future::advance(Timeline& timeline, int updates) {
    for (int i = 0; i < updates && !isDone(); ++i) {
        const StepInput& input = m_inputs.next();
        m_session.step(input);
        timeline.add(input, m_session);
    }
}

} // namespace spacetow
