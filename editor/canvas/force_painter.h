#pragma once
// The forces on one body as arrows: each from where it acts, as long as it is strong, with a word beside it. The
// longest is always as long; the others by comparison.

#include "core/physics/query/explain.h"
#include "editor/canvas/label_painter.h"
#include "editor/canvas/stage.h"

#include <vector>

namespace spacetow {

struct ForceArrow {
    enum class Source : std::uint8_t { Gravity, Applied, Connectors, Contact, Damping };

    Source source = Source::Gravity;
    Vec2 at{0, 0};    // world
    Vec2 force{0, 0}; // N
};

/// Those that can be told from nothing beside the strongest; every contact has its own.
std::vector<ForceArrow> forceArrows(const World& world, BodyId body);

QString forceName(ForceArrow::Source source);
/// As people who see fewer colours tell them apart; words stand beside them anyway.
QColor forceColor(ForceArrow::Source source, Shade shade);

void paintForces(const Stage& stage, const std::vector<ForceArrow>& arrows, LabelPainter& labels);

} // namespace spacetow
