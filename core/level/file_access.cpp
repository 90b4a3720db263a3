// Reading and writing level files on disk (POSIX).

#include "core/level/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace spacetow {

namespace {

namespace fs = std::filesystem;

std::string reason(int code) {
    return std::generic_category().message(code);
}

Error cannot(const char* what, const fs::path& path, int code) {
    return {what, {path.string(), reason(code)}};
}

Error notAFile(const char* what, const fs::path& path, const struct stat& info) {
    return S_ISDIR(info.st_mode) ? cannot(what, path, EISDIR) : Error{what, {path.string(), "not a regular file"}};
}

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number) : m_number(number) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    bool isOpen() const { return m_number >= 0; }
    int number() const { return m_number; }
    /// 0, or the error code.
    int close() {
        const int number = std::exchange(m_number, -1);
        return number >= 0 && ::close(number) != 0 ? errno : 0;
    }

  private:
    int m_number;
};

/// 0, or the error code.
int writeAll(const Descriptor& file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(file.number(), text.data(), text.size());
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count <= 0) {
            return count < 0 ? errno : EIO;
        }
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return ::fsync(file.number()) == 0 ? 0 : errno;
}

/// The file that a chain of links leads to, even when it does not exist yet.
fs::path target(fs::path path) {
    constexpr int maxLinks = 40;
    std::error_code error;
    for (int i = 0; i < maxLinks && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
        const fs::path link = fs::read_symlink(path, error);
        if (error) {
            break;
        }
        path = link.is_absolute() ? link : path.parent_path() / link;
    }
    return path;
}

fs::path temporaryBeside(const fs::path& path) {
    static std::atomic<unsigned> count{0};
    const std::string name =
        '.' + path.filename().string() + '.' + std::to_string(::getpid()) + '-' + std::to_string(++count) + ".tmp";
    return path.parent_path() / name;
}

/// So that the rename itself survives a power cut; where directories cannot be flushed there is nothing to do.
void flushDirectory(const fs::path& directory) {
    const Descriptor file(::open(directory.empty() ? "." : directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (file.isOpen()) {
        ::fsync(file.number());
    }
}

/// Writes the text to a new file that gets owner and mode of `old`, if there is one. 0, or the error code.
int writeTemporary(const fs::path& path, std::string_view text, const struct stat* old) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (!file.isOpen()) {
        return errno;
    }
    if (old != nullptr) {
        // Only root may give files away; otherwise the new file simply is the writer's. The mode comes last, for a
        // change of owner clears some of its bits.
        [[maybe_unused]] const int ignored = ::fchown(file.number(), old->st_uid, old->st_gid);
        if (::fchmod(file.number(), old->st_mode & 07777u) != 0) {
            return errno;
        }
    }
    const int error = writeAll(file, text);
    return error != 0 ? error : file.close();
}

} // namespace

Result<LevelFile> readLevel(const fs::path& path, Checks checks) {
    // Not waiting keeps a pipe without a writer from hanging the program.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat info {};
    if (!file.isOpen() || ::fstat(file.number(), &info) != 0) {
        return cannot("cannot-read", path, errno);
    }
    if (!S_ISREG(info.st_mode)) {
        return notAFile("cannot-read", path, info);
    }
    if (static_cast<std::uint64_t>(info.st_size) > maxLevelBytes) {
        return Error{"file-too-large", {path.string(), std::to_string(maxLevelBytes)}};
    }
    std::string text(static_cast<std::size_t>(info.st_size), '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t count = ::read(file.number(), text.data() + size, text.size() - size);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            return cannot("cannot-read", path, errno);
        }
        if (count == 0) {
            break;
        }
        size += static_cast<std::size_t>(count);
    }
    text.resize(size);
    return parseLevel(text, checks);
}

std::optional<Error> writeLevel(const fs::path& path, const Level& level) {
    if (std::optional<Error> error = notWritable(level)) {
        return error;
    }
    const std::string text = levelText(level);
    if (text.size() > maxLevelBytes) {
        return Error{"file-too-large", {path.string(), std::to_string(maxLevelBytes)}};
    }
    const fs::path file = target(path);
    struct stat info {};
    const bool exists = ::stat(file.c_str(), &info) == 0;
    if (!exists && errno != ENOENT) {
        return cannot("cannot-write", path, errno);
    }
    if (exists && !S_ISREG(info.st_mode)) {
        return notAFile("cannot-write", path, info);
    }
    // Renaming over a file needs no right to write it; a file that its owner protected stays as it is.
    if (exists && ::access(file.c_str(), W_OK) != 0) {
        return cannot("cannot-write", path, errno);
    }
    const fs::path temporary = temporaryBeside(file);
    int error = writeTemporary(temporary, text, exists ? &info : nullptr);
    if (error == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) {
        error = errno;
    }
    if (error != 0) {
        ::unlink(temporary.c_str());
        return cannot("cannot-write", path, error);
    }
    flushDirectory(file.parent_path());
    return {};
}

} // namespace spacetow
