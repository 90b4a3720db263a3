// New, open, save, close, quit.
#include "editor/window/application.h"
#include "editor/window/dropped_files.h"
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

void openFile(MainWindow& window) {
    window.enterTyping();
    openDropped(window.files().chosen(), window);
}

void reopenClosed(MainWindow& window) {
    window.enterTyping();
    window.finishDrawing();
    window.messageBar().dismiss();
    window.application()->reopenClosed(window);
}

void closeLevel(MainWindow& window) {
    if (window.application() != nullptr) {
        window.application()->close(window);
    } else {
        window.close();
    }
}

void quit(MainWindow& window) {
    if (window.application() != nullptr) {
        window.application()->quit();
    } else {
        window.close();
    }
}

template <bool (Files::*save)()>
void saveWith(MainWindow& window) {
    window.enterTyping();
    if ((window.files().*save)()) {
        window.statusLine().showMessage(MainWindow::tr("Saved %1").arg(window.files().path()), 4000);
    }
}

void reload(MainWindow& window) {
    const QString path = window.files().path();
    window.fileReader().read({path}, [&window, path](const std::vector<FileToOpen>& files) {
        if (files.empty() || window.files().path() != path) {
            return; // nobody waits for it any more
        }
        window.enterTyping();
        window.finishDrawing();
        window.messageBar().dismiss();
        if (window.files().reload(files.front().read)) {
            window.diskChanges().dismiss();
            window.statusLine().showMessage(MainWindow::tr("Read %1 again").arg(path), 4000);
        }
    });
}

constexpr ActionRow fileRows[] = {
    {.id = Act::New,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&New"),
     .icon = "new",
     .keys = "Ctrl+N",
     .tip = QT_TRANSLATE_NOOP("Actions", "Start an empty level"),
     .flags = WithoutLevel | OnMainBar,
     .run = [](MainWindow& window) { window.startNew(); }},
    {.id = Act::Open,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Open…"),
     .icon = "open",
     .keys = "Ctrl+O",
     .tip = QT_TRANSLATE_NOOP("Actions", "Open a level file"),
     .flags = WithoutLevel | OnMainBar,
     .run = openFile},
    {.id = Act::ReopenClosed,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "Reopen Closed &Level"),
     .icon = "restart",
     .keys = "Ctrl+Shift+T",
     .tip = QT_TRANSLATE_NOOP("Actions", "Open again the level that was closed last"),
     .flags = WithoutLevel,
     .run = reopenClosed,
     .isPossible =
         [](const MainWindow& window) { return window.application() != nullptr && window.application()->canReopen(); },
     .why = QT_TRANSLATE_NOOP("Actions", "No level has been closed yet.")},
    {.id = Act::QuickOpen,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "Q&uick Open…"),
     .icon = "search",
     .keys = "Ctrl+P",
     .tip = QT_TRANSLATE_NOOP("Actions", "Find a level by a few letters of its name: recent ones, those beside it, "
                                         "and those that come with the program"),
     .flags = WithoutLevel | WhilePlaying,
     .run = [](MainWindow& window) { window.finder().open(QStringLiteral("/")); }},
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
    {.id = Act::Reload,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "Reloa&d"),
     .icon = "reload",
     .keys = "Ctrl+R",
     .tip = QT_TRANSLATE_NOOP("Actions", "Read the level from its file again; Undo brings back what it is now"),
     .flags = SeparatorBefore,
     .run = reload,
     .isPossible = [](const MainWindow& window) { return !window.files().path().isEmpty(); },
     .why = QT_TRANSLATE_NOOP("Actions", "The level has no file yet.")},
    {.id = Act::Recover,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "Reco&ver Unsaved Work…"),
     .icon = "recover",
     .keys = "Ctrl+Alt+J",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show what was left unsaved when the program ended all of a sudden"),
     .flags = WithoutLevel,
     .run = [](MainWindow& window) { window.offerRecovery(true); }},
};

constexpr ActionRow leaveRows[] = {
    {.id = Act::Close,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Close"),
     .icon = "close",
     .keys = "Ctrl+W",
     .tip = QT_TRANSLATE_NOOP("Actions", "Close this level and its window"),
     .flags = WithoutLevel | WhilePlaying | SeparatorBefore,
     .run = closeLevel},
    {.id = Act::Quit,
     .menu = MenuId::File,
     .text = QT_TRANSLATE_NOOP("Actions", "&Quit"),
     .icon = "quit",
     .keys = "Ctrl+Q",
     .tip = QT_TRANSLATE_NOOP("Actions", "Close all windows and leave the program"),
     .flags = WithoutLevel | WhilePlaying,
     .run = quit},
};

} // namespace

std::span<const ActionRow> fileActions() {
    return fileRows;
}

std::span<const ActionRow> leaveActions() {
    return leaveRows;
}

} // namespace spacetow
