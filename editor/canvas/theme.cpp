#include "editor/canvas/theme.h"

#include "core/physics/debug_draw.h"
#include "editor/canvas/stage.h"

namespace spacetow {

BodyColors Theme::body(BodyKind kind, const Shape& shape) const {
    const bool round = std::holds_alternative<Circle>(shape);
    const bool polygon = std::holds_alternative<Polygon>(shape);
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

const Theme& editingTheme() {
    static const Theme theme = [] {
        Theme changed;
        changed.rock.setAlpha(190);
        return changed;
    }();
    return theme;
}

QPen stroke(const QColor& color, double width, Qt::PenStyle style) {
    return {color, width, style, style == Qt::SolidLine ? Qt::RoundCap : Qt::FlatCap, Qt::RoundJoin};
}

} // namespace spacetow
