#include "editor/window/panels.h"

#include "editor/panels/names.h"
#include "editor/window/key_bindings.h"
#include "editor/window/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLayout>
#include <QScrollArea>
#include <QShortcutEvent>
#include <QToolBar>

#include <algorithm>

namespace spacetow {

namespace {

constexpr PanelRow allPanels[] = {
    {.name = "inspector",
     .title = QT_TRANSLATE_NOOP("Panels", "&Inspector"),
     .keys = "Ctrl+Alt+1",
     .area = Qt::RightDockWidgetArea,
     .height = 520,
     .make = [](MainWindow& window) -> QWidget* { return &window.inspector(); }},
    {.name = "outliner",
     .title = QT_TRANSLATE_NOOP("Panels", "&Outliner"),
     .keys = "Ctrl+Shift+O",
     .area = Qt::RightDockWidgetArea,
     .height = 230,
     .make = [](MainWindow& window) -> QWidget* { return &window.outliner(); }},
    {.name = "problems",
     .title = QT_TRANSLATE_NOOP("Panels", "&Problems"),
     .keys = "Ctrl+Alt+2",
     .area = Qt::RightDockWidgetArea,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.problems(); }},
    {.name = "nodes",
     .title = QT_TRANSLATE_NOOP("Panels", "&Nodes"),
     .keys = "Ctrl+Alt+3",
     .area = Qt::RightDockWidgetArea,
     .height = 260,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.nodes(); }},
    {.name = "history",
     .title = QT_TRANSLATE_NOOP("Panels", "&History"),
     .keys = "Ctrl+Shift+H",
     .area = Qt::RightDockWidgetArea,
     .height = 260,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.history(); }},
    {.name = "minimap",
     .title = QT_TRANSLATE_NOOP("Panels", "&Minimap"),
     .keys = "Ctrl+Shift+K",
     .area = Qt::RightDockWidgetArea,
     .height = 230,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.minimap(); }},
    {.name = "level",
     .title = QT_TRANSLATE_NOOP("Panels", "&Level Properties"),
     .keys = "Ctrl+Alt+4",
     .area = Qt::RightDockWidgetArea,
     .shownAtFirst = false,
     .tabOf = "inspector",
     .make = [](MainWindow& window) -> QWidget* { return &window.levelPanel(); }},
    {.name = "flights",
     .title = QT_TRANSLATE_NOOP("Panels", "&Flights"),
     .keys = "Ctrl+Alt+5",
     .area = Qt::RightDockWidgetArea,
     .height = 260,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.flights(); }},
    {.name = "tagMatrix",
     .title = QT_TRANSLATE_NOOP("Panels", "&Tag Matrix"),
     .keys = "Ctrl+Alt+6",
     .area = Qt::RightDockWidgetArea,
     .height = 330,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.tagMatrix(); }},
    {.name = "differences",
     .title = QT_TRANSLATE_NOOP("Panels", "&Differences"),
     .keys = "Ctrl+Alt+7",
     .area = Qt::RightDockWidgetArea,
     .height = 260,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.differences(); }},
    {.name = "runChanges",
     .title = QT_TRANSLATE_NOOP("Panels", "&Run Changes"),
     .keys = "Ctrl+Alt+A",
     .area = Qt::RightDockWidgetArea,
     .shownAtFirst = false,
     .tabOf = "inspector",
     .make = [](MainWindow& window) -> QWidget* { return &window.runChangesPanel(); }},
    {.name = "explain",
     .title = QT_TRANSLATE_NOOP("Panels", "E&xplain"),
     .keys = "Ctrl+Shift+X",
     .area = Qt::RightDockWidgetArea,
     .height = 400,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.explanations().panel(); }},
    {.name = "plots",
     .title = QT_TRANSLATE_NOOP("Panels", "Plot&s"),
     .keys = "Ctrl+Alt+8",
     .area = Qt::RightDockWidgetArea,
     .height = 400,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.explanations().plots(); }},
    {.name = "profile",
     .title = QT_TRANSLATE_NOOP("Panels", "Profil&e"),
     .keys = "Ctrl+Alt+9",
     .area = Qt::RightDockWidgetArea,
     .height = 400,
     .shownAtFirst = false,
     .tabOf = "outliner",
     .make = [](MainWindow& window) -> QWidget* { return &window.explanations().profile(); }},
};

QString translatedTitle(const char* words) {
    return QCoreApplication::translate("Panels", words);
}

/// What is called is of use at once, in a window of any size: those above and below it give it room.
void giveRoom(QMainWindow& window, QDockWidget& dock, int height) {
    constexpr int least = 120;   // px, that are left to others
    window.layout()->activate(); // it may just have come
    const int wanted = std::min(height, window.height() / 2);
    const int missing = wanted - dock.height();
    if (dock.isFloating() || missing <= 0) {
        return;
    }
    QList<QDockWidget*> docks{&dock};
    QList<int> heights{wanted};
    for (QDockWidget* other : window.findChildren<QDockWidget*>()) {
        const bool inColumn =
            other->isVisible() && !other->isFloating() && other->x() == dock.x(); // tabs behind are not
        if (inColumn && other != &dock && other->y() != dock.y()) {
            docks << other;
            heights << std::max(least, other->height() - missing);
        }
    }
    window.resizeDocks(docks, heights, Qt::Vertical);
}

/// Its key leads into a panel that is shown already, and closes it only from within; the menu shows and hides it.
class KeyIntoPanel : public QObject {
  public:
    KeyIntoPanel(MainWindow& window, QDockWidget& dock) : QObject(&dock), m_window(window), m_dock(dock) {
        dock.toggleViewAction()->installEventFilter(this);
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::Shortcut || static_cast<QShortcutEvent*>(event)->isAmbiguous() ||
            !m_dock.toggleViewAction()->isEnabled()) {
            return QObject::eventFilter(watched, event);
        }
        const QWidget* const typing = QApplication::focusWidget();
        const bool isInFront = m_dock.isVisible() && !m_dock.visibleRegion().isEmpty();
        if (!isInFront || (typing != nullptr && m_dock.isAncestorOf(typing))) {
            m_dock.toggleViewAction()->trigger();
        }
        if (m_dock.isVisible()) {
            Panels::enter(m_dock);
        } else { // Qt would lead into the next panel
            m_window.canvas().setFocus(Qt::ShortcutFocusReason);
        }
        return true;
    }

  private:
    MainWindow& m_window;
    QDockWidget& m_dock;
};

/// Its action brings a panel to the front that stands as a tab behind another, before it hides it.
void followTabs(QMainWindow& window, QDockWidget& dock, int height) {
    constexpr auto behind = "behind";
    QObject::connect(&dock, &QDockWidget::visibilityChanged, &dock, [&dock](bool isInFront) {
        if (isInFront || dock.isVisible()) {
            dock.setProperty(behind, !isInFront);
        }
    });
    QObject::connect(dock.toggleViewAction(), &QAction::triggered, &dock, [&window, &dock, height](bool isShown) {
        if (isShown || dock.property(behind).toBool()) {
            dock.show();
            dock.raise();
            giveRoom(window, dock, height);
        }
    });
}

} // namespace

std::span<const PanelRow> panelRows() {
    return allPanels;
}

QString codeOf(const PanelRow& row) {
    return QStringLiteral("panels/") + QLatin1String(row.name);
}

Panels::Panels(MainWindow& window) : m_window(window) {
    for (const PanelRow& row : allPanels) {
        add(row);
    }
    setKeys({});
    placeAtFirst();
}

void Panels::setKeys(const KeyBindings& bindings) {
    for (const PanelRow& row : allPanels) {
        dock(QLatin1String(row.name)).toggleViewAction()->setShortcuts(bindings.keys(*keyOwner(codeOf(row))));
    }
}

void Panels::add(const PanelRow& row) {
    auto* const dock = new QDockWidget(withoutMnemonic(translatedTitle(row.title)), &m_window); // owned by it
    dock->setObjectName(QLatin1String(row.name));
    dock->setWidget(row.make(m_window));
    m_window.addDockWidget(row.area, dock);
    QAction* const action = dock->toggleViewAction();
    action->setText(translatedTitle(row.title));
    action->setStatusTip(QCoreApplication::translate("Panels", "Show or hide this panel"));
    followTabs(m_window, *dock, row.height);
    new KeyIntoPanel(m_window, *dock); // owned by the dock
    m_window.addAction(action);
    m_docks[dock->objectName()] = dock;
}

void Panels::placeAtFirst() {
    QList<QDockWidget*> stacked;
    QList<int> heights;
    for (const PanelRow& row : allPanels) {
        QDockWidget& one = dock(QLatin1String(row.name));
        if (row.tabOf != nullptr) {
            QDockWidget& other = dock(QLatin1String(row.tabOf));
            m_window.tabifyDockWidget(&other, &one);
        } else {
            stacked << &one;
            heights << row.height;
        }
        one.setVisible(row.shownAtFirst);
    }
    for (QDockWidget* first : stacked) {
        first->raise(); // before those that came behind it, of which showing puts the last in front
    }
    m_window.resizeDocks(stacked, heights, Qt::Vertical);
}

void Panels::widenInspector() {
    constexpr int roomy = 1100; // px
    if (m_window.width() >= roomy) {
        QDockWidget& inspector = dock(QStringLiteral("inspector"));
        m_window.resizeDocks({&inspector}, {inspector.widget()->sizeHint().width()}, Qt::Horizontal);
    }
}

QList<QAction*> Panels::actions() const {
    QList<QAction*> all;
    for (const PanelRow& row : allPanels) {
        all << dock(QLatin1String(row.name)).toggleViewAction();
    }
    return all;
}

/// A field or a list goes before what only folds a section or scrolls.
void Panels::enter(QDockWidget& dock) {
    QWidget* const panel = dock.widget();
    if (dock.isFloating()) {
        dock.activateWindow();
    }
    QWidget* first = nullptr;
    for (QWidget* each = panel->nextInFocusChain(); each != panel; each = each->nextInFocusChain()) {
        const bool takesTab = panel->isAncestorOf(each) && (each->focusPolicy() & Qt::TabFocus) != 0 &&
                              each->isVisible() && each->isEnabled();
        const bool isField =
            qobject_cast<QAbstractButton*>(each) == nullptr && qobject_cast<QScrollArea*>(each) == nullptr;
        if (takesTab && isField) {
            first = each;
            break;
        }
        first = takesTab && first == nullptr ? each : first;
    }
    (first != nullptr ? first : panel)->setFocus(Qt::TabFocusReason);
}

QDockWidget* Panels::holding(const QWidget* widget) const {
    for (const auto& [name, dock] : m_docks) {
        if (dock->isAncestorOf(widget)) {
            return dock;
        }
    }
    return nullptr;
}

void Panels::setAway(bool away) {
    if (away == m_away) {
        return;
    }
    if (!away) {
        m_away = false;
        m_window.restoreState(m_arrangement);
        return;
    }
    m_arrangement = m_window.saveState();
    m_away = true;
    for (const auto& [name, dock] : m_docks) {
        dock->hide();
    }
    if (auto* tools = m_window.findChild<QToolBar*>(QStringLiteral("tools"))) {
        tools->hide();
    }
}

QByteArray Panels::arrangement() const {
    return m_away ? m_arrangement : m_window.saveState();
}

} // namespace spacetow
