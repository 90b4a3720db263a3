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
    {.id = Act::Stop,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "&Stop"),
     .icon = "stop",
     .keys = "F8",
     .tip = QT_TRANSLATE_NOOP("Actions", "Go back to the level as it was"),
     .flags = WhilePlaying | OnlyPlaying | OnMainBar,
     .run = [](MainWindow& window) { window.stopPlaying(); }},
    {.id = Act::Pause,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "Pa&use"),
     .icon = "pause",
     .keys = "F9",
     .tip = QT_TRANSLATE_NOOP("Actions", "Hold the game"),
     .flags = WhilePlaying | OnlyPlaying | SeparatorBefore | OnMainBar,
     .toggle = [](MainWindow& window, bool on) { window.playView().setPaused(on); },
     .isOn = [](const MainWindow& window) { return window.playView().isPaused(); }},
    {.id = Act::Step,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "&Next Frame"),
     .icon = "step",
     .keys = "F10",
     .tip = QT_TRANSLATE_NOOP("Actions", "Hold the game and advance it by one update"),
     .flags = WhilePlaying | OnlyPlaying | OnMainBar,
     .run = [](MainWindow& window) { window.playView().stepOnce(); }},
    {.id = Act::Restart,
     .menu = MenuId::Play,
     .text = QT_TRANSLATE_NOOP("Actions", "&Restart"),
     .icon = "restart",
     .keys = "Shift+F5",
     .tip = QT_TRANSLATE_NOOP("Actions", "Play the level from its beginning"),
     .flags = WhilePlaying | OnlyPlaying,
     .run = [](MainWindow& window) { window.playView().restart(); }},
};

} // namespace

std::span<const ActionRow> playActions() {
    return playRows;
}

} // namespace spacetow
