// New, open, save, quit.
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

void startNew(MainWindow& window) {
    window.enterTyping();
    window.finishDrawing();
    window.messageBar().dismiss();
    window.files().startNew();
}

void openFile(MainWindow& window) {
    window.enterTyping();
    window.finishDrawing();
    window.messageBar().dismiss();
    window.files().chooseAndOpen();
}

template <bool (Files::*save)()>
void saveWith(MainWindow& window) {
    window.enterTyping();
    if ((window.files().*save)()) {
        window.messageBar().dismiss();
        window.statusLine().showMessage(MainWindow::tr("Saved %1").arg(window.files().path()), 4000);
    }
}

constexpr ActionRow fileRows[] = {
    {.id = Act::New,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&New"),
     .icon = "new",
     .keys = "Ctrl+N",
     .tip = QT_TRANSLATE_NOOP("Actions", "Start an empty level"),
     .flags = OnMainBar,
     .run = startNew},
    {.id = Act::Open,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Open…"),
     .icon = "open",
     .keys = "Ctrl+O",
     .tip = QT_TRANSLATE_NOOP("Actions", "Open a level file"),
     .flags = OnMainBar,
     .run = openFile},
    {.id = Act::Save,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Save"),
     .icon = "save",
     .keys = "Ctrl+S",
     .tip = QT_TRANSLATE_NOOP("Actions", "Write the level to its file"),
     .flags = SeparatorBefore | OnMainBar,
     .run = saveWith<&Files::save>},
    {.id = Act::SaveAs,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "Save &As…"),
     .icon = "save-as",
     .keys = "Ctrl+Shift+S",
     .tip = QT_TRANSLATE_NOOP("Actions", "Write the level to another file"),
     .run = saveWith<&Files::saveAs>},
    {.id = Act::Quit,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Quit"),
     .icon = "quit",
     .keys = "Ctrl+Q",
     .tip = QT_TRANSLATE_NOOP("Actions", "Leave the program"),
     .flags = WhilePlaying | SeparatorBefore,
     .run = [](MainWindow& window) { window.close(); }},
};

} // namespace

std::span<const ActionRow> fileActions() {
    return fileRows;
}

} // namespace spacetow
