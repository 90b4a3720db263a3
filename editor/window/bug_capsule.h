#pragma once
// The bug capsule of a window: what runs in it, up to the moment that is shown, as text on the clipboard; and such a
// text opened again at its moment, which its run is simulated up to: see Course::open. Text and hash are made and read
// beside the window.

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
    /// In this window where nothing is lost by it, else in another one; what is wrong with the text is said, and later
    /// whether the run comes out otherwise.
    void open(std::string text);
    /// Whether the run that was opened in this window has come out as it did, once it has been simulated.
    void compare();
    void forgetRun() { m_opened = nullptr; }
    /// Waits for what is being done.
    void finish() { m_task.finish(); }

  private:
    void copied(const QString& text);
    void opened(const std::shared_ptr<const Capsule>& capsule, const std::shared_ptr<const Level>& edited);
    /// The window that shows the level; null when the user would rather keep what is open.
    MainWindow* windowFor(const Capsule& capsule);
    bool isBusy();

    MainWindow& m_window;
    std::shared_ptr<const Capsule> m_opened; // runs here, and has not been compared yet; null for none
    BackgroundTask m_task;                   // last, so that it has ended before the rest goes
};

} // namespace spacetow
