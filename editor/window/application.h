#pragma once
// The application: owns the windows, and decides which of them shows what. A level is open once, in however many
// windows; what was open is remembered from one run to the next.

#include "editor/window/window_memory.h"

#include <QObject>
#include <QStringList>

#include <memory>
#include <vector>

namespace spacetow {

class MainWindow;
class OpenLevel;
struct FileToOpen;
struct Level;

class Application : public QObject {
    Q_OBJECT

  public:
    Application();
    ~Application() override;

    /// The first windows: of these files or, without any, those of the last run, where that is wanted.
    void start(const QStringList& files);

    /// In the order in which they were opened.
    std::vector<MainWindow*> windows() const;
    /// With an empty level.
    MainWindow& newWindow(const MainWindow* beside);
    /// Of the level that the window shows, and of the same part of it.
    MainWindow& newView(const MainWindow& window);
    /// In this window where nothing is lost by it, else in a new one.
    void startNew(MainWindow& from);
    /// Each where it is open already, else in this window where nothing is lost by it, else in a new one. What cannot
    /// be opened, this window says.
    void openAll(const std::vector<FileToOpen>& files, MainWindow& from);
    /// The window that shows this file, the one of its views that was used last; null when none does.
    MainWindow* showing(const QString& path) const;
    /// The same with one file; null when it cannot be opened.
    MainWindow* open(const FileToOpen& file, MainWindow& from);
    /// Where work of this file, or of none, may be restored.
    MainWindow& roomToRestore(const QString& path, MainWindow& from);
    void showNext(const MainWindow& from);

    /// In this window where nothing is lost by it, else in a new one, unless one shows it already.
    void showWelcome(MainWindow& from);
    /// Closes the window, if the user agrees; the last one stays with the welcome page, where that is wanted.
    void close(MainWindow& window);

    /// The levels that were closed, the last one first.
    bool canReopen() const { return !m_closed.empty(); }
    void reopenClosed(MainWindow& from);

    /// In all windows at once, and from then on; empty for the language of the desktop.
    void setLanguage(const QString& code);

    /// Asks about all that is modified before it closes anything; false when the user would rather stay.
    bool quit();

  private:
    struct Closed {
        QString path; // empty: it had no file, and this is what it was
        std::shared_ptr<const Level> level;
        RememberedView view;
    };

    MainWindow& add(std::shared_ptr<OpenLevel> level, const MainWindow* beside);
    MainWindow& roomFor(MainWindow& from);
    void replace(MainWindow& old);
    void restoreWindows();
    /// Of those that are left, each when the one before is there, as several may be views of one level.
    void restoreNext();
    void restore(const RememberedWindow& remembered);
    void closed(MainWindow& window);
    void keepClosed(const MainWindow& window);
    void tellApart(const MainWindow& window);
    void remember() const;
    bool isRestoring() const { return m_arriving != nullptr || !m_left.empty(); }

    std::vector<std::unique_ptr<MainWindow>> m_windows;
    std::vector<Closed> m_closed;
    bool m_quitting = false;
    std::vector<RememberedWindow> m_left; // to be restored
    QStringList m_gone;                   // of those that were, there is no file any more
    MainWindow* m_arriving = nullptr;     // whose level is being read
};

} // namespace spacetow
