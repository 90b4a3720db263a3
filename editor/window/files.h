#pragma once
// Opening and saving: which file the document belongs to, and that no work is lost on the way. Questions are asked
// through functions, so that tests can answer them.

#include "core/level/file.h"
#include "core/level/file_state.h"
#include "editor/editing/document.h"
#include "editor/editing/journal.h"
#include "editor/window/file_to_open.h"
#include "editor/window/message_bar.h"
#include "editor/window/preferences.h"

#include <QStringList>

#include <filesystem>
#include <functional>
#include <memory>

namespace spacetow {

enum class Unsaved : std::uint8_t { Save, Discard, Cancel };

struct FileQuestions {
    std::function<QStringList(const QString& folder)> whichToOpen; // empty: none
    std::function<QString(const QString& suggestion)> whereToSave; // empty: nowhere
    std::function<Unsaved(const QString& name)> whatAboutChanges;
    std::function<QString(const QString& folder)> whichToCompare{}; // empty: none
};

/// Asks with the dialogs of the desktop, in front of the widget that is the parent then.
FileQuestions dialogQuestions(const std::function<QWidget*()>& parent);

class Files {
  public:
    using Tell = std::function<void(MessageBar::Tone, const QString&, const std::vector<MessageBar::Choice>& choices)>;

    /// The document must outlive this.
    Files(Document& document, FileQuestions questions, Tell tell);

    FileQuestions questions;

    /// Each returns whether it was done; when not, document and file are as they were.
    bool startNew();
    /// The same without a question: nothing of the level is wanted any more.
    void startOver();
    bool open(const FileToOpen& file);
    bool openExample(const QString& resource);
    /// A level that the user chooses, and what to call it; null when there was none.
    std::shared_ptr<const Level> chooseToCompare(QString& shownName);
    /// Not when somebody else has changed the file meanwhile; then `conflict` asks what to do.
    bool save();
    /// Whatever the file holds.
    bool overwrite();
    bool saveAs();
    /// The files that the user would like to open.
    QStringList chosen() const;
    /// Takes over what the file holds now, as one edit, so that the view stays and undo takes it back.
    bool reload(std::shared_ptr<const FileRead> read = nullptr);
    /// The same with what has been read already.
    void takeFromDisk(Level level, const FileState& disk);
    /// Saving may replace what the file holds then.
    void setDisk(const FileState& disk) { m_disk = disk; }
    /// What a journal holds, not saved, of the file it was of.
    bool restore(const JournalEntry& entry);
    /// A former version of the file, as one edit.
    bool openBackup(const std::filesystem::path& backup);
    /// The newest former version of a file that holds no level any more; the file stays as it is.
    void openNewestBackup(const QString& path);
    /// Where there is one, a choice that calls `open`.
    static std::vector<MessageBar::Choice> backupChoices(const QString& path, std::function<void()> open);
    /// Offers to save what is modified; false when the user would rather stay.
    bool mayLeave();

    /// Empty for a level that has no file yet.
    const QString& path() const { return m_path; }
    /// For the title: the file's name; without a file a name that holds the number, when that is not 1.
    QString name() const;
    /// What it would be called without a file, with this number.
    QString untitled(int number) const;
    /// By which a flight in the level finds it again: without the number, which tells it apart only while it is open.
    QString nameInFlights() const;
    /// By which levels without a file are told apart; it is 1 again with every other level.
    void setNumber(int number);
    /// What the file held when it was last read or written here.
    const FileState& disk() const { return m_disk; }

    Signal<> leaving;  // unless the user would rather stay
    Signal<> conflict; // saving would replace what somebody else has written
    Signal<> changed;  // path or name
    Signal<> saving;   // is about to
    Signal<> saved;
    Signal<> opened; // the document holds another level
    Preferences preferences;

  private:
    /// What the file holds; tells why when that is no level.
    std::optional<LevelFile> readable(const FileToOpen& file);
    bool holdsLevel(const LevelFile& file, const QString& shownName);
    /// The file must hold a level. The path is empty for an example.
    void adopt(const LevelFile& file, const QString& path);
    /// With `known`, only while the file is still that one.
    bool writeTo(const QString& path, const std::optional<FileStamp>& known = {});
    void sayNotSaved(const Error& error);
    void sayNoBackup(const std::optional<Error>& error);
    QString suggestion() const;
    void setUntitled(const QString& fileName);

    Document& m_document;
    Tell m_tell;
    QString m_path;
    FileState m_disk;
    QString m_readPath;
    FileState m_read;   // of the file that was read last
    QString m_untitled; // suggested file name while there is no path
    int m_number = 1;
    bool m_lacksBackup = false;
};

} // namespace spacetow
