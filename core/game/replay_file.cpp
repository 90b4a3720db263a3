// Recorded flights are read.

#include "core/game/codes.h"
#include "core/game/replay.h"
#include "core/game/replay_words.h"
#include "core/level/file.h"
#include "core/level/key_text.h"
#include "core/level/problem_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace spacetow {
namespace {

using Json = nlohmann::json;

constexpr int deepest = 4; // a replay is an object of arrays of arrays, of arrays at most; its end is an object

struct BadField {
    std::string pointer;
};
struct TooDeep {};
struct WrongField {
    GameCode code;
    std::string name;
};

/// The members of a replay, or of its end, each once and none else: what is not understood here would be dropped by the
/// next save, and of two seeds nobody knows which was flown.
class FieldsSeen {
  public:
    explicit FieldsSeen(std::vector<std::string_view> known) : m_known(std::move(known)) {}

    void see(const std::string& name) {
        if (std::ranges::find(m_seen, name) != m_seen.end()) {
            throw WrongField{"replay-duplicate-field", name};
        }
        m_seen.push_back(name);
        m_hasUnknown = m_hasUnknown || std::ranges::find(m_known, name) == m_known.end();
        m_unknown = m_hasUnknown && m_unknown.empty() ? name : m_unknown;
    }
    void finish() const {
        if (m_hasUnknown) {
            throw WrongField{"replay-unknown-field", m_unknown};
        }
    }

  private:
    std::vector<std::string_view> m_known;
    std::vector<std::string> m_seen;
    bool m_hasUnknown = false;
    std::string m_unknown;
};

const Json& member(const Json& object, const char* name, const std::string& pointer = {}) {
    const auto found = object.find(name);
    if (found == object.end()) {
        throw BadField{pointer + '/' + name};
    }
    return *found;
}

/// A whole number from `least` to `most`.
std::int64_t integer(const Json& value, std::int64_t least, std::int64_t most, const std::string& pointer) {
    const bool fits = value.is_number_integer() &&
                      (!value.is_number_unsigned() || value.get<std::uint64_t>() <= static_cast<std::uint64_t>(most));
    if (!fits || value.get<std::int64_t>() < least || value.get<std::int64_t>() > most) {
        throw BadField{pointer};
    }
    return value.get<std::int64_t>();
}

std::uint64_t fromHex(const Json& value, const char* pointer) {
    std::uint64_t number = 0;
    const std::string text = value.is_string() ? value.get<std::string>() : std::string();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    if (text.size() != 16 || error != std::errc() || end != text.data() + text.size()) {
        throw BadField{pointer};
    }
    return number;
}

std::vector<Replay::Run> runsFrom(const Json& list) {
    if (!list.is_array()) {
        throw BadField{"/updates"};
    }
    std::vector<Replay::Run> runs;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string pointer = "/updates/" + std::to_string(i);
        if (!list[i].is_array() || list[i].size() != 2) {
            throw BadField{pointer};
        }
        const std::int64_t bits = integer(list[i][0], 0, 15, pointer + "/0");
        const std::int64_t count = integer(list[i][1], 1, std::int64_t{1} << 62, pointer + "/1");
        runs.push_back({controlsFromBits(static_cast<std::uint8_t>(bits)), count});
    }
    return runs;
}

std::vector<Key> keysFrom(const Json& list, const std::string& pointer) {
    std::vector<Key> keys;
    if (!list.is_array()) {
        throw BadField{pointer};
    }
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::optional<Key> key =
            list[i].is_string() ? keyFromText(list[i].get_ref<const std::string&>()) : std::nullopt;
        if (!key) {
            throw BadField{pointer + '/' + std::to_string(i)};
        }
        keys.push_back(*key);
    }
    return keys;
}

/// The list of this name, each entry an array that begins with an update later than the one before.
template <class Read>
void readUpdates(const Json& json, const std::string& name, const Read& read) {
    const auto list = json.find(name);
    if (list == json.end()) {
        return;
    }
    if (!list->is_array()) {
        throw BadField{'/' + name};
    }
    std::int64_t least = 0;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::string pointer = '/' + name + '/' + std::to_string(i);
        const Json& entry = (*list)[i];
        if (!entry.is_array() || entry.empty()) {
            throw BadField{pointer};
        }
        const std::int64_t update = integer(entry[0], least, maxReplayUpdates, pointer + "/0");
        read(update, entry, pointer);
        least = update + 1;
    }
}

Replay::Hold holdFrom(std::int64_t update, const Json& entry, const std::string& pointer) {
    if (entry.size() == 1) {
        return {update, {}};
    }
    const std::optional<Key> key =
        entry.size() == 6 && entry[1].is_string() ? keyFromText(entry[1].get_ref<const std::string&>()) : std::nullopt;
    if (!key) {
        throw BadField{pointer};
    }
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!entry[i + 2].is_number()) {
            throw BadField{pointer + '/' + std::to_string(i + 2)};
        }
        numbers[i] = entry[i + 2].get<double>();
    }
    return {update, Grab{*key, Vec2(numbers[0], numbers[1]), Vec2(numbers[2], numbers[3])}};
}

Replay::Edit editFrom(std::int64_t update, const Json& entry, const std::string& pointer) {
    if (entry.size() != 4 || !entry[1].is_string()) {
        throw BadField{pointer};
    }
    LevelFile file = parseLevel(entry[1].get_ref<const std::string&>(), Checks::FileOnly);
    // A level that could not be written as it is was not written by anybody.
    if (!file.level || parseLevel(levelText(*file.level), Checks::FileOnly).level != file.level) {
        throw BadField{pointer + "/1"};
    }
    return {update, {keysFrom(entry[2], pointer + "/2"), *std::move(file.level), keysFrom(entry[3], pointer + "/3")}};
}

RunKind kindFrom(const Json& value) {
    for (const auto& [kind, name] : replay_words::kinds) {
        if (value == name) {
            return kind;
        }
    }
    throw BadField{"/kind"};
}

FlightEnd outcomeFrom(const Json& value) {
    for (const auto& [end, name] : replay_words::outcomes) {
        if (value == name) {
            return end;
        }
    }
    throw BadField{"/end/outcome"};
}

FlightResult endFrom(const Json& json) {
    if (!json.is_object()) {
        throw BadField{"/end"};
    }
    const auto seconds = [&json](const char* name) {
        const Json& value = member(json, name, "/end");
        return value.is_number() && value.get<double>() >= 0 ? value.get<double>()
                                                             : throw BadField{std::string("/end/") + name};
    };
    FlightResult result;
    result.end = outcomeFrom(member(json, "outcome", "/end"));
    result.time = seconds("time");
    result.fuel = seconds("fuel");
    result.update = integer(member(json, "update", "/end"), 0, maxReplayUpdates, "/end/update");
    result.seconds = seconds("seconds");
    if (const auto place = json.find("place"); place != json.end()) {
        if (!place->is_array() || place->size() != 2 || !(*place)[0].is_number() || !(*place)[1].is_number()) {
            throw BadField{"/end/place"};
        }
        result.place = Vec2((*place)[0].get<double>(), (*place)[1].get<double>());
    }
    return result;
}

bool tooLong(const std::vector<Replay::Run>& runs) {
    std::int64_t sum = 0;
    for (const Replay::Run& run : runs) {
        if (run.count > maxReplayUpdates - sum) {
            return true;
        }
        sum += run.count;
    }
    return false;
}

Result<Replay> replayFrom(const Json& json) {
    if (!json.is_object()) {
        return Error{GameCode("replay-none"), {}};
    }
    const std::int64_t version = integer(member(json, "replay"), 1, std::int64_t{1} << 62, "/replay");
    if (version > replayVersion) {
        return Error{GameCode("replay-newer"), {std::to_string(version), std::to_string(replayVersion)}};
    }
    Replay replay;
    const Json& level = member(json, "level");
    if (!level.is_string()) {
        throw BadField{"/level"};
    }
    replay.level = level.get<std::string>();
    if (json.contains("levelHash")) {
        replay.levelHash = fromHex(json["levelHash"], "/levelHash");
    }
    const Json& seed = member(json, "seed");
    if (!seed.is_number_unsigned()) {
        throw BadField{"/seed"};
    }
    replay.seed = seed.get<std::uint64_t>();
    if (version == 1 && (json.contains("holds") || json.contains("edits"))) {
        throw WrongField{"replay-unknown-field", json.contains("holds") ? "holds" : "edits"};
    }
    if (version < 3 && json.contains("end")) {
        throw WrongField{"replay-unknown-field", "end"};
    }
    if (const auto kind = json.find("kind"); kind != json.end()) {
        if (version < 4) {
            throw WrongField{"replay-unknown-field", "kind"};
        }
        replay.kind = kindFrom(*kind);
    }
    replay.runs = runsFrom(member(json, "updates"));
    readUpdates(json, "holds", [&replay](std::int64_t update, const Json& entry, const std::string& pointer) {
        replay.holds.push_back(holdFrom(update, entry, pointer));
    });
    readUpdates(json, "edits", [&replay](std::int64_t update, const Json& entry, const std::string& pointer) {
        replay.edits.push_back(editFrom(update, entry, pointer));
    });
    if (const auto end = json.find("end"); end != json.end()) {
        replay.ended = endFrom(*end);
    }
    if (tooLong(replay.runs)) {
        return Error{GameCode("replay-too-long"), {std::to_string(maxReplayUpdates)}};
    }
    return replay;
}

/// The line of the second of two members of the same name, or of the only one.
int lineOfField(const JsonTree& tree, const WrongField& wrong) {
    if (wrong.code == "replay-duplicate-field") {
        for (const Problem& twice : tree.duplicateNames()) {
            if (twice.arguments.front() == wrong.name) {
                return twice.line;
            }
        }
    }
    const std::string segment = '/' + pointerSegment(wrong.name);
    return std::max(tree.lineAt(segment), tree.lineAt("/end" + segment));
}

/// `lineIn(tree)` of the text, or the first where it is no JSON behind what is wrong.
template <class LineIn>
std::string lineWhere(std::string_view text, const LineIn& lineIn) {
    const auto parsed = JsonTree::parsed(text);
    const auto* const tree = std::get_if<JsonTree>(&parsed);
    return std::to_string(tree == nullptr ? 1 : lineIn(*tree));
}

/// Why the library gave it up.
Error syntaxError(std::string_view text) {
    const auto parsed = JsonTree::parsed(text);
    if (const auto* const problem = std::get_if<Problem>(&parsed)) {
        return problem->code == "empty-file" ? Error{problem->code, {}} : errorOf(GameCode("not-sound-json"), *problem);
    }
    Problem tooDeep{.code = "nested-too-deep", .arguments = {std::to_string(deepest)}};
    tooDeep.line = std::max(1, lineDeeperThan(std::get<JsonTree>(parsed).root(), deepest));
    return errorOf(GameCode("not-sound-json"), tooDeep);
}

} // namespace

Result<Replay> parseReplay(std::string_view text) {
    try {
        FieldsSeen fields({"replay", "kind", "level", "levelHash", "seed", "updates", "holds", "edits", "end"});
        FieldsSeen endFields({"outcome", "time", "fuel", "update", "seconds", "place"});
        const auto bounded = [&fields, &endFields](int depth, Json::parse_event_t event, Json& value) {
            if (event == Json::parse_event_t::key && depth == 1) {
                fields.see(value.get<std::string>());
            } else if (event == Json::parse_event_t::key && depth == 2) {
                endFields.see(value.get<std::string>());
            }
            return depth <= deepest ? true : throw TooDeep{};
        };
        const Json json = Json::parse(text.begin(), text.end(), bounded);
        Result<Replay> replay = replayFrom(json);
        if (replay) {
            fields.finish();
            endFields.finish();
        }
        return replay;
    } catch (const WrongField& wrong) {
        return Error{wrong.code, {wrong.name, lineWhere(text, [&wrong](const JsonTree& tree) {
                                      return lineOfField(tree, wrong);
                                  })}};
    } catch (const BadField& bad) {
        const auto lineOf = [&bad](const JsonTree& tree) { return tree.lineAt(bad.pointer); };
        return Error{GameCode("replay-bad-field"), {bad.pointer, lineWhere(text, lineOf)}};
    } catch (const TooDeep&) {
        return syntaxError(text);
    } catch (const Json::exception&) {
        return syntaxError(text);
    }
}

Result<Replay> readReplay(const std::filesystem::path& path, Sources sources) {
    const Result<ReadText> read = readFile(path, maxReplayBytes, sources);
    return read ? parseReplay(read.value().text) : Result<Replay>(read.error());
}

std::optional<Error> writeReplay(const std::filesystem::path& path, const Replay& replay) {
    const Result<FileStamp> written = writeFile(path, replayText(replay));
    return written ? std::nullopt : std::optional(written.error());
}

} // namespace spacetow
