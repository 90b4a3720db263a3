// What the keys do, and what program this is.
#include "editor/window/key_editor.h"
#include "editor/window/keys_dialog.h"
#include "editor/window/main_window.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace spacetow {

namespace {

void showAbout(MainWindow& window) {
    QMessageBox box(&window);
    box.setWindowTitle(MainWindow::tr("About SpaceTow Studio"));
    box.setIconPixmap(window.windowIcon().pixmap(72, 72));
    box.setTextFormat(Qt::PlainText);
    box.setText(MainWindow::tr("SpaceTow Studio %1").arg(QCoreApplication::applicationVersion()));
    box.setInformativeText(MainWindow::tr("Draw levels and fly them: a level editor and physics sandbox.\n\n"
                                          "Free software under the MIT license. Made with Qt %1 and Eigen.")
                               .arg(QString::fromLatin1(qVersion())));
    box.addButton(MainWindow::tr("&Close"), QMessageBox::RejectRole);
    box.exec();
}

constexpr ActionRow helpRows[] = {
    {.id = Act::CommandPalette,
     .menu = MenuId::Help,
     .text = QT_TRANSLATE_NOOP("Actions", "&Find Action…"),
     .icon = "commands",
     .keys = "Ctrl+Shift+P",
     .tip = QT_TRANSLATE_NOOP("Actions", "Find actions, panels, levels, objects and problems by a few letters"),
     .flags = WithoutLevel | WhilePlaying,
     .run = [](MainWindow& window) { window.finder().open(QString()); }},
    {.id = Act::Keys,
     .menu = MenuId::Help,
     .text = QT_TRANSLATE_NOOP("Actions", "&Keys…"),
     .icon = "keyboard",
     .keys = "F1",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show what the keys do"),
     .flags = WithoutLevel | WhilePlaying,
     .run = [](MainWindow& window) { KeysDialog(window.files().preferences.keyBindings(), &window).exec(); }},
    {.id = Act::EditKeys,
     .menu = MenuId::Help,
     .text = QT_TRANSLATE_NOOP("Actions", "Keyboard &Shortcuts…"),
     .icon = "keyboard",
     .keys = "Ctrl+Alt+K",
     .tip = QT_TRANSLATE_NOOP("Actions", "Give other keys to actions, or the keys of Tiled, Inkscape or Blender"),
     .flags = WithoutLevel | WhilePlaying,
     .run = [](MainWindow& window) { KeyEditor(&window).exec(); }},
    {.id = Act::CopyCapsule,
     .menu = MenuId::Help,
     .text = QT_TRANSLATE_NOOP("Actions", "Copy &Bug Capsule"),
     .icon = "bug",
     .keys = "Ctrl+Alt+B",
     .tip =
         QT_TRANSLATE_NOOP("Actions", "Copy the level and the run up to this moment as text, for a mail or an issue; "
                                      "pasted into a window, it opens at the same moment"),
     .flags = WhilePlaying,
     .run = [](MainWindow& window) { window.bugCapsule().copy(); }},
    {.id = Act::About,
     .menu = MenuId::Help,
     .text = QT_TRANSLATE_NOOP("Actions", "&About SpaceTow Studio…"),
     .icon = "info",
     .keys = "Ctrl+F1",
     .tip = QT_TRANSLATE_NOOP("Actions", "Show version and license"),
     .flags = WithoutLevel | WhilePlaying,
     .run = showAbout},
};

} // namespace

std::span<const ActionRow> helpActions() {
    return helpRows;
}

} // namespace spacetow
