#include "editor/window/play_keys.h"

#include <QCoreApplication>

#include <array>

namespace spacetow {

namespace {

struct GameLine {
    const char* keys;
    const char* meaning;
};

// clang-format off
constexpr std::array gameLines{
    GameLine{QT_TRANSLATE_NOOP("Keys", "W or Up"), QT_TRANSLATE_NOOP("Keys", "Thrust")},
    GameLine{QT_TRANSLATE_NOOP("Keys", "A or Left · D or Right"), QT_TRANSLATE_NOOP("Keys", "Turn left · turn right")},
    GameLine{QT_TRANSLATE_NOOP("Keys", "Space"), QT_TRANSLATE_NOOP("Keys", "Tow the payload when it is near; again: let it go")},
    GameLine{QT_TRANSLATE_NOOP("Keys", "Esc"), QT_TRANSLATE_NOOP("Keys", "Hold the game and show the menu")},
    GameLine{QT_TRANSLATE_NOOP("Keys", "R · P · O"), QT_TRANSLATE_NOOP("Keys", "Restart · hold · next frame")},
    GameLine{QT_TRANSLATE_NOOP("Keys", "F"), QT_TRANSLATE_NOOP("Keys", "Let the view follow the ship again")},
};
// clang-format on

} // namespace

std::vector<PlayKeyLine> playKeyLines() {
    std::vector<PlayKeyLine> all;
    for (const GameLine& each : gameLines) {
        all.push_back(
            {QCoreApplication::translate("Keys", each.keys), QCoreApplication::translate("Keys", each.meaning)});
    }
    return all;
}

} // namespace spacetow
