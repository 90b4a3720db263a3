#pragma once
// What is different between two levels, object by object and field by field. Objects are one by their keys, whatever
// their place in the list.

#include "core/level/field_value.h"
#include "core/level/fields.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace spacetow {

struct FieldDifference {
    std::string id; // as of FieldSummary: the field's name, with ".x" or ".y" for the parts of a point
    Field field;
    FieldValue before, after;

    bool operator==(const FieldDifference&) const = default;
};

enum class ObjectChange : std::uint8_t {
    Added,
    Removed,
    Moved,     // nothing else of it has changed
    Retagged,  // likewise: what it is, or what it touches
    Reordered, // likewise: drawn sooner or later
    Changed,
};

struct ObjectDifference {
    Key key = 0;
    ObjectChange change = ObjectChange::Changed;
    std::vector<FieldDifference> fields; // of an object that is in both levels
    bool shapesMoved = false;            // all vertices by one and the same way
    bool shapesChanged = false;          // otherwise
    bool otherKind = false;              // a ship under the key of what was a body
    bool reordered = false;              // against the other objects that both levels have
    bool unknownFields = false;          // what the program does not know of it

    bool operator==(const ObjectDifference&) const = default;
};

struct TagDifference {
    int index = 0;
    TagInfo before, after;

    bool operator==(const TagDifference&) const = default;
};

struct LevelDifference {
    std::vector<FieldDifference> fields; // of the level and its rules
    std::vector<TagDifference> tags;
    std::vector<Guide> guidesAdded, guidesRemoved;
    std::vector<ObjectDifference> objects; // removed ones in the order before, then the others in the order after
    bool unknownFields = false;
    bool hiddenProblems = false; // others are hidden

    bool empty() const {
        return fields.empty() && tags.empty() && guidesAdded.empty() && guidesRemoved.empty() && objects.empty() &&
               !unknownFields && !hiddenProblems;
    }
};

/// Empty exactly when the levels are equal, but for the order of their guides. Pieces that both share are not looked
/// into.
LevelDifference differenceBetween(const Level& before, const Level& after);

/// The objects with these keys as `other` has them: what it does not have goes, what only it has comes to stand behind
/// what it follows there, with the groups and bodies that it refers to. Tags are known by their names. What hangs on
/// one that goes, goes with it, as when it is deleted.
Level takenOver(Level level, const Level& other, std::span<const Key> keys);

/// How all vertices have moved, when the shapes are the same but for that; circles by their centres.
std::optional<Vec2> commonWay(const std::vector<LevelShape>& before, const std::vector<LevelShape>& after);

} // namespace spacetow
