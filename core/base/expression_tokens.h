#pragma once
// An expression cut into numbers, names and signs. Typographic signs (×, −, ², π, no-break spaces, marks of writing
// direction) mean what they look like.

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace spacetow {

struct Token {
    enum class Kind { Number, Name, Sign, End };
    Kind kind = Kind::End;
    double number = 0;
    std::string text; // as it was typed; of a sign one of + - * / ^ ( ) ; =
};

/// The last one is the end.
Result<std::vector<Token>> expressionTokens(std::string_view typed);

} // namespace spacetow
