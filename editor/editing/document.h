#pragma once
// The document: the level being edited, its history and the preview of the gesture in progress. Values are swapped,
// never changed, so undo cannot go wrong.

#include "core/level/level.h"
#include "editor/editing/codes.h"
#include "editor/editing/selection.h"
#include "editor/editing/signal.h"

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spacetow {

/// A level with what is selected in it.
struct Edit {
    std::shared_ptr<const Level> level; // never null
    Selection selection;
};

/// What an edit is called in menus and in the history: a code such as "move", how many objects it concerns, and of one
/// that changes a single field, the id of that, as "angle" (see core/level/field_survey.h).
struct Label {
    LabelCode code;
    int count = 1;
    std::string field = {};

    bool operator==(const Label&) const = default;
};

/// What is shown before and after. Compare your own slice and repaint if it differs.
struct Change {
    Edit before, after;
};

class Document {
  public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    static constexpr std::size_t maxEntries = 1000; // older ones are forgotten
    static constexpr std::chrono::steady_clock::duration mergeWindow = std::chrono::seconds(1);

    /// The clock decides which commits merge.
    explicit Document(Level level = {}, Clock clock = std::chrono::steady_clock::now);

    /// What is shown: the preview while there is one, else the current edit.
    const Edit& shown() const;
    /// Without the preview.
    const Edit& current() const { return m_current; }
    const Level& level() const { return *shown().level; }
    const Selection& selection() const { return shown().selection; }

    void preview(Edit edit);
    void dropPreview();
    bool hasPreview() const;

    /// One history entry; ends the preview. An edit that leaves the level equal in value adds none and only selects.
    /// Commits with the same merge key (not empty) within a second of each other share one entry, unless the history,
    /// the saved state or the selection changed in between; when together they change nothing, the entry goes.
    void commit(const Label& label, Edit edit, const std::string& mergeKey = {});
    /// Ends the preview. Selecting is no history entry of its own; undoing an edit brings back the selection it was
    /// made with.
    void select(const Selection& selection);

    bool canUndo() const;
    bool canRedo() const;
    /// Both end the preview; without anything to undo or redo they do no more than that.
    void undo();
    void redo();
    /// The label that undo or redo would take back or repeat; there must be one.
    const Label& undoLabel() const;
    const Label& redoLabel() const;
    /// All labels, oldest first, and how many of them are applied.
    std::vector<Label> history() const;
    int position() const;
    /// The same without copying all: entry 0 is the oldest that is kept.
    int historySize() const { return static_cast<int>(m_entries.size()); }
    const Label& label(int entry) const;
    /// No other entry has this number, and younger ones have greater numbers.
    std::uint64_t entryNumber(int entry) const;
    /// How many entries have been dropped at the old end since the level came.
    int forgotten() const { return m_forgotten; }
    /// From 0 (nothing applied) to the length of the history.
    void goTo(int position);

    /// Whether the level differs in value from the one last saved or opened.
    bool isModified() const;
    void markSaved();
    /// After how many entries the level was what was saved last; nothing before anything was saved, or when that state
    /// is not in the history any more.
    std::optional<int> savedPosition() const;
    /// What was saved or opened is no longer what the file holds: the document counts as modified, until it is saved.
    void setSavedGone(bool gone);
    /// Starts over with another level and an empty history.
    void reset(Level level);
    /// Another one after each reset: a history that is empty may just have had its only entry merged away.
    int levelNumber() const { return m_levelNumber; }

    Signal<const Change&> changed; // level or selection shown
    Signal<> historyChanged;       // labels, position or isModified

  private:
    struct Entry {
        Label label;
        Edit before, after;
        std::string mergeKey;
        std::chrono::steady_clock::time_point time;
        std::uint64_t number = 0;
    };
    void becomeCurrent(Edit edit, Edit before);
    bool mergesWithLast(const std::string& mergeKey) const;
    void record(const Label& label, const Edit& edit, const std::string& mergeKey);

    Clock m_clock;
    Edit m_current;
    std::optional<Edit> m_preview;
    std::deque<Entry> m_entries;
    std::size_t m_position = 0;
    std::uint64_t m_lastNumber = 0; // given to an entry
    int m_forgotten = 0;
    int m_levelNumber = 0;
    std::shared_ptr<const Level> m_saved;
    bool m_wasSaved = false; // since the level came
    bool m_savedGone = false;
    bool m_mergeable = false; // nothing happened since the last commit that the user would see as a break
};

} // namespace spacetow
