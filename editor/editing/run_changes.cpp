#include "editor/editing/run_changes.h"

#include "core/level/merge.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace spacetow {

namespace {

/// What each needs comes before it.
std::vector<int> neededFirst(const std::vector<LevelChange>& changes, const std::vector<int>& places) {
    std::vector<int> order;
    std::vector<bool> seen(changes.size(), false);
    const std::function<void(int)> visit = [&](int place) {
        if (seen[static_cast<std::size_t>(place)]) {
            return;
        }
        seen[static_cast<std::size_t>(place)] = true;
        std::ranges::for_each(changes[static_cast<std::size_t>(place)].needs, visit);
        order.push_back(place);
    };
    std::ranges::for_each(places, visit);
    return order;
}

} // namespace

Label keptLabel(const LevelChange& change) {
    if (change.object == 0) {
        return {"keep-level", 1};
    }
    switch (change.what.objects.front().change) {
    case ObjectChange::Added:
        return {"keep-added", 1};
    case ObjectChange::Removed:
        return {"keep-removed", 1};
    case ObjectChange::Moved:
        return {"keep-moved", 1};
    case ObjectChange::Retagged:
        return {"keep-tags", 1};
    case ObjectChange::Reordered:
        return {"keep-order", 1};
    case ObjectChange::Changed:
        break;
    }
    return {"keep-change", 1};
}

RunChanges::Name RunChanges::nameOf(const LevelChange& change) {
    const LevelDifference& what = change.what;
    const bool isOfLevel = change.object == 0;
    const std::vector<FieldDifference>& fields = isOfLevel ? what.fields : what.objects.front().fields;
    return {change.object,
            change.guides,
            what.unknownFields,
            what.hiddenProblems,
            what.tags.empty() ? -1 : what.tags.front().index,
            isOfLevel ? ObjectChange::Changed : what.objects.front().change,
            fields.empty() ? std::string() : std::string(fields.front().field.name)};
}

RunChanges::RunChanges(Document& document) : m_document(document) {
    m_listener = m_document.changed.connect([this](const Change&) { follow(); });
}

RunChanges::~RunChanges() {
    m_document.changed.disconnect(m_listener);
}

void RunChanges::begin() {
    if (m_runs++ == 0) {
        m_start = m_document.current().level;
        m_levelNumber = m_document.levelNumber();
    }
}

void RunChanges::end() {
    if (m_runs == 0 || --m_runs > 0) {
        return;
    }
    const std::shared_ptr<const Level> before = std::exchange(m_start, nullptr);
    std::shared_ptr<const Level> after = m_document.current().level;
    if (before == after && !areWaiting()) {
        return;
    }
    if (areWaiting()) { // from a run before this one
        after = std::make_shared<const Level>(merged(*m_before, *after, *m_after).level);
    }
    const int recorded = m_document.position();
    const std::uint64_t last = recorded > 0 ? m_document.entryNumber(recorded - 1) : 0;
    m_committing = true;
    m_document.commit({"end-run", 1}, {before, m_document.selection()});
    m_committing = false;
    if (const int now = m_document.position(); now > 0 && m_document.entryNumber(now - 1) != last) {
        m_ended = Ended{m_document.entryNumber(now - 1), after};
    }
    list(m_document.current().level, std::move(after));
}

void RunChanges::list(std::shared_ptr<const Level> before, std::shared_ptr<const Level> after) {
    for (std::size_t i = 0; i < m_changes.size(); ++i) {
        if (m_ticked[i]) {
            m_unticked.erase(nameOf(m_changes[i]));
        } else {
            m_unticked.insert(nameOf(m_changes[i]));
        }
    }
    std::vector<LevelChange> changes = changesBetween(*before, *after);
    if (changes.empty()) {
        empty();
        return;
    }
    m_levelNumber = m_document.levelNumber();
    m_before = std::move(before);
    m_after = std::move(after);
    m_changes = std::move(changes);
    m_ticked.assign(m_changes.size(), true);
    for (std::size_t i = 0; i < m_changes.size(); ++i) {
        m_ticked[i] = !m_unticked.contains(nameOf(m_changes[i]));
    }
    untickUnmet();
    changed.emit();
}

/// What needs something that has no tick has none either.
void RunChanges::untickUnmet() {
    for (bool more = true; more;) {
        more = false;
        for (std::size_t i = 0; i < m_changes.size(); ++i) {
            const bool met = std::ranges::all_of(m_changes[i].needs, [this](int place) { return isTicked(place); });
            more = more || (m_ticked[i] && !met);
            m_ticked[i] = m_ticked[i] && met;
        }
    }
}

void RunChanges::empty() {
    m_changes.clear();
    m_ticked.clear();
    m_before = nullptr;
    m_after = nullptr;
    m_whole = m_wholeOf = nullptr;
    changed.emit();
}

/// Nor does undo bring anything back into the list.
void RunChanges::forget() {
    const bool were = areWaiting() || m_ended;
    m_unticked.clear();
    m_ended.reset();
    if (were) {
        empty();
    }
}

/// In the history; -1 when it is there no more.
int RunChanges::indexOfEnd() const {
    for (int i = m_document.historySize() - 1; i >= 0; --i) {
        if (m_document.entryNumber(i) == m_ended->step) {
            return i;
        }
    }
    return -1;
}

/// What is done by hand meanwhile is no longer in the list. Redo that ends the run once more lists what it did.
void RunChanges::follow() {
    const std::shared_ptr<const Level> level = m_document.current().level;
    if (m_committing || !(m_start || m_before || m_ended)) {
        return;
    }
    if (m_document.levelNumber() != m_levelNumber) { // another level has come
        m_start = nullptr;
        m_runs = 0;
        forget();
    } else if (!isRunning() && level != m_before) {
        if (m_ended && m_document.position() == indexOfEnd() + 1 && m_document.position() > 0) {
            list(level, m_ended->after);
        } else if (m_before) {
            list(level, std::make_shared<const Level>(merged(*m_before, *level, *m_after).level));
        } else if (m_ended && indexOfEnd() < 0) { // there is another future
            forget();
        }
    }
}

/// What a run has edited meanwhile is in the document alone.
std::shared_ptr<const Level> RunChanges::undecided() const {
    if (!areWaiting() || !isRunning()) {
        return m_after;
    }
    if (const std::shared_ptr<const Level>& now = m_document.current().level; now != m_wholeOf) {
        m_whole = std::make_shared<const Level>(merged(*m_before, *now, *m_after).level);
        m_wholeOf = now;
    }
    return m_whole;
}

int RunChanges::ticked() const {
    return static_cast<int>(std::ranges::count(m_ticked, true));
}

void RunChanges::setTicked(int place, bool ticked) {
    if (ticked) {
        for (const int needed : keptTogether(m_changes, std::vector{place})) {
            m_ticked[static_cast<std::size_t>(needed)] = true;
        }
    } else {
        m_ticked[static_cast<std::size_t>(place)] = false;
        untickUnmet();
    }
    changed.emit();
}

void RunChanges::keepTicked() {
    std::vector<int> places;
    for (int i = 0; i < static_cast<int>(m_changes.size()); ++i) {
        if (isTicked(i)) {
            places.push_back(i);
        }
    }
    keep(places);
}

void RunChanges::keepAll() {
    std::vector<int> places(m_changes.size());
    std::iota(places.begin(), places.end(), 0);
    keep(places);
}

void RunChanges::keep(const std::vector<int>& places) {
    if (!areWaiting()) {
        return;
    }
    m_committing = true;
    const std::shared_ptr<const Level> now = m_document.current().level; // with the edits of a run that goes on
    const auto step = [&](const Label& label, Level kept) {
        auto level = std::make_shared<const Level>(std::move(kept));
        if (isRunning()) {
            m_start = level;
            level = std::make_shared<const Level>(merged(*m_before, *now, *level).level);
        }
        m_document.commit(label, {std::move(level), m_document.selection()});
    };
    if (places.size() > mostSteps) { // nobody undoes so many, and they would push everything older out of the history
        step({"keep-change", static_cast<int>(places.size())}, withKept(*m_before, *m_after, m_changes, places));
    } else {
        ChangesKept kept(*m_before, *m_after, m_changes);
        for (const int place : neededFirst(m_changes, places)) {
            step(keptLabel(m_changes[static_cast<std::size_t>(place)]), kept.with(place));
        }
    }
    m_committing = false;
    forget();
}

void RunChanges::discard() {
    forget();
}

} // namespace spacetow
