// Level files on disk.

#include "core/level/file.h"

namespace spacetow {

namespace fs = std::filesystem;

Result<LevelFile> readLevel(const fs::path& path, Checks checks, Sources sources) {
    const Result<ReadText> read = readFile(path, maxLevelBytes, sources);
    if (!read) {
        return read.error();
    }
    LevelFile file = parseLevel(read.value().text, checks);
    file.stamp = read.value().stamp;
    return file;
}

Result<FileStamp> savedLevel(const fs::path& path, const Level& level, const std::optional<FileStamp>& known) {
    const Result<std::string> text = savableText(level);
    return text ? writeFile(path, text.value(), known) : Result<FileStamp>(text.error());
}

std::optional<Error> writeLevel(const fs::path& path, const Level& level) {
    const Result<FileStamp> saved = savedLevel(path, level);
    return saved ? std::nullopt : std::optional(saved.error());
}

} // namespace spacetow
