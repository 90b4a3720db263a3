#pragma once
// The calls of the system (POSIX) that whole files are read and written with. Each answers with its error code, 0 for
// none; tests can have any of them fail.

#include <sys/stat.h>
#include <sys/types.h>

#include <string>
#include <string_view>
#include <utility>

namespace spacetow::disk {

/// Asked before each call, by its name; answers with the code that the call is to fail with, 0 for none.
using Fault = int (*)(std::string_view call);
/// For tests; null for none. Concerns the whole program.
void setFault(Fault fault);

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : m_number(number) {}
    Descriptor(Descriptor&& other) noexcept : m_number(std::exchange(other.m_number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(m_number, other.m_number);
        return *this;
    }
    ~Descriptor();

    bool isOpen() const { return m_number >= 0; }
    int number() const { return m_number; }

  private:
    int m_number;
};

/// As of open(2); permissions are those of a file that is created.
struct OpenMode {
    int flags = 0;
    mode_t permissions = 0;
};

/// Relative to the folder; closed on exec.
int openAt(Descriptor& out, const Descriptor& folder, const std::string& name, const OpenMode& mode);
int writeAll(const Descriptor& file, std::string_view text, off_t at);
/// For what has no places: pipes and devices.
int writeOn(const Descriptor& stream, std::string_view text);
/// From here to the end, or to one byte more than `most`.
int readAll(std::string& out, const Descriptor& file, std::size_t most);
/// To the disk.
int flush(const Descriptor& file);
/// Has room set aside for `size` bytes, where the file system can, without changing the file.
int reserve(const Descriptor& file, off_t size);
int resize(const Descriptor& file, off_t size);
int renameAt(const Descriptor& folder, const std::string& from, const std::string& to);
/// Fails where the new name is taken.
int renameToFreeName(const Descriptor& folder, const std::string& from, const std::string& to);
int removeAt(const Descriptor& folder, const std::string& name);
/// Gives `copy` the owner, group, mode, extended attributes and access lists of `original`, whose `info` this is. Fails
/// when any of them cannot be given.
int keepAttributes(const Descriptor& copy, const Descriptor& original, const struct stat& info);

} // namespace spacetow::disk
