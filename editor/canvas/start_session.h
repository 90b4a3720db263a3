#pragma once
// The game of a level at its start, for what is shown while nothing runs: made beside the window when somebody wants
// it, and again after each edit.

#include "core/game/session.h"
#include "editor/canvas/background_task.h"
#include "editor/editing/document.h"

#include <QObject>

#include <memory>

namespace spacetow {

class StartSession : public QObject {
    Q_OBJECT

  public:
    /// The document must outlive it. Nothing is made before somebody wants it.
    explicit StartSession(Document& document, QObject* parent = nullptr);
    ~StartSession() override;

    /// As long as anybody does. Everyone who says so once has to take it back once.
    void want();
    void release();

    /// The newest there is, of the level as it was a moment ago; null before the first is ready. Immutable.
    std::shared_ptr<const Session> latest() const { return m_latest; }
    /// Whether it is that of the level as it is shown.
    bool isCurrent() const { return m_latest && m_made == m_document.shown().level; }
    /// Waits until it is.
    void finish();

  signals:
    void changed();

  private:
    void refresh();

    Document& m_document;
    int m_wanted = 0;
    int m_listener = 0;
    std::shared_ptr<const Session> m_latest;
    std::shared_ptr<const Level> m_made; // of which it is the session
    BackgroundTask m_task;               // last, so that it has ended before the rest goes
};

} // namespace spacetow
