#pragma once
// "Save Flight…": what has been flown in a window as a file that can be dropped on one. The window waits neither for
// the update that runs nor for the disk.

#include "editor/canvas/background_task.h"

#include <QString>

namespace spacetow {

class MainWindow;
struct Recording;

class FlightFile {
  public:
    /// The window must outlive this.
    explicit FlightFile(MainWindow& window) : m_window(window) {}

    /// Holds the run, asks for a name, and says how it went.
    void save();
    /// Waits for the file that is being written.
    void finish() { m_task.finish(); }
    /// What is said of a flight that has been saved under this name.
    static QString savedWords(const QString& file, const Recording& recording);

  private:
    void say(const QString& path, const Recording& recording);

    MainWindow& m_window;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
