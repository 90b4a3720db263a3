#include "editor/editing/document.h"

#include "core/base/contract.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

bool sameLevel(const Edit& a, const Edit& b) {
    return a.level == b.level || *a.level == *b.level;
}

} // namespace

Document::Document(Level level, Clock clock)
    : m_clock(std::move(clock)), m_current{std::make_shared<const Level>(std::move(level)), {}},
      m_saved(m_current.level) {}

const Edit& Document::shown() const {
    return m_preview ? *m_preview : m_current;
}

bool Document::hasPreview() const {
    return m_preview.has_value();
}

void Document::preview(Edit edit) {
    EXPECTS(edit.level);
    const Edit before = shown();
    m_preview = std::move(edit);
    if (before.level != m_preview->level || before.selection != m_preview->selection) {
        changed.emit({before, *m_preview});
    }
}

void Document::dropPreview() {
    if (m_preview) {
        becomeCurrent(m_current, shown());
    }
}

/// Ends the preview. `before` is taken by value because it may be the preview itself.
void Document::becomeCurrent(Edit edit, Edit before) {
    m_preview.reset();
    m_current = std::move(edit);
    if (before.level != m_current.level || before.selection != m_current.selection) {
        changed.emit({std::move(before), m_current});
    }
}

bool Document::mergesWithLast(const std::string& mergeKey) const {
    return m_mergeable && !mergeKey.empty() && m_position > 0 && m_position == m_entries.size() &&
           m_entries.back().mergeKey == mergeKey && m_clock() - m_entries.back().time <= mergeWindow;
}

void Document::record(const Label& label, const Edit& edit, const std::string& mergeKey) {
    if (mergesWithLast(mergeKey)) {
        Entry& last = m_entries.back();
        if (sameLevel(last.before, edit)) {
            m_entries.pop_back();
        } else {
            last.label = label;
            last.after = edit;
            last.time = m_clock();
        }
    } else {
        m_entries.erase(m_entries.begin() + position(), m_entries.end());
        m_entries.push_back({label, m_current, edit, mergeKey, m_clock(), ++m_lastNumber});
        if (m_entries.size() > maxEntries) {
            m_entries.pop_front();
            ++m_forgotten;
        }
    }
    m_position = m_entries.size();
    m_mergeable = true;
}

void Document::commit(const Label& label, Edit edit, const std::string& mergeKey) {
    EXPECTS(edit.level);
    edit.selection = edit.selection.within(*edit.level);
    if (sameLevel(m_current, edit)) {
        select(edit.selection);
        return;
    }
    record(label, edit, mergeKey);
    becomeCurrent(std::move(edit), shown());
    historyChanged.emit();
}

void Document::select(const Selection& selection) {
    Edit edit{m_current.level, selection.within(*m_current.level)};
    m_mergeable = m_mergeable && edit.selection == m_current.selection;
    becomeCurrent(std::move(edit), shown());
}

bool Document::canUndo() const {
    return m_position > 0;
}

bool Document::canRedo() const {
    return m_position < m_entries.size();
}

void Document::undo() {
    goTo(position() - (canUndo() ? 1 : 0));
}

void Document::redo() {
    goTo(position() + (canRedo() ? 1 : 0));
}

const Label& Document::undoLabel() const {
    EXPECTS(canUndo());
    return m_entries[m_position - 1].label;
}

const Label& Document::redoLabel() const {
    EXPECTS(canRedo());
    return m_entries[m_position].label;
}

std::vector<Label> Document::history() const {
    std::vector<Label> labels;
    for (const Entry& entry : m_entries) {
        labels.push_back(entry.label);
    }
    return labels;
}

const Label& Document::label(int entry) const {
    EXPECTS(entry >= 0 && entry < historySize());
    return m_entries[static_cast<std::size_t>(entry)].label;
}

std::uint64_t Document::entryNumber(int entry) const {
    EXPECTS(entry >= 0 && entry < historySize());
    return m_entries[static_cast<std::size_t>(entry)].number;
}

int Document::position() const {
    return static_cast<int>(m_position);
}

void Document::goTo(int position) {
    EXPECTS(position >= 0 && position <= static_cast<int>(m_entries.size()));
    const auto target = static_cast<std::size_t>(position);
    if (target == m_position) {
        dropPreview();
        return;
    }
    const Edit edit = target < m_position ? m_entries[target].before : m_entries[target - 1].after;
    m_position = target;
    m_mergeable = false;
    becomeCurrent(edit, shown());
    historyChanged.emit();
}

bool Document::isModified() const {
    return m_savedGone || (m_saved != m_current.level && !(*m_saved == *m_current.level));
}

void Document::markSaved() {
    m_saved = m_current.level;
    m_wasSaved = true;
    m_savedGone = false;
    m_mergeable = false;
    historyChanged.emit();
}

std::optional<int> Document::savedPosition() const {
    if (!m_wasSaved) {
        return {};
    }
    if (m_entries.empty() || m_entries.front().before.level == m_saved) {
        return m_entries.empty() && m_saved != m_current.level ? std::nullopt : std::optional(0);
    }
    const auto found = std::ranges::find(m_entries, m_saved, [](const Entry& entry) { return entry.after.level; });
    return found == m_entries.end() ? std::nullopt : std::optional(static_cast<int>(found - m_entries.begin()) + 1);
}

void Document::setSavedGone(bool gone) {
    if (m_savedGone != gone) {
        m_savedGone = gone;
        historyChanged.emit();
    }
}

void Document::reset(Level level) {
    ++m_levelNumber;
    m_savedGone = false;
    m_entries.clear();
    m_position = 0;
    m_forgotten = 0;
    m_mergeable = false;
    Edit edit{std::make_shared<const Level>(std::move(level)), {}};
    m_saved = edit.level;
    m_wasSaved = false;
    becomeCurrent(std::move(edit), shown());
    historyChanged.emit();
}

} // namespace spacetow
