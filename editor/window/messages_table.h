#pragma once
// The English texts of editor/window/messages, by code. %1, %2 … stand for the arguments, %n for a number of objects.

#include <span>

namespace spacetow {

struct MessageText {
    const char* code;
    const char* text;
};

struct LabelText {
    const char* code;
    const char* one;
    const char* many; // with %n
};

std::span<const MessageText> problemTexts();  // and errors
std::span<const MessageText> exchangeTexts(); // what importing and exporting have to say
/// Why two objects do not collide, and what would cure it.
std::span<const MessageText> explainTexts();
std::span<const LabelText> labelTexts();
/// Of all tools, which have them in their rows, and of guides.
std::span<const MessageText> hintTexts();
std::span<const MessageText> selectHints();
std::span<const MessageText> nodeHints();
std::span<const MessageText> drawHints();
std::span<const MessageText> placeHints();
std::span<const MessageText> guideHints();
std::span<const MessageText> measureHints();

} // namespace spacetow
