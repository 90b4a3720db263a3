#pragma once
// Files that are to be opened, whatever they are. Small ones are left to whoever opens them; others are read beside the
// window, which says for how long and can be told to leave them.

#include "editor/canvas/background_task.h"
#include "editor/window/file_to_open.h"

#include <QElapsedTimer>
#include <QStringList>
#include <QTimer>

#include <deque>
#include <functional>
#include <vector>

namespace spacetow {

class MessageBar;

class FileReader {
  public:
    using Then = std::function<void(const std::vector<FileToOpen>&)>;

    /// Larger than this together, bytes, they are read beside.
    static constexpr qint64 small = 256 << 10;

    /// The bar must outlive this.
    explicit FileReader(MessageBar& bar);

    /// `then` is called with all of them: before this returns where they are small, else once they have been read; with
    /// none where they are left. Several wait for each other.
    void read(const QStringList& paths, Then then);
    /// What is being read is not opened.
    void leave();
    bool isReading() const { return !m_waiting.empty(); }
    /// What is read: "cave.json (24.7 MB)".
    QString subject() const;
    /// Since when, s.
    double readingFor() const { return static_cast<double>(m_time.elapsed()) / 1000; }
    /// Waits for all that is being read.
    void finish();
    /// No longer reading, or still; some times a second, for who shows for how long.
    std::function<void()> changed;

  private:
    struct Wish {
        QStringList paths;
        Then then;
    };
    void next();
    void arrived(const std::vector<FileToOpen>& files);
    void tick();
    void dismiss();
    void tell();

    MessageBar& m_bar;
    std::deque<Wish> m_waiting; // the first one is being read
    int m_generation = 0;
    QString m_said;
    QElapsedTimer m_time;
    QTimer m_ticks;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
