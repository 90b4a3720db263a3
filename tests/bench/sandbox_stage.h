#pragma once
// The window in which the sandbox is timed, with preferences and files of its own, and how long it answers nothing.
// Needs a QApplication.

#include "editor/window/main_window.h"
#include "tests/bench/sandbox_figures.h"

#include <QTemporaryDir>

#include <memory>

namespace spacetow::bench {

class SandboxStage {
  public:
    explicit SandboxStage(const Meter& meter);
    ~SandboxStage();

    MainWindow& window() { return *m_window; }
    Canvas& canvas() { return m_window->canvas(); }
    LiveRun& run() { return m_window->liveRun(); }
    QString file(const QString& name) const { return m_folder.filePath(name); }

    /// In place of what is there, all of it in view; once everything that is worked out beside the window is done.
    void show(Level level);
    /// One round of the event loop, and a moment of rest, which does not count; ms.
    double turn();
    /// Rounds until it comes true, or half a minute has passed; the longest, ms.
    double longestTurn(const std::function<bool()>& isDone);
    /// Of the work and of all rounds until it has come true.
    double longestTurn(const std::function<void()>& work, const std::function<bool()>& isDone);
    void stop();
    /// How often the canvas has been painted.
    int paintings() const { return m_paintings; }

  private:
    class PaintWatch;

    const Meter& m_meter;
    QTemporaryDir m_folder;
    int m_paintings = 0;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<PaintWatch> m_watch;
};

} // namespace spacetow::bench
