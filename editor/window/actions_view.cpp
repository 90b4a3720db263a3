// What part of the level is shown, and what beside it.
#include "editor/editing/guide_verbs.h"
#include "editor/window/main_window.h"

namespace spacetow {

namespace {

constexpr double zoomStep = 1.25;

/// Light and dark switched off leave it to the desktop; leaving it to the desktop switched off keeps what is seen.
template <Appearance appearance>
void setAppearance(MainWindow& window, bool on) {
    const Appearance seen = shadeOf(window.palette()) == Shade::Dark ? Appearance::Dark : Appearance::Light;
    window.setAppearance(on ? appearance : appearance == Appearance::System ? seen : Appearance::System);
}

template <Appearance appearance>
bool hasAppearance(const MainWindow& window) {
    return window.appearance() == appearance;
}

void setFullScreen(MainWindow& window, bool on) {
    window.setWindowState(on ? window.windowState() | Qt::WindowFullScreen
                             : window.windowState() & ~Qt::WindowFullScreen);
}

constexpr ActionRow viewRows[] = {
    {.id = Act::ZoomIn,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "Zoom &In"),
     .icon = "zoom-in",
     .keys = "Ctrl+= Ctrl++ + =",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show less of the level, larger"),
     .flags = OnMainBar | WhilePlaying | YieldsToGame,
     .run = [](MainWindow& window) { window.canvas().zoom(zoomStep); }},
    {.id = Act::ZoomOut,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "Zoom &Out"),
     .icon = "zoom-out",
     .keys = "Ctrl+- -",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show more of the level, smaller"),
     .flags = OnMainBar | WhilePlaying | YieldsToGame,
     .run = [](MainWindow& window) { window.canvas().zoom(1 / zoomStep); }},
    {.id = Act::ZoomReset,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "Original Si&ze"),
     .icon = "zoom-reset",
     .keys = "Ctrl+0 1",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the level as large as in the game"),
     .flags = WhilePlaying | YieldsToGame,
     .run = [](MainWindow& window) { window.canvas().zoomTo(Viewport().scale); }},
    {.id = Act::FitLevel,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "&Fit Level"),
     .icon = "zoom-fit",
     .keys = "Ctrl+/ 4",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the whole level"),
     .flags = OnMainBar | WhilePlaying | YieldsToGame,
     .run = [](MainWindow& window) { window.canvas().fitLevel(); }},
    {.id = Act::Center,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "&Center Selection"),
     .icon = "center",
     .keys = "F",
     .tip = QT_TRANSLATE_NOOP("Actions", "Bring the selection to the middle of the view"),
     .run = [](MainWindow& window) { window.canvas().centerSelection(); }},
    {.id = Act::Frame,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "Fra&me Selection"),
     .keys = "Shift+F 3",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the selection as large as fits"),
     .run = [](MainWindow& window) { window.canvas().frameSelection(); }},
    {.id = Act::Grid,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "&Grid"),
     .icon = "grid",
     .keys = "G #",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the grid"),
     .flags = SeparatorBefore | OnMainBar,
     .toggle = [](MainWindow& window, bool on) { window.setGridVisible(on); },
     .isOn = [](const MainWindow& window) { return window.canvas().isGridVisible(); }},
    {.id = Act::Rulers,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "&Rulers"),
     .icon = "ruler",
     .keys = "Ctrl+Alt+R",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the rulers, out of which guides are dragged"),
     .toggle = [](MainWindow& window, bool on) { window.setRulersVisible(on); },
     .isOn = [](const MainWindow& window) { return window.canvasFrame().areRulersVisible(); }},
    {.id = Act::Guides,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "Guid&es"),
     .icon = "guide",
     .keys = "| Ctrl+Alt+G",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show the guides; what is hidden is neither taken nor snapped to"),
     .toggle = [](MainWindow& window, bool on) { window.setGuidesVisible(on); },
     .isOn = [](const MainWindow& window) { return window.canvas().areGuidesVisible(); }},
    {.id = Act::ClearGuides,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "&Delete All Guides"),
     .keys = "Alt+Shift+I",
     .tip = QT_TRANSLATE_NOOP("Actions", "Take all guides out of the level"),
     .run = [](MainWindow& window) { window.toolbox().finish(clearGuides(window.toolbox().context())); },
     .isPossible = [](const MainWindow& window) { return !window.document().level().guides.empty(); },
     .why = QT_TRANSLATE_NOOP("Actions", "The level has no guides.")},
    {.id = Act::HidePanels,
     .menu = MenuId::Panels,
     .text = QT_TRANSLATE_NOOP("Actions", "Hide &All"),
     .keys = "Tab",
     .tip = QT_TRANSLATE_NOOP("Actions", "Put all panels out of the way, and back as they were"),
     .flags = KeyOfCanvas | WhilePlaying,
     .toggle = [](MainWindow& window, bool on) { window.setPanelsHidden(on); },
     .isOn = [](const MainWindow& window) { return window.arePanelsHidden(); }},
    {.id = Act::FullScreen,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "F&ull Screen"),
     .keys = "F11",
     .tip = QT_TRANSLATE_NOOP("Actions", "Use the whole screen"),
     .flags = WithoutLevel | WhilePlaying | SeparatorBefore,
     .toggle = setFullScreen,
     .isOn = [](const MainWindow& window) { return window.isFullScreen(); }},
    {.id = Act::AppearanceSystem,
     .menu = MenuId::Appearance,
     .text = QT_TRANSLATE_NOOP("Actions", "Like &the Desktop"),
     .icon = "desktop",
     .keys = "Ctrl+F9",
     .tip = QT_TRANSLATE_NOOP("Actions", "Light or dark as the desktop is, and changing with it"),
     .flags = WithoutLevel | WhilePlaying,
     .toggle = setAppearance<Appearance::System>,
     .isOn = hasAppearance<Appearance::System>},
    {.id = Act::AppearanceLight,
     .menu = MenuId::Appearance,
     .text = QT_TRANSLATE_NOOP("Actions", "&Light"),
     .icon = "sun",
     .keys = "Ctrl+F10",
     .tip = QT_TRANSLATE_NOOP("Actions", "Light panels and a white drawing board"),
     .flags = WithoutLevel | WhilePlaying,
     .toggle = setAppearance<Appearance::Light>,
     .isOn = hasAppearance<Appearance::Light>},
    {.id = Act::AppearanceDark,
     .menu = MenuId::Appearance,
     .text = QT_TRANSLATE_NOOP("Actions", "&Dark"),
     .icon = "moon",
     .keys = "Ctrl+F11",
     .tip = QT_TRANSLATE_NOOP("Actions", "Dark panels and a drawing board as dark as space"),
     .flags = WithoutLevel | WhilePlaying,
     .toggle = setAppearance<Appearance::Dark>,
     .isOn = hasAppearance<Appearance::Dark>},
};

} // namespace

std::span<const ActionRow> viewActions() {
    return viewRows;
}

} // namespace spacetow
