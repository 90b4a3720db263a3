#include "editor/panels/plot_names.h"

#include "editor/panels/names.h"

#include <QCoreApplication>

#include <array>

namespace spacetow {

namespace {

constexpr std::array<const char*, plotQuantityCount> quantityNames{
    QT_TRANSLATE_NOOP("Plots", "x"),
    QT_TRANSLATE_NOOP("Plots", "y"),
    QT_TRANSLATE_NOOP("Plots", "angle"),
    QT_TRANSLATE_NOOP("Plots", "velocity to the right"),
    QT_TRANSLATE_NOOP("Plots", "velocity upwards"),
    QT_TRANSLATE_NOOP("Plots", "speed"),
    QT_TRANSLATE_NOOP("Plots", "angular velocity"),
    QT_TRANSLATE_NOOP("Plots", "force to the right"),
    QT_TRANSLATE_NOOP("Plots", "force upwards"),
    QT_TRANSLATE_NOOP("Plots", "force of contacts"),
    QT_TRANSLATE_NOOP("Plots", "kinetic energy"),
    QT_TRANSLATE_NOOP("Plots", "potential energy"),
    QT_TRANSLATE_NOOP("Plots", "energy"),
    QT_TRANSLATE_NOOP("Plots", "momentum to the right"),
    QT_TRANSLATE_NOOP("Plots", "momentum upwards"),
    QT_TRANSLATE_NOOP("Plots", "spin"),
    QT_TRANSLATE_NOOP("Plots", "length"),
    QT_TRANSLATE_NOOP("Plots", "tension"),
    QT_TRANSLATE_NOOP("Plots", "elastic energy"),
    QT_TRANSLATE_NOOP("Plots", "energy of everything"),
    QT_TRANSLATE_NOOP("Plots", "kinetic energy of everything"),
    QT_TRANSLATE_NOOP("Plots", "potential energy of everything"),
    QT_TRANSLATE_NOOP("Plots", "elastic energy of everything"),
    QT_TRANSLATE_NOOP("Plots", "drift of energy"),
    QT_TRANSLATE_NOOP("Plots", "momentum of everything to the right"),
    QT_TRANSLATE_NOOP("Plots", "momentum of everything upwards"),
    QT_TRANSLATE_NOOP("Plots", "drift of momentum"),
    QT_TRANSLATE_NOOP("Plots", "angular momentum of everything"),
};

constexpr std::array<const char*, stepStageCount> stageNames{
    QT_TRANSLATE_NOOP("Plots", "Changes"),  QT_TRANSLATE_NOOP("Plots", "Motion"),
    QT_TRANSLATE_NOOP("Plots", "Pairs"),    QT_TRANSLATE_NOOP("Plots", "Contacts"),
    QT_TRANSLATE_NOOP("Plots", "Solver"),   QT_TRANSLATE_NOOP("Plots", "Time of impact"),
    QT_TRANSLATE_NOOP("Plots", "Crushing"), QT_TRANSLATE_NOOP("Plots", "Advance"),
    QT_TRANSLATE_NOOP("Plots", "Touches"),  QT_TRANSLATE_NOOP("Plots", "Sleep"),
};

} // namespace

QString quantityName(PlotQuantity quantity) {
    return QCoreApplication::translate("Plots", quantityNames[static_cast<std::size_t>(quantity)]);
}

QString curveName(const Level& level, const PlotSource& source) {
    const Object* object = level.objects.find(source.object);
    const QString what = quantityName(source.quantity);
    return object == nullptr ? what : QCoreApplication::translate("Plots", "%1: %2").arg(displayName(*object), what);
}

QString stageName(StepStage stage) {
    return QCoreApplication::translate("Plots", stageNames[static_cast<std::size_t>(stage)]);
}

} // namespace spacetow
