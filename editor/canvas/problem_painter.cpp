#include "editor/canvas/problem_painter.h"

#include "editor/canvas/way_out_painter.h"

#include <QPainterPath>

#include <map>

namespace spacetow {

namespace {

constexpr double cell = 16;    // px: signs closer than that would cover each other
constexpr double side = 11;    // px, of a sign
constexpr int mostLines = 400; // in view; with more of them nothing could be told apart

QColor colorOf(Severity severity, const MarkColors& colors, const Theme& theme) {
    return severity == Severity::Error ? colors.error : severity == Severity::Warning ? colors.warning : theme.text;
}

/// A triangle for what is wrong, a dot for what could be tidied.
void paintSign(const Stage& stage, const ProblemMark& mark, const QColor& color, double size) {
    const QPointF at = stage.at(mark.at);
    QPainterPath sign;
    if (mark.severity == Severity::Note) {
        sign.addEllipse(at, 0.3 * size, 0.3 * size);
    } else {
        const double half = 0.5 * size;
        sign.addPolygon(
            QPolygonF{{at + QPointF(-half, 0.8 * half), at + QPointF(half, 0.8 * half), at + QPointF(0, -0.9 * half)}});
        sign.closeSubpath();
    }
    stage.painter.strokePath(sign, stroke(stage.theme.halo, 3));
    stage.painter.fillPath(sign, color);
    if (mark.severity != Severity::Note) {
        stage.painter.setPen(stroke(stage.theme.halo, 1.4));
        stage.painter.drawLine(at + QPointF(0, -0.16 * size), at + QPointF(0, 0.12 * size));
        stage.painter.drawPoint(at + QPointF(0, 0.28 * size));
    }
}

void paintLine(const Stage& stage, const ProblemMark& mark, QColor color, double width) {
    color.setAlpha(width > 3 ? 220 : 120);
    stage.painter.setPen(stroke(color, width));
    stage.painter.drawPolyline(stage.at(mark.line));
}

} // namespace

void paintProblems(const Stage& stage, std::span<const ProblemMark> marks, int current, const MarkColors& colors) {
    const SavedPainter saved(stage.painter);
    const Aabb seen = stage.view.visible().grown(cell * stage.view.pixel());
    std::map<std::pair<int, int>, const ProblemMark*> signs;
    const ProblemMark* chosen = nullptr;
    int lines = 0;
    for (const ProblemMark& mark : marks) {
        chosen = mark.problem == current ? &mark : chosen;
        paintWayOut(stage, mark.wayOut, colorOf(mark.severity, colors, stage.theme), mark.problem == current);
        Aabb box{mark.at, mark.at};
        for (const Vec2& point : mark.line) {
            box.include(point);
        }
        if (!seen.overlaps(box)) {
            continue;
        }
        if (!mark.line.empty() && ++lines <= mostLines) {
            paintLine(stage, mark, colorOf(mark.severity, colors, stage.theme), 3);
        }
        if (seen.contains(mark.at)) {
            const QPointF at = stage.at(mark.at);
            const ProblemMark*& sign = signs[{static_cast<int>(at.x() / cell), static_cast<int>(at.y() / cell)}];
            sign = sign == nullptr || sign->severity < mark.severity ? &mark : sign;
        }
    }
    for (const auto& [place, mark] : signs) {
        paintSign(stage, *mark, colorOf(mark->severity, colors, stage.theme), side);
    }
    if (chosen != nullptr) {
        const QColor color = colorOf(chosen->severity, colors, stage.theme);
        if (!chosen->line.empty()) {
            paintLine(stage, *chosen, color, 5);
        }
        paintSign(stage, *chosen, color, 1.5 * side);
        stage.painter.setPen(stroke(color, 2));
        stage.painter.setBrush(Qt::NoBrush);
        stage.painter.drawEllipse(stage.at(chosen->at), 1.5 * side, 1.5 * side);
    }
}

} // namespace spacetow
