#pragma once
// The English texts of editor/window/messages, by code. %1, %2 … stand for the arguments, %n for a number of objects.

#include "editor/editing/codes.h"
#include "editor/exchange/codes.h"
#include "editor/panels/explain_codes.h"

#include <span>

namespace spacetow {

/// All codes of problems and errors.
using SentenceCode = ExchangeCode::And<explainCodes>;

struct MessageText {
    SentenceCode code;
    const char* text;
    const char* unnamed = nullptr; // when the first argument, a name, is empty; %2 is what kind of thing it is
};

struct HintText {
    const char* code;
    const char* text;
};

struct LabelText {
    LabelCode code;
    const char* one;
    const char* many; // with %n
};

std::span<const MessageText> problemTexts();  // and errors
std::span<const MessageText> exchangeTexts(); // what importing and exporting have to say
/// Why two objects do not collide, and what would cure it.
std::span<const MessageText> explainTexts();
std::span<const LabelText> labelTexts();
/// Of all tools, which have them in their rows, and of guides.
std::span<const HintText> hintTexts();
std::span<const HintText> selectHints();
std::span<const HintText> nodeHints();
std::span<const HintText> drawHints();
std::span<const HintText> placeHints();
std::span<const HintText> guideHints();
std::span<const HintText> measureHints();

} // namespace spacetow
