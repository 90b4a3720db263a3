#pragma once
// A capsule (core/game/capsule.h) as text that survives mails, chats and issue trackers: two lines for people, then its
// JSON in compressed pieces, as base64 in short lines between a first line and a last one with a checksum. Quoting
// (">"), indenting and other line ends do no harm.

#include "core/game/capsule.h"

#include <string>
#include <string_view>

namespace spacetow {

constexpr std::size_t maxCapsuleText = 16u << 20; // bytes

/// Codes: those of capsuleJson.
Result<std::string> capsuleText(const Capsule& capsule);

/// Whether there is one in the text, be it whole or not.
bool holdsCapsule(std::string_view text);

/// The first one in the text. Never takes more memory than a capsule may have, whatever the text says.
/// Codes: those of parseCapsule, "capsule-none", "capsule-cut" (its end is missing), "capsule-too-large" (bytes
/// allowed).
Result<Capsule> capsuleFromText(std::string_view text);

} // namespace spacetow
