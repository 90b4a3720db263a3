// The menus and tool bars of the window, made from the table of actions.
#include "editor/window/main_window.h"

#include "editor/editing/pick.h"
#include "editor/panels/names.h"

#include <QFileInfo>
#include <QMenuBar>
#include <QToolBar>
#include <QToolButton>

#include <initializer_list>
#include <map>

namespace spacetow {

namespace {

constexpr QSize iconSize(20, 20);

/// A null entry is a separator.
void fill(QToolBar& bar, const Actions& actions, std::initializer_list<std::optional<Act>> acts) {
    bar.setIconSize(iconSize);
    bar.setMovable(false);
    for (const std::optional<Act>& act : acts) {
        if (act) {
            bar.addAction(&actions[*act]);
        } else {
            bar.addSeparator();
        }
    }
}

} // namespace

void MainWindow::makeMenus() {
    std::map<MenuId, QMenu*> menus; // owned by the menu bar
    menus[MenuId::File] = menuBar()->addMenu(tr("&File"));
    menus[MenuId::Edit] = menuBar()->addMenu(tr("&Edit"));
    menus[MenuId::View] = menuBar()->addMenu(tr("&View"));
    menus[MenuId::Insert] = menuBar()->addMenu(tr("&Insert"));
    menus[MenuId::Object] = menuBar()->addMenu(tr("&Object"));
    menus[MenuId::Play] = menuBar()->addMenu(tr("&Play"));
    menus[MenuId::Help] = menuBar()->addMenu(tr("&Help"));
    for (const ActionRow& row : actionRows()) {
        if (row.act == Act::OverlayAabb) {
            menus[MenuId::Overlays] = menus[MenuId::View]->addMenu(tr("O&verlays"));
        }
        QMenu* const menu = menus.at(row.menu);
        if ((row.flags & SeparatorBefore) != 0) {
            menu->addSeparator();
        }
        menu->addAction(&m_actions[row.act]);
        if (row.act == Act::Open) {
            menu->addMenu(&m_recent);
        } else if (row.act == Act::Snap) {
            menu->addMenu(&m_status.stepMenu());
        }
    }
    QMenu* const panels = menus[MenuId::View]->addMenu(tr("&Panels"));
    panels->addAction(m_inspectorDock.toggleViewAction());
    panels->addAction(m_problemsDock.toggleViewAction());
}

void MainWindow::makeToolBars() {
    QToolBar* const main = addToolBar(tr("Main"));
    main->setObjectName(QStringLiteral("main"));
    fill(*main, m_actions,
         {Act::New,
          Act::Open,
          Act::Save,
          {},
          Act::Undo,
          Act::Redo,
          {},
          Act::Grid,
          Act::Snap,
          {},
          Act::ZoomOut,
          Act::ZoomIn,
          Act::FitLevel,
          {},
          Act::OverlayAabb,
          Act::OverlayIncircle,
          Act::OverlayVelocity,
          Act::OverlayOrientation,
          Act::OverlayNormals,
          Act::OverlayQuadtree,
          {},
          Act::Play,
          Act::Stop,
          Act::Pause,
          Act::Step});
    if (auto* button = qobject_cast<QToolButton*>(main->widgetForAction(&m_actions[Act::Play]))) {
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
    QToolBar* const tools = addToolBar(tr("Tools"));
    tools->setObjectName(QStringLiteral("tools"));
    addToolBar(Qt::LeftToolBarArea, tools);
    fill(*tools, m_actions,
         {Act::ToolSelect,
          {},
          Act::ToolEdge,
          Act::ToolLine,
          Act::ToolPolygon,
          Act::ToolCircle,
          {},
          Act::PlaceShip,
          Act::PlacePayload,
          Act::PlaceFinish,
          {},
          Act::RotateLeft,
          Act::RotateRight,
          Act::Reverse});
}

void MainWindow::fillRecent() {
    m_recent.clear();
    const QStringList files = m_files.preferences.recentFiles();
    for (const QString& path : files) {
        QAction* const action = m_recent.addAction(QFileInfo(path).fileName());
        action->setStatusTip(path);
        action->setToolTip(path);
        connect(action, &QAction::triggered, this, [this, path] { open(path); });
    }
    if (files.isEmpty()) {
        m_recent.addAction(tr("No files yet"))->setEnabled(false);
        return;
    }
    m_recent.addSeparator();
    connect(m_recent.addAction(tr("&Clear List")), &QAction::triggered, this, [this] {
        m_files.preferences.clearRecent();
        fillRecent();
    });
}

void MainWindow::openMenuAt(const QPoint& global) {
    constexpr double reach = 6; // px
    const std::vector<Key> under =
        picked(m_document.level(), m_canvas.pointerPosition(), reach * m_canvas.view().pixel());
    if (!under.empty() && !m_document.selection().contains(under.front())) {
        m_document.select(Selection({under.front()}));
    }
    QMenu menu(this);
    if (under.size() > 1) {
        QMenu* const below = menu.addMenu(tr("Select &Under Pointer"));
        for (const Key key : under) {
            QAction* const action = below->addAction(displayName(*m_document.level().objects.find(key)));
            connect(action, &QAction::triggered, this, [this, key] { m_document.select(Selection({key})); });
        }
        menu.addSeparator();
    }
    for (const Act act : {Act::Cut, Act::Copy, Act::Paste, Act::Duplicate, Act::Delete}) {
        menu.addAction(&m_actions[act]);
    }
    menu.addSeparator();
    for (const Act act : {Act::RotateLeft, Act::RotateRight, Act::Reverse}) {
        menu.addAction(&m_actions[act]);
    }
    menu.addSeparator();
    for (const Act act : {Act::SelectAll, Act::Frame, Act::FitLevel}) {
        menu.addAction(&m_actions[act]);
    }
    menu.exec(global);
}

} // namespace spacetow
