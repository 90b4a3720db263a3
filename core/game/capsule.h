#pragma once
// A run up to a moment as one value, to be handed to somebody else: the level, what came from outside in each update,
// and the hash of the session then. As JSON:
//   {"capsule": 1, "program": "…", "platform": "…", "hash": "0123456789abcdef",
//    "simulation": true, "level": "text of the level file", "run": "text of the replay file"}
// A capsule that does not say is that of a game. Its replay leaves it to the capsule what it is of.

#include "core/base/result.h"
#include "core/game/replay.h"
#include "core/game/session.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

namespace spacetow {

constexpr int capsuleVersion = 1;
constexpr std::size_t maxCapsuleBytes = 32u << 20;

struct Capsule {
    std::string program;                // with its version
    std::string platform;               // for people
    std::shared_ptr<const Level> level; // at the start
    Replay run;                         // up to the moment, with an edit then; without a hash of the level
    std::uint64_t hash = 0;             // of the session then

    bool operator==(const Capsule& other) const;
};

/// Codes: those of savableText, "capsule-too-long" (updates allowed).
Result<std::string> capsuleJson(const Capsule& capsule);
/// Codes: "capsule-damaged", "capsule-bad-field" (its name), "capsule-newer" (version, newest known),
/// "capsule-bad-level" (line of the level, code and arguments of the problem there), and those of parseReplay.
Result<Capsule> parseCapsule(std::string_view json);

/// The session after all of its inputs, which takes its time; as far as it has come when a stop is requested, or bodies
/// crowd (core/game/crowd.h).
Session sessionOf(const Capsule& capsule, const std::stop_token& stop = {});

} // namespace spacetow
