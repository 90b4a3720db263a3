#pragma once
// A recorded flight: what the player held down in each update, run-length encoded. With the same level and seed it
// gives the same game to the last bit. As a file:
//   {"replay": 1, "level": "01_first_haul.json", "levelHash": "0123456789abcdef", "seed": 1,
//    "updates": [[bits, count], …]}
// where bit 0 is left, 1 right, 2 thrust, 3 tow. `levelHash` may be missing; a different one means that the level has
// been edited since. What was done to the level by hand meanwhile makes it a file of version 2, which has
//    "holds": [[update, key, anchor x, anchor y, target x, target y], [update], …]
//    "edits": [[update, level, [keys removed], [keys in their order]], …]
// beside: what the mouse held, or that it let go, and the level file of what was changed; see LevelDelta. How the
// flight ended in the level that it was flown in makes it a file of version 3, which has
//    "end": {"outcome": "won", "time": 31.2, "fuel": 9.8, "update": 1571, "seconds": 31.42, "place": [11, 8.9]}
// beside: the outcome is won, lost or running; see FlightResult. `place` is missing where there is no ship. A
// simulation rather than a game makes it a file of version 4, which says
//    "kind": "simulation"
// A file that does not say is that of a game.

#include "core/base/whole_file.h"
#include "core/game/controls.h"
#include "core/game/flight_end.h"
#include "core/game/input_runs.h"
#include "core/game/snapshot.h"
#include "core/level/level_delta.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spacetow {

constexpr int replayVersion = 4;
constexpr std::size_t maxReplayBytes = 8u << 20;
constexpr std::int64_t maxReplayUpdates = 1'000'000; // five and a half hours

/// A game is flown and won or lost; a simulation runs, and nobody flies.
enum class RunKind : std::uint8_t { Game, Simulation };

struct Replay {
    struct Run {
        Controls controls;
        std::int64_t count = 1; // updates, > 0

        bool operator==(const Run&) const = default;
    };

    /// What the mouse holds in the update after so many, and until another entry says otherwise.
    struct Hold {
        std::int64_t update = 0;
        std::optional<Grab> grab;

        bool operator==(const Hold&) const = default;
    };
    /// The level becomes another one with the update after so many.
    struct Edit {
        std::int64_t update = 0;
        LevelDelta delta; // from the level as it was before

        bool operator==(const Edit&) const = default;
    };

    std::string level; // file name, for people and tools
    std::optional<std::uint64_t> levelHash;
    std::uint64_t seed = 1;
    RunKind kind = RunKind::Game;
    std::vector<Run> runs;
    std::vector<Hold> holds;           // in order, each later than the one before
    std::vector<Edit> edits;           // likewise
    std::optional<FlightResult> ended; // Won, Lost or UnderWay, when it was recorded; none where that is not known

    /// One more update.
    void append(const Controls& controls);
    std::int64_t updates() const;

    bool operator==(const Replay&) const = default;
};

struct Outcome {
    Phase phase = Phase::Sandbox;
    double time = 0; // s, of the last attempt
    double fuel = 0; // s of thrust
    int lives = 0;
    std::int64_t updates = 0;
    std::uint64_t hash = 0;    // of the session at the end
    bool levelChanged = false; // since the recording, as far as its hash tells

    bool won() const { return phase == Phase::Won; }
    bool lost() const { return phase == Phase::Crashed || phase == Phase::GameOver; }

    bool operator==(const Outcome&) const = default;
};

/// What comes from outside in each update of the recording, in this level.
InputRuns inputsOf(const Replay& replay, const Level& level);
/// Makes the recording one of these inputs in a session that begins with the level, which may end in another way.
void setInputs(Replay& replay, const InputRuns& inputs, const Level& level);
/// The same flight for those who have another level now: it begins with becoming the one that it was.
Replay basedOn(Replay replay, const Level& was, const Level& now);

/// As it has been edited when the recording ends. An edit after the last update is one that the next will take over.
Level levelAfter(const Replay& replay, const Level& level);

/// Flies the whole recording.
Outcome replayed(const Level& level, const Replay& replay);

/// Of the level as its file spells it.
std::uint64_t levelHash(const Level& level);

/// Codes: "empty-file", "not-sound-json" (line, code and arguments of the problem there), "replay-none",
/// "replay-bad-field" (JSON pointer, line), "replay-newer" (version, newest known), "replay-too-long" (updates
/// allowed), "replay-unknown-field" (name, line), "replay-duplicate-field" (name, line).
Result<Replay> parseReplay(std::string_view text);
std::string replayText(const Replay& replay);

/// Codes: those of parseReplay and of readFile.
Result<Replay> readReplay(const std::filesystem::path& path, Sources sources = Sources::Files);
/// The old file stays whole when anything fails. Codes: those of writeFile.
std::optional<Error> writeReplay(const std::filesystem::path& path, const Replay& replay);

} // namespace spacetow
