#pragma once
// Keeps the journal of one open document: what it holds and its file does not, never more than a gesture behind.
// Written by a thread beside, so that the window never waits. See editor/editing/journal.h.

#include "editor/canvas/background_task.h"
#include "editor/editing/document.h"
#include "editor/editing/journal.h"
#include "editor/window/files.h"

#include <QTimer>

namespace spacetow {

class Recovery : public QObject {
  public:
    /// Document and files must outlive this.
    Recovery(Document& document, Files& files, std::filesystem::path folder);
    ~Recovery() override;

    /// What the document would hold if what is half done were ended now, or null; asked every few seconds.
    std::function<std::shared_ptr<const Level>()> unfinished;

    /// What would be lost though the document does not hold it, or null; see lookAgain.
    std::function<std::shared_ptr<const Level>()> undecided;

    /// After `undecided` has another answer.
    void lookAgain() { m_soon.start(0); }
    /// Waits until the journal holds what the document does. False when it cannot be written.
    bool flush();
    /// The user has let go of the document: nothing of it stays.
    void close();
    /// Whether the journal lacks something of the document, besides what is half done.
    bool isBehind() const;
    /// Whether the file of the document is open in another window or program as well.
    bool isFileOpenElsewhere() const;
    const std::filesystem::path& folder() const { return m_folder; }

    Signal<const Error&> failed; // once, until it goes again

  private:
    std::shared_ptr<const Level> wanted() const;
    void note();
    void noteFile();
    void noteUnfinished();
    void keep(std::shared_ptr<const Level> level);
    void kept(const std::shared_ptr<const Level>& level, const std::optional<Error>& error);

    Document& m_document;
    Files& m_files;
    std::filesystem::path m_folder;
    std::optional<JournalSlot> m_slot;
    std::shared_ptr<const Level> m_kept; // what the journal holds; null: nothing
    QString m_keptPath;
    bool m_broken = false; // could not be written the last time
    bool m_isToRetry = false;
    int m_historyListener = 0;
    int m_fileListener = 0;
    QTimer m_soon;         // once the events that are there are through
    QTimer m_now;          // and then for what is half done
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
