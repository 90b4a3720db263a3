#include "editor/window/actions.h"

#include "editor/canvas/icons.h"
#include "editor/window/main_window.h"

#include <QCoreApplication>
#include <QScopedValueRollback>

#include <vector>

namespace spacetow {

namespace {

constexpr auto topics = {fileActions, editActions,    viewActions,    overlayActions, toolActions, objectActions,
                         nodeActions, arrangeActions, combineActions, levelActions,   playActions, helpActions};

QString translated(const char* words) {
    return QCoreApplication::translate("Actions", words);
}

/// "Undo (Ctrl+Z)".
QString toolTip(const ActionRow& row) {
    const QList<QKeySequence> keys = keysOf(row);
    const QString key = !keys.isEmpty()              ? keys.front().toString(QKeySequence::NativeText)
                        : (row.flags & KeyElsewhere) ? QStringLiteral("I")
                                                     : QString();
    return key.isEmpty() ? plainText(row) : QStringLiteral("%1 (%2)").arg(plainText(row), key);
}

bool isTool(const ActionRow& row) {
    return std::holds_alternative<ToolId>(row.id);
}

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
    QString text = translated(row.text);
    text.remove(QLatin1Char('&'));
    text.remove(QChar(0x2026));
    return text;
}

QList<QKeySequence> keysOf(const ActionRow& row) {
    QList<QKeySequence> keys;
    for (const QString& key : QString::fromLatin1(row.keys).split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        keys << QKeySequence(key, QKeySequence::PortableText);
    }
    return keys;
}

Actions::Actions(MainWindow& window) : m_window(window), m_tools(nullptr) {
    for (const ActionRow& row : actionRows()) {
        auto action = std::make_unique<QAction>(translated(row.text));
        action->setShortcuts(keysOf(row));
        action->setToolTip(toolTip(row));
        action->setStatusTip(translated(row.tip));
        action->setCheckable(row.isOn != nullptr || isTool(row));
        if (isTool(row)) {
            m_tools.addAction(action.get());
        }
        window.addAction(action.get());
        m_actions[row.id] = std::move(action);
        connectRow(row);
    }
    tint(window.palette());
}

void Actions::connectRow(const ActionRow& row) {
    QAction& action = (*this)[row.id];
    if (row.toggle != nullptr) {
        QObject::connect(&action, &QAction::toggled, &action, [this, &row](bool on) {
            if (!m_refreshing) {
                row.toggle(m_window, on);
                refresh();
            }
        });
        return;
    }
    QObject::connect(&action, &QAction::triggered, &action, [this, &row] {
        if (const ToolId* tool = std::get_if<ToolId>(&row.id)) {
            m_window.takeTool(*tool);
        } else {
            row.run(m_window);
        }
        refresh();
    });
}

void Actions::tint(const QPalette& palette) const {
    for (const ActionRow& row : actionRows()) {
        if (*row.icon != '\0') {
            (*this)[row.id].setIcon(icon(QString::fromLatin1(row.icon), palette));
        }
    }
}

bool Actions::isPossible(const ActionRow& row) const {
    const bool inThisMode = m_window.isPlaying() ? (row.flags & WhilePlaying) != 0 : (row.flags & OnlyPlaying) == 0;
    const int selected = m_window.document().selection().size();
    return inThisMode && (selected >= 1 || (row.flags & NeedsSelection) == 0) &&
           (selected >= 2 || (row.flags & NeedsSeveral) == 0) &&
           (row.isPossible == nullptr || row.isPossible(m_window));
}

bool Actions::isOn(const ActionRow& row) const {
    const ToolId* const tool = std::get_if<ToolId>(&row.id);
    return tool != nullptr ? m_window.toolbox().current() == *tool : row.isOn(m_window);
}

void Actions::refresh() {
    const QScopedValueRollback<bool> guard(m_refreshing, true);
    for (const ActionRow& row : actionRows()) {
        QAction& action = (*this)[row.id];
        action.setEnabled(isPossible(row));
        if (action.isCheckable()) {
            action.setChecked(isOn(row));
        }
        if (row.name != nullptr) {
            action.setText(row.name(m_window));
        }
    }
}

} // namespace spacetow
