#include "core/game/replay.h"

#include "core/base/hash.h"
#include "core/game/session.h"
#include "core/level/file.h"

namespace spacetow {

void Replay::append(const Controls& controls) {
    if (!runs.empty() && runs.back().controls == controls) {
        ++runs.back().count;
    } else {
        runs.push_back({controls, 1});
    }
}

std::int64_t Replay::updates() const {
    std::int64_t sum = 0;
    for (const Run& run : runs) {
        sum += run.count;
    }
    return sum;
}

Outcome replayed(const Level& level, const Replay& replay) {
    Session session(level, replay.seed);
    for (const Replay::Run& run : replay.runs) {
        for (std::int64_t i = 0; i < run.count; ++i) {
            session.step(run.controls);
        }
    }
    return {session.phase(),
            session.time(),
            session.fuel(),
            session.lives(),
            session.updates(),
            session.hash(),
            replay.levelHash && *replay.levelHash != levelHash(level)};
}

std::uint64_t levelHash(const Level& level) {
    StateHash hash;
    for (const char c : levelText(level)) {
        hash.add(std::uint64_t{static_cast<unsigned char>(c)});
    }
    return hash.value();
}

} // namespace spacetow
