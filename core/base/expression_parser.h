#pragma once
// The grammar of expressions, from tokens to a quantity.

#include "core/base/expression_tokens.h"
#include "core/base/quantity.h"
#include "core/base/result.h"

#include <span>

namespace spacetow {

/// What a unit multiplies in "1 / 2 m": the factor before it, or all of the product so far.
enum class UnitBinding { ToFactor, ToProduct };

struct ExpressionReading {
    UnitBinding binding = UnitBinding::ToFactor;
    Quantity plainUnit; // of a plain number that is added to one with this dimension
};

/// The tokens must end with the end. For the codes see expression.h.
Result<Quantity> parsedExpression(std::span<const Token> tokens, const ExpressionReading& reading);

} // namespace spacetow
