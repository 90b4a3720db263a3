#pragma once
// The rows of the inspector as a table: which field stands where, what it is called, and in which unit it is shown.

#include <QString>

#include <cstdint>
#include <span>

namespace spacetow {

enum class RowKind : std::uint8_t {
    Number,
    Switch,
    Choice,
    Text,
    LongText,
    Background,
    Tags,
    Touches,
    Body,  // the key of another body
    Group, // the key of a group, or nothing
    Color,
    Points, // how many; they are edited on the canvas
};

/// Its texts are translated in the context "Inspector".
struct FormRow {
    const char* section; // heading above the first row of it
    const char* label;   // a second part of a pair has none
    const char* id;      // see FieldSummary
    RowKind kind;
    const char* meaning = ""; // for the tooltip; of a pair the first one says it
    double step = 0.1;        // of the arrow keys, in the unit shown
    const char* none = "";    // what an empty number means
    std::span<const char* const> choices = {};
};

/// In the language of the user; empty for an empty text.
QString rowText(const char* words);

/// Of objects, and of the level when nothing is selected.
std::span<const FormRow> objectRows();
std::span<const FormRow> levelRows();

/// The unit that people read: angles are shown in degrees.
const char* shownUnit(const char* unit);
/// From the unit of the file to the one that is shown and back. What is shown comes back to the bit, with as few
/// digits as that takes.
double shownNumber(double stored, const char* unit);
double storedNumber(double shown, const char* unit);

} // namespace spacetow
