#pragma once
// The actions of the window, made from their rows: menus, tool bars, tooltips and the overview of keys show these.

#include "editor/editing/selected_kinds.h"
#include "editor/window/action_row.h"

#include <QAction>
#include <QActionGroup>
#include <QKeySequence>
#include <QList>
#include <QString>

#include <map>
#include <memory>
#include <span>

class QKeyEvent;
class QPalette;

namespace spacetow {

class KeyBindings;

/// Of all topics, in the order of the menus.
std::span<const ActionRow> actionRows();
/// Translated, without mnemonic and ellipsis.
QString plainText(const ActionRow& row);
/// By which the action is remembered, as in "file/save-as": menu and text in English.
QString codeOf(const ActionRow& row);
/// The keys it comes with.
QList<QKeySequence> keysOf(const ActionRow& row);
/// Of keys in their portable spelling, separated by blanks.
QList<QKeySequence> keysIn(const char* keys);

class Actions {
  public:
    /// Adds the actions to the window, which must outlive this and be complete before one is triggered.
    explicit Actions(MainWindow& window);

    QAction& operator[](ActionId id) const { return *m_actions.at(id); }
    bool has(const QAction& action) const;
    /// The action that has this key; null when none has.
    QAction* withKey(QKeyCombination key) const;
    /// Actions that were made elsewhere, whose keys are to be found as well; they must outlive this.
    void know(const QList<QAction*>& others) { m_others = others; }
    /// For a stroke that is nobody's key: the key of a US keyboard in its place, where that is an action's. A Latin
    /// letter never stands for another one.
    std::optional<QKeyCombination> keyByPlace(const QKeyEvent& stroke) const;
    /// Puts these keys on the actions, their tooltips included.
    void setKeys(const KeyBindings& bindings);
    /// Draws the icons in the colours of the palette.
    void tint(const QPalette& palette) const;
    /// A sentence that says why it is not possible at this moment; empty while it is.
    QString whyNot(const ActionRow& row) const;
    /// Shows what is possible, what is on, and what it is called at this moment.
    void refresh();
    /// For the action that is being carried out, when it has found nothing to do.
    void sayNothingChanged();

  private:
    void connectRow(const ActionRow& row);
    /// Unless a drag is under way, which nothing may cross.
    template <class Do>
    void carryOut(const ActionRow& row, const Do& action);
    bool isOfGame(const ActionRow& row) const; // while one is running
    bool isForWelcome(const ActionRow& row) const;
    /// What is missing among what is selected; empty when nothing is.
    const char* lackOf(const ActionRow& row) const;
    /// For what needs a run.
    bool runsEnough(const ActionRow& row) const;
    bool isOn(const ActionRow& row) const;

    MainWindow& m_window;
    QActionGroup m_tools;
    std::map<ActionId, std::unique_ptr<QAction>> m_actions;
    QList<QAction*> m_others;
    SelectedKinds m_kinds;                   // at the last refresh
    const ActionRow* m_carriedOut = nullptr; // by the user, at this moment
    bool m_refreshing = false;
};

} // namespace spacetow
