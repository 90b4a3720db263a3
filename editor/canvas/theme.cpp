#include "editor/canvas/theme.h"

#include "core/physics/query/debug_draw.h"
#include "editor/canvas/stage.h"

namespace spacetow {

namespace {

constexpr int rockOnTheBoard = 190; // alpha

/// The dark one as it is in the game, the light one like ink on paper.
Theme paper() {
    Theme theme;
    theme.shade = Shade::Light;
    theme.background = {246, 248, 251};
    theme.rock = {208, 214, 224};
    theme.rim = {84, 98, 126};
    theme.wall = {46, 54, 68};
    theme.gridMinor = {20, 44, 90, 18};
    theme.gridMajor = {20, 44, 90, 44};
    theme.axisX = {200, 60, 50, 150};
    theme.axisY = {24, 140, 70, 150};
    theme.text = {26, 32, 44};
    theme.halo = {255, 255, 255, 225};
    theme.casing = {52, 60, 76, 235};
    theme.shipLight = {252, 253, 255};
    theme.shipDark = {192, 202, 218};
    theme.shipLine = {50, 62, 86};
    theme.shipGlass = {20, 132, 190};
    theme.payloadLight = {255, 218, 130};
    theme.payloadDark = {226, 142, 44};
    theme.payloadLine = {140, 80, 8};
    theme.finish = {0, 130, 92};
    theme.hover = {126, 119, 230};
    theme.selection = {214, 48, 0};
    theme.collision = {78, 0, 90};
    theme.draft = {26, 32, 44};
    theme.snap = {224, 16, 146};
    theme.band = {98, 90, 210};
    theme.guide = {96, 36, 150};
    theme.overlayBox = {23, 14, 10};
    theme.overlayIncircle = {72, 40, 214};
    theme.overlayVelocity = {124, 0, 0};
    theme.overlayOrientation = {10, 150, 182};
    theme.overlayNormal = {140, 142, 78};
    theme.overlayCell = {19, 105, 69};
    return theme;
}

BodyColors onPaper(BodyKind kind, bool round, bool polygon) {
    switch (kind) {
    case BodyKind::Static:
        return {{118, 116, 112, 74}, {46, 54, 68}};
    case BodyKind::Dynamic:
        return round     ? BodyColors{{80, 168, 104, 96}, {18, 112, 56}}
               : polygon ? BodyColors{{146, 122, 214, 96}, {102, 62, 180}}
                         : BodyColors{{206, 186, 60, 96}, {128, 104, 0}};
    case BodyKind::Kinematic:
        break;
    }
    return round     ? BodyColors{{84, 104, 222, 96}, {48, 68, 200}}
           : polygon ? BodyColors{{224, 136, 124, 96}, {186, 48, 38}}
                     : BodyColors{{70, 172, 84, 96}, {8, 120, 28}};
}

Theme onTheBoard(Theme theme) {
    theme.rock.setAlpha(rockOnTheBoard);
    return theme;
}

} // namespace

BodyColors Theme::body(BodyKind kind, const Shape& shape) const {
    const bool round = std::holds_alternative<Circle>(shape);
    const bool polygon = std::holds_alternative<Polygon>(shape);
    if (shade == Shade::Light) {
        return onPaper(kind, round, polygon);
    }
    switch (kind) {
    case BodyKind::Static:
        return {{210, 200, 200, 90}, {226, 222, 214}};
    case BodyKind::Dynamic:
        return round     ? BodyColors{{150, 200, 150, 128}, {150, 250, 200}}
               : polygon ? BodyColors{{150, 150, 200, 128}, {205, 165, 255}}
                         : BodyColors{{200, 200, 100, 128}, {250, 250, 75}};
    case BodyKind::Kinematic:
        break;
    }
    return round     ? BodyColors{{80, 90, 220, 140}, {130, 150, 255}}
           : polygon ? BodyColors{{200, 150, 150, 120}, {255, 120, 110}}
                     : BodyColors{{100, 200, 100, 128}, {80, 215, 80}};
}

QColor Theme::connector(double distance, double length) {
    return QColor::fromHsvF(static_cast<float>(connectorHue(distance, length)), 1, 1);
}

const Theme& canvasTheme() {
    static const Theme theme;
    return theme;
}

const Theme& editingTheme(Shade shade) {
    static const Theme dark = onTheBoard({});
    static const Theme light = onTheBoard(paper());
    return shade == Shade::Dark ? dark : light;
}

QPen stroke(const QColor& color, double width, Qt::PenStyle style) {
    return {color, width, style, style == Qt::SolidLine ? Qt::RoundCap : Qt::FlatCap, Qt::RoundJoin};
}

} // namespace spacetow
