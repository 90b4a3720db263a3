#pragma once
// Colours of everything that is painted on the canvas and in the play view. The canvas is dark whatever the desktop
// looks like, so that one set of colours is read the same way everywhere; kinds also differ in fill, dash and mark,
// not in colour alone.

#include "core/physics/body.h"

#include <QColor>

namespace spacetow {

struct BodyColors {
    QColor fill;
    QColor line;
};

struct Theme {
    QColor background{11, 25, 45};
    QColor rock{34, 44, 62};    // matter behind walls that have no back
    QColor rim{150, 166, 196};  // the solid side, strongest at the wall
    QColor wall{226, 222, 214}; // one-way walls
    QColor gridMinor{255, 255, 255, 14};
    QColor gridMajor{255, 255, 255, 34};
    QColor axisX{255, 120, 110, 150}; // the lines y = 0 and x = 0
    QColor axisY{120, 220, 150, 150};
    QColor text{226, 232, 242};
    QColor halo{6, 14, 26, 200}; // behind text and thin marks

    QColor shipLight{240, 244, 250};
    QColor shipDark{176, 190, 212};
    QColor shipGlass{70, 190, 230};
    QColor payloadLight{255, 226, 150};
    QColor payloadDark{222, 140, 44};
    QColor finish{110, 240, 190};

    QColor selection{84, 180, 255};
    QColor draft{255, 255, 255};
    QColor snap{255, 208, 66};
    QColor band{84, 180, 255};

    QColor overlayBox{255, 255, 255, 150};
    QColor overlayIncircle{255, 150, 240};
    QColor overlayVelocity{255, 84, 84};
    QColor overlayOrientation{0, 255, 255};
    QColor overlayNormal{200, 200, 190};
    QColor overlayCell{140, 255, 140, 90};

    /// Circles, polygons and lines of a kind differ, as they did in the original's debug drawing.
    BodyColors body(BodyKind kind, const Shape& shape) const;
    /// Red when pressed to half its length or less, yellow at rest, green when pulled to one and a half or more.
    static QColor connector(double distance, double length);
};

/// The colours of the game.
const Theme& canvasTheme();
/// Likewise, with rock that lets the grid shine through.
const Theme& editingTheme();

} // namespace spacetow
