#pragma once
// What has been changed in a level while it ran. During the run these are edits of the document like all others; when
// it ends, the document goes back to the level before the run, and the changes wait in a list, each to be kept or not.
// Until somebody decides, the list follows what else is done to the document; what another run edits joins it when that
// ends.

#include "core/level/kept_changes.h"
#include "editor/editing/document.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace spacetow {

class RunChanges {
  public:
    /// The document must outlive this.
    explicit RunChanges(Document& document);
    ~RunChanges();
    RunChanges(const RunChanges&) = delete;
    RunChanges& operator=(const RunChanges&) = delete;

    /// One more window runs the level.
    void begin();
    /// One less. With the last, back to the level before the run, as one step that can be undone.
    void end();
    bool isRunning() const { return m_runs > 0; }

    /// Whether changes wait to be kept or discarded; the rest is about these.
    bool areWaiting() const { return !m_changes.empty(); }
    /// Whether undo has taken back the end of the run: what waited is in the level again, and redo, which takes it out,
    /// lists it again.
    bool isEndUndone() const {
        return !areWaiting() && !isRunning() && m_ended && indexOfEnd() >= m_document.position();
    }
    const std::vector<LevelChange>& changes() const { return m_changes; }
    const Level& before() const { return *m_before; }
    const Level& after() const { return *m_after; }
    /// The document with all of them, for the journal; null while none waits.
    std::shared_ptr<const Level> undecided() const;

    /// All are at first.
    bool isTicked(int place) const { return m_ticked[static_cast<std::size_t>(place)]; }
    int ticked() const;
    /// Ticks with it what it needs, or takes the tick from what needs it.
    void setTicked(int place, bool ticked);

    static constexpr std::size_t mostSteps = 100; // of the history at once
    /// Each is one step of the history, or all are where they are more than `mostSteps`; then none waits. While the
    /// level runs again, they belong to what it goes back to.
    void keepTicked();
    void keepAll();
    /// Undoing after it brings back all of them.
    void discard();

    Signal<> changed; // the list, or what is ticked in it

  private:
    /// By which a change is known, whatever its values become.
    using Name = std::tuple<Key, bool, bool, bool, int, ObjectChange, std::string>;
    /// The step that ended a run, by its number in the history, and the level with all that waited then.
    struct Ended {
        std::uint64_t step = 0;
        std::shared_ptr<const Level> after;
    };

    static Name nameOf(const LevelChange& change);
    int indexOfEnd() const;
    void follow();
    void list(std::shared_ptr<const Level> before, std::shared_ptr<const Level> after);
    void untickUnmet();
    void keep(const std::vector<int>& places);
    void empty();
    void forget();

    Document& m_document;
    int m_levelNumber = 0;                // of the document, for which the rest holds
    int m_runs = 0;                       // that are going on
    std::shared_ptr<const Level> m_start; // of the first of them
    std::shared_ptr<const Level> m_before, m_after;
    std::vector<LevelChange> m_changes;
    std::vector<bool> m_ticked;
    std::set<Name> m_unticked; // of these, and of those that undo has taken from the list
    std::optional<Ended> m_ended;
    mutable std::shared_ptr<const Level> m_whole, m_wholeOf; // undecided while the level runs, and of which document
    bool m_committing = false;
    int m_listener = 0;
};

/// What the step is called that keeps the change.
Label keptLabel(const LevelChange& change);

} // namespace spacetow
