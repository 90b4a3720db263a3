#include "core/game/replay.h"

#include "core/base/hash.h"
#include "core/game/session.h"
#include "core/level/file.h"

#include <algorithm>

namespace spacetow {
namespace {

/// Other numbers do nothing, and a file cannot spell them.
bool isUsable(const std::optional<Grab>& grab) {
    return grab && grab->object != 0 && isFinite(grab->anchor) && isFinite(grab->target);
}

} // namespace

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

InputRuns inputsOf(const Replay& replay, const Level& level) {
    InputRuns inputs;
    Level now = level;
    std::optional<Grab> grab;
    auto hold = replay.holds.begin();
    auto edit = replay.edits.begin();
    std::int64_t update = 0;
    for (const Replay::Run& run : replay.runs) {
        for (const std::int64_t end = update + run.count; update < end;) {
            for (; hold != replay.holds.end() && hold->update <= update; ++hold) {
                grab = hold->grab;
            }
            StepInput input{run.controls, grab, {}};
            for (; edit != replay.edits.end() && edit->update <= update; ++edit) {
                now = withDelta(now, edit->delta);
                input.level = std::make_shared<const Level>(now);
            }
            std::int64_t until = hold != replay.holds.end() ? std::min(end, hold->update) : end;
            until = edit != replay.edits.end() ? std::min(until, edit->update) : until;
            if (input.level) { // it comes once
                until = update + 1;
            }
            inputs.append(input, until - update);
            update = until;
        }
    }
    return inputs;
}

void setInputs(Replay& replay, const InputRuns& inputs, const Level& level) {
    replay.runs.clear();
    replay.holds.clear();
    replay.edits.clear();
    replay.ended.reset();
    std::optional<Grab> grab;
    const Level* now = &level;
    std::int64_t update = 0;
    for (const InputRun& run : inputs.runs()) {
        const std::optional<Grab> held = isUsable(run.input.grab) ? run.input.grab : std::nullopt;
        if (held != grab) {
            grab = held;
            replay.holds.push_back({update, grab});
        }
        if (run.input.level) {
            replay.edits.push_back({update, deltaBetween(*now, *run.input.level)});
            now = run.input.level.get();
        }
        if (!replay.runs.empty() && replay.runs.back().controls == run.input.controls) {
            replay.runs.back().count += run.count;
        } else {
            replay.runs.push_back({run.input.controls, run.count});
        }
        update += run.count;
    }
}

Replay basedOn(Replay replay, const Level& was, const Level& now) {
    if (was == now) {
        return replay;
    }
    InputRuns inputs = inputsOf(replay, was);
    InputRuns begun;
    for (const InputRun& run : inputs.runs()) {
        StepInput input = run.input;
        if (begun.updates() == 0 && !input.level) {
            input.level = std::make_shared<const Level>(was);
            begun.append(input);
            input.level = nullptr;
            begun.append(input, run.count - 1);
        } else {
            begun.append(input, run.count);
        }
    }
    const std::optional<FlightResult> ended = replay.ended;
    setInputs(replay, begun, now);
    replay.ended = ended;
    return replay;
}

Level levelAfter(const Replay& replay, const Level& level) {
    Level now = level;
    for (const Replay::Edit& edit : replay.edits) {
        now = withDelta(now, edit.delta);
    }
    return now;
}

Outcome replayed(const Level& level, const Replay& replay) {
    Session session(level, replay.seed);
    for (InputReader inputs(inputsOf(replay, level)); !inputs.isAtEnd();) {
        session.step(inputs.next());
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
