// Undo, clipboard, selection.
#include "core/level/file.h"
#include "editor/editing/arrange_verbs.h"
#include "editor/editing/clipboard.h"
#include "editor/editing/node_verbs.h"
#include "editor/editing/verbs.h"
#include "editor/exchange/capsule_text.h"
#include "editor/window/messages.h"
#include "editor/window/verb_action.h"

#include <QApplication>
#include <QClipboard>

#include <algorithm>

namespace spacetow {

namespace {

/// Of a half-drawn shape, its last point is what was done last; there is nothing after it to be done again.
void undo(MainWindow& window) {
    if (window.toolbox().isBusy()) {
        window.canvas().toolKey(ToolKey::Backspace);
    } else {
        window.document().undo();
    }
}

void redo(MainWindow& window) {
    if (!window.toolbox().isBusy()) {
        window.document().redo();
    }
}

bool isInNodeTool(MainWindow& window) {
    return window.toolbox().current() == ToolId::Nodes && !window.document().selection().empty();
}

void selectEverything(MainWindow& window) {
    const Edit& shown = window.document().shown();
    window.document().select(isInNodeTool(window) ? selectAllNodes(shown) : selectAll(shown));
}

void selectTheOthers(MainWindow& window) {
    const Edit& shown = window.document().shown();
    window.document().select(isInNodeTool(window) ? invertedNodes(shown) : invertedSelection(shown));
}

QString undoName(const MainWindow& window) {
    const QString verb = MainWindow::tr("&Undo");
    const Document& document = window.document();
    const bool ofEdit = document.canUndo() && !window.toolbox().isBusy();
    return ofEdit ? QStringLiteral("%1: %2").arg(verb, sentence(document.undoLabel())) : verb;
}

QString redoName(const MainWindow& window) {
    const QString verb = MainWindow::tr("&Redo");
    const Document& document = window.document();
    return document.canRedo() ? QStringLiteral("%1: %2").arg(verb, sentence(document.redoLabel())) : verb;
}

void copySelection(MainWindow& window) {
    if (!window.document().selection().empty()) {
        QApplication::clipboard()->setText(QString::fromStdString(copied(window.document().current())));
    }
}

/// What was measured goes before what is selected: it is what one looks at.
void copyToClipboard(MainWindow& window) {
    const std::string numbers = window.toolbox().numbers();
    if (numbers.empty()) {
        copySelection(window);
    } else {
        QApplication::clipboard()->setText(QString::fromStdString(numbers));
    }
}

bool hasSomethingToCopy(const MainWindow& window) {
    return !window.document().selection().empty() || window.toolbox().current() == ToolId::Measure;
}

void cutToClipboard(MainWindow& window) {
    copySelection(window);
    doing<cut>(window);
}

/// Of a text of which nothing has come to be in the level.
QString whyNotPasted(const std::string& text) {
    std::vector<Problem> problems;
    const std::vector<Object> objects = parseObjects(text, problems).objects;
    if (objects.empty()) {
        return MainWindow::tr("There is nothing on the clipboard that can be pasted here.");
    }
    const bool areConnectors = std::ranges::all_of(
        objects, [](const Object& object) { return std::holds_alternative<ConnectorObject>(object.data); });
    return areConnectors
               ? MainWindow::tr("A connector is pasted together with the two bodies that it joins.")
               : MainWindow::tr("A level has one ship, one payload and one finish, and this one has them already.");
}

void pasteAt(MainWindow& window, const std::optional<Vec2>& at) {
    const std::string text = QApplication::clipboard()->text().toStdString();
    if (holdsCapsule(text)) {
        window.bugCapsule().open(text);
        return;
    }
    const std::optional<FinishedEdit> edit = pasted(window.toolbox().context(), text, at);
    if (!edit) {
        window.messageBar().say(MessageBar::Tone::Info, whyNotPasted(text));
    }
    window.toolbox().finish(edit);
    QStringList notes;
    for (const Error& note : edit ? edit->notes : std::vector<Error>()) {
        notes << sentence(note);
    }
    if (!notes.isEmpty()) {
        window.messageBar().say(MessageBar::Tone::Info, notes.join(QLatin1Char(' ')));
    }
}

void paste(MainWindow& window) {
    pasteAt(window, window.canvas().pointerPosition());
}

void pasteInPlace(MainWindow& window) {
    pasteAt(window, std::nullopt);
}

constexpr ActionRow editRows[] = {
    {.id = Act::Undo,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "&Undo"),
     .icon = "undo",
     .keys = "Ctrl+Z",
     .tip = QT_TRANSLATE_NOOP("Actions", "Take back the last change"),
     .flags = OnMainBar | WithPanels,
     .run = undo,
     .isPossible = [](const MainWindow& window) { return window.toolbox().isBusy() || window.document().canUndo(); },
     .why = QT_TRANSLATE_NOOP("Actions", "There is nothing to undo."),
     .name = undoName},
    {.id = Act::Redo,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "&Redo"),
     .icon = "redo",
     .keys = "Ctrl+Shift+Z Ctrl+Y",
     .tip = QT_TRANSLATE_NOOP("Actions", "Make the change again"),
     .flags = OnMainBar | WithPanels,
     .run = redo,
     .isPossible = [](const MainWindow& window) { return !window.toolbox().isBusy() && window.document().canRedo(); },
     .why = QT_TRANSLATE_NOOP("Actions", "There is nothing to redo."),
     .name = redoName},
    {.id = Act::Cut,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "Cu&t"),
     .icon = "cut",
     .keys = "Ctrl+X",
     .tip = QT_TRANSLATE_NOOP("Actions", "Move the selection to the clipboard"),
     .flags = NeedsSelection | SeparatorBefore | NeedsUnlocked,
     .run = cutToClipboard},
    {.id = Act::Copy,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "&Copy"),
     .icon = "copy",
     .keys = "Ctrl+C",
     .tip = QT_TRANSLATE_NOOP("Actions", "Copy the selection to the clipboard as text"),
     .run = copyToClipboard,
     .isPossible = hasSomethingToCopy,
     .why = QT_TRANSLATE_NOOP("Actions", "Select something first.")},
    {.id = Act::Paste,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "&Paste"),
     .icon = "paste",
     .keys = "Ctrl+V",
     .tip = QT_TRANSLATE_NOOP("Actions", "Insert what is on the clipboard at the pointer"),
     .run = paste},
    {.id = Act::PasteInPlace,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "Paste &in Place"),
     .keys = "Ctrl+Shift+V Ctrl+Alt+V",
     .tip = QT_TRANSLATE_NOOP("Actions", "Insert what is on the clipboard where it was copied"),
     .run = pasteInPlace},
    {.id = Act::Duplicate,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "&Duplicate"),
     .icon = "duplicate",
     .keys = "Ctrl+D",
     .tip = QT_TRANSLATE_NOOP("Actions", "Copy the selection one grid step away"),
     .flags = NeedsSelection | NeedsCopyable,
     .run = doing<duplicateSelected>},
    {.id = Act::DuplicateInPlace,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "Duplicat&e in Place"),
     .icon = "duplicate-in-place",
     .keys = "Alt+Shift+D",
     .tip = QT_TRANSLATE_NOOP("Actions", "Copy the selection onto itself; what is done to the copy can be repeated"),
     .flags = NeedsSelection | NeedsCopyable,
     .run = doing<duplicateInPlace>},
    {.id = Act::Delete,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "De&lete"),
     .icon = "delete",
     .keys = "Del",
     .tip = QT_TRANSLATE_NOOP("Actions", "Remove the selection"),
     .flags = NeedsSelection | NeedsUnlocked,
     .run = [](MainWindow& window) { window.canvas().toolKey(ToolKey::Delete); }},
    {.id = Act::SelectAll,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "Select &All"),
     .icon = "select-all",
     .keys = "Ctrl+A",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select every object"),
     .flags = SeparatorBefore,
     .run = selectEverything},
    {.id = Act::SelectNone,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "Select &None"),
     .keys = "Ctrl+Shift+A",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select nothing"),
     .flags = NeedsSelection,
     .run = [](MainWindow& window) { window.document().select(Selection()); }},
    {.id = Act::InvertSelection,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "In&vert Selection"),
     .icon = "invert",
     .keys = "Ctrl+I !",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select what is not selected"),
     .run = selectTheOthers},
    {.id = Act::SelectSameKind,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "Select Same &Kind"),
     .keys = "Alt+Shift+K",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select all objects of the same kind as those selected"),
     .flags = NeedsSelection,
     .run = [](MainWindow& window) { window.document().select(sameKind(window.document().shown())); }},
    {.id = Act::SelectSameTags,
     .menu = MenuId::Edit,
     .text = QT_TRANSLATE_NOOP("Actions", "Select Same Ta&gs"),
     .keys = "Alt+Shift+G",
     .tip = QT_TRANSLATE_NOOP("Actions", "Select all bodies with the same tags as those selected"),
     .flags = NeedsSelection,
     .run = [](MainWindow& window) { window.document().select(sameTags(window.document().shown())); }},
};

} // namespace

std::span<const ActionRow> editActions() {
    return editRows;
}

} // namespace spacetow
