// What is drawn over bodies, while editing and while playing.
#include "core/base/contract.h"
#include "editor/canvas/overlay_table.h"
#include "editor/window/main_window.h"

#include <utility>
#include <vector>

namespace spacetow {

namespace {

constexpr auto firstOverlay = static_cast<std::size_t>(Act::OverlayAabb);
constexpr std::size_t overlayCount = static_cast<std::size_t>(Act::OverlaysOff) - firstOverlay;
constexpr std::size_t withDigit = 9;

template <std::size_t index>
void setOverlay(MainWindow& window, bool on) {
    OverlayFlags flags = window.overlays();
    flags.*overlayRows()[index].flag = on;
    window.setOverlays(flags);
}

template <std::size_t index>
bool hasOverlay(const MainWindow& window) {
    return window.overlays().*overlayRows()[index].flag;
}

template <std::size_t index>
ActionRow overlayAction() {
    const OverlayRow& row = overlayRows()[index];
    ActionRow action{.id = static_cast<Act>(firstOverlay + index),
                     .menu = MenuId::Overlays,
                     .text = row.text,
                     .icon = row.icon,
                     .keys = row.keys,
                     .tip = row.tip,
                     .flags = NoFlag,
                     .toggle = setOverlay<index>,
                     .isOn = hasOverlay<index>};
    // A game selects nothing that could collide, and has the plain key.
    action.flags |= row.flag == &OverlayFlags::collides ? NoFlag : WhilePlaying;
    action.flags |= row.onMainBar ? OnMainBar : NoFlag;
    action.flags |= index == withDigit ? SeparatorBefore : NoFlag;
    return action;
}

template <std::size_t... index>
std::vector<ActionRow> tableActions(std::index_sequence<index...> /*of the table*/) {
    EXPECTS(overlayRows().size() == overlayCount);
    return {overlayAction<index>()...};
}

constexpr ActionRow otherOverlayRows[] = {
    {.id = Act::OverlaysOff,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&All Off"),
     .icon = "overlay-none",
     .keys = "Alt+0",
     .tip = QT_TRANSLATE_NOOP("Actions", "Hide all overlays"),
     .flags = WhilePlaying | SeparatorBefore,
     .run = [](MainWindow& window) { window.setOverlays({.ways = false, .problems = window.overlays().problems}); }},
    {.id = Act::OverlayProblems,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Problems"),
     .icon = "warning",
     .keys = "Shift+P",
     .tip = QT_TRANSLATE_NOOP("Actions", "Mark the places of all problems of the level"),
     .flags = SeparatorBefore,
     .toggle =
         [](MainWindow& window, bool on) {
             OverlayFlags flags = window.overlays();
             flags.problems = on;
             window.setOverlays(flags);
         },
     .isOn = [](const MainWindow& window) { return window.overlays().problems; }},
    {.id = Act::Reach,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "Reach o&f the Ship"),
     .icon = "reach",
     .keys = "Ctrl+F3",
     .tip =
         QT_TRANSLATE_NOOP("Actions", "Show where the ship, and the payload on its rope, can be in the next seconds: "
                                      "from its start, or from where it is in a run that is paused"),
     .flags = WhilePlaying,
     .toggle = [](MainWindow& window, bool on) { window.reach().setOn(on); },
     .isOn = [](const MainWindow& window) { return window.reach().isOn(); }},
    {.id = Act::ReachLonger,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "Reach a Second Longer"),
     .icon = "next",
     .keys = "F12",
     .tip = QT_TRANSLATE_NOOP("Actions", "Look a second further ahead, up to five"),
     .flags = WhilePlaying,
     .run = [](MainWindow& window) { window.reach().setSeconds(window.reach().seconds() + 1); }},
    {.id = Act::ReachShorter,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "Reach a Second Shorter"),
     .icon = "previous",
     .keys = "Shift+F12",
     .tip = QT_TRANSLATE_NOOP("Actions", "Look less far ahead, down to one second"),
     .flags = WhilePlaying,
     .run = [](MainWindow& window) { window.reach().setSeconds(window.reach().seconds() - 1); }},
    {.id = Act::OverlayLegend,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "&Legend"),
     .icon = "legend",
     .keys = "Alt+Shift+Y",
     .tip = QT_TRANSLATE_NOOP("Actions", "Explain the colors of the overlays that are on, in a corner of the canvas"),
     .flags = WhilePlaying | SeparatorBefore,
     .toggle = [](MainWindow& window, bool on) { window.setLegendShown(on); },
     .isOn = [](const MainWindow& window) { return window.isLegendShown(); }},
    {.id = Act::OverlayColors,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "Overlay Colors…"),
     .icon = "palette",
     .keys = "Ctrl+Alt+Y",
     .tip = QT_TRANSLATE_NOOP("Actions", "Choose the set of colors of the overlays, and colors of your own for each"),
     .flags = WhilePlaying,
     .run = [](MainWindow& window) { window.chooseOverlayColors(); }},
    {.id = Act::OverlayColorsSafe,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "Color-Blind-Safe Colors"),
     .icon = "palette",
     .keys = "Alt+Shift+U",
     .tip =
         QT_TRANSLATE_NOOP("Actions", "Draw the overlays in the colors of Okabe and Ito, which everybody tells apart"),
     .flags = WhilePlaying,
     .toggle =
         [](MainWindow& window, bool on) {
             OverlayPalette palette = window.overlayPalette();
             palette.set = on ? OverlayColorSet::OkabeIto : OverlayColorSet::Standard;
             window.setOverlayPalette(palette);
         },
     .isOn = [](const MainWindow& window) { return window.overlayPalette().set == OverlayColorSet::OkabeIto; }},
    {.id = Act::OverlayColorsReset,
     .menu = MenuId::Overlays,
     .text = QT_TRANSLATE_NOOP("Actions", "Forget Own Colors"),
     .icon = "reset",
     .keys = "Alt+Shift+J",
     .tip = QT_TRANSLATE_NOOP("Actions", "Give all overlays the colors of the set again"),
     .flags = WhilePlaying,
     .run =
         [](MainWindow& window) {
             OverlayPalette palette = window.overlayPalette();
             palette.own.clear();
             window.setOverlayPalette(palette);
         },
     .isPossible = [](const MainWindow& window) { return !window.overlayPalette().own.empty(); },
     .why = QT_TRANSLATE_NOOP("Actions", "No overlay has a color of your own: click one in the legend.")},
};

} // namespace

std::span<const ActionRow> overlayActions() {
    static const std::vector<ActionRow> rows = [] {
        std::vector<ActionRow> all = tableActions(std::make_index_sequence<overlayCount>());
        all.insert(all.end(), std::begin(otherOverlayRows), std::end(otherOverlayRows));
        return all;
    }();
    return rows;
}

} // namespace spacetow
