#pragma once
// Arithmetic as people type it into a field: "2*pi/3", "sqrt(2)", "sin(30°)", "20 cm + 1/2 m", "+=0.5". Text is UTF-8
// with ASCII digits; comma and point are both decimal signs, so arguments are parted by semicolons.
//
// A unit multiplies what stands before it, and the reading that has the wanted dimension counts: "1/2 m" is half a
// metre, "1 m / 20 cm" is 5. Plain numbers in trigonometric functions are radians.

#include "core/base/quantity.h"
#include "core/base/result.h"

#include <string_view>

namespace spacetow {

/// What an entry does to the number that is there.
struct NumberChange {
    enum class Kind : std::uint8_t { Set, Add, Subtract, Multiply, Divide };
    Kind kind = Kind::Set;
    double operand = 0;

    bool isRelative() const { return kind != Kind::Set; }
    bool operator==(const NumberChange&) const = default;
};

/// In `unit` (as "m/s²"; empty for none), which plain numbers are taken to be in. Codes, all starting with
/// "expression-": empty, unfinished, unexpected (text), unknown (word), unclosed, arguments (function), too-deep,
/// divided-by-zero, not-finite, units-differ, wrong-unit (unit), needs-no-unit.
Result<double> evaluated(std::string_view text, std::string_view unit);

/// An expression, or one after "+=", "-=", "*=" or "/="; a factor has no unit.
Result<NumberChange> numberChange(std::string_view text, std::string_view unit);

/// The number after the change; not finite when it is too large.
double applied(const NumberChange& change, double number);

} // namespace spacetow
