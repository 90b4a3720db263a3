#include "core/base/whole_file.h"

#include "core/base/codes.h"
#include "core/base/replace_file.h"
#include "core/base/system_reason.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace spacetow {

namespace {

namespace fs = std::filesystem;

Error cannotRead(const fs::path& path, int code) {
    return Error{BaseCode("cannot-read"), {path.string(), systemReason(code)}};
}

/// The file that a chain of links leads to, even when it does not exist yet.
fs::path endOfLinks(fs::path path) {
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

/// The sentence that says most.
Error writeError(const fs::path& path, const fs::path& file, const disk::WriteFailure& failure) {
    using Step = disk::WriteFailure::Step;
    const std::string name = path.string();
    const std::string folder = file.has_parent_path() ? file.parent_path().string() : std::string(".");
    const int code = failure.code;
    const bool denied = code == EACCES || code == EPERM;
    if (failure.step == Step::Damaged && !failure.copy.empty()) {
        return Error{BaseCode("file-damaged-but-beside"),
                     {name, systemReason(code), (file.parent_path() / failure.copy).string()}};
    }
    if (failure.step == Step::Damaged) {
        return Error{BaseCode("file-damaged"), {name, systemReason(code)}};
    }
    if (failure.step == Step::Changed) {
        return Error{BaseCode("changed-on-disk"), {name}};
    }
    if (code == ENOSPC) {
        return Error{BaseCode("disk-full"), {name}};
    }
    if (code == EDQUOT) {
        return Error{BaseCode("quota-full"), {name}};
    }
    if (code == EROFS) {
        return Error{BaseCode("disk-read-only"), {name}};
    }
    if (failure.step == Step::Folder && (code == ENOENT || code == ENOTDIR)) {
        return Error{BaseCode("folder-missing"), {name, folder}};
    }
    if ((failure.step == Step::Folder || failure.step == Step::Create) && denied) {
        return Error{BaseCode("folder-protected"), {name, folder}};
    }
    if (failure.step == Step::File && denied) {
        return Error{BaseCode("file-protected"), {name}};
    }
    return Error{BaseCode("cannot-write"), {name, failure.words.empty() ? systemReason(code) : failure.words}};
}

bool isSame(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

std::optional<Error> writtenOn(const fs::path& path, int number, std::string_view text) {
    const disk::Descriptor stream(number);
    const int code = stream.isOpen() ? disk::writeOn(stream, text) : errno;
    return code == 0 ? std::nullopt
                     : std::optional(writeError(path, path, {disk::WriteFailure::Step::Write, code, {}, {}}));
}

} // namespace

FileStamp stampOf(const fs::path& path) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0 ? disk::stampOf(info) : FileStamp();
}

Result<ReadText> readFile(const fs::path& path, std::size_t most, Sources sources) {
    // Not waiting keeps a pipe without a writer from hanging the program.
    const int waiting = sources == Sources::Any ? 0 : O_NONBLOCK;
    // A socket cannot be opened by its name.
    const disk::Descriptor file(sources == Sources::Any && path == "/dev/stdin"
                                    ? ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 0)
                                    : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | waiting));
    struct stat info {};
    if (!file.isOpen() || ::fstat(file.number(), &info) != 0) {
        return cannotRead(path, errno);
    }
    if (S_ISDIR(info.st_mode)) {
        return cannotRead(path, EISDIR);
    }
    if (!S_ISREG(info.st_mode) && sources == Sources::Files) {
        return Error{BaseCode("cannot-read"), {path.string(), "not a regular file"}};
    }
    ReadText read;
    read.stamp = disk::stampOf(info);
    const bool told = S_ISREG(info.st_mode) && static_cast<std::uint64_t>(info.st_size) > most;
    const int code = told ? 0 : disk::readAll(read.text, file, most);
    if (code != 0) {
        return cannotRead(path, code);
    }
    if (told || read.text.size() > most) {
        return Error{BaseCode("file-too-large"), {path.string(), std::to_string(most)}};
    }
    return read;
}

Result<FileStamp> writeFile(const fs::path& path, std::string_view text, const std::optional<FileStamp>& known) {
    const fs::path file = endOfLinks(path);
    disk::WriteFailure failure;
    const FileStamp stamp = disk::replaced(file, text, known, failure);
    if (failure.step != disk::WriteFailure::Step::None) {
        return writeError(path, file, failure);
    }
    return stamp;
}

bool isStandardOutput(const fs::path& path) {
    struct stat out {};
    struct stat named {};
    return ::fstat(STDOUT_FILENO, &out) == 0 && ::stat(path.c_str(), &named) == 0 && isSame(out, named);
}

std::optional<Error> writeFileOrStream(const fs::path& path, std::string_view text) {
    if (isStandardOutput(path)) {
        return writtenOn(path, ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0), text);
    }
    struct stat info {};
    if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode)) {
        return writtenOn(path, ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY), text);
    }
    const Result<FileStamp> written = writeFile(path, text);
    return written ? std::nullopt : std::optional(written.error());
}

} // namespace spacetow
