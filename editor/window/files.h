#pragma once
// Opening and saving: which file the document belongs to, and that no work is lost on the way. Questions are asked
// through functions, so that tests can answer them.

#include "core/level/file.h"
#include "editor/editing/document.h"
#include "editor/window/message_bar.h"
#include "editor/window/preferences.h"

#include <QString>

#include <functional>
#include <memory>

namespace spacetow {

enum class Unsaved : std::uint8_t { Save, Discard, Cancel };

struct FileQuestions {
    std::function<QString(const QString& folder)> whichToOpen;     // empty: none
    std::function<QString(const QString& suggestion)> whereToSave; // empty: nowhere
    std::function<Unsaved(const QString& name)> whatAboutChanges;
};

/// Asks with the dialogs of the desktop.
FileQuestions dialogQuestions(QWidget* parent);

class Files {
  public:
    using Tell = std::function<void(MessageBar::Tone, const QString&)>;

    /// The document must outlive this.
    Files(Document& document, FileQuestions questions, Tell tell);

    FileQuestions questions;

    /// Each returns whether it was done; when not, document and file are as they were.
    bool startNew();
    bool chooseAndOpen();
    bool open(const QString& path);
    bool openExample(const QString& resource);
    /// A level that the user chooses, and what to call it; null when there was none.
    std::shared_ptr<const Level> chooseToCompare(QString& shownName);
    bool save();
    bool saveAs();
    /// Offers to save what is modified; false when the user would rather stay.
    bool mayLeave();

    /// Empty for a level that has no file yet.
    const QString& path() const { return m_path; }
    /// For the title: the file's name, or that of the level.
    QString name() const;

    Signal<> changed; // path or name
    Signal<> opened;  // the document holds another level
    Preferences preferences;

  private:
    /// What the file holds; tells why when that is no level.
    std::optional<LevelFile> readable(const QString& path);
    bool holdsLevel(const LevelFile& file, const QString& shownName);
    /// The file must hold a level. The path is empty for an example.
    void adopt(const LevelFile& file, const QString& path);
    bool writeTo(const QString& path);
    QString suggestion() const;

    Document& m_document;
    Tell m_tell;
    QString m_path;
    QString m_untitled; // suggested file name while there is no path
};

} // namespace spacetow
