#pragma once
// The events of the last update, each list in a deterministic order. The next update clears all lists.

#include "core/physics/def/body.h"

#include <vector>

namespace spacetow {

struct TouchEvent {
    int iteration; // of the update, from 0
    BodyId a, b;   // a is the one that was added to the world first
    bool solid;    // false when a or b is intangible
};

struct TagsTouchedEvent {
    int iteration;
    BodyId body;  // one that reports touches
    TagMask tags; // of all bodies that `body` touched in this iteration; never empty
};

/// A kinematic body begins to press a dynamic one, directly or through others, against a body that does not yield. The
/// dynamic body stays in front of `against`, and `by` overlaps it. The owner of the world decides what becomes of it.
struct CrushedEvent {
    int iteration;
    BodyId body;
    BodyId by;      // the body that overlaps `body` most
    BodyId against; // the body that does not yield
};

struct RemovedEvent {
    int iteration; // −1: before the first iteration
    BodyId body;   // no longer in the world
    std::uint64_t user;
};

/// The state of a body was no longer finite. The engine has deactivated the body.
struct FaultEvent {
    int iteration;
    BodyId body;
};

/// A body fell asleep or woke up.
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
    std::vector<SleepEvent> fellAsleep;
    std::vector<SleepEvent> wokeUp;

    void clear() {
        began.clear();
        ended.clear();
        tagsTouched.clear();
        crushed.clear();
        removed.clear();
        faults.clear();
        fellAsleep.clear();
        wokeUp.clear();
    }
};

} // namespace spacetow
