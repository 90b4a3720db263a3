// What leads into the panels.
#include "editor/window/main_window.h"

#include <QDockWidget>

namespace spacetow {

namespace {

void bringIntoSight(MainWindow& window, const QString& panel) {
    QDockWidget& dock = window.panels().dock(panel);
    dock.show();
    dock.raise();
}

OutlinerPanel& outlinerInSight(MainWindow& window) {
    bringIntoSight(window, QStringLiteral("outliner"));
    return window.outliner();
}

constexpr ActionRow panelActionRows[] = {
    {.id = Act::Find,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "&Find…"),
     .icon = "search",
     .keys = "Ctrl+F",
     .tip = QT_TRANSLATE_NOOP("Actions", "Find objects by name, kind or tag in the outliner"),
     .flags = SeparatorBefore,
     .run =
         [](MainWindow& window) {
             QLineEdit& field = outlinerInSight(window).filterField();
             field.setFocus(Qt::ShortcutFocusReason);
             field.selectAll();
         }},
    {.id = Act::Rename,
     .menu = MenuId::Object,
     .text = QT_TRANSLATE_NOOP("Actions", "Rena&me…"),
     .icon = "rename",
     .keys = "F2",
     .tip = QT_TRANSLATE_NOOP("Actions", "Give the selected object another name, in the outliner"),
     .flags = NeedsSelection | SeparatorBefore,
     .run = [](MainWindow& window) { outlinerInSight(window).renameSelected(); }},
    {.id = Act::LevelProperties,
     .menu = MenuId::Level,
     .text = QT_TRANSLATE_NOOP("Actions", "Level P&roperties…"),
     .icon = "properties",
     .keys = "Ctrl+Alt+P",
     .tip = QT_TRANSLATE_NOOP("Actions", "Edit the name, rules and physics of the level itself"),
     .flags = SeparatorBefore,
     .run =
         [](MainWindow& window) {
             bringIntoSight(window, QStringLiteral("level"));
             window.levelPanel().form().editor(QStringLiteral("name"))->setFocus(Qt::ShortcutFocusReason);
         }},
    {.id = Act::Compare,
     .menu = MenuId::View,
     .text = QT_TRANSLATE_NOOP("Actions", "Compare &With…"),
     .icon = "compare",
     .keys = "Ctrl+Alt+C",
     .tip = QT_TRANSLATE_NOOP("Actions", "Choose a level file and show what is different from it"),
     .flags = SeparatorBefore,
     .run =
         [](MainWindow& window) {
             QString name;
             if (std::shared_ptr<const Level> other = window.files().chooseToCompare(name)) {
                 window.compareWith(std::move(other), name);
             }
         }},
};

} // namespace

std::span<const ActionRow> panelActions() {
    return panelActionRows;
}

} // namespace spacetow
