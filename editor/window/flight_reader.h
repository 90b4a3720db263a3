#pragma once
// Recorded flights that are dropped on a window or opened otherwise. Each is read beside the window, and then flown in
// the window that shows the level that it is of: one that is open, else one that is opened.

#include "core/game/replay.h"
#include "editor/canvas/background_task.h"

#include <QElapsedTimer>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <memory>
#include <vector>

namespace spacetow {

class MainWindow;

class FlightReader {
  public:
    /// The window must outlive this.
    explicit FlightReader(MainWindow& window);

    /// One after another. Those that were being read before are left.
    void open(const QStringList& paths);
    /// Nothing becomes of what is being read.
    void leave();
    bool isReading() const { return m_reading; }
    /// Since when, s.
    double readingFor() const { return static_cast<double>(m_time.elapsed()) / 1000; }
    /// Waits for all flights that are being read.
    void finish();
    /// No longer reading, or still; some times a second, for who shows for how long.
    std::function<void()> changed;

  private:
    /// A file, and which of the levels that are open are the one that it is of.
    struct Read {
        QString path;
        Result<Replay> replay;
        std::vector<std::shared_ptr<const Level>> levels;
    };
    void next();
    void fly(const Read& read);
    /// Null when there is none, which is said.
    MainWindow* windowFor(const Read& read);
    void setReading(bool reading);

    MainWindow& m_window;
    QStringList m_waiting;
    bool m_reading = false;
    bool m_again = false; // the task is still at work on what was left
    QElapsedTimer m_time;
    QTimer m_ticks;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
