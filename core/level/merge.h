#pragma once
// Three-way merge of levels: what two people made of the same level, each without knowing of the other, put together.
// Objects are one by their keys, tags by their names, and of an object each field counts by itself.

#include "core/level/level.h"

#include <string>
#include <vector>

namespace spacetow {

enum class MergeSide : std::uint8_t { Ours, Theirs };

enum class ConflictKind : std::uint8_t {
    Field,       // both changed it, differently: the preferred side's is taken
    Kind,        // both made something else of the object: the preferred side's is taken
    AddedTwice,  // both added another object under this key: the preferred side's is taken
    RemovedOurs, // we removed what they changed or what they need: it stays
    RemovedTheirs,
    Circle,   // groups would be in each other: where ours are in is taken
    Order,    // both changed the order of drawing: the preferred side's is taken
    TagsFull, // their tag finds no place among the 32: it is dropped
};

struct MergeConflict {
    ConflictKind kind = ConflictKind::Field;
    Key object = 0;    // 0: the level itself
    std::string field; // its name, of kind Field; the name of the tag, of kind TagsFull

    bool operator==(const MergeConflict&) const = default;
};

struct MergedLevel {
    Level level;
    std::vector<MergeConflict> conflicts; // of the level, then in the order of the merged objects
};

/// What both did alike, and what only one of them did, is taken over. No object refers to one that the merge has
/// removed.
MergedLevel merged(const Level& base, const Level& ours, const Level& theirs, MergeSide preferred = MergeSide::Ours);

} // namespace spacetow
