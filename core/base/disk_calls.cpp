#include "core/base/disk_calls.h"

#include <fcntl.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/xattr.h>
#endif

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <vector>

namespace spacetow::disk {

namespace {

std::atomic<Fault> theFault{nullptr};

int faultOf(std::string_view call) {
    const Fault fault = theFault.load();
    return fault == nullptr ? 0 : fault(call);
}

/// Goes on where a signal interrupts.
template <class Call>
int codeOf(std::string_view name, Call call) {
    if (const int code = faultOf(name); code != 0) {
        return code;
    }
    while (call() < 0) {
        if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

/// Calls `write(rest, done)` until nothing is left.
template <class Write>
int written(std::string_view text, Write write) {
    std::size_t done = 0;
    while (done < text.size()) {
        ssize_t count = 0;
        const int code = codeOf("write", [&] { return count = write(text.substr(done), done); });
        if (code != 0 || count == 0) {
            return code != 0 ? code : EIO;
        }
        done += static_cast<std::size_t>(count);
    }
    return 0;
}

#ifdef __linux__
/// Names of the extended attributes, among which access lists are.
int attributeNames(const Descriptor& file, std::vector<std::string>& names) {
    std::vector<char> list(1u << 16u);
    const ssize_t size = ::flistxattr(file.number(), list.data(), list.size());
    if (size < 0) {
        return errno == ENOTSUP ? 0 : errno;
    }
    for (ssize_t at = 0; at < size; at += static_cast<ssize_t>(names.back().size()) + 1) {
        names.emplace_back(list.data() + at);
    }
    return 0;
}

/// Empty for one that cannot be read.
std::string attribute(const Descriptor& file, const std::string& name) {
    std::string value(1u << 16u, '\0');
    const ssize_t size = ::fgetxattr(file.number(), name.c_str(), value.data(), value.size());
    value.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return value;
}

/// Labels of security modules are the system's own business: a new file has the one that it should have.
bool isOfSystem(const std::string& name) {
    return name.starts_with("security.") || name.starts_with("trusted.");
}

int keepExtended(const Descriptor& copy, const Descriptor& original) {
    std::vector<std::string> wanted;
    std::vector<std::string> had;
    int code = attributeNames(original, wanted);
    code = code != 0 ? code : attributeNames(copy, had);
    for (const std::string& name : had) { // as a folder gives to new files
        if (!isOfSystem(name) && std::ranges::find(wanted, name) == wanted.end()) {
            ::fremovexattr(copy.number(), name.c_str());
        }
    }
    for (const std::string& name : wanted) {
        const std::string value = attribute(original, name);
        if (code != 0 || value == attribute(copy, name)) {
            continue;
        }
        const int failed =
            codeOf("setxattr", [&] { return ::fsetxattr(copy.number(), name.c_str(), value.data(), value.size(), 0); });
        code = isOfSystem(name) ? 0 : failed;
    }
    return code;
}
#endif

} // namespace

void setFault(Fault fault) {
    theFault = fault;
}

Descriptor::~Descriptor() {
    if (m_number >= 0) {
        ::close(m_number);
    }
}

int openAt(Descriptor& out, const Descriptor& folder, const std::string& name, const OpenMode& mode) {
    return codeOf((mode.flags & O_CREAT) != 0 ? "create" : "open", [&] {
        out = Descriptor(::openat(folder.number(), name.c_str(), mode.flags | O_CLOEXEC, mode.permissions));
        return out.number();
    });
}

int writeAll(const Descriptor& file, std::string_view text, off_t at) {
    return written(text, [&](std::string_view rest, std::size_t done) {
        return ::pwrite(file.number(), rest.data(), rest.size(), at + static_cast<off_t>(done));
    });
}

int writeOn(const Descriptor& stream, std::string_view text) {
    return written(
        text, [&](std::string_view rest, std::size_t) { return ::write(stream.number(), rest.data(), rest.size()); });
}

int readAll(std::string& out, const Descriptor& file, std::size_t most) {
    constexpr std::size_t step = 1u << 16u;
    struct stat info {};
    const bool told = ::fstat(file.number(), &info) == 0 && S_ISREG(info.st_mode) && info.st_size > 0;
    // One byte more than it says, to see its end at once.
    std::size_t room = told ? static_cast<std::size_t>(info.st_size) + 1 : step;
    std::size_t size = 0;
    for (;;) {
        out.resize(std::min(room, most + 1));
        ssize_t count = 0;
        const int code =
            codeOf("read", [&] { return count = ::read(file.number(), out.data() + size, out.size() - size); });
        size += code == 0 ? static_cast<std::size_t>(count) : 0;
        if (code != 0 || count == 0 || size > most) {
            out.resize(size);
            return code;
        }
        room = size == out.size() ? 2 * size : room;
    }
}

int flush(const Descriptor& file) {
    return codeOf("fsync", [&] { return ::fsync(file.number()); });
}

int reserve(const Descriptor& file, off_t size) {
#ifdef __linux__
    const int code = codeOf("reserve", [&] { return ::fallocate(file.number(), FALLOC_FL_KEEP_SIZE, 0, size); });
    return code == EOPNOTSUPP || code == ENOSYS || code == EINVAL ? 0 : code;
#else
    return file.isOpen() && size >= 0 ? 0 : EBADF;
#endif
}

int resize(const Descriptor& file, off_t size) {
    return codeOf("resize", [&] { return ::ftruncate(file.number(), size); });
}

int renameAt(const Descriptor& folder, const std::string& from, const std::string& to) {
    return codeOf("rename", [&] { return ::renameat(folder.number(), from.c_str(), folder.number(), to.c_str()); });
}

int renameToFreeName(const Descriptor& folder, const std::string& from, const std::string& to) {
#ifdef RENAME_NOREPLACE
    const int code = codeOf("rename", [&] {
        return ::renameat2(folder.number(), from.c_str(), folder.number(), to.c_str(), RENAME_NOREPLACE);
    });
    if (code != EINVAL && code != ENOSYS) {
        return code;
    }
#endif
    return renameAt(folder, from, to);
}

int removeAt(const Descriptor& folder, const std::string& name) {
    return codeOf("remove", [&] { return ::unlinkat(folder.number(), name.c_str(), 0); });
}

int keepAttributes(const Descriptor& copy, const Descriptor& original, const struct stat& info) {
    struct stat own {};
    int code = ::fstat(copy.number(), &own) == 0 ? 0 : errno;
    // One by one: whoever may not give the file away may still give it to a group of his.
    if (code == 0 && own.st_gid != info.st_gid) {
        code = codeOf("chown", [&] { return ::fchown(copy.number(), static_cast<uid_t>(-1), info.st_gid); });
    }
    if (code == 0 && own.st_uid != info.st_uid) {
        code = codeOf("chown", [&] { return ::fchown(copy.number(), info.st_uid, static_cast<gid_t>(-1)); });
    }
    // The mode comes after the owner, a change of whom clears some of its bits; access lists come after the mode, which
    // would change them.
    if (code == 0) {
        code = codeOf("chmod", [&] { return ::fchmod(copy.number(), info.st_mode & 07777u); });
    }
#ifdef __linux__
    return code == 0 ? keepExtended(copy, original) : code;
#else
    return original.isOpen() ? code : EBADF;
#endif
}

} // namespace spacetow::disk
