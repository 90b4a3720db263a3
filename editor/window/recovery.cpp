#include "editor/window/recovery.h"

#include "core/base/codes.h"
#include "core/level/file.h"

#include <QFileInfo>

#include <ctime>
#include <utility>

namespace spacetow {

namespace {

constexpr int halfDoneTime = 3000; // ms, between looks at what is half done: with the writing, less than 5 s

std::optional<Error> writeEntry(const JournalSlot& slot, JournalEntry entry, const Level& level) {
    // What could not be read again is of no use; what was written before it stays.
    Result<std::string> text = savableText(level);
    if (!text) {
        return text.error();
    }
    entry.text = std::move(text).value();
    return slot.write(entry);
}

/// By which others know the file, whatever links lead to it.
std::string sharedName(const QString& path) {
    const QString canonical = QFileInfo(path).canonicalFilePath();
    return (canonical.isEmpty() ? path : canonical).toStdString();
}

} // namespace

Recovery::Recovery(Document& document, Files& files, std::filesystem::path folder)
    : m_document(document), m_files(files), m_folder(std::move(folder)) {
    Result<JournalSlot> slot = JournalSlot::made(m_folder);
    if (slot) {
        m_slot = std::move(slot).value();
    }
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &Recovery::note);
    m_now.setInterval(halfDoneTime);
    connect(&m_now, &QTimer::timeout, this, &Recovery::noteUnfinished);
    m_now.start();
    m_historyListener = m_document.historyChanged.connect([this] { m_soon.start(0); });
    m_fileListener = m_files.changed.connect([this] { noteFile(); });
    noteFile();
    note();
}

Recovery::~Recovery() {
    m_document.historyChanged.disconnect(m_historyListener);
    m_files.changed.disconnect(m_fileListener);
}

std::shared_ptr<const Level> Recovery::wanted() const {
    if (std::shared_ptr<const Level> level = undecided ? undecided() : nullptr) {
        return level;
    }
    return m_document.isModified() ? m_document.current().level : nullptr;
}

bool Recovery::isBehind() const {
    const std::shared_ptr<const Level> level = wanted();
    return m_task.isRunning() || m_isToRetry || level != m_kept || (level && m_keptPath != m_files.path());
}

bool Recovery::isFileOpenElsewhere() const {
    return m_slot && !m_files.path().isEmpty() && isOpenElsewhere(m_folder, sharedName(m_files.path()), m_slot->id());
}

void Recovery::noteFile() {
    if (m_slot) {
        m_slot->setFile(m_files.path().isEmpty() ? std::string() : sharedName(m_files.path()));
    }
    m_soon.start(0);
}

void Recovery::note() {
    if (!m_task.isRunning() && isBehind()) {
        keep(wanted());
    }
}

void Recovery::noteUnfinished() {
    std::shared_ptr<const Level> level = m_document.hasPreview() ? m_document.shown().level : nullptr;
    if (!level && unfinished) {
        level = unfinished();
    }
    if (m_task.isRunning()) {
        return;
    }
    if (level && level != m_document.current().level) {
        if (level != m_kept) {
            keep(level);
        }
    } else {
        note(); // what was half done may have been given up
    }
}

void Recovery::keep(std::shared_ptr<const Level> level) {
    if (!m_slot) {
        kept(level, Error{BaseCode("cannot-write"), {m_folder.string(), "no place could be made there"}});
        return;
    }
    m_keptPath = m_files.path();
    JournalEntry entry{m_keptPath.toStdString(), m_files.name().toStdString(), {}, std::time(nullptr), {}};
    if (m_files.disk().exists()) {
        entry.fileHash = m_files.disk().hash;
    }
    m_task.start([this, &slot = *m_slot, entry, level](const std::stop_token&) -> BackgroundTask::Then {
        std::optional<Error> error;
        if (level) {
            error = writeEntry(slot, entry, *level);
        } else {
            slot.erase();
        }
        return [this, level, error] {
            kept(level, error);
            if (!m_isToRetry || wanted() != level) {
                note(); // what has come meanwhile
            }
        };
    });
}

void Recovery::kept(const std::shared_ptr<const Level>& level, const std::optional<Error>& error) {
    m_kept = level; // also when it failed: a level that cannot be saved never can
    m_isToRetry = error && error->code == BaseCode("cannot-write"); // but a disk may have room again
    if (error && !std::exchange(m_broken, true)) {
        failed.emit(*error);
    } else if (!error) {
        m_broken = false;
    }
}

bool Recovery::flush() {
    m_task.finish();
    note();
    m_task.finish();
    return !m_broken;
}

void Recovery::close() {
    m_soon.stop();
    m_task.finish();
    m_task.finish(); // the second is what was noted when the first ended
    if (m_slot) {
        m_slot->erase();
    }
    m_isToRetry = false;
    m_kept = wanted(); // so that nothing is written any more
    m_keptPath = m_files.path();
}

} // namespace spacetow
