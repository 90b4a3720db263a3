#include "editor/canvas/grid_painter.h"

#include <QLineF>
#include <QVector>

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

void paintLines(const Stage& stage, double step, const QColor& color) {
    const Aabb visible = stage.view.visible();
    QVector<QLineF> lines;
    const auto index = [step](double value) { return static_cast<long long>(std::ceil(value / step)); };
    for (long long i = index(visible.min.x()); i * step <= visible.max.x(); ++i) {
        const double x = std::floor(stage.at(Vec2(static_cast<double>(i) * step, 0)).x()) + 0.5;
        lines << QLineF(x, 0, x, stage.view.size.y());
    }
    for (long long i = index(visible.min.y()); i * step <= visible.max.y(); ++i) {
        const double y = std::floor(stage.at(Vec2(0, static_cast<double>(i) * step)).y()) + 0.5;
        lines << QLineF(0, y, stage.view.size.x(), y);
    }
    stage.painter.setPen(stroke(color, 1));
    stage.painter.drawLines(lines);
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
    paintLines(stage, steps.minor, stage.theme.gridMinor);
    paintLines(stage, steps.major, stage.theme.gridMajor);
    const QPointF origin = stage.at(Vec2(0, 0));
    stage.painter.setPen(stroke(stage.theme.axisX, 1));
    stage.painter.drawLine(QLineF(0, std::floor(origin.y()) + 0.5, stage.view.size.x(), std::floor(origin.y()) + 0.5));
    stage.painter.setPen(stroke(stage.theme.axisY, 1));
    stage.painter.drawLine(QLineF(std::floor(origin.x()) + 0.5, 0, std::floor(origin.x()) + 0.5, stage.view.size.y()));
    stage.painter.restore();
}

} // namespace spacetow
