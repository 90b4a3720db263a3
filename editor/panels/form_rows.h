#pragma once
// The rows of the inspector as a table: which field stands where, what it is called, and in which unit it is shown.

#include <cstdint>
#include <span>

namespace spacetow {

enum class RowKind : std::uint8_t { Number, Switch, Choice, Text, LongText, Background, Tags, Touches };

struct FormRow {
    const char* section; // heading above the first row of it; translate in the context "Inspector"
    const char* label;   // a second part of a pair has none
    const char* id;      // see FieldEntry
    RowKind kind;
    double step = 0.1;     // of the arrow keys, in the unit shown
    const char* none = ""; // what an empty number means
    std::span<const char* const> choices = {};
};

/// Of objects, and of the level when nothing is selected.
std::span<const FormRow> objectRows();
std::span<const FormRow> levelRows();

/// How many of the unit that people read make one of the file's: angles are shown in degrees.
double shownPerStored(const char* unit);
/// The unit that people read.
const char* shownUnit(const char* unit);

} // namespace spacetow
