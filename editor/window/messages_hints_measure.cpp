// What the measure tool says.
#include "editor/window/messages_table.h"

#include <QtGlobal>

namespace spacetow {

namespace {

constexpr HintText measureTexts[] = {
    {"measure.start", QT_TRANSLATE_NOOP("messages", "Measure · drag from one point to the other, or click both · Ctrl: "
                                                    "snap off/on")},
    {"measure.first",
     QT_TRANSLATE_NOOP("messages", "%1 m, across %2 m, upwards %3 m, %4° · click or release: done · Shift: 15° · "
                                   "Ctrl: snap off/on · Escape: clear")},
    {"measure.same-point", QT_TRANSLATE_NOOP("messages", "First point · click the other one · Escape: clear")},
    {"measure.done", QT_TRANSLATE_NOOP("messages", "%1 m, across %2 m, upwards %3 m, %4° · Ctrl+C: copy · drag: "
                                                   "measure anew · Escape: clear")},
    {"measure.second",
     QT_TRANSLATE_NOOP("messages", "%1 m, across %2 m, upwards %3 m, %4° · click: angle %5° · Ctrl+C: copy · drag: "
                                   "measure anew · Escape: clear")},
    {"measure.angle", QT_TRANSLATE_NOOP("messages", "Angle %1° between %2 m and %3 m · Ctrl+C: copy · click or drag: "
                                                    "measure anew · Escape: clear")},
};

} // namespace

std::span<const HintText> measureHints() {
    return measureTexts;
}

} // namespace spacetow
