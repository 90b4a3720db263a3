#pragma once
// What lint finds in a document, looked for anew shortly after each edit, by a thread beside the window. However many
// views a document has, each level of it is checked once.

#include "core/level/problem_place.h"
#include "editor/canvas/background_task.h"
#include "editor/editing/document.h"

#include <QTimer>

#include <memory>
#include <vector>

namespace spacetow {

class LevelCheck : public QObject {
    Q_OBJECT

  public:
    using Marks = std::vector<ProblemMark>;
    struct Found {
        std::shared_ptr<const Level> level;                                   // null before the first check
        std::shared_ptr<const std::vector<Problem>> problems;                 // hidden ones among them
        std::shared_ptr<const Marks> marks = std::make_shared<const Marks>(); // of those that are not hidden
    };

    /// The document must outlive it.
    explicit LevelCheck(Document& document);
    ~LevelCheck() override;

    Document& document() { return m_document; }
    /// Of the last check that came to its end; see isUpToDate.
    const Found& found() const { return m_found; }
    bool isUpToDate() const { return m_document.current().level == m_found.level; }
    bool isRunning() const { return m_task.isRunning(); }
    /// How many have begun.
    int checks() const { return m_checks; }

    /// Waits until the level is checked, unless a gesture is under way.
    void check();
    /// Begins as soon as the events that are there are through.
    void hurry();

  Q_SIGNALS:
    void started();
    /// What is found is that of the level now; it may be what it was.
    void checked();

  private:
    void checkBeside();
    void take(Found found);

    Document& m_document;
    Found m_found;
    int m_checks = 0;
    QTimer m_soon;
    int m_listener = 0;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
