#include "editor/window/messages_table.h"

#include <vector>

namespace spacetow {

std::span<const MessageText> hintTexts() {
    static const std::vector<MessageText> texts = [] {
        std::vector<MessageText> all;
        for (const auto hints : {selectHints(), nodeHints(), drawHints(), placeHints(), guideHints(), measureHints()}) {
            all.insert(all.end(), hints.begin(), hints.end());
        }
        return all;
    }();
    return texts;
}

} // namespace spacetow
