#include "editor/window/action_row.h"
#include "editor/window/messages_table.h"

#include <algorithm>
#include <vector>

namespace spacetow {

std::span<const HintText> hintTexts() {
    static const std::vector<HintText> texts = [] {
        std::vector<HintText> all(guideHints().begin(), guideHints().end());
        std::vector<std::span<const HintText> (*)()> taken;
        for (const ActionRow& row : toolActions()) {
            if (row.hints != nullptr && std::ranges::find(taken, row.hints) == taken.end()) {
                taken.push_back(row.hints); // several tools may share theirs
                all.insert(all.end(), row.hints().begin(), row.hints().end());
            }
        }
        return all;
    }();
    return texts;
}

} // namespace spacetow
