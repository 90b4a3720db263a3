#include "editor/window/actions.h"

#include "editor/canvas/icons.h"
#include "editor/canvas/key_place.h"
#include "editor/panels/names.h"
#include "editor/window/key_bindings.h"
#include "editor/window/main_window.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QScopedValueRollback>

#include <algorithm>
#include <vector>

namespace spacetow {

namespace {

constexpr auto topics = {fileActions,    exchangeActions, leaveActions,  editActions,   viewActions,    snapActions,
                         overlayActions, toolActions,     objectActions, nodeActions,   arrangeActions, combineActions,
                         levelActions,   panelActions,    playActions,   windowActions, helpActions};

QString translated(const char* words) {
    return QCoreApplication::translate("Actions", words);
}

/// "Undo (Ctrl+Z)".
QString toolTip(const ActionRow& row, const QKeySequence& key) {
    return key.isEmpty() ? plainText(row)
                         : QStringLiteral("%1 (%2)").arg(plainText(row), key.toString(QKeySequence::NativeText));
}

bool isTool(const ActionRow& row) {
    return std::holds_alternative<ToolId>(row.id);
}

struct Need {
    ActionFlag flag;
    bool SelectedKinds::*there;
    const char* why;
};
constexpr Need needs[] = {
    {NeedsUnlocked, &SelectedKinds::unlocked, QT_TRANSLATE_NOOP("Actions", "What is selected is locked.")},
    {NeedsCopyable, &SelectedKinds::copyable,
     QT_TRANSLATE_NOOP("Actions",
                       "Ship, payload and finish exist once, and connectors are copied with their two bodies.")},
    {NeedsDirection, &SelectedKinds::reversible, QT_TRANSLATE_NOOP("Actions", "Select a wall or a line first.")},
    {NeedsGroup, &SelectedKinds::groups, QT_TRANSLATE_NOOP("Actions", "Select a group first.")},
    {NeedsOutline, &SelectedKinds::nodes, QT_TRANSLATE_NOOP("Actions", "What is selected has no nodes.")},
};

} // namespace

std::span<const ActionRow> actionRows() {
    static const std::vector<ActionRow> rows = [] {
        std::vector<ActionRow> all;
        for (const auto topic : topics) {
            all.insert(all.end(), topic().begin(), topic().end());
        }
        return all;
    }();
    return rows;
}

QString plainText(const ActionRow& row) {
    return withoutMnemonic(translated(row.text)).remove(QChar(0x2026));
}

QString codeOf(const ActionRow& row) {
    QString code = QString::fromUtf8(menuRow(row.menu).text) + QLatin1Char('/') + QString::fromUtf8(row.text);
    code.remove(QLatin1Char('&'));
    code.remove(QChar(0x2026));
    return code.toLower().replace(QLatin1Char(' '), QLatin1Char('-'));
}

QList<QKeySequence> keysOf(const ActionRow& row) {
    return keysIn(row.keys);
}

QList<QKeySequence> keysIn(const char* keys) {
    QList<QKeySequence> all;
    for (const QString& key : QString::fromLatin1(keys).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        all << QKeySequence(key, QKeySequence::PortableText);
    }
    return all;
}

Actions::Actions(MainWindow& window) : m_window(window), m_tools(nullptr) {
    for (const ActionRow& row : actionRows()) {
        auto action = std::make_unique<QAction>(translated(row.text));
        action->setIconText(plainText(row)); // of buttons
        action->setShortcutContext((row.flags & KeyOfCanvas) != 0 ? Qt::WidgetShortcut : Qt::WindowShortcut);
        action->setStatusTip(translated(row.tip));
        action->setCheckable(row.isOn != nullptr || isTool(row));
        if (isTool(row)) {
            m_tools.addAction(action.get());
        }
        window.addAction(action.get());
        m_actions[row.id] = std::move(action);
        connectRow(row);
    }
    setKeys({});
    tint(window.palette());
}

void Actions::setKeys(const KeyBindings& bindings) {
    for (const ActionRow& row : actionRows()) {
        (*this)[row.id].setShortcuts(bindings.keys(*keyOwner(codeOf(row))));
    }
    for (const ActionRow& row : actionRows()) {
        QAction& action = (*this)[row.id];
        const bool isElsewhere = action.shortcuts().isEmpty() && (row.flags & KeyElsewhere) != 0;
        action.setToolTip(toolTip(row, (isElsewhere ? (*this)[Act::PlaceNext] : action).shortcut()));
    }
}

template <class Do>
void Actions::carryOut(const ActionRow& row, const Do& action) {
    if (!m_window.canvas().isDragging()) {
        const QScopedValueRollback<const ActionRow*> carriedOut(m_carriedOut, &row);
        action();
    }
    refresh();
}

void Actions::sayNothingChanged() {
    if (m_carriedOut != nullptr) {
        m_window.statusLine().showMessage(
            translated(QT_TRANSLATE_NOOP("Actions", "“%1” changes nothing here.")).arg(plainText(*m_carriedOut)), 8000);
    }
}

void Actions::connectRow(const ActionRow& row) {
    QAction& action = (*this)[row.id];
    if (row.toggle != nullptr) {
        QObject::connect(&action, &QAction::toggled, &action, [this, &row](bool on) {
            if (!m_refreshing) {
                carryOut(row, [&] { row.toggle(m_window, on); });
            }
        });
        return;
    }
    QObject::connect(&action, &QAction::triggered, &action, [this, &row] {
        carryOut(row, [&] {
            if (const ToolId* tool = std::get_if<ToolId>(&row.id)) {
                m_window.takeTool(*tool);
            } else {
                row.run(m_window);
            }
        });
    });
}

bool Actions::has(const QAction& action) const {
    return std::any_of(m_actions.begin(), m_actions.end(),
                       [&](const auto& entry) { return entry.second.get() == &action; });
}

QAction* Actions::withKey(QKeyCombination key) const {
    const QKeySequence wanted(key);
    QAction* found = nullptr;
    for (const auto& [id, action] : m_actions) {
        // The same key may mean one thing to the editor and another to a running game.
        if (action->shortcuts().contains(wanted) && (found == nullptr || action->isEnabled())) {
            found = action.get();
        }
    }
    for (QAction* other : m_others) {
        if (found == nullptr && other->shortcuts().contains(wanted)) {
            found = other;
        }
    }
    return found;
}

std::optional<QKeyCombination> Actions::keyByPlace(const QKeyEvent& stroke) const {
    const std::optional<Qt::Key> key = keyAtPlace(stroke);
    const bool latinLetter = stroke.key() >= Qt::Key_A && stroke.key() <= Qt::Key_Z;
    if (!key || latinLetter) {
        return {};
    }
    const QKeyCombination meant(stroke.modifiers() & ~Qt::GroupSwitchModifier, *key);
    return withKey(meant) != nullptr ? std::optional(meant) : std::nullopt;
}

void Actions::tint(const QPalette& palette) const {
    for (const ActionRow& row : actionRows()) {
        if (*row.icon != '\0') {
            (*this)[row.id].setIcon(icon(QString::fromLatin1(row.icon), palette));
        }
    }
}

bool Actions::runsEnough(const ActionRow& row) const {
    return (row.flags & OnlyPlaying) == 0 || m_window.isPlaying() ||
           ((row.flags & WhileStarting) != 0 && m_window.isGettingReady());
}

bool Actions::isOfGame(const ActionRow& row) const {
    return (row.flags & WhilePlaying) != 0 || ((row.flags & WithPanels) != 0 && !m_window.arePanelsHidden());
}

/// What is being read there can be left.
bool Actions::isForWelcome(const ActionRow& row) const {
    return (row.flags & WithoutLevel) != 0 || ((row.flags & WhileStarting) != 0 && m_window.isGettingReady());
}

const char* Actions::lackOf(const ActionRow& row) const {
    const Selection& selection = m_window.document().selection();
    if (selection.empty() && (row.flags & NeedsSelection) != 0) {
        return QT_TRANSLATE_NOOP("Actions", "Select something first.");
    }
    if (selection.size() < 2 && (row.flags & NeedsSeveral) != 0) {
        return QT_TRANSLATE_NOOP("Actions", "Select at least two objects first.");
    }
    if (selection.nodes().empty() && (row.flags & NeedsNodes) != 0) {
        return QT_TRANSLATE_NOOP("Actions", "Select nodes first, with the node tool.");
    }
    for (const Need& need : needs) {
        if ((row.flags & need.flag) != 0 && !(m_kinds.*need.there)) {
            return need.why;
        }
    }
    return row.isPossible != nullptr && !row.isPossible(m_window) ? row.why : "";
}

QString Actions::whyNot(const ActionRow& row) const {
    const char* why = lackOf(row);
    if (m_window.isInGame()) {
        if (!isOfGame(row)) {
            why = (row.flags & WithPanels) != 0
                      ? QT_TRANSLATE_NOOP("Actions", "In a game only while its panels are shown.")
                      : QT_TRANSLATE_NOOP("Actions", "Not while a game is running.");
        }
    } else if (m_window.isWelcoming()) {
        why = isForWelcome(row) ? why : QT_TRANSLATE_NOOP("Actions", "Open a level first.");
    } else if (!runsEnough(row)) {
        why = QT_TRANSLATE_NOOP("Actions", "Only while a game is running.");
    }
    return *why == '\0' ? QString() : translated(why);
}

bool Actions::isOn(const ActionRow& row) const {
    const ToolId* const tool = std::get_if<ToolId>(&row.id);
    return tool != nullptr ? m_window.toolbox().current() == *tool : row.isOn(m_window);
}

void Actions::refresh() {
    const QScopedValueRollback<bool> guard(m_refreshing, true);
    m_kinds = selectedKinds(m_window.document().shown());
    for (const ActionRow& row : actionRows()) {
        QAction& action = (*this)[row.id];
        const QString why = whyNot(row);
        if (!why.isEmpty() || !action.isEnabled()) {
            const QString tip = translated(row.tip);
            action.setStatusTip(why.isEmpty() ? tip : QStringLiteral("%1 · %2").arg(tip, why));
        }
        action.setEnabled(why.isEmpty());
        if (action.isCheckable()) {
            action.setChecked(isOn(row));
        }
        if (row.name != nullptr) {
            action.setText(row.name(m_window));
        }
    }
}

} // namespace spacetow
