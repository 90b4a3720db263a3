#pragma once
// A run up to a moment as one value, to be handed to somebody else: the level, what came from outside in each update,
// and the hash of the session then. As JSON:
//   {"capsule": 1, "program": "…", "platform": "…", "name": "cave.json", "seed": 1, "hash": "0123456789abcdef",
//    "level": "text of the level file", "controls": [[bits, updates], …],
//    "grabs": [[update, key, anchor x, anchor y, [target x, target y, …]], …],
//    "edits": [[update, line, lines to leave out, "lines in their place"], …]}
// Each grab has a target for every update from its own on, as long as the same body is held at the same point. Each
// edit makes the next level out of the text of the one before, lines being counted from 0.

#include "core/base/result.h"
#include "core/game/session.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace spacetow {

constexpr int capsuleVersion = 1;
constexpr std::size_t maxCapsuleBytes = 32u << 20;
constexpr std::size_t maxCapsuleLevels = 128u << 20;  // bytes of all levels together, as edited
constexpr std::int64_t maxCapsuleUpdates = 1'000'000; // five and a half hours
constexpr std::size_t maxCapsuleEdits = 1000;         // each of them is a level

struct Capsule {
    std::string program;  // with its version
    std::string platform; // for people
    std::string name;     // of the level's file, or of the level
    std::shared_ptr<const Level> level;
    std::uint64_t seed = 1;
    std::vector<StepInput> inputs; // of each update
    std::uint64_t hash = 0;        // of the session after them

    /// Levels by their values.
    bool operator==(const Capsule& other) const;
};

/// Codes: those of savableText, "capsule-too-large" (bytes allowed), "capsule-too-long" (updates allowed).
Result<std::string> capsuleJson(const Capsule& capsule);
/// Codes: "capsule-damaged", "capsule-bad-field" (its name), "capsule-newer" (version, newest known),
/// "capsule-too-long" (updates allowed), "capsule-bad-level".
Result<Capsule> parseCapsule(std::string_view json);

/// The session after all of its inputs, which takes its time; as far as it has come when a stop is requested.
Session sessionOf(const Capsule& capsule, const std::stop_token& stop = {});

} // namespace spacetow
