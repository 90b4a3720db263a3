// The spelling of capsules.
#include "core/game/capsule.h"
#include "core/level/file.h"
#include "core/level/key_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace spacetow {

namespace {

using CapsuleValue = nlohmann::json;

constexpr int deepestInCapsule = 5;

struct BadCapsuleField {
    const char* name;
};
struct CapsuleTooDeep {};

// What differs between two texts, as one stretch of lines.

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

struct LineEdit {
    std::size_t line = 0;
    std::size_t without = 0;
    std::string lines;
};

LineEdit lineEdit(std::string_view before, std::string_view after) {
    const std::vector<std::string_view> old = linesOf(before);
    const std::vector<std::string_view> now = linesOf(after);
    const auto same = std::ranges::mismatch(old, now);
    const auto front = static_cast<std::size_t>(same.in1 - old.begin());
    std::size_t back = 0;
    while (back < std::min(old.size(), now.size()) - front &&
           old[old.size() - 1 - back] == now[now.size() - 1 - back]) {
        ++back;
    }
    LineEdit edit{front, old.size() - front - back, {}};
    for (std::size_t i = front; i < now.size() - back; ++i) {
        edit.lines += now[i];
    }
    return edit;
}

std::string withLines(std::string_view before, const LineEdit& edit) {
    const std::vector<std::string_view> old = linesOf(before);
    if (edit.line > old.size() || edit.without > old.size() - edit.line) {
        throw BadCapsuleField{"edits"};
    }
    std::string text;
    for (std::size_t i = 0; i < edit.line; ++i) {
        text += old[i];
    }
    text += edit.lines;
    for (std::size_t i = edit.line + edit.without; i < old.size(); ++i) {
        text += old[i];
    }
    return text;
}

// Writing

CapsuleValue controlsJson(const Capsule& capsule) {
    CapsuleValue list = CapsuleValue::array();
    for (std::size_t i = 0; i < capsule.inputs.size();) {
        const Controls controls = capsule.inputs[i].controls;
        std::size_t end = i;
        while (end < capsule.inputs.size() && capsule.inputs[end].controls == controls) {
            ++end;
        }
        list.push_back(CapsuleValue::array({toBits(controls), end - i}));
        i = end;
    }
    return list;
}

CapsuleValue grabsJson(const Capsule& capsule) {
    CapsuleValue list = CapsuleValue::array();
    const auto holdsAlike = [&capsule](std::size_t a, std::size_t b) {
        const std::optional<Grab>& one = capsule.inputs[a].grab;
        const std::optional<Grab>& other = capsule.inputs[b].grab;
        return one && other && one->object == other->object && one->anchor == other->anchor;
    };
    for (std::size_t i = 0; i < capsule.inputs.size();) {
        if (!capsule.inputs[i].grab) {
            ++i;
            continue;
        }
        const Grab first = *capsule.inputs[i].grab;
        CapsuleValue targets = CapsuleValue::array();
        std::size_t end = i;
        for (; end < capsule.inputs.size() && holdsAlike(i, end); ++end) {
            targets.push_back(capsule.inputs[end].grab->target.x());
            targets.push_back(capsule.inputs[end].grab->target.y());
        }
        list.push_back(
            CapsuleValue::array({i, keyText(first.object), first.anchor.x(), first.anchor.y(), std::move(targets)}));
        i = end;
    }
    return list;
}

/// Each level is written as what makes it out of the one before.
class LevelTexts {
  public:
    /// What kept one from being written, if anything.
    std::optional<Error> error;

    std::string next(const Level& level) {
        Result<std::string> text = savableText(level);
        if (!text) {
            error = text.error();
            return m_last;
        }
        m_sum += text.value().size();
        if (m_sum > maxCapsuleLevels) {
            error = Error{"capsule-too-large", {std::to_string(maxCapsuleLevels)}};
        }
        return m_last = std::move(text).value();
    }
    CapsuleValue edits(const std::vector<StepInput>& inputs) {
        CapsuleValue list = CapsuleValue::array();
        for (std::size_t i = 0; i < inputs.size() && !error; ++i) {
            if (inputs[i].level) {
                const std::string before = m_last;
                const LineEdit edit = lineEdit(before, next(*inputs[i].level));
                list.push_back(CapsuleValue::array({i, edit.line, edit.without, edit.lines}));
            }
        }
        if (list.size() > maxCapsuleEdits || inputs.size() > static_cast<std::size_t>(maxCapsuleUpdates)) {
            error = Error{"capsule-too-long", {std::to_string(maxCapsuleUpdates)}};
        }
        return list;
    }

  private:
    std::string m_last;
    std::size_t m_sum = 0;
};

// Reading

const CapsuleValue& memberOf(const CapsuleValue& object, const char* name) {
    const auto found = object.find(name);
    if (found == object.end()) {
        throw BadCapsuleField{name};
    }
    return *found;
}

std::string textOf(const CapsuleValue& object, const char* name) {
    const CapsuleValue& value = memberOf(object, name);
    return value.is_string() ? value.get<std::string>() : throw BadCapsuleField{name};
}

const CapsuleValue& listOf(const CapsuleValue& object, const char* name) {
    const CapsuleValue& value = memberOf(object, name);
    return value.is_array() ? value : throw BadCapsuleField{name};
}

/// A row of so many values.
const CapsuleValue& rowOf(const CapsuleValue& row, std::size_t size, const char* name) {
    return row.is_array() && row.size() == size ? row : throw BadCapsuleField{name};
}

std::size_t countOf(const CapsuleValue& value, std::size_t most, const char* name) {
    const bool fits = value.is_number_unsigned() && value.get<std::uint64_t>() <= most;
    return fits ? static_cast<std::size_t>(value.get<std::uint64_t>()) : throw BadCapsuleField{name};
}

double numberOf(const CapsuleValue& value, const char* name) {
    const bool fits = value.is_number() && std::isfinite(value.get<double>());
    return fits ? value.get<double>() : throw BadCapsuleField{name};
}

std::uint64_t hashOf(const std::string& text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    const bool fits = text.size() == 16 && error == std::errc() && end == text.data() + text.size();
    return fits ? number : throw BadCapsuleField{"hash"};
}

/// False when there are too many.
bool readControls(const CapsuleValue& list, Capsule& capsule) {
    for (const CapsuleValue& row : list) {
        rowOf(row, 2, "controls");
        const std::size_t bits = countOf(row[0], 15, "controls");
        const std::size_t count = countOf(row[1], std::size_t{1} << 40, "controls");
        if (count > static_cast<std::size_t>(maxCapsuleUpdates) - capsule.inputs.size()) {
            return false;
        }
        for (std::size_t i = 0; i < count; ++i) {
            capsule.inputs.emplace_back().controls = controlsFromBits(static_cast<std::uint8_t>(bits));
        }
    }
    return true;
}

void readGrabs(const CapsuleValue& list, Capsule& capsule) {
    for (const CapsuleValue& row : list) {
        rowOf(row, 5, "grabs");
        const std::size_t from = countOf(row[0], capsule.inputs.size(), "grabs");
        const std::optional<Key> object = row[1].is_string() ? keyFromText(row[1].get<std::string>()) : std::nullopt;
        const CapsuleValue& targets = row[4];
        if (!object || !targets.is_array() || targets.size() % 2 != 0 ||
            targets.size() / 2 > capsule.inputs.size() - from) {
            throw BadCapsuleField{"grabs"};
        }
        const Vec2 anchor(numberOf(row[2], "grabs"), numberOf(row[3], "grabs"));
        for (std::size_t i = 0; i < targets.size() / 2; ++i) {
            const Vec2 target(numberOf(targets[2 * i], "grabs"), numberOf(targets[2 * i + 1], "grabs"));
            capsule.inputs[from + i].grab = Grab{*object, anchor, target};
        }
    }
}

/// Null for a text that is no level.
std::shared_ptr<const Level> levelOf(const std::string& text) {
    LevelFile file = parseLevel(text, Checks::FileOnly);
    return file.level ? std::make_shared<const Level>(std::move(*file.level)) : nullptr;
}

bool readEdits(const CapsuleValue& list, std::string text, Capsule& capsule) {
    if (list.size() > maxCapsuleEdits) {
        throw BadCapsuleField{"edits"};
    }
    std::size_t sum = text.size();
    for (const CapsuleValue& row : list) {
        rowOf(row, 4, "edits");
        const std::size_t update = countOf(row[0], capsule.inputs.size(), "edits");
        if (update == capsule.inputs.size() || !row[3].is_string()) {
            throw BadCapsuleField{"edits"};
        }
        text = withLines(text, {countOf(row[1], text.size(), "edits"), countOf(row[2], text.size(), "edits"),
                                row[3].get<std::string>()});
        sum += text.size();
        capsule.inputs[update].level = sum <= maxCapsuleLevels ? levelOf(text) : nullptr;
        if (!capsule.inputs[update].level) {
            return false;
        }
    }
    return true;
}

Result<Capsule> capsuleFrom(const CapsuleValue& json) {
    if (!json.is_object()) {
        return Error{"capsule-damaged", {}};
    }
    const std::size_t version = countOf(memberOf(json, "capsule"), std::size_t{1} << 62, "capsule");
    if (version > static_cast<std::size_t>(capsuleVersion)) {
        return Error{"capsule-newer", {std::to_string(version), std::to_string(capsuleVersion)}};
    }
    const CapsuleValue& seed = memberOf(json, "seed");
    if (!seed.is_number_unsigned()) {
        return Error{"capsule-bad-field", {"seed"}};
    }
    const std::string text = textOf(json, "level");
    Capsule capsule{textOf(json, "program"),     textOf(json, "platform"),
                    textOf(json, "name"),        levelOf(text),
                    seed.get<std::uint64_t>(),   {},
                    hashOf(textOf(json, "hash"))};
    if (!capsule.level) {
        return Error{"capsule-bad-level", {}};
    }
    if (!readControls(listOf(json, "controls"), capsule)) {
        return Error{"capsule-too-long", {std::to_string(maxCapsuleUpdates)}};
    }
    readGrabs(listOf(json, "grabs"), capsule);
    if (!readEdits(listOf(json, "edits"), text, capsule)) {
        return Error{"capsule-bad-level", {}};
    }
    return capsule;
}

} // namespace

Result<std::string> capsuleJson(const Capsule& capsule) {
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(capsule.hash));
    LevelTexts levels;
    CapsuleValue json = CapsuleValue::object();
    json["capsule"] = capsuleVersion;
    json["program"] = capsule.program;
    json["platform"] = capsule.platform;
    json["name"] = capsule.name;
    json["seed"] = capsule.seed;
    json["hash"] = hash;
    json["level"] = levels.next(*capsule.level);
    json["controls"] = controlsJson(capsule);
    json["grabs"] = grabsJson(capsule);
    json["edits"] = levels.edits(capsule.inputs);
    if (levels.error) {
        return *levels.error;
    }
    return json.dump(-1, ' ', false, CapsuleValue::error_handler_t::replace);
}

Result<Capsule> parseCapsule(std::string_view json) {
    try {
        const auto bounded = [](int depth, CapsuleValue::parse_event_t, CapsuleValue&) {
            return depth <= deepestInCapsule ? true : throw CapsuleTooDeep{};
        };
        return capsuleFrom(CapsuleValue::parse(json.begin(), json.end(), bounded));
    } catch (const BadCapsuleField& bad) {
        return Error{"capsule-bad-field", {bad.name}};
    } catch (const CapsuleTooDeep&) {
        return Error{"capsule-damaged", {}};
    } catch (const CapsuleValue::exception&) {
        return Error{"capsule-damaged", {}};
    }
}

} // namespace spacetow
