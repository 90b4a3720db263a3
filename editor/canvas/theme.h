#pragma once
// Colours of everything that is painted on the canvas and in the play view. The game is dark, as space is; the canvas
// follows the panels. Kinds also differ in fill, dash and mark, not in colour alone, and the marks of hovering,
// selecting, snapping and of the overlays are told apart by people who see fewer colours too.

#include "core/physics/def/body.h"
#include "editor/canvas/palette.h"

#include <QColor>

namespace spacetow {

struct BodyColors {
    QColor fill;
    QColor line;
};

struct Theme {
    Shade shade = Shade::Dark;

    QColor background{11, 25, 45};
    QColor rock{39, 50, 70};    // matter behind walls that have no back
    QColor rim{150, 166, 196};  // the solid side, strongest at the wall
    QColor wall{226, 222, 214}; // one-way walls
    QColor gridMinor{255, 255, 255, 14};
    QColor gridMajor{255, 255, 255, 34};
    QColor axisX{255, 120, 110, 150}; // the lines y = 0 and x = 0
    QColor axisY{120, 220, 150, 150};
    QColor text{226, 232, 242};
    QColor halo{6, 14, 26, 200};   // behind text and thin marks
    QColor casing{6, 14, 26, 200}; // around connectors, whose colours are bright

    QColor shipLight{240, 244, 250};
    QColor shipDark{176, 190, 212};
    QColor shipLine{240, 244, 250};
    QColor shipGlass{70, 190, 230};
    QColor payloadLight{255, 226, 150};
    QColor payloadDark{222, 140, 44};
    QColor payloadLine{255, 226, 150};
    QColor finish{110, 240, 190};

    QColor hover{173, 205, 238};
    QColor selection{236, 136, 0};
    QColor collision{114, 54, 252}; // what the selection would collide with
    QColor draft{255, 255, 255};
    QColor snap{214, 40, 180};
    QColor band{173, 205, 238};
    QColor guide{66, 122, 248};

    QColor overlayBox{132, 145, 144};
    QColor overlayIncircle{202, 147, 255};
    QColor overlayVelocity{222, 40, 48};
    QColor overlayOrientation{142, 255, 174};
    QColor overlayNormal{238, 207, 102};
    QColor overlayCell{54, 180, 105};

    /// Circles, polygons and lines of a kind differ, as they did in the original's debug drawing.
    BodyColors body(BodyKind kind, const Shape& shape) const;
    /// Red when pressed to half its length or less, yellow at rest, green when pulled to one and a half or more.
    static QColor connector(double distance, double length);
};

/// The colours of the game.
const Theme& canvasTheme();
/// The drawing board's; its rock lets the grid shine through.
const Theme& editingTheme(Shade shade = Shade::Dark);

} // namespace spacetow
