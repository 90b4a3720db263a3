#include "core/base/replace_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <memory>

namespace spacetow::disk {

namespace {

namespace fs = std::filesystem;
using Step = WriteFailure::Step;

constexpr std::string_view temporaryEnd = ".tmp";

int statAt(const Descriptor& folder, const std::string& name, struct stat& info) {
    return ::fstatat(folder.number(), name.c_str(), &info, 0) == 0 ? 0 : errno;
}

/// Another process that holds the lock lives. Where there are no locks nobody gets any.
bool locked(const Descriptor& file, int wait) {
    return ::flock(file.number(), LOCK_EX | wait) == 0;
}

/// One file that is being replaced.
class Replacement {
  public:
    Replacement(const fs::path& path, std::string_view text, const std::optional<FileStamp>& known)
        : m_name(path.filename().string()), m_beside(namesBeside(path)), m_text(text), m_known(known) {
        const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
        m_folder = Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
#ifdef O_PATH
        if (!m_folder.isOpen() && errno == EACCES) { // one whose list may not be read
            m_folder = Descriptor(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
        }
#endif
        if (!m_folder.isOpen()) {
            fail(Step::Folder, errno);
        }
    }

    WriteFailure run() {
        if (failed() || !look()) {
            return m_failure;
        }
        // A new file in its place would be none of the old one's other names.
        bool inPlace = m_exists && m_info.st_nlink > 1;
        writeBeside(inPlace);
        if (!failed() && inPlace) {
            writeInPlace();
        }
        if (!m_temporary.empty() && m_failure.step == Step::Damaged) {
            m_failure.copy = m_temporary;
        } else if (!m_temporary.empty()) {
            removeAt(m_folder, m_temporary);
        }
        if (!failed()) {
            flush(m_folder); // or the rename would not survive a power cut; not all folders can be flushed
            removeLeftovers();
        }
        return m_failure;
    }

    /// Of what was written, which somebody may have replaced since.
    const FileStamp& written() const {
        return m_written;
    }

  private:
    FileStamp stamp() const {
        struct stat info {};
        return statAt(m_folder, m_name, info) == 0 ? stampOf(info) : FileStamp();
    }
    void noteWritten(const Descriptor& file) {
        struct stat info {};
        m_written = ::fstat(file.number(), &info) == 0 ? stampOf(info) : FileStamp();
    }
    bool failed() const {
        return m_failure.step != Step::None;
    }
    void fail(Step step, int code) {
        m_failure = {step, code, {}, {}};
    }

    /// What is there now, and whether it may be written.
    bool look() {
        const int code = statAt(m_folder, m_name, m_info);
        m_exists = code == 0;
        if (code != 0 && code != ENOENT) {
            fail(Step::Write, code);
        } else if (m_exists && S_ISDIR(m_info.st_mode)) {
            fail(Step::Write, EISDIR);
        } else if (m_exists && !S_ISREG(m_info.st_mode)) {
            m_failure = {Step::Write, EINVAL, "not a regular file", {}};
        } else if (m_exists && ::faccessat(m_folder.number(), m_name.c_str(), W_OK, 0) != 0) {
            // Renaming over a file needs no right to write it; a file that its owner protected stays as it is.
            fail(Step::File, errno);
        } else if (isAnother()) {
            fail(Step::Changed, 0);
        }
        return !failed();
    }
    bool isAnother() const {
        return m_known && stamp() != *m_known;
    }

    /// Writes the file beside and renames it, or says that the file is to be written in place. The file beside then
    /// stays until that is done: whatever happens, one of the two is whole.
    void writeBeside(bool& inPlace) {
        Descriptor file;
        if (const int code = create(file); code != 0) {
            // A file may be writable though its folder is not.
            inPlace = m_exists && (code == EACCES || code == EPERM || code == EROFS || code == ENAMETOOLONG);
            if (!inPlace) {
                fail(Step::Create, code);
            }
            return;
        }
        if (m_exists && !inPlace) {
            Descriptor old;
            inPlace = openAt(old, m_folder, m_name, {O_RDONLY | O_NOFOLLOW | O_NONBLOCK}) != 0 ||
                      keepAttributes(file, old, m_info) != 0;
        }
        int code = writeAll(file, m_text, 0);
        code = code != 0 ? code : flush(file);
        noteWritten(file);
        if (code != 0) {
            fail(Step::Write, code);
        } else if (isAnother()) {
            fail(Step::Changed, 0);
        } else if (!inPlace) {
            takePlace(inPlace);
        }
    }

    /// 0 or the error code. The name is never one that is taken.
    int create(Descriptor& file) {
        static std::atomic<unsigned> count{0};
        constexpr int attempts = 100;
        const mode_t mode = m_exists ? 0600 : 0666;
        int code = EEXIST;
        for (int i = 0; i < attempts && code == EEXIST; ++i) {
            const std::string name =
                m_beside + std::to_string(::getpid()) + '-' + std::to_string(++count) + std::string(temporaryEnd);
            code = openAt(file, m_folder, name, {O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, mode});
            if (code != 0) {
                continue;
            }
            m_temporary = name;
            locked(file, 0);
            struct stat info {};
            if (::fstat(file.number(), &info) == 0 && info.st_nlink == 0) { // taken for a leftover before it was locked
                m_temporary.clear();
                code = EEXIST;
            }
        }
        return code;
    }

    void takePlace(bool& inPlace) {
        const int code =
            m_exists ? renameAt(m_folder, m_temporary, m_name) : renameToFreeName(m_folder, m_temporary, m_name);
        if (code == 0) {
            m_temporary.clear();
        } else if (m_exists && (code == EACCES || code == EPERM || code == EBUSY || code == EXDEV)) {
            inPlace = true; // the folder is one of others, or the file is mounted
        } else if (code == EEXIST) {
            fail(Step::Changed, code);
        } else {
            fail(Step::Write, code);
        }
    }

    void writeInPlace() {
        Descriptor file;
        if (const int code = openAt(file, m_folder, m_name, {O_WRONLY | O_NOFOLLOW | O_NONBLOCK}); code != 0) {
            fail(Step::File, code);
            return;
        }
        std::string old;
        Descriptor reader;
        constexpr std::size_t most = 1u << 30u;
        const bool known = openAt(reader, m_folder, m_name, {O_RDONLY | O_NOFOLLOW | O_NONBLOCK}) == 0 &&
                           readAll(old, reader, most) == 0 && old.size() <= most;
        // Room is made before anything is touched.
        int code = reserve(file, static_cast<off_t>(m_text.size()));
        if (code != 0) {
            fail(Step::Write, code);
            return;
        }
        code = fill(file, m_text);
        noteWritten(file);
        if (code != 0) {
            fail(known && fill(file, old) == 0 ? Step::Write : Step::Damaged, code);
        }
    }
    static int fill(const Descriptor& file, std::string_view text) {
        int code = writeAll(file, text, 0);
        code = code != 0 ? code : resize(file, static_cast<off_t>(text.size()));
        return code != 0 ? code : flush(file);
    }

    /// Those whose writer was killed: they bear our name for this file, belong to us, and nobody holds their lock.
    void removeLeftovers() const {
        const int number = ::openat(m_folder.number(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        const std::unique_ptr<DIR, int (*)(DIR*)> list(number < 0 ? nullptr : ::fdopendir(number), &::closedir);
        while (const dirent* entry = list ? ::readdir(list.get()) : nullptr) {
            const std::string name = entry->d_name;
            if (!name.starts_with(m_beside) || !name.ends_with(temporaryEnd)) {
                continue;
            }
            Descriptor file;
            struct stat info {};
            if (openAt(file, m_folder, name, {O_RDONLY | O_NOFOLLOW | O_NONBLOCK}) == 0 &&
                ::fstat(file.number(), &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == ::geteuid() &&
                info.st_nlink == 1 && locked(file, LOCK_NB)) {
                removeAt(m_folder, name);
            }
        }
    }

    std::string m_name;
    std::string m_beside;    // what temporary names start with
    std::string m_temporary; // empty when there is none
    std::string_view m_text;
    const std::optional<FileStamp>& m_known;
    Descriptor m_folder;
    bool m_exists = false;
    struct stat m_info {};
    FileStamp m_written;
    WriteFailure m_failure;
};

} // namespace

FileStamp stampOf(const struct stat& info) {
    constexpr std::int64_t second = 1'000'000'000;
#ifdef __APPLE__
    const timespec& modified = info.st_mtimespec;
#else
    const timespec& modified = info.st_mtim;
#endif
    return {true, static_cast<std::uint64_t>(info.st_dev), static_cast<std::uint64_t>(info.st_ino),
            static_cast<std::uint64_t>(info.st_size), second * modified.tv_sec + modified.tv_nsec};
}

std::string namesBeside(const fs::path& path) {
    // Short, so that the name of the file itself may be as long as names can be.
    std::uint32_t hash = 0x811c9dc5u;
    for (const char c : path.filename().string()) {
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193u;
    }
    char text[32];
    std::snprintf(text, sizeof text, ".spacetow-%08x-", hash);
    return text;
}

FileStamp replaced(const fs::path& path, std::string_view text, const std::optional<FileStamp>& known,
                   WriteFailure& failure) {
    Replacement replacement(path, text, known);
    failure = replacement.run();
    return failure.step == Step::None ? replacement.written() : FileStamp();
}

} // namespace spacetow::disk
