// Saving, and what else may have happened to the file meanwhile.
#include "core/base/codes.h"
#include "editor/editing/backups.h"
#include "editor/window/files.h"
#include "editor/window/messages.h"
#include "editor/window/state_folder.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace spacetow {

namespace {

struct DiskWords {
    Q_DECLARE_TR_FUNCTIONS(Files)
};

std::shared_ptr<const Level> shared(Level level) {
    return std::make_shared<const Level>(std::move(level));
}

} // namespace

void Files::sayNotSaved(const Error& error) {
    m_tell(MessageBar::Tone::Error,
           sentence(error) + QLatin1Char('\n') +
               DiskWords::tr("Nothing is lost: your work is still here. Save it elsewhere?"),
           {{DiskWords::tr("Save As…"), [this] { saveAs(); }}});
}

bool Files::writeTo(const QString& path, const std::optional<FileStamp>& known) {
    const std::filesystem::path file = path.toStdString();
    saving.emit();
    // Without a copy of what was there it is saved all the same.
    const std::optional<Error> noBackup = backUp(backupFolder(), file);
    const Result<std::string> text = savableText(*m_document.current().level);
    const Result<FileStamp> written = text ? writeFile(file, text.value(), known) : Result<FileStamp>(text.error());
    if (!written) {
        if (written.error().code == BaseCode("changed-on-disk")) {
            conflict.emit();
        } else {
            sayNotSaved(written.error());
        }
        return false;
    }
    m_path = path;
    m_disk = {written.value(), contentHash(text.value())}; // not what somebody may have written since
    setUntitled({});
    preferences.addRecent(path);
    m_document.markSaved();
    changed.emit();
    saved.emit();
    sayNoBackup(noBackup);
    return true;
}

/// Once, until it works again, as a disk may be full for long.
void Files::sayNoBackup(const std::optional<Error>& error) {
    if (error && !m_lacksBackup) {
        m_tell(MessageBar::Tone::Warning,
               DiskWords::tr("%1 is saved, but of the version before no backup could be made:").arg(name()) +
                   QLatin1Char('\n') + sentence(*error),
               {});
    }
    m_lacksBackup = error.has_value();
}

bool Files::save() {
    if (m_path.isEmpty()) {
        return saveAs();
    }
    // The stamp first, so that what is written while the content is looked at counts as another's change.
    const FileStamp seen = stampOf(m_path.toStdString());
    const FileState now = fileState(m_path.toStdString(), m_disk);
    if (now.exists() && !now.sameContent(m_disk)) {
        conflict.emit();
        return false;
    }
    return writeTo(m_path, seen);
}

bool Files::overwrite() {
    return writeTo(m_path);
}

bool Files::reload(std::shared_ptr<const FileRead> read) {
    if (m_path.isEmpty()) {
        return false;
    }
    const std::optional<LevelFile> file = readable({m_path, std::move(read)});
    if (!file) {
        return false;
    }
    takeFromDisk(*file->level, m_read);
    return true;
}

void Files::takeFromDisk(Level level, const FileState& disk) {
    m_disk = disk;
    m_document.commit({"reload", 1}, {shared(std::move(level)), m_document.current().selection});
    m_document.markSaved();
}

bool Files::restore(const JournalEntry& entry) {
    LevelFile found = parseLevel(entry.text, Checks::FileOnly);
    if (!found.level) {
        m_tell(MessageBar::Tone::Error, DiskWords::tr("What was kept of %1 cannot be read.").arg(entry.name.c_str()),
               {});
        return false;
    }
    m_path = QString::fromStdString(entry.path);
    setUntitled(m_path.isEmpty() ? QString::fromStdString(entry.name) : QString());
    m_disk = m_path.isEmpty() ? FileState() : fileState(entry.path);
    const bool sameFile = m_disk.exists() && entry.fileHash == m_disk.hash;
    Result<LevelFile> base = sameFile ? readLevel(entry.path, Checks::FileOnly) : Result<LevelFile>(Error());
    if (base && base.value().level) {
        m_document.reset(std::move(*base.value().level));
        m_document.commit({"recover", 1}, {shared(std::move(*found.level)), {}});
    } else {
        m_document.reset(std::move(*found.level));
        m_document.setSavedGone(true);
    }
    if (m_disk.exists() && !sameFile) {
        m_disk = {{.exists = true}, entry.fileHash.value_or(0)}; // so that saving asks first
    }
    opened.emit();
    changed.emit();
    return true;
}

std::vector<MessageBar::Choice> Files::backupChoices(const QString& path, std::function<void()> open) {
    if (path.isEmpty() || backupsOf(backupFolder(), path.toStdString()).empty()) {
        return {};
    }
    return {{DiskWords::tr("Open Newest Backup"), std::move(open)}};
}

void Files::openNewestBackup(const QString& path) {
    std::optional<Level> found;
    for (const Backup& backup : backupsOf(backupFolder(), path.toStdString())) {
        Result<LevelFile> file = readLevel(backup.file, Checks::FileOnly);
        if (file && file.value().level) {
            found = std::move(std::move(file).value().level);
            break;
        }
    }
    if (!found) {
        m_tell(MessageBar::Tone::Error, DiskWords::tr("This backup cannot be opened."), {});
    } else if (mayLeave() && restore({path.toStdString(), QFileInfo(path).fileName().toStdString(),
                                      fileState(path.toStdString()).hash, 0, levelText(*found)})) {
        m_tell(MessageBar::Tone::Info,
               DiskWords::tr("This is the newest backup of %1. The file stays as it is until you save.").arg(name()),
               {});
    }
}

bool Files::openBackup(const std::filesystem::path& backup) {
    Result<LevelFile> file = readLevel(backup, Checks::FileOnly);
    if (!file || !file.value().level) {
        m_tell(MessageBar::Tone::Error, file ? DiskWords::tr("This backup cannot be opened.") : sentence(file.error()),
               {});
        return false;
    }
    m_document.commit({"open-backup", 1}, {shared(std::move(*file.value().level)), m_document.current().selection});
    return true;
}

} // namespace spacetow
