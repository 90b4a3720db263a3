#pragma once
// Level files: JSON as laid down in levels/README.md. Reading reports every problem with its line and JSON pointer;
// writing is atomic. A file that the program wrote, read and saved unchanged, is the same to the byte.

#include "core/base/whole_file.h"
#include "core/level/adopt_tags.h"
#include "core/level/problem.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spacetow {

constexpr int levelSchema = 2;
constexpr std::size_t maxLevelBytes = 128u << 20; // larger files are refused unread

/// What a file says. There is a level unless something in the file cannot be understood without guessing.
struct LevelFile {
    std::optional<Level> level;
    std::vector<Problem> problems; // of the file, then of lint, in the order of their lines
    FileStamp stamp;               // of the file that was read from disk
};

/// What is looked for in a file that is read: also what lint finds, with its lines, or only what keeps the file from
/// saying what was meant, for those who ask lint themselves.
enum class Checks : std::uint8_t { All, FileOnly };

LevelFile parseLevel(std::string_view text, Checks checks = Checks::All);
/// The text of the file, newline at the end. Shortest round-trip numbers, keys in fixed order.
std::string levelText(const Level& level);

/// The same, of a level whose file could be read again. Codes: those of saveError, "text-too-large" (bytes allowed),
/// "too-many-values" (number allowed), "too-many-vertices".
Result<std::string> savableText(const Level& level);

/// Codes: those of readFile.
Result<LevelFile> readLevel(const std::filesystem::path& path, Checks checks = Checks::All,
                            Sources sources = Sources::Files);
/// Replaces the file as writeFile does, so that it is whole whatever happens; with `known`, only while it is still that
/// one. Gives what the file is now. Codes: those of writeFile and of savableText.
Result<FileStamp> savedLevel(const std::filesystem::path& path, const Level& level,
                             const std::optional<FileStamp>& known = {});
/// Likewise, for those who do not care what the file is then.
std::optional<Error> writeLevel(const std::filesystem::path& path, const Level& level);

/// Why a file of the level could not be read again. Codes: "not-finite" (field), "bad-tag-name" (name),
/// "duplicate-tag" (name), "too-many-vertices" (number allowed).
std::optional<Error> saveError(const Level& level);

/// Objects as text and back, for the clipboard; the text says the names of their tags. Parsing gives the objects that
/// have no error, with the tags that the text tells of and those it only names.
std::string objectsText(const Level& level, std::span<const Key> keys);
ForeignObjects parseObjects(std::string_view text, std::vector<Problem>& problems);

} // namespace spacetow
