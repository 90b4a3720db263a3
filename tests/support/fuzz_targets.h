#pragma once
// What must hold for any bytes whatever. The programs in tests/fuzz look for bytes for which it does not, the tests try
// those that were found.

#include "core/game/replay.h"
#include "core/level/file.h"
#include "editor/editing/clipboard.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace spacetow::test {

/// Ends the program, which is what a fuzzer takes for a finding.
inline void mustHold(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "does not hold: %s\n", what);
        std::abort();
    }
}

/// What can be opened can be saved, and comes back.
inline void mustComeBack(const Level& level) {
    const Result<std::string> text = savableText(level);
    mustHold(bool(text), "what was opened can be saved");
    const LevelFile again = parseLevel(text.value(), Checks::FileOnly);
    mustHold(again.level.has_value(), "what was saved can be opened");
    mustHold(*again.level == level, "the same level comes back");
    mustHold(levelText(*again.level) == text.value(), "the same text comes back");
}

inline void tryLevel(std::string_view text) {
    const LevelFile file = parseLevel(text);
    mustHold(file.level || hasErrors(file.problems), "a file that is refused says why");
    if (file.level) {
        mustComeBack(*file.level);
    }
}

inline void tryReplay(std::string_view text) {
    const Result<Replay> replay = parseReplay(text);
    if (replay) {
        const Result<Replay> again = parseReplay(replayText(replay.value()));
        mustHold(bool(again), "what was written can be read");
        mustHold(again.value() == replay.value(), "the same replay comes back");
    }
}

inline void tryClipboard(std::string_view text) {
    Level level;
    level.tags.set(9, {"ice", 0x123456});
    level.objects.append({1, "ship", ShipObject(), {}});
    const ToolContext context{{std::make_shared<const Level>(level), {}}, {}};
    for (const std::optional<Vec2>& at : {std::optional<Vec2>(), std::optional(Vec2(3, 4))}) {
        const std::optional<FinishedEdit> edit = pasted(context, text, at);
        if (edit) {
            mustComeBack(*edit->edit.level);
            mustHold(!copied(edit->edit).empty(), "what was pasted can be copied");
        }
    }
}

} // namespace spacetow::test
