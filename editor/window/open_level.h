#pragma once
// A level that is open: its document and its file, and the windows that show it, which may be several.

#include "editor/editing/document.h"
#include "editor/editing/run_changes.h"
#include "editor/panels/level_check.h"
#include "editor/window/disk_changes.h"
#include "editor/window/files.h"
#include "editor/window/recovery.h"

#include <vector>

namespace spacetow {

class MainWindow;

class OpenLevel {
  public:
    OpenLevel();

    Document document;
    /// What a run has changed and nobody has decided about.
    RunChanges runChanges;
    /// For all views.
    LevelCheck check;
    /// Asks and speaks through the view that was used last.
    Files files;
    DiskChanges disk;
    Recovery recovery;

    /// The windows that show the level, the one used last in front. A window adds and removes itself.
    const std::vector<MainWindow*>& views() const { return m_views; }
    MainWindow* front() const { return m_views.empty() ? nullptr : m_views.front(); }
    /// The number of the view, by which its title tells it from others.
    int add(MainWindow& view);
    void remove(const MainWindow& view);
    /// The others finish what is half drawn: two hands on one level would get into each other's way.
    void bringToFront(MainWindow& view);

    /// Nobody has done anything with it yet, so that another level may take its place.
    bool isUntouched() const;

  private:
    void listen();

    std::vector<MainWindow*> m_views;
    int m_lastNumber = 0;
};

} // namespace spacetow
