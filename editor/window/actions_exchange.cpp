// Import and export.
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

void importFile(MainWindow& window) {
    window.enterTyping();
    window.finishDrawing();
    window.messageBar().dismiss();
    window.exchange().chooseAndImport();
}

template <void (Exchange::*write)()>
void exportWith(MainWindow& window) {
    window.enterTyping();
    window.messageBar().dismiss();
    (window.exchange().*write)();
}

constexpr ActionRow exchangeRows[] = {
    {.id = Act::Import,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Import…"),
     .icon = "import",
     .keys = "Ctrl+Alt+O",
     .tip = QT_TRANSLATE_NOOP("Actions", "Add an SVG drawing, a map of Tiled or a scene of R.U.B.E. to the level"),
     .flags = SeparatorBefore,
     .run = importFile},
    {.id = Act::ExportAs,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Export As…"),
     .icon = "export",
     .keys = "Ctrl+Shift+E",
     .tip = QT_TRANSLATE_NOOP("Actions", "Write a picture of the level, as PNG or SVG"),
     .run = exportWith<&Exchange::exportAs>},
    {.id = Act::ExportAgain,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "E&xport Again"),
     .icon = "export-again",
     .keys = "Ctrl+E",
     .tip = QT_TRANSLATE_NOOP("Actions", "Write the picture once more, to the same file in the same way"),
     .run = exportWith<&Exchange::exportAgain>},
    {.id = Act::Screenshot,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "Screens&hot"),
     .icon = "screenshot",
     .keys = "Ctrl+F12",
     .tip = QT_TRANSLATE_NOOP("Actions", "Write what the canvas shows to your pictures"),
     .run = [](MainWindow& window) { window.exchange().takeScreenshot(); }},
};

} // namespace

std::span<const ActionRow> exchangeActions() {
    return exchangeRows;
}

} // namespace spacetow
