#pragma once
// The head-up display: lives, fuel and time along the top, what to do next above the middle, the keys and the tow hint
// below. Sizes are logical pixels; whatever the window, no text leaves it, no two overlap, and none covers the ship.

#include "core/game/snapshot.h"
#include "editor/play/key_map.h"

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

namespace spacetow {

struct HudText {
    enum class Role { Lives, Fuel, Time, Title, Advice, Hint, Keys, Banner, Paused };

    Role role;
    QString text;
    QRectF box; // the text fills it, centred; may hold several lines
    QFont font;
};

struct HudInput {
    Phase phase = Phase::Sandbox;
    Hud hud{};
    bool paused = false; // by the pause key: the menu has words of its own
    PlayKeys keys = {};  // that the advice names
    QString goal = {};   // what the level says of itself, for who has not begun
    QRectF ship = {};    // where it is in the view
    bool shipLost = false, payloadLost = false;
    QString cause = {}; // of a crash, see crashWords; empty where it is not known
};

/// Where every text goes in a view of this size.
std::vector<HudText> hudLayout(const HudInput& input, const QSizeF& size, const QFont& base);
void paintHud(QPainter& painter, const std::vector<HudText>& texts);

} // namespace spacetow
