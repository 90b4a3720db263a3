#include "core/level/file.h"

#include "core/level/groups.h"
#include "core/level/json_read.h"
#include "core/level/json_write.h"
#include "core/level/lint.h"
#include "core/level/migrate.h"
#include "core/level/tag_edits.h"

#include <algorithm>

namespace spacetow {

static_assert(levelSchema == newestSchema);

namespace {

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

/// Leaves at most `maxProblems`, errors before warnings, in the order of their lines.
void trim(std::vector<Problem>& problems) {
    if (problems.size() > maxProblems) {
        const std::size_t total = problems.size();
        std::ranges::stable_partition(problems, [](const Problem& p) { return p.severity == Severity::Error; });
        problems.resize(maxProblems);
        Problem more;
        more.severity = Severity::Warning;
        more.code = "more-problems";
        more.arguments = {std::to_string(total - maxProblems)};
        more.line = problems.back().line;
        problems.push_back(std::move(more));
    }
    std::ranges::stable_sort(problems, {}, &Problem::line);
}

} // namespace

LevelFile parseLevel(std::string_view text, Checks checks) {
    LevelFile file;
    if (text.starts_with(byteOrderMark)) {
        text.remove_prefix(byteOrderMark.size());
        file.problems.push_back({Severity::Warning, "byte-order-mark", {}, "", 1, 0});
    }
    if (text.size() > maxLevelBytes) {
        file.problems.push_back({Severity::Error, "text-too-large", {std::to_string(maxLevelBytes)}, "", 1, 0});
        return file;
    }
    const auto parsed = JsonTree::parsed(text);
    if (const auto* problem = std::get_if<Problem>(&parsed)) {
        file.problems.push_back(*problem);
        return file;
    }
    const auto& tree = std::get<JsonTree>(parsed);
    LevelReading reading = readTree(tree);
    std::ranges::move(reading.problems, std::back_inserter(file.problems));
    file.level = std::move(reading.level);
    if (file.level && checks == Checks::All) {
        std::vector<Problem> found = lint(*file.level);
        std::ranges::stable_partition(found, [](const Problem& p) { return p.severity == Severity::Error; });
        for (Problem& problem : found) {
            // Lines of problems that are going to be trimmed need not be looked up.
            problem.line = file.problems.size() <= maxProblems ? tree.lineAt(problem.pointer) : 1;
            file.problems.push_back(std::move(problem));
        }
    }
    trim(file.problems);
    return file;
}

std::string levelText(const Level& level) {
    return writtenLevel(level).laidOut();
}

std::string objectsText(const Level& level, std::span<const Key> keys) {
    const std::vector<Key> wanted = withMembers(level, keys);
    JsonText json = JsonText::object();
    json.append("schema", JsonText::integer(newestSchema));
    JsonText objects = JsonText::array();
    TagMask used;
    for (const Object& object : level.objects) {
        if (std::ranges::binary_search(wanted, object.key)) {
            objects.append(writtenObject(object, level.tags));
            used = used | tagsInUse(object);
        }
    }
    json.append("tags", writtenTags(level.tags, used));
    json.append("objects", std::move(objects).broken());
    return std::move(json).broken().laidOut();
}

ForeignObjects parseObjects(std::string_view text, std::vector<Problem>& problems) {
    if (text.size() > maxLevelBytes) {
        problems.push_back({Severity::Error, "text-too-large", {std::to_string(maxLevelBytes)}, "", 1, 0});
        return {};
    }
    const auto parsed = JsonTree::parsed(text);
    if (const auto* problem = std::get_if<Problem>(&parsed)) {
        problems.push_back(*problem);
        return {};
    }
    std::vector<Problem> found;
    ForeignObjects objects = readObjects(std::get<JsonTree>(parsed), found);
    trim(found);
    std::ranges::move(found, std::back_inserter(problems));
    return objects;
}

} // namespace spacetow
