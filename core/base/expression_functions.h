#pragma once
// The functions that expressions may call: sin, cos, tan, asin, acos, atan, atan2, sqrt, abs, round, floor, ceil, exp,
// ln, log, min, max.

#include "core/base/quantity.h"
#include "core/base/result.h"

#include <span>
#include <string_view>

namespace spacetow {

bool isFunction(std::string_view name);

/// The name must be that of a function. Codes: "expression-arguments" (function), "expression-units-differ",
/// "expression-not-finite".
Result<Quantity> functionValue(std::string_view name, std::span<const Quantity> arguments);

} // namespace spacetow
