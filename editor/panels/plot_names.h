#pragma once
// What quantities and stages are called.

#include "core/game/plot_quantity.h"
#include "core/physics/def/stage_times.h"

#include <QString>

namespace spacetow {

QString quantityName(PlotQuantity quantity);
/// "Ball: speed".
QString curveName(const Level& level, const PlotSource& source);
QString stageName(StepStage stage);

} // namespace spacetow
