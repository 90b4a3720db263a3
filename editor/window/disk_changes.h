#pragma once
// What others do to the file of an open document: changes, deletes or moves it. A document without changes of its own
// follows at once; else the user is asked, in a bar. The file is read by a thread beside.

#include "editor/canvas/background_task.h"
#include "editor/editing/document.h"
#include "editor/window/files.h"
#include "editor/window/message_bar.h"

#include <QFileSystemWatcher>
#include <QTimer>

#include <optional>

namespace spacetow {

class DiskChanges : public QObject {
    Q_OBJECT

  public:
    /// What the bar says.
    struct Notice {
        MessageBar::Tone tone;
        QString text;
        std::vector<MessageBar::Choice> choices;
    };

    /// Document and files must outlive this.
    DiskChanges(Document& document, Files& files);
    ~DiskChanges() override;

    /// Whether something is half done, in which case the level stays as it is for the moment.
    std::function<bool()> isBusy;
    /// Shows what is different from this level, which the file holds, or with null nothing any more.
    std::function<void(std::shared_ptr<const Level> other, const QString& name)> compare;

    /// Finds out what the file holds, whether or not the system has told of a change.
    void look();
    bool isLooking() const { return m_task.isRunning(); }
    const std::optional<Notice>& notice() const { return m_notice; }
    void dismiss();

    Signal<> noticed; // another notice, or none any more

  private:
    void watch();
    void conclude(const QString& path, const FileState& known, const FileState& now, std::optional<LevelFile> file);
    void changed(const FileState& now, std::optional<LevelFile> file);
    void gone();
    void saveRefused();
    void say(MessageBar::Tone tone, const QString& text, std::vector<MessageBar::Choice> choices = {});

    MessageBar::Choice reloadChoice();
    MessageBar::Choice keepChoice(const FileState& now);
    MessageBar::Choice compareChoice();

    Document& m_document;
    Files& m_files;
    QFileSystemWatcher m_watcher;
    QTimer m_soon;   // others write in several steps
    QTimer m_fading; // of what needs no answer
    std::optional<Notice> m_notice;
    FileState m_told; // what the notice is of
    bool m_gone = false;
    bool m_comparing = false;
    bool m_again = false; // look once more when the running one has ended
    std::array<int, 4> m_listeners{};
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
