// The files of the journal, and their locks (POSIX).
#include "core/base/codes.h"
#include "core/base/system_reason.h"
#include "core/level/file_state.h"
#include "editor/editing/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <sstream>

namespace spacetow {

namespace {

namespace fs = std::filesystem;

constexpr auto journalSuffix = ".journal";
constexpr auto lockSuffix = ".lock";
constexpr auto unfinishedSuffix = ".journal.new";
constexpr auto discardedSuffix = ".discarded";
constexpr std::time_t youngSeconds = 60; // a lock may belong to a place that is being made
constexpr std::time_t discardedSeconds = 7 * 24 * 3600;

Error cannotJournal(const fs::path& path, int code) {
    return {BaseCode("cannot-write"), {path.string(), systemReason(code)}};
}

/// Unlike any other, in this process and elsewhere.
std::string freshId() {
    static std::atomic<unsigned> count{0};
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    return std::to_string(now) + '-' + std::to_string(::getpid()) + '-' + std::to_string(++count);
}

std::string contents(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return std::move(text).str();
}

/// 0, or the error code.
int writeFlushed(const fs::path& path, std::string_view text) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (file < 0) {
        return errno;
    }
    int error = 0;
    while (error == 0 && !text.empty()) {
        const ssize_t count = ::write(file, text.data(), text.size());
        if (count >= 0) {
            text.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    if (error == 0 && ::fdatasync(file) != 0) {
        error = errno;
    }
    return ::close(file) != 0 && error == 0 ? errno : error;
}

/// Whether a process holds the lock. Those who only look share it with each other.
bool isHeld(const fs::path& lock) {
    const int file = ::open(lock.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return false;
    }
    const bool held = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    ::close(file);
    return held;
}

bool isOlder(const fs::path& path, std::time_t seconds) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0 && std::time(nullptr) - info.st_ctime > seconds;
}

/// The part of a name before the suffix; empty when it has another end.
std::string idIn(const fs::path& path, std::string_view suffix) {
    const std::string name = path.filename().string();
    return name.ends_with(suffix) ? name.substr(0, name.size() - suffix.size()) : std::string();
}

std::vector<fs::path> filesOf(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        files.push_back(it->path());
    }
    return files;
}

/// What nobody will ask for again.
void tidy(const fs::path& folder) {
    for (const fs::path& path : filesOf(folder)) {
        const std::string unfinished = idIn(path, unfinishedSuffix);
        const std::string lock = idIn(path, lockSuffix);
        const bool stale =
            (!unfinished.empty() && !isHeld(folder / (unfinished + lockSuffix))) ||
            (!lock.empty() && !fs::exists(folder / (lock + journalSuffix)) &&
             !fs::exists(folder / (lock + discardedSuffix)) && isOlder(path, youngSeconds) && !isHeld(path)) ||
            (!idIn(path, discardedSuffix).empty() && isOlder(path, discardedSeconds));
        if (stale) {
            ::unlink(path.c_str());
        }
    }
}

} // namespace

JournalSlot::JournalSlot(fs::path folder, std::string id, int lock)
    : m_folder(std::move(folder)), m_id(std::move(id)), m_lock(lock) {}

JournalSlot::JournalSlot(JournalSlot&& other) noexcept
    : m_folder(std::move(other.m_folder)), m_id(std::move(other.m_id)), m_lock(std::exchange(other.m_lock, -1)) {}

JournalSlot& JournalSlot::operator=(JournalSlot&& other) noexcept {
    if (this != &other) {
        release();
        m_folder = std::move(other.m_folder);
        m_id = std::move(other.m_id);
        m_lock = std::exchange(other.m_lock, -1);
    }
    return *this;
}

JournalSlot::~JournalSlot() {
    release();
}

void JournalSlot::release() {
    if (m_lock < 0) {
        return;
    }
    std::error_code error;
    if (!fs::exists(file(journalSuffix), error) && !fs::exists(file(discardedSuffix), error)) {
        ::unlink(file(lockSuffix).c_str());
    }
    ::close(std::exchange(m_lock, -1));
}

fs::path JournalSlot::file(const char* suffix) const {
    return m_folder / (m_id + suffix);
}

Result<JournalSlot> JournalSlot::made(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    const std::string id = freshId();
    const fs::path lock = folder / (id + lockSuffix);
    const int file = ::open(lock.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0) {
        return cannotJournal(lock, errno);
    }
    while (::flock(file, LOCK_EX) != 0 && errno == EINTR) {
    }
    return JournalSlot(folder, id, file);
}

std::optional<JournalSlot> JournalSlot::takenOver(const fs::path& folder, const std::string& id) {
    const int file = ::open((folder / (id + lockSuffix)).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (file < 0) {
        return {};
    }
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
        ::close(file);
        return {};
    }
    JournalSlot slot(folder, id, file);
    slot.setFile({}); // nobody has it open any more
    const bool found = fs::exists(slot.file(journalSuffix)) || fs::exists(slot.file(discardedSuffix));
    return found ? std::optional(std::move(slot)) : std::nullopt;
}

std::optional<Error> JournalSlot::write(const JournalEntry& entry) const {
    const fs::path unfinished = file(unfinishedSuffix);
    int error = writeFlushed(unfinished, journalText(entry));
    if (error == 0 && std::rename(unfinished.c_str(), file(journalSuffix).c_str()) != 0) {
        error = errno;
    }
    if (error == 0) {
        return {};
    }
    ::unlink(unfinished.c_str());
    return cannotJournal(file(journalSuffix), error);
}

std::optional<JournalEntry> JournalSlot::read() const {
    return parsedJournal(contents(file(journalSuffix)));
}

void JournalSlot::erase() const {
    ::unlink(file(journalSuffix).c_str());
}

void JournalSlot::discard() const {
    std::rename(file(journalSuffix).c_str(), file(discardedSuffix).c_str());
}

void JournalSlot::bringBack() const {
    std::rename(file(discardedSuffix).c_str(), file(journalSuffix).c_str());
}

void JournalSlot::setFile(const std::string& path) const {
    const std::string text = std::to_string(::getpid()) + '\n' + path;
    // Where it cannot be told, nobody is warned; that is all.
    [[maybe_unused]] const bool told =
        ::ftruncate(m_lock, 0) == 0 && ::pwrite(m_lock, text.data(), text.size(), 0) >= 0;
}

std::vector<Orphan> orphans(const fs::path& folder) {
    tidy(folder);
    std::vector<Orphan> found;
    for (const fs::path& path : filesOf(folder)) {
        const std::string id = idIn(path, journalSuffix);
        std::optional<JournalEntry> entry;
        if (!id.empty() && !isHeld(folder / (id + lockSuffix))) {
            entry = parsedJournal(contents(path));
        }
        if (!entry) {
            continue;
        }
        const FileState state = entry->path.empty() ? FileState() : fileState(entry->path);
        if (state.exists() && state.stamp.size == entry->text.size() && state.hash == contentHash(entry->text)) {
            if (const std::optional<JournalSlot> slot = JournalSlot::takenOver(folder, id)) {
                slot->erase(); // killed between saving and saying so
            }
            continue;
        }
        found.push_back({id, std::move(*entry)});
    }
    std::ranges::stable_sort(found, std::ranges::greater(), [](const Orphan& orphan) { return orphan.entry.time; });
    return found;
}

bool isOpenElsewhere(const fs::path& folder, const std::string& path, const std::string& ownId) {
    return std::ranges::any_of(filesOf(folder), [&](const fs::path& lock) {
        const std::string id = idIn(lock, lockSuffix);
        if (id.empty() || id == ownId || !isHeld(lock)) {
            return false;
        }
        const std::string text = contents(lock);
        const std::size_t end = text.find('\n');
        return end != std::string::npos && text.substr(end + 1) == path;
    });
}

} // namespace spacetow
