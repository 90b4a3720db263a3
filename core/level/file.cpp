#include "core/level/file.h"

#include "core/level/codes.h"
#include "core/level/fields.h"
#include "core/level/groups.h"
#include "core/level/json_read.h"
#include "core/level/json_write.h"
#include "core/level/lint.h"
#include "core/level/lint_findings.h"
#include "core/level/migrate.h"
#include "core/level/tag_edits.h"

#include <algorithm>
#include <array>

namespace spacetow {

static_assert(levelSchema == newestSchema);

namespace {

constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";

void errorsFirst(std::vector<Problem>& problems) {
    std::stable_partition(problems.begin(), problems.end(),
                          [](const Problem& p) { return p.severity == Severity::Error; });
}

/// Leaves at most `maxProblems`, errors before warnings, in the order of their lines. `unlisted` are not among them.
void trim(std::vector<Problem>& problems, std::size_t unlisted = 0) {
    if (problems.size() > maxProblems || unlisted > 0) {
        const std::size_t total = problems.size() + unlisted;
        errorsFirst(problems);
        problems.resize(std::min(problems.size(), maxProblems));
        Problem more;
        more.severity = Severity::Warning;
        more.code = "more-problems";
        more.arguments = {std::to_string(total - problems.size())};
        more.line = problems.back().line;
        problems.push_back(std::move(more));
    }
    std::ranges::stable_sort(problems, {}, &Problem::line);
}

/// Whether a file may, by its size, say more than this program can write down for another reading: missing fields are
/// written too, and blanks.
bool mayBeTooLargeToSave(std::string_view text, const JsonTree& tree) {
    constexpr std::size_t growth = 8; // of a text, at most
    constexpr std::size_t valueGrowth = 3;
    return text.size() > maxLevelBytes / growth || tree.size() > JsonTree::maxValues / valueGrowth;
}

std::size_t vertexCount(const Level& level) {
    std::size_t count = 0;
    for (const Object& object : level.objects) {
        if (const auto* body = std::get_if<BodyObject>(&object.data)) {
            for (const LevelShape& shape : body->shapes) {
                std::visit(
                    [&count](const auto& part) {
                        if constexpr (requires { part.vertices; }) {
                            count += part.vertices.size();
                        }
                    },
                    shape);
            }
        }
    }
    return count;
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
    if (file.level && mayBeTooLargeToSave(text, tree) && !savableText(*file.level)) {
        file.problems.push_back({Severity::Error, "too-large-to-save", {}, "", 1, 0});
        file.level.reset();
    }
    if (file.level && checks == Checks::All) {
        std::vector<Problem> found = lint(*file.level);
        errorsFirst(found);
        auto errors = static_cast<std::size_t>(std::ranges::count(file.problems, Severity::Error, &Problem::severity));
        for (Problem& problem : found) {
            // Lines of problems that are going to be trimmed need not be looked up; errors are the last to go.
            const std::size_t before = problem.severity == Severity::Error ? errors++ : file.problems.size();
            problem.line = before <= maxProblems ? tree.lineAt(problem.pointer) : 1;
            file.problems.push_back(std::move(problem));
        }
    }
    trim(file.problems, reading.unlisted);
    return file;
}

std::string levelText(const Level& level) {
    return writtenLevel(level).laidOut();
}

std::optional<Error> saveError(const Level& level) {
    constexpr std::array<LevelCode, 3> unreadable{"not-finite", "bad-tag-name", "duplicate-tag"};
    if (vertexCount(level) > static_cast<std::size_t>(limits::vertices)) {
        return Error{LevelCode("too-many-vertices"), {std::to_string(limits::vertices)}};
    }
    Findings findings;
    checkRanges(level, findings);
    checkTags(level, findings);
    for (const Problem& problem : std::move(findings).sorted()) {
        if (std::ranges::find(unreadable, problem.code) != unreadable.end()) {
            return Error{problem.code, problem.arguments};
        }
    }
    return {};
}

Result<std::string> savableText(const Level& level) {
    if (std::optional<Error> error = saveError(level)) {
        return *std::move(error);
    }
    std::string text = levelText(level);
    if (text.size() > maxLevelBytes) {
        return Error{LevelCode("text-too-large"), {std::to_string(maxLevelBytes)}};
    }
    // As many vertices as a file may have take at least so many bytes, as many values take more.
    constexpr std::size_t always = std::size_t{6} * limits::vertices;
    if (text.size() >= always) {
        const auto parsed = JsonTree::parsed(text);
        if (const auto* problem = std::get_if<Problem>(&parsed)) {
            return Error{problem->code, problem->arguments};
        }
    }
    return text;
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
