#pragma once
// What is wrong with a level or its file: a code, where, and the facts its sentence needs. The sentences are made in
// editor/window/messages.

#include "core/level/codes.h"
#include "core/level/level.h"

#include <string>
#include <vector>

namespace spacetow {

enum class Severity : std::uint8_t { Note, Warning, Error };

/// As programs are told: "note", "warning", "error".
const char* severityName(Severity severity);

struct Problem {
    Severity severity = Severity::Error;
    LevelCode code;                     // e.g. "ship-missing"
    std::vector<std::string> arguments; // values for the sentence, in the order the code's sentence names them
    std::string pointer;                // JSON pointer into the file, "" for the whole document
    int line = 1;                       // of the file, from 1; 0 when there is no file
    Key object = 0;                     // 0: the level itself
    std::vector<Vec2> place = {};       // world, m: a point or a line along it; empty for where the pointer leads
    std::vector<Vec2> wayOut = {};      // world, m: how the ship gets out of its cave, from where it starts

    bool operator==(const Problem&) const = default;
};

/// Errors keep a level from being played as meant; warnings are worth a look; notes could be tidied.
bool hasErrors(const std::vector<Problem>& problems);

} // namespace spacetow
