// The windows of the program.
#include "editor/window/application.h"
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

bool hasApplication(const MainWindow& window) {
    return window.application() != nullptr;
}

constexpr ActionRow windowRows[] = {
    {.id = Act::NewWindow,
     .menu = MenuId::Window,
     .text = QT_TRANSLATE_NOOP("Actions", "New &Window"),
     .icon = "new",
     .keys = "Ctrl+Alt+N",
     .tip = QT_TRANSLATE_NOOP("Actions", "Start an empty level in another window"),
     .flags = WithoutLevel | WhilePlaying,
     .run = [](MainWindow& window) { window.application()->newWindow(&window); },
     .isPossible = hasApplication,
     .why = QT_TRANSLATE_NOOP("Actions", "This window stands alone.")},
    {.id = Act::NewView,
     .menu = MenuId::Window,
     .text = QT_TRANSLATE_NOOP("Actions", "New &View"),
     .icon = "duplicate-in-place",
     .keys = "Ctrl+Alt+W",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show this level in a second window, at another place or another size"),
     .run = [](MainWindow& window) { window.application()->newView(window); },
     .isPossible = hasApplication,
     .why = QT_TRANSLATE_NOOP("Actions", "This window stands alone.")},
    {.id = Act::NextWindow,
     .menu = MenuId::Window,
     .text = QT_TRANSLATE_NOOP("Actions", "&Next Window"),
     .icon = "next",
     .keys = "Ctrl+F6",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go on in the next window of the program"),
     .flags = WithoutLevel | WhilePlaying,
     .run = [](MainWindow& window) { window.application()->showNext(window); },
     .isPossible =
         [](const MainWindow& window) {
             return window.application() != nullptr && window.application()->windows().size() > 1;
         },
     .why = QT_TRANSLATE_NOOP("Actions", "There is no other window.")},
    {.id = Act::Welcome,
     .menu = MenuId::Window,
     .text = QT_TRANSLATE_NOOP("Actions", "Welcome &Page"),
     .icon = "spacetow",
     .keys = "Ctrl+Alt+Home",
     .tip = QT_TRANSLATE_NOOP("Actions", "Choose among recent levels and those that come with the program"),
     .flags = SeparatorBefore,
     .run =
         [](MainWindow& window) {
             if (window.application() != nullptr) {
                 window.application()->showWelcome(window);
             } else {
                 window.showWelcome();
             }
         }},
    {.id = Act::RestoreWindows,
     .menu = MenuId::Window,
     .text = QT_TRANSLATE_NOOP("Actions", "&Reopen Windows at Start"),
     .keys = "Ctrl+Alt+S",
     .tip = QT_TRANSLATE_NOOP("Actions", "Begin with the levels that were open when the program was left"),
     .flags = WithoutLevel | WhilePlaying,
     .toggle = [](MainWindow& window, bool on) { window.files().preferences.setRestoresWindows(on); },
     .isOn = [](const MainWindow&) { return Preferences().restoresWindows(); }},
};

} // namespace

std::span<const ActionRow> windowActions() {
    return windowRows;
}

} // namespace spacetow
