#pragma once
// Whole files on disk (POSIX), read and written at once. At any moment, be it of a crash or of a power cut, a file that
// is written holds what it held before or what it is to hold, and everything else about it stays: owner, group, mode,
// attributes, links to it. Sizes in bytes.

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace spacetow {

/// Tells whether a file is still the one that was seen.
struct FileStamp {
    bool exists = false;
    std::uint64_t device = 0;
    std::uint64_t number = 0; // on the device
    std::uint64_t size = 0;
    std::int64_t modified = 0; // ns

    bool operator==(const FileStamp&) const = default;
};

/// Of the file that links lead to.
FileStamp stampOf(const std::filesystem::path& path);

struct ReadText {
    std::string text;
    FileStamp stamp;
};

/// What may be read: files alone, which cannot keep the reader waiting, or pipes and devices as well.
enum class Sources : std::uint8_t { Files, Any };

/// Codes: "cannot-read" (path, reason), "file-too-large" (path, most).
Result<ReadText> readFile(const std::filesystem::path& path, std::size_t most, Sources sources = Sources::Files);

/// Writes a file beside, flushes it and puts it in the place of the old one; links are followed. Where that cannot be,
/// or would take something from the file (its owner, its other hard links), it is written in place; what was there is
/// put back if that fails. With `known`, only a file that is still that one is replaced. Gives what it is now.
/// Codes: "changed-on-disk" (path), "disk-full" (path), "quota-full" (path), "disk-read-only" (path), "folder-missing"
/// (path, folder), "folder-protected" (path, folder), "file-protected" (path), "cannot-write" (path, reason): the old
/// file is whole; "file-damaged" (path, reason), "file-damaged-but-beside" (path, reason, file that holds the text): it
/// is not.
Result<FileStamp> writeFile(const std::filesystem::path& path, std::string_view text,
                            const std::optional<FileStamp>& known = {});

/// Pipes and devices are written on, and so is what standard output goes to; all else as writeFile does.
std::optional<Error> writeFileOrStream(const std::filesystem::path& path, std::string_view text);
/// Whether this names what standard output goes to.
bool isStandardOutput(const std::filesystem::path& path);

} // namespace spacetow
