#pragma once
// The keys of the game in words, for the lists of keys. What they do stands in editor/play/key_map.

#include <QString>

#include <vector>

namespace spacetow {

struct PlayKeyLine {
    QString keys; // translated, as is the other
    QString meaning;
};

std::vector<PlayKeyLine> playKeyLines();

} // namespace spacetow
