#pragma once
// The fields of objects and of the level as a flat list that a form can show and change, whatever kind of object they
// belong to. Made from core/level/fields.h, which knows units and ranges. Values are in the units of the file.

#include "core/level/fields.h"
#include "core/level/level.h"

#include <string>
#include <variant>
#include <vector>

namespace spacetow {

/// Of an enumeration: the position among its spellings.
struct Choice {
    int index = 0;

    bool operator==(const Choice&) const = default;
};
/// Without a number: a depth without end, a mass that comes from the shapes.
struct Unset {
    bool operator==(const Unset&) const = default;
};
using FieldValue = std::variant<Unset, double, bool, Choice, std::string, TagMask>;

struct FieldEntry {
    std::string id; // the field's name, with ".x" or ".y" for the parts of a point
    Field field;
    FieldValue value;
    bool mayBeUnset = false;
    bool whole = false; // an integer
};

/// Those of the body's shapes are among them; vertices are not. Of several shapes of a kind the first one counts.
std::vector<FieldEntry> fieldsOf(const Object& object);
/// Of the level itself and its rules.
std::vector<FieldEntry> fieldsOf(const Level& level);

/// Sets the field wherever the object has it, in all its shapes; does nothing where there is none of that kind.
void setField(Object& object, const std::string& id, const FieldValue& value);
void setField(Level& level, const std::string& id, const FieldValue& value);

} // namespace spacetow
