#pragma once
// Why a recorded flight or a bug capsule cannot be read or made.

#include "core/level/codes.h"

namespace spacetow {

inline constexpr std::string_view recordCodes[] = {
    "not-sound-json",         "replay-none",   "replay-bad-field", "replay-unknown-field",
    "replay-duplicate-field", "replay-newer",  "replay-too-long",  "capsule-no-run",
    "capsule-none",           "capsule-cut",   "capsule-damaged",  "capsule-bad-field",
    "capsule-bad-level",      "capsule-newer", "capsule-too-long", "capsule-too-large",
};

using GameCode = LevelCode::And<recordCodes>;

} // namespace spacetow
