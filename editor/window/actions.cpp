#include "editor/window/actions.h"

#include "editor/canvas/icons.h"

#include <QCoreApplication>
#include <QWidget>

#include <array>

namespace spacetow {

namespace {

#define TEXT(words) QT_TRANSLATE_NOOP("Actions", words)

// clang-format off
constexpr std::array rows{
    ActionRow{Act::New, MenuId::File, TEXT("&New"), "new", "Ctrl+N", TEXT("Start an empty level")},
    ActionRow{Act::Open, MenuId::File, TEXT("&Open…"), "open", "Ctrl+O", TEXT("Open a level file")},
    ActionRow{Act::Save, MenuId::File, TEXT("&Save"), "save", "Ctrl+S", TEXT("Write the level to its file"), SeparatorBefore},
    ActionRow{Act::SaveAs, MenuId::File, TEXT("Save &As…"), "save-as", "Ctrl+Shift+S", TEXT("Write the level to another file")},
    ActionRow{Act::Quit, MenuId::File, TEXT("&Quit"), "quit", "Ctrl+Q", TEXT("Leave the program"), WhilePlaying | SeparatorBefore},

    ActionRow{Act::Undo, MenuId::Edit, TEXT("&Undo"), "undo", "Ctrl+Z", TEXT("Take back the last change")},
    ActionRow{Act::Redo, MenuId::Edit, TEXT("&Redo"), "redo", "Ctrl+Shift+Z Ctrl+Y", TEXT("Make the change again")},
    ActionRow{Act::Cut, MenuId::Edit, TEXT("Cu&t"), "cut", "Ctrl+X", TEXT("Move the selection to the clipboard"), NeedsSelection | SeparatorBefore},
    ActionRow{Act::Copy, MenuId::Edit, TEXT("&Copy"), "copy", "Ctrl+C", TEXT("Copy the selection to the clipboard as text"), NeedsSelection},
    ActionRow{Act::Paste, MenuId::Edit, TEXT("&Paste"), "paste", "Ctrl+V", TEXT("Insert what is on the clipboard at the pointer")},
    ActionRow{Act::PasteInPlace, MenuId::Edit, TEXT("Paste &in Place"), "", "Ctrl+Shift+V Ctrl+Alt+V", TEXT("Insert what is on the clipboard where it was copied")},
    ActionRow{Act::Duplicate, MenuId::Edit, TEXT("&Duplicate"), "duplicate", "Ctrl+D", TEXT("Copy the selection one grid step away"), NeedsSelection},
    ActionRow{Act::Delete, MenuId::Edit, TEXT("De&lete"), "delete", "Del", TEXT("Remove the selection"), NeedsSelection},
    ActionRow{Act::SelectAll, MenuId::Edit, TEXT("Select &All"), "select-all", "Ctrl+A", TEXT("Select every object"), SeparatorBefore},
    ActionRow{Act::SelectNone, MenuId::Edit, TEXT("Select &None"), "", "Ctrl+Shift+A", TEXT("Select nothing"), NeedsSelection},
    ActionRow{Act::InvertSelection, MenuId::Edit, TEXT("In&vert Selection"), "invert", "Ctrl+I", TEXT("Select what is not selected")},

    ActionRow{Act::ZoomIn, MenuId::View, TEXT("Zoom &In"), "zoom-in", "Ctrl+= Ctrl++ + =", TEXT("Show less of the level, larger")},
    ActionRow{Act::ZoomOut, MenuId::View, TEXT("Zoom &Out"), "zoom-out", "Ctrl+- -", TEXT("Show more of the level, smaller")},
    ActionRow{Act::ZoomReset, MenuId::View, TEXT("&Original Size"), "zoom-reset", "Ctrl+0 1", TEXT("Show the level as large as in the game")},
    ActionRow{Act::FitLevel, MenuId::View, TEXT("&Fit Level"), "zoom-fit", "Ctrl+/ 4", TEXT("Show the whole level")},
    ActionRow{Act::Center, MenuId::View, TEXT("&Center Selection"), "center", "F", TEXT("Bring the selection to the middle of the view")},
    ActionRow{Act::Frame, MenuId::View, TEXT("F&rame Selection"), "", "Shift+F 3", TEXT("Show the selection as large as fits")},
    ActionRow{Act::Grid, MenuId::View, TEXT("&Grid"), "grid", "G #", TEXT("Show the grid"), Checkable | SeparatorBefore},
    ActionRow{Act::Snap, MenuId::View, TEXT("&Snap to Grid"), "snap", "Shift+G", TEXT("Let points land on the grid; Ctrl inverts it while drawing"), Checkable},

    ActionRow{Act::OverlayAabb, MenuId::Overlays, TEXT("&Bounding Boxes"), "overlay-aabb", "Alt+1", TEXT("Show the bounding box of every body"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayIncircle, MenuId::Overlays, TEXT("&Incircles"), "overlay-incircle", "Alt+2", TEXT("Show the incircle of every polygon"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayVelocity, MenuId::Overlays, TEXT("&Velocities"), "overlay-velocity", "Alt+3", TEXT("Show where every body would be in a second"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayOrientation, MenuId::Overlays, TEXT("&Orientations"), "overlay-orientation", "Alt+4", TEXT("Show which way up every body is"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayNormals, MenuId::Overlays, TEXT("&Normals"), "overlay-normals", "Alt+5", TEXT("Show the free side of every wall"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayQuadtree, MenuId::Overlays, TEXT("&Quadtree"), "overlay-quadtree", "Alt+6", TEXT("Show the cells in which collisions are looked for"), Checkable | WhilePlaying},
    ActionRow{Act::OverlaysOff, MenuId::Overlays, TEXT("&All Off"), "overlay-none", "Alt+0", TEXT("Hide all overlays"), WhilePlaying | SeparatorBefore},
    ActionRow{Act::FullScreen, MenuId::View, TEXT("F&ull Screen"), "", "F11", TEXT("Use the whole screen"), Checkable | WhilePlaying | SeparatorBefore},

    ActionRow{Act::ToolSelect, MenuId::Insert, TEXT("&Select"), "select", "S Q", TEXT("Select and move objects"), Checkable | Tool},
    ActionRow{Act::ToolEdge, MenuId::Insert, TEXT("One-Way &Wall"), "edge", "E", TEXT("Draw walls that are solid from one side"), Checkable | Tool | SeparatorBefore},
    ActionRow{Act::ToolLine, MenuId::Insert, TEXT("Two-Way &Line"), "line", "L", TEXT("Draw walls that are solid from both sides"), Checkable | Tool},
    ActionRow{Act::ToolPolygon, MenuId::Insert, TEXT("&Polygon"), "polygon", "P", TEXT("Draw a solid polygon"), Checkable | Tool},
    ActionRow{Act::ToolCircle, MenuId::Insert, TEXT("&Circle"), "circle", "C", TEXT("Draw a circle from its center"), Checkable | Tool},
    ActionRow{Act::PlaceShip, MenuId::Insert, TEXT("S&hip"), "ship", "", TEXT("Place the ship; drag to turn it"), Checkable | Tool | KeyElsewhere | SeparatorBefore},
    ActionRow{Act::PlacePayload, MenuId::Insert, TEXT("Pay&load"), "payload", "", TEXT("Place the payload"), Checkable | Tool | KeyElsewhere},
    ActionRow{Act::PlaceFinish, MenuId::Insert, TEXT("&Finish"), "finish", "", TEXT("Draw the line that the payload has to cross"), Checkable | Tool | KeyElsewhere},
    ActionRow{Act::PlaceNext, MenuId::Insert, TEXT("Place S&hip, Payload, Finish"), "", "I", TEXT("Place ship, payload or finish; again for the next of them")},

    ActionRow{Act::RotateLeft, MenuId::Object, TEXT("Rotate &Left 15°"), "rotate-left", "[", TEXT("Turn the selection anticlockwise"), NeedsSelection},
    ActionRow{Act::RotateRight, MenuId::Object, TEXT("Rotate &Right 15°"), "rotate-right", "]", TEXT("Turn the selection clockwise"), NeedsSelection},
    ActionRow{Act::QuarterLeft, MenuId::Object, TEXT("Rotate Left &90°"), "", "Ctrl+[ Z", TEXT("Turn the selection a quarter anticlockwise"), NeedsSelection},
    ActionRow{Act::QuarterRight, MenuId::Object, TEXT("Rotate Right 9&0°"), "", "Ctrl+] Shift+Z", TEXT("Turn the selection a quarter clockwise"), NeedsSelection},
    ActionRow{Act::Reverse, MenuId::Object, TEXT("Re&verse Direction"), "reverse", "Shift+R", TEXT("Make one-way walls solid from the other side"), NeedsSelection | SeparatorBefore},
    ActionRow{Act::NextProblem, MenuId::Object, TEXT("&Next Problem"), "warning", "F4", TEXT("Go to the next problem of the level"), SeparatorBefore},
    ActionRow{Act::PreviousProblem, MenuId::Object, TEXT("&Previous Problem"), "", "Shift+F4", TEXT("Go to the problem before")},

    ActionRow{Act::Play, MenuId::Play, TEXT("&Play"), "play", "F5", TEXT("Play a copy of the level, here and now")},
    ActionRow{Act::Stop, MenuId::Play, TEXT("&Stop"), "stop", "F8", TEXT("Go back to the level as it was"), WhilePlaying | OnlyPlaying},
    ActionRow{Act::Pause, MenuId::Play, TEXT("Pa&use"), "pause", "F9", TEXT("Hold the game"), Checkable | WhilePlaying | OnlyPlaying | SeparatorBefore},
    ActionRow{Act::Step, MenuId::Play, TEXT("&Next Frame"), "step", "F10", TEXT("Hold the game and advance it by one update"), WhilePlaying | OnlyPlaying},
    ActionRow{Act::Restart, MenuId::Play, TEXT("&Restart"), "restart", "Ctrl+R", TEXT("Play the level from its beginning"), WhilePlaying | OnlyPlaying},

    ActionRow{Act::Keys, MenuId::Help, TEXT("&Keys…"), "keyboard", "F1", TEXT("Show what the keys do"), WhilePlaying},
    ActionRow{Act::About, MenuId::Help, TEXT("&About SpaceTow Studio…"), "info", "Ctrl+F1", TEXT("Show version and license"), WhilePlaying},
};
// clang-format on

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

} // namespace

std::span<const ActionRow> actionRows() {
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

Actions::Actions(QWidget& window) : m_tools(nullptr), m_actions(rows.size()) {
    for (const ActionRow& row : rows) {
        auto action = std::make_unique<QAction>(translated(row.text));
        action->setShortcuts(keysOf(row));
        action->setToolTip(toolTip(row));
        action->setStatusTip(translated(row.tip));
        action->setCheckable((row.flags & Checkable) != 0);
        if ((row.flags & Tool) != 0) {
            m_tools.addAction(action.get());
        }
        window.addAction(action.get());
        m_actions[static_cast<std::size_t>(row.act)] = std::move(action);
    }
    tint(window.palette());
}

void Actions::on(Act act, std::function<void()> handler) const {
    QObject::connect(&(*this)[act], &QAction::triggered, &(*this)[act], [handler = std::move(handler)] { handler(); });
}

void Actions::onToggled(Act act, std::function<void(bool)> handler) const {
    QObject::connect(&(*this)[act], &QAction::toggled, &(*this)[act], std::move(handler));
}

void Actions::tint(const QPalette& palette) const {
    for (const ActionRow& row : rows) {
        if (*row.icon != '\0') {
            (*this)[row.act].setIcon(icon(QString::fromLatin1(row.icon), palette));
        }
    }
}

void Actions::setSituation(bool playing, bool selection) const {
    for (const ActionRow& row : rows) {
        const bool now = playing ? (row.flags & WhilePlaying) != 0 : (row.flags & OnlyPlaying) == 0;
        (*this)[row.act].setEnabled(now && (selection || (row.flags & NeedsSelection) == 0));
    }
}

} // namespace spacetow
