#pragma once
// The English texts of editor/window/messages, by code. %1, %2 … stand for the arguments, %n for a number of objects.

#include "editor/editing/codes.h"
#include "editor/exchange/codes.h"
#include "editor/panels/explain_codes.h"

#include <span>
#include <string_view>

namespace spacetow {

/// All codes of problems and errors.
using SentenceCode = ExchangeCode::And<explainCodes>;

/// What each argument is, a letter each: n a number, b a size in bytes, r the reason that the system gives, else what
/// stands as it is, as do those beyond.
using ArgumentKinds = const char*;

struct MessageText {
    SentenceCode code;
    const char* text;
    const char* unnamed = nullptr; // when the first argument, a name, is empty; %2 is what kind of thing it is
    ArgumentKinds kinds = "";
};

/// Numbers that do not stand in quotation marks are spelled as the user does.
struct HintText {
    const char* code;
    const char* text;
};

struct LabelText {
    LabelCode code;
    const char* one;
    const char* many; // with %n
};

struct ReasonText {
    std::string_view reason; // as of the system
    const char* text;
};

/// Why files cannot be read or written.
std::span<const ReasonText> systemReasons();

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
