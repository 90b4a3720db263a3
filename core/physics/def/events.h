#pragma once
// What happened during the last update, in a fixed order. Valid until the next update.

#include "core/physics/def/body.h"
#include "core/physics/def/force_field.h"

#include <vector>

namespace spacetow {

struct TouchEvent {
    int iteration; // of the update, from 0
    BodyId a, b;   // a was added to the world before b
    bool solid;    // false when one of them is intangible
};

struct TagsTouchedEvent {
    int iteration;
    BodyId body;  // one that reports touches
    TagMask tags; // of everything it touched in this iteration; never empty
};

/// A body begins to be crushed: what nothing can stop drives it, perhaps through others, against what stands still. It
/// stays on its side of that and is overlapped from behind; what becomes of it is for the owner of the world to say.
struct CrushedEvent {
    int iteration;
    BodyId body;
    BodyId by;      // overlaps it most
    BodyId against; // stands still
};

struct RemovedEvent {
    int iteration; // −1: before the first
    BodyId body;   // no longer in the world
    std::uint64_t user;
};

/// A body whose state stopped being finite and which was therefore switched off.
struct FaultEvent {
    int iteration;
    BodyId body;
};

/// A force field gave a value that is not finite, which was left out; once an update for each field.
struct FieldFaultEvent {
    int iteration;
    FieldId field;
    BodyId body;
};

/// Of a body that fell asleep or woke up.
struct SleepEvent {
    int iteration; // −1: before the first
    BodyId body;
};

struct Events {
    std::vector<TouchEvent> began;
    std::vector<TouchEvent> ended;
    std::vector<TagsTouchedEvent> tagsTouched;
    std::vector<CrushedEvent> crushed;
    std::vector<RemovedEvent> removed;
    std::vector<FaultEvent> faults;
    std::vector<FieldFaultEvent> fieldFaults;
    std::vector<SleepEvent> fellAsleep;
    std::vector<SleepEvent> wokeUp;

    void clear() {
        began.clear();
        ended.clear();
        tagsTouched.clear();
        crushed.clear();
        removed.clear();
        faults.clear();
        fieldFaults.clear();
        fellAsleep.clear();
        wokeUp.clear();
    }
};

} // namespace spacetow
