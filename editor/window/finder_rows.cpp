#include "editor/window/finder_rows.h"

#include "core/level/level_title.h"
#include "editor/canvas/icons.h"
#include "editor/canvas/palette.h"
#include "editor/panels/names.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"
#include "editor/window/welcome_page.h"

#include <QCoreApplication>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QPointer>

#include <algorithm>

namespace spacetow {

namespace {

constexpr int mostFiles = 500; // of a folder

QString codeOfPlace(const QString& path) {
    return QStringLiteral("level:") + path;
}

/// What the level calls itself; empty where its file does not say so soon.
QString titleOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QByteArray beginning = file.read(static_cast<qint64>(titleBytes));
    return QString::fromStdString(
        titleIn({beginning.constData(), static_cast<std::size_t>(beginning.size())}).value_or(std::string()));
}

} // namespace

FinderRows::FinderRows(MainWindow& window) : m_window(window), m_level(window.document().current().level) {
    for (int kind = 0; kind < kindCount(); ++kind) {
        m_kinds.push_back(kindName(kind));
    }
    if (!window.isInGame()) {
        m_problems = window.problems().shown();
    } else {
        m_level = std::make_shared<const Level>(); // there is nothing to be selected in a game
    }
    addActions();
    addPanels();
    addEntries();
    addLevels();
}

void FinderRows::addActions() {
    for (const ActionRow& row : actionRows()) {
        QAction& action = m_window.actions()[row.id];
        FinderRow found{.kind = FindKind::Action,
                        .name = withoutMnemonic(action.text()),
                        .place = menuPath(row.menu),
                        .key = action.shortcut().toString(QKeySequence::NativeText),
                        .tip = action.statusTip(),
                        .code = codeOf(row),
                        .icon = action.icon(),
                        .isOn = action.isCheckable() && action.isChecked(),
                        .isPossible = action.isEnabled(),
                        .run = [&action] { action.trigger(); }};
        if (!found.isPossible) {
            found.whyNot = m_window.actions().whyNot(row);
        }
        m_few.push_back(std::move(found));
    }
}

void FinderRows::addPanels() {
    const char* const why = m_window.isInGame() ? "Not while a game is running." : "Open a level first.";
    for (const PanelRow& row : panelRows()) {
        QDockWidget& dock = m_window.panels().dock(QLatin1String(row.name));
        m_few.push_back({.kind = FindKind::Panel,
                         .name = dock.windowTitle(),
                         .place = menuPath(MenuId::Panels),
                         .key = dock.toggleViewAction()->shortcut().toString(QKeySequence::NativeText),
                         .code = codeOf(row),
                         .whyNot = QCoreApplication::translate("Actions", why),
                         .icon = icon(QStringLiteral("panels"), m_window.palette()),
                         .isOn = !dock.isHidden(),
                         .isPossible = dock.toggleViewAction()->isEnabled(),
                         .run = [&dock] {
                             dock.show();
                             dock.raise();
                             Panels::enter(dock);
                         }});
    }
}

/// What menus list besides the actions of the table: languages, steps of the grid, windows, former versions. The files
/// that were open lately are among the levels.
void FinderRows::addEntries() {
    for (const MenuRow& row : menuRows()) {
        if (row.id == MenuId::Recent) {
            continue;
        }
        for (QAction* const entry : m_window.listedIn(row.id)) {
            m_few.push_back({.kind = FindKind::Action,
                             .name = withoutMnemonic(entry->text()),
                             .place = menuPath(row.id),
                             .tip = entry->statusTip(),
                             .icon = entry->icon(),
                             .isOn = entry->isChecked(),
                             .run = [entry = QPointer<QAction>(entry)] {
                                 if (entry) { // menus are filled anew when they open
                                     entry->trigger();
                                 }
                             }});
        }
    }
}

/// Those that were open lately, those beside the file that is open, and those that come with the program. What is open
/// is none to be opened.
void FinderRows::addLevels() {
    const QString current = m_window.files().path();
    for (const QString& path : m_window.files().preferences.recentFiles()) {
        if (path != current) {
            addLevel(path, QDir::toNativeSeparators(QFileInfo(path).absolutePath()));
        }
    }
    const QStringList spelling{QStringLiteral("*.json")};
    if (!current.isEmpty()) {
        const QDir folder = QFileInfo(current).absoluteDir();
        for (const QString& name : folder.entryList(spelling, QDir::Files, QDir::Name).mid(0, mostFiles)) {
            if (!name.endsWith(QLatin1String(".replay.json")) && name != QFileInfo(current).fileName()) {
                addLevel(folder.filePath(name), QDir::toNativeSeparators(folder.path()));
            }
        }
    }
    for (const QString& resource : shippedLevels()) {
        addLevel(resource, MainWindow::tr("comes with the program"));
    }
}

void FinderRows::addLevel(const QString& path, const QString& place) {
    const QString code = codeOfPlace(path);
    if (withCode(code)) {
        return;
    }
    const bool isShipped = path.startsWith(QLatin1Char(':'));
    const QString name = QFileInfo(path).fileName();
    const QString title = titleOf(path);
    m_few.push_back({.kind = FindKind::Level,
                     .name = isShipped ? QFileInfo(path).completeBaseName() : name,
                     .place = title.isEmpty() ? place : title + QStringLiteral(" · ") + place,
                     .code = code,
                     .icon = icon(QStringLiteral("level"), m_window.palette()),
                     .run = [window = &m_window, path] { window->openFiles({path}); }});
}

FindKind FinderRows::kind(int row) const {
    return row < few()                    ? m_few[static_cast<std::size_t>(row)].kind
           : row < few() + problemCount() ? FindKind::Problem
                                          : FindKind::Object;
}

QString FinderRows::text(int row) const {
    if (row < few()) {
        const FinderRow& found = m_few[static_cast<std::size_t>(row)];
        return found.name + QLatin1Char(' ') + found.place;
    }
    if (row < few() + problemCount()) {
        return sentence(m_problems[static_cast<std::size_t>(row - few())]);
    }
    const Object& object = m_level->objects[row - few() - problemCount()];
    const QString& kind = m_kinds[static_cast<std::size_t>(kindOf(object))];
    return object.name.empty() ? kind : QString::fromStdString(object.name) + QLatin1Char(' ') + kind;
}

FinderRow FinderRows::row(int row) const {
    if (row < few()) {
        return m_few[static_cast<std::size_t>(row)];
    }
    return row < few() + problemCount() ? problemRow(m_problems[static_cast<std::size_t>(row - few())])
                                        : objectRow(m_level->objects[row - few() - problemCount()]);
}

FinderRow FinderRows::problemRow(const Problem& problem) const {
    const Object* const object = m_level->objects.find(problem.object);
    const bool isError = problem.severity == Severity::Error;
    return {.kind = FindKind::Problem,
            .name = sentence(problem),
            .place = object != nullptr ? listedName(*m_level, *object) : MainWindow::tr("Level"),
            .icon = icon(isError ? QStringLiteral("error") : QStringLiteral("warning"),
                         isError ? markColors(shadeOf(m_window.palette())).error
                                 : markColors(shadeOf(m_window.palette())).warning),
            .run = [window = &m_window, problem] { window->problems().goTo(problem); }};
}

FinderRow FinderRows::objectRow(const Object& object) const {
    const bool isNamed = !object.name.empty();
    const QString kind = m_kinds[static_cast<std::size_t>(kindOf(object))];
    return {.kind = FindKind::Object,
            .name = isNamed ? QString::fromStdString(object.name) : kind,
            .place = isNamed ? kind : placedKind(object),
            .icon = icon(kindIcon(object), m_window.palette()),
            .run = [window = &m_window, key = object.key] { window->showObject(key); }};
}

std::optional<int> FinderRows::withCode(const QString& code) const {
    const auto found = std::ranges::find(m_few, code, &FinderRow::code);
    return found == m_few.end() ? std::nullopt : std::optional(static_cast<int>(found - m_few.begin()));
}

} // namespace spacetow
