#pragma once
// Former versions of files, kept in the user's state folder: each save puts aside what it replaces.

#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace spacetow {

constexpr std::size_t maxBackups = 20; // of one file; the oldest go

struct Backup {
    std::filesystem::path file;
    std::int64_t time = 0; // ms since 1970, when this version was saved
    std::uintmax_t size = 0;
};

/// Copies what stands in the file now; does nothing when there is no file or when the newest backup holds the same.
/// `path` is absolute. Code: "cannot-write" (path, reason).
std::optional<Error> backUp(const std::filesystem::path& folder, const std::filesystem::path& path);
/// Newest first.
std::vector<Backup> backupsOf(const std::filesystem::path& folder, const std::filesystem::path& path);

} // namespace spacetow
