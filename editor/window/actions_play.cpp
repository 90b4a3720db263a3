// Starting, holding and ending a game.
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

constexpr ActionRow playRows[] = {
    {.id = Act::Play,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "&Play"),
     .icon = "play",
     .keys = "F5",
     .tip = QT_TRANSLATE_NOOP("Actions", "Play a copy of the level, here and now"),
     .flags = OnMainBar,
     .run = [](MainWindow& window) { window.play(); }},
    {.id = Act::Simulate,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "S&imulate"),
     .icon = "simulate",
     .keys = "Ctrl+F5",
     .tip = QT_TRANSLATE_NOOP("Actions", "Let the bodies of the level move in place, and go on editing beside"),
     .flags = OnMainBar,
     .run = [](MainWindow& window) { window.simulate(); },
     .isPossible = [](const MainWindow& window) { return !window.isPlaying(); },
     .why = QT_TRANSLATE_NOOP("Actions", "The level runs already.")},
    {.id = Act::PlayFromHere,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "Play from &Pointer"),
     .icon = "play-from-here",
     .keys = "F6",
     .tip = QT_TRANSLATE_NOOP("Actions", "Play a copy of the level in which the ship starts where the pointer is"),
     .run = [](MainWindow& window) { window.playFromPointer(); }},
    {.id = Act::Stop,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "&Stop"),
     .icon = "stop",
     .keys = "F8",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go back to the drawing board"),
     .flags = WhilePlaying | OnlyPlaying | OnMainBar,
     .run = [](MainWindow& window) { window.stopPlaying(); }},
    {.id = Act::Pause,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "Pa&use"),
     .icon = "pause",
     .keys = "F9",
     .tip = QT_TRANSLATE_NOOP("Actions", "Hold what runs, or let it go on"),
     .flags = WhilePlaying | OnlyPlaying | SeparatorBefore | OnMainBar,
     .toggle = [](MainWindow& window, bool on) { window.liveRun().setPaused(on); },
     .isOn = [](const MainWindow& window) { return window.liveRun().isPaused(); }},
    {.id = Act::Step,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "&Next Frame"),
     .icon = "step",
     .keys = "F10",
     .tip = QT_TRANSLATE_NOOP("Actions", "Hold what runs and advance it by one update"),
     .flags = WhilePlaying | OnlyPlaying | OnMainBar,
     .run = [](MainWindow& window) { window.liveRun().stepOnce(); }},
    {.id = Act::Restart,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "&Restart"),
     .icon = "restart",
     .keys = "Shift+F5",
     .tip = QT_TRANSLATE_NOOP("Actions", "Run the level from its beginning"),
     .flags = WhilePlaying | OnlyPlaying,
     .run = [](MainWindow& window) { window.liveRun().restart(); }},
};

} // namespace

std::span<const ActionRow> playActions() {
    return playRows;
}

} // namespace spacetow
