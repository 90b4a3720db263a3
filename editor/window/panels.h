#pragma once
// The panels as a table: what each is called, where it stands at first, and how it is made. View ▸ Panels, what play
// and Tab put out of the way, and what is remembered are made from it; a new panel is one row.

#include <QByteArray>
#include <QList>
#include <QString>
#include <Qt>

#include <map>
#include <span>

class QAction;
class QDockWidget;
class QWidget;

namespace spacetow {

class KeyBindings;
class MainWindow;

struct PanelRow {
    const char* name;      // stable: the arrangement of the panels is remembered by it
    const char* title;     // with mnemonic; translate in the context "Panels"
    const char* keys = ""; // that show and hide it, separated by blanks
    Qt::DockWidgetArea area;
    int height = 200;            // at first, beside the others of its area, and at least when it is called
    bool shownAtFirst = true;    // else it waits in the menu
    const char* tabOf = nullptr; // a row above this one, behind which it stands as a tab at first
    QWidget* (*make)(MainWindow&);
};

std::span<const PanelRow> panelRows();
/// By which its keys are remembered.
QString codeOf(const PanelRow& row);

/// The docks of a window that hold the panels.
class Panels {
  public:
    /// Adds the docks to the window, which owns them.
    explicit Panels(MainWindow& window);

    QDockWidget& dock(const QString& name) const { return *m_docks.at(name); }
    /// Of all panels, for the menu.
    QList<QAction*> actions() const;
    void setKeys(const KeyBindings& bindings);
    /// In a window that has room for it the inspector has its labels beside the fields.
    void widenInspector();
    /// The keyboard goes to the first thing in the panel that takes it.
    static void enter(QDockWidget& dock);
    /// The panel that holds the widget; null for one outside.
    QDockWidget* holding(const QWidget* widget) const;

    /// Puts all panels out of the way, and back as they were. While they are away a panel can be called by its action.
    void setAway(bool away);
    bool areAway() const { return m_away; }
    /// The arrangement to remember: that of the panels when they are not away.
    QByteArray arrangement() const;

  private:
    void add(const PanelRow& row);
    void placeAtFirst();

    MainWindow& m_window;
    std::map<QString, QDockWidget*> m_docks;
    QByteArray m_arrangement; // while they are away
    bool m_away = false;
};

} // namespace spacetow
