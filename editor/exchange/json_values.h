#pragma once
// Members of JSON objects that may be missing or of another kind than they should.

#include "core/level/json_tree.h"
#include "core/math/vec.h"

#include <optional>
#include <string>

namespace spacetow {

std::optional<JsonView> jsonMember(const JsonView& object, std::string_view name);
/// `otherwise` when it is missing or no finite number. What R.U.B.E. writes for a float, eight hexadecimal digits of
/// its bits in quotation marks, is one too.
double jsonNumber(const JsonView& object, std::string_view name, double otherwise = 0);
std::optional<double> jsonNumberIn(const JsonView& value);
bool jsonFlag(const JsonView& object, std::string_view name, bool otherwise = false);
/// Empty when it is missing or no text.
std::string jsonText(const JsonView& object, std::string_view name);
/// {"x": 1, "y": 2}; R.U.B.E. writes 0 for the origin.
Vec2 jsonPoint(const JsonView& object, std::string_view name);

} // namespace spacetow
