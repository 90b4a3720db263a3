#pragma once
// What must hold for any bytes that are pasted as a bug capsule; see fuzz_targets.h.

#include "editor/exchange/capsule_text.h"
#include "tests/support/fuzz_targets.h"

namespace spacetow::test {

/// The bytes are tried as the text of a capsule, and as the JSON in one.
inline void tryCapsule(std::string_view bytes) {
    for (const Result<Capsule>& capsule : {capsuleFromText(bytes), parseCapsule(bytes)}) {
        if (!capsule) {
            mustHold(!capsule.error().code.text().empty(), "what is refused says why");
            continue;
        }
        const Result<std::string> text = capsuleText(capsule.value());
        if (text) {
            const Result<Capsule> again = capsuleFromText(text.value());
            mustHold(bool(again), "what was written can be read");
            mustHold(again.value() == capsule.value(), "the same capsule comes back");
        }
    }
}

} // namespace spacetow::test
