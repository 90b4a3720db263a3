#include "editor/canvas/grid_painter.h"

#include <QPainter>

#include <cmath>

namespace spacetow {

namespace {

constexpr double closest = 9; // px between fine lines

/// The smallest of 1, 2, 5, 10, … times a power of ten that is a multiple of `step` and at least `least`.
double roundMultiple(double step, double least) {
    double power = std::pow(10, std::floor(std::log10(least)));
    for (int i = 0; i < 60; ++i, power *= 10) {
        for (const double digit : {1.0, 2.0, 2.5, 5.0}) {
            const double candidate = digit * power;
            const double times = candidate / step;
            if (candidate >= least * (1 - 1e-9) && std::abs(times - std::round(times)) < 1e-6) {
                return candidate;
            }
        }
    }
    return least;
}

/// Filled rectangles: a pen that is not opaque takes some twenty times as long.
void paintColumn(const Stage& stage, double x, const QColor& color) {
    stage.painter.fillRect(QRectF(std::floor(stage.at(Vec2(x, 0)).x()), 0, 1, stage.view.size.y()), color);
}
void paintRow(const Stage& stage, double y, const QColor& color) {
    stage.painter.fillRect(QRectF(0, std::floor(stage.at(Vec2(0, y)).y()), stage.view.size.x(), 1), color);
}

void paintLines(const Stage& stage, double step, const QColor& color) {
    const Aabb visible = stage.view.visible();
    const auto index = [step](double value) { return static_cast<long long>(std::ceil(value / step)); };
    for (long long i = index(visible.min.x()); i * step <= visible.max.x(); ++i) {
        paintColumn(stage, static_cast<double>(i) * step, color);
    }
    for (long long i = index(visible.min.y()); i * step <= visible.max.y(); ++i) {
        paintRow(stage, static_cast<double>(i) * step, color);
    }
}

/// What `color` looks like on the background, which it is painted on.
QColor opaque(const Stage& stage, const QColor& color) {
    const QColor& below = stage.theme.background;
    const auto mixed = [&](int above, int under) {
        return static_cast<int>(std::lround(under + (above - under) * color.alphaF()));
    };
    return {mixed(color.red(), below.red()), mixed(color.green(), below.green()), mixed(color.blue(), below.blue())};
}

} // namespace

GridSteps gridSteps(double step, double pixelsPerMetre) {
    const double least = std::max(step, closest / pixelsPerMetre);
    const double minor = least > step ? roundMultiple(step, least) : step;
    return {minor, roundMultiple(minor, 4 * minor)};
}

void paintGrid(const Stage& stage, double step) {
    if (!(step > 0)) {
        return;
    }
    stage.painter.save();
    stage.painter.setRenderHint(QPainter::Antialiasing, false);
    const GridSteps steps = gridSteps(step, stage.view.scale);
    paintLines(stage, steps.minor, opaque(stage, stage.theme.gridMinor));
    paintLines(stage, steps.major, opaque(stage, stage.theme.gridMajor));
    paintRow(stage, 0, opaque(stage, stage.theme.axisX));
    paintColumn(stage, 0, opaque(stage, stage.theme.axisY));
    stage.painter.restore();
}

} // namespace spacetow
