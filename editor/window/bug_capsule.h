#pragma once
// The bug capsule of a window: what runs in it, up to the moment that is shown, as text on the clipboard; and such a
// text opened again at its moment. Both take their time and are done beside the window.

#include "editor/canvas/background_task.h"

#include <QString>

#include <memory>
#include <string>

namespace spacetow {

class MainWindow;
struct Capsule;
struct Level;

class BugCapsule {
  public:
    /// The window must outlive this.
    explicit BugCapsule(MainWindow& window) : m_window(window) {}

    /// While nothing runs: the level at its start.
    void copy();
    /// In this window where nothing is lost by it, else in another one; what is wrong with the text is said.
    void open(std::string text);
    /// Waits for what is being done.
    void finish() { m_task.finish(); }

  private:
    struct Opening {
        std::shared_ptr<const Level> edited; // as the level was at the moment
        bool isSame = false;                 // the run comes out as it did
    };
    void copied(const QString& text);
    void opened(const std::shared_ptr<const Capsule>& capsule, const Opening& opening);
    /// The window that shows the level; null when the user would rather keep what is open.
    MainWindow* windowFor(const Capsule& capsule);
    bool isBusy();

    MainWindow& m_window;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
