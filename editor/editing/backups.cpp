#include "editor/editing/backups.h"

#include "core/base/codes.h"
#include "core/base/system_reason.h"
#include "core/level/file_state.h"

#include <sys/stat.h>

#include <algorithm>
#include <charconv>

namespace spacetow {

namespace {

namespace fs = std::filesystem;

/// A folder for each file: its name for people, its whole path as a number.
fs::path folderOf(const fs::path& folder, const fs::path& path) {
    constexpr std::size_t longest = 60; // bytes
    std::uint64_t number = contentHash(path.string());
    std::string digits;
    for (int i = 0; i < 16; ++i, number >>= 4) {
        digits += "0123456789abcdef"[number & 15];
    }
    return folder / (path.stem().string().substr(0, longest) + '-' + digits);
}

std::optional<std::int64_t> timeIn(const fs::path& backup) {
    const std::string name = backup.stem().string();
    std::int64_t time = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), time);
    const bool whole = error == std::errc() && end == name.data() + name.size() && backup.extension() == ".json";
    return whole ? std::optional(time) : std::nullopt;
}

std::int64_t savedAt(const fs::path& path) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0
               ? static_cast<std::int64_t>(info.st_mtim.tv_sec) * 1000 + info.st_mtim.tv_nsec / 1'000'000
               : 0;
}

} // namespace

std::vector<Backup> backupsOf(const fs::path& folder, const fs::path& path) {
    std::vector<Backup> backups;
    std::error_code error;
    for (fs::directory_iterator it(folderOf(folder, path), error), end; !error && it != end; it.increment(error)) {
        if (const std::optional<std::int64_t> time = timeIn(it->path())) {
            std::error_code gone;
            const std::uintmax_t size = fs::file_size(it->path(), gone);
            backups.push_back({it->path(), *time, gone ? 0 : size});
        }
    }
    std::ranges::sort(backups, std::ranges::greater(), &Backup::time);
    return backups;
}

std::optional<Error> backUp(const fs::path& folder, const fs::path& path) {
    const FileState state = fileState(path);
    std::vector<Backup> backups = backupsOf(folder, path);
    if (!state.exists() || (!backups.empty() && fileState(backups.front().file).sameContent(state))) {
        return {};
    }
    const fs::path own = folderOf(folder, path);
    // Two versions of one moment, or a clock that was put back: what is kept last is the newest all the same.
    const std::int64_t time = std::max(savedAt(path), backups.empty() ? 0 : backups.front().time + 1);
    const fs::path backup = own / (std::to_string(time) + ".json");
    const fs::path unfinished = own / "unfinished";
    std::error_code error;
    fs::create_directories(own, error);
    if (!error) {
        fs::copy_file(path, unfinished, fs::copy_options::overwrite_existing, error);
    }
    if (!error) {
        fs::rename(unfinished, backup, error);
    }
    if (error) {
        return Error{BaseCode("cannot-write"), {backup.string(), systemReason(error.value())}};
    }
    for (std::size_t i = maxBackups - 1; i < backups.size(); ++i) {
        fs::remove(backups[i].file, error);
    }
    return {};
}

} // namespace spacetow
