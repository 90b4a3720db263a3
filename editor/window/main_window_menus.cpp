// The menus and tool bars of the window, made from the table of actions.
#include "editor/window/language.h"
#include "editor/window/main_window.h"

#include "core/level/bounds.h"
#include "editor/editing/backups.h"
#include "editor/panels/names.h"
#include "editor/window/application.h"
#include "editor/window/context_menu.h"
#include "editor/window/state_folder.h"

#include <QActionGroup>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace spacetow {

namespace {

constexpr QSize iconSize(20, 20);

/// The actions that want to be in a bar or menu, in the order of their rows, with separators where the menu changes.
class Filler {
  public:
    Filler(QWidget& place, const Actions& actions) : m_place(place), m_actions(actions) {}

    void add(const ActionRow& row) {
        if (m_last != nullptr && (m_last->menu != row.menu || (row.flags & SeparatorBefore) != 0)) {
            auto* const separator = new QAction(&m_place);
            separator->setSeparator(true);
            m_place.addAction(separator);
        }
        m_place.addAction(&m_actions[row.id]);
        m_last = &row;
    }

  private:
    QWidget& m_place;
    const Actions& m_actions;
    const ActionRow* m_last = nullptr;
};

QToolBar* addBar(QMainWindow& window, const QString& title, const QString& name, Qt::ToolBarArea area) {
    QToolBar* const bar = window.addToolBar(title);
    bar->setObjectName(name);
    bar->setIconSize(iconSize);
    bar->setMovable(false);
    window.addToolBar(area, bar);
    return bar;
}

/// The first nine can be chosen by their number.
QString numberedEntry(int number, const QString& name) {
    return number > 9 ? menuSafe(name) : QStringLiteral("&%1 %2").arg(number).arg(menuSafe(name));
}

} // namespace

QMenu* MainWindow::makeMenu(const MenuRow& row) {
    if (row.id == MenuId::GridStep) {
        return &m_status.stepMenu();
    }
    if (row.id == MenuId::SubGrid) {
        return &m_status.divisionMenu();
    }
    QMenu* const parent = row.parent ? m_menus.at(*row.parent) : nullptr;
    return parent != nullptr ? new QMenu(menuText(row), parent) : menuBar()->addMenu(menuText(row));
}

void MainWindow::makeMenus() {
    for (const MenuRow& row : menuRows()) {
        m_menus[row.id] = makeMenu(row);
    }
    const auto addMenusAfter = [this](MenuId parent, const std::optional<ActionId>& action) {
        for (const MenuRow& row : menuRows()) {
            if (row.parent == parent && row.after == action) {
                m_menus.at(parent)->addMenu(m_menus.at(row.id));
            }
        }
    };
    for (const ActionRow& row : actionRows()) {
        QMenu* const menu = m_menus.at(row.menu);
        if ((row.flags & SeparatorBefore) != 0) {
            menu->addSeparator();
        }
        menu->addAction(&m_actions[row.id]);
        if ((row.flags & KeyOfCanvas) != 0) {
            m_canvas.addAction(&m_actions[row.id]);
        }
        addMenusAfter(row.menu, row.id);
    }
    for (const MenuRow& row : menuRows()) {
        addMenusAfter(row.id, std::nullopt);
    }
    m_menus.at(MenuId::Panels)->addSeparator();
    m_menus.at(MenuId::Panels)->addActions(m_panels->actions());
    m_status.setSnapMenu(*m_menus.at(MenuId::Snapping));
    fillRecent();
    fillWindows();
    connect(m_menus.at(MenuId::Recent), &QMenu::aboutToShow, this, &MainWindow::fillRecent);
    connect(m_menus.at(MenuId::Window), &QMenu::aboutToShow, this, &MainWindow::fillWindows);
    fillLanguages();
    fillBackups();
    connect(m_menus.at(MenuId::Backups), &QMenu::aboutToShow, this, &MainWindow::fillBackups);
    for (const auto& [id, menu] : m_menus) {
        menu->menuAction()->setVisible(!menu->isEmpty());
    }
}

void MainWindow::makeToolBars() {
    QToolBar* const main = addBar(*this, tr("Main"), QStringLiteral("main"), Qt::TopToolBarArea);
    QToolBar* const tools = addBar(*this, tr("Tools"), QStringLiteral("tools"), Qt::LeftToolBarArea);
    Filler mainFiller(*main, m_actions);
    Filler toolsFiller(*tools, m_actions);
    // Where there is no room for all, the last ones go.
    for (const bool overlays : {false, true}) {
        for (const ActionRow& row : actionRows()) {
            if ((row.flags & OnMainBar) != 0 && (row.menu == MenuId::Overlays) == overlays) {
                mainFiller.add(row);
            }
        }
    }
    for (const ActionRow& row : actionRows()) {
        if ((row.flags & OnToolsBar) != 0 || std::holds_alternative<ToolId>(row.id)) {
            toolsFiller.add(row);
        }
    }
    m_timeline.setActions({&m_actions[Act::TimeFirst], &m_actions[Act::StepBack], &m_actions[Act::Pause],
                           &m_actions[Act::Step], &m_actions[Act::TimeLast]});
    if (auto* button = qobject_cast<QToolButton*>(main->widgetForAction(&m_actions[Act::SmartSnap]))) {
        button->setMenu(m_menus.at(MenuId::Snapping));
        button->setPopupMode(QToolButton::MenuButtonPopup);
    }
    if (auto* button = qobject_cast<QToolButton*>(main->widgetForAction(&m_actions[Act::Play]))) {
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
}

void MainWindow::fillRecent() {
    QMenu& recent = *m_menus.at(MenuId::Recent);
    recent.clear();
    const QStringList files = m_files.preferences.recentFiles();
    int number = 0;
    for (const QString& path : files) {
        QAction* const action = recent.addAction(numberedEntry(++number, QFileInfo(path).fileName()));
        action->setStatusTip(path);
        action->setToolTip(plainToolTip(path));
        connect(action, &QAction::triggered, this, [this, path] { openFiles({path}); });
    }
    if (files.isEmpty()) {
        recent.addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    recent.addSeparator();
    connect(recent.addAction(tr("&Clear List")), &QAction::triggered, this, [this] {
        m_files.preferences.clearRecent();
        fillRecent();
    });
}

/// The windows that are open, below the actions of the menu.
void MainWindow::fillWindows() {
    QMenu& menu = *m_menus.at(MenuId::Window);
    constexpr auto listed = "window";
    for (QAction* const action : menu.actions()) {
        if (action->property(listed).toBool()) {
            menu.removeAction(action);
            action->deleteLater();
        }
    }
    const auto list = [&](QAction* action) { action->setProperty(listed, true); };
    list(menu.addSeparator());
    const std::vector<MainWindow*> windows =
        m_application != nullptr ? m_application->windows() : std::vector<MainWindow*>{this};
    int number = 0;
    for (MainWindow* const window : windows) {
        const QString mark = window->isWindowModified() ? QStringLiteral("*") : QString();
        QAction* const action = menu.addAction(numberedEntry(++number, window->name() + mark));
        action->setToolTip(plainToolTip(window->files().path()));
        action->setStatusTip(window->files().path());
        action->setCheckable(true);
        action->setChecked(window == this);
        list(action);
        connect(action, &QAction::triggered, window, &MainWindow::comeForward);
    }
}

/// Each is called what its speakers call it, so that whoever chose a wrong one finds back.
void MainWindow::fillLanguages() {
    QMenu& menu = *m_menus.at(MenuId::Language);
    auto* const choice = new QActionGroup(&menu); // owned by it
    const QString spoken = m_files.preferences.language();
    const auto add = [&](const QString& name, const QString& code) {
        QAction* const action = menu.addAction(name);
        action->setCheckable(true);
        action->setChecked(code == spoken);
        action->setActionGroup(choice);
        action->setStatusTip(tr("Texts in this language from now on, in all windows"));
        action->setEnabled(m_application != nullptr);
        connect(action, &QAction::triggered, this, [this, code] { m_application->setLanguage(code); });
    };
    add(tr("Like the &Desktop"), QString());
    menu.addSeparator();
    for (const Language& language : languages()) {
        add(language.name, language.code);
    }
}

void MainWindow::fillBackups() {
    QMenu& menu = *m_menus.at(MenuId::Backups);
    menu.clear();
    const QString path = m_files.path();
    const auto backups = path.isEmpty() ? std::vector<Backup>() : backupsOf(backupFolder(), path.toStdString());
    for (const Backup& backup : backups) {
        const QDateTime time = QDateTime::fromMSecsSinceEpoch(backup.time);
        QAction* const action = menu.addAction(QLocale().toString(time, QLocale::ShortFormat) + time.toString(":ss"));
        action->setStatusTip(tr("Take back the level as it was saved then, as one edit; its file stays as it is"));
        connect(action, &QAction::triggered, this, [this, file = backup.file] {
            enterTyping();
            finishDrawing();
            m_files.openBackup(file);
        });
    }
    if (backups.empty()) {
        menu.addAction(tr("No former versions yet"))->setEnabled(false);
    }
}

QList<QAction*> MainWindow::listedIn(MenuId id) {
    if (id == MenuId::Window) {
        fillWindows();
    } else if (id == MenuId::Backups) {
        fillBackups();
    }
    QMenu& menu = *m_menus.at(id);
    QList<QAction*> listed;
    for (QAction* const action : menu.actions()) {
        const bool plain = !action->isSeparator() && action->menu() == nullptr;
        if (plain && action->isEnabled() && menu.isEnabled() && !m_actions.has(*action) &&
            !m_panels->actions().contains(action)) {
            listed << action;
        }
    }
    return listed;
}

void MainWindow::openMenuAt(const QPoint& global) {
    QMenu menu(this);
    fillMenuAtPointer(*this, menu);
    menu.exec(global);
}

void MainWindow::openMenuAtSelection() {
    QMenu menu(this);
    fillMenuOfSelection(*this, menu);
    menu.exec(placeOfSelection());
}

QPoint MainWindow::placeOfSelection() {
    const Aabb box = boundsOfSelection();
    const Vec2 wanted = box.isEmpty() ? m_canvas.view().center : box.center();
    const Vec2 screen = m_canvas.view().toScreen(wanted);
    const QPoint place(std::clamp(qRound(screen.x()), 0, m_canvas.width()),
                       std::clamp(qRound(screen.y()), 0, m_canvas.height()));
    m_canvas.pointAt(place);
    return m_canvas.mapToGlobal(place);
}

void MainWindow::openOutlinerMenuAt(const QPoint& global) {
    QMenu menu(this);
    fillMenuOfOutliner(*this, menu);
    menu.exec(global);
}

} // namespace spacetow
