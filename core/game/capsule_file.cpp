// The spelling of capsules.
#include "core/game/capsule.h"
#include "core/game/codes.h"
#include "core/level/file.h"
#include "core/level/problem_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>

namespace spacetow {

namespace {

using CapsuleValue = nlohmann::json;

constexpr int deepestInCapsule = 2;

struct BadCapsuleField {
    const char* name;
};
struct CapsuleTooDeep {};

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

std::uint64_t hashOf(const std::string& text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, 16);
    const bool fits = text.size() == 16 && error == std::errc() && end == text.data() + text.size();
    return fits ? number : throw BadCapsuleField{"hash"};
}

bool isSimulation(const CapsuleValue& object) {
    const auto found = object.find("simulation");
    if (found != object.end() && !found->is_boolean()) {
        throw BadCapsuleField{"simulation"};
    }
    return found != object.end() && found->get<bool>();
}

Result<Capsule> capsuleFrom(const CapsuleValue& json) {
    if (!json.is_object()) {
        return Error{GameCode("capsule-damaged"), {}};
    }
    const CapsuleValue& version = memberOf(json, "capsule");
    if (!version.is_number_unsigned()) {
        return Error{GameCode("capsule-bad-field"), {"capsule"}};
    }
    if (version.get<std::uint64_t>() > static_cast<std::uint64_t>(capsuleVersion)) {
        return Error{GameCode("capsule-newer"), {version.dump(), std::to_string(capsuleVersion)}};
    }
    LevelFile file = parseLevel(textOf(json, "level"), Checks::FileOnly);
    if (!file.level) {
        return errorOf(GameCode("capsule-bad-level"),
                       *std::ranges::find(file.problems, Severity::Error, &Problem::severity));
    }
    Result<Replay> run = parseReplay(textOf(json, "run"));
    if (!run) {
        return run.error();
    }
    Replay replay = std::move(run).value();
    replay.kind = isSimulation(json) ? RunKind::Simulation : replay.kind;
    return Capsule{textOf(json, "program"), textOf(json, "platform"),
                   std::make_shared<const Level>(std::move(*file.level)), std::move(replay),
                   hashOf(textOf(json, "hash"))};
}

} // namespace

Result<std::string> capsuleJson(const Capsule& capsule) {
    Result<std::string> level = savableText(*capsule.level);
    if (!level) {
        return level.error();
    }
    if (capsule.run.updates() > maxReplayUpdates) {
        return Error{GameCode("capsule-too-long"), {std::to_string(maxReplayUpdates)}};
    }
    char hash[17];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(capsule.hash));
    CapsuleValue json = CapsuleValue::object();
    json["capsule"] = capsuleVersion;
    json["program"] = capsule.program;
    json["platform"] = capsule.platform;
    json["hash"] = hash;
    json["simulation"] = capsule.run.kind == RunKind::Simulation;
    json["level"] = level.value();
    Replay run = capsule.run;
    run.kind = RunKind::Game; // so that programs which do not know of kinds read it
    json["run"] = replayText(run);
    return json.dump(-1, ' ', false, CapsuleValue::error_handler_t::replace);
}

Result<Capsule> parseCapsule(std::string_view json) {
    try {
        const auto bounded = [](int depth, CapsuleValue::parse_event_t, CapsuleValue&) {
            return depth <= deepestInCapsule ? true : throw CapsuleTooDeep{};
        };
        return capsuleFrom(CapsuleValue::parse(json.begin(), json.end(), bounded));
    } catch (const BadCapsuleField& bad) {
        return Error{GameCode("capsule-bad-field"), {bad.name}};
    } catch (const CapsuleTooDeep&) {
        return Error{GameCode("capsule-damaged"), {}};
    } catch (const CapsuleValue::exception&) {
        return Error{GameCode("capsule-damaged"), {}};
    }
}

} // namespace spacetow
