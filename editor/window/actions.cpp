#include "editor/window/actions.h"

#include "editor/canvas/icons.h"

#include <QCoreApplication>
#include <QWidget>

#include <array>

namespace spacetow {

namespace {

// clang-format off
constexpr std::array rows{
    ActionRow{Act::New, MenuId::File, QT_TRANSLATE_NOOP("Actions", "&New"), "new", "Ctrl+N", QT_TRANSLATE_NOOP("Actions", "Start an empty level")},
    ActionRow{Act::Open, MenuId::File, QT_TRANSLATE_NOOP("Actions", "&Open…"), "open", "Ctrl+O", QT_TRANSLATE_NOOP("Actions", "Open a level file")},
    ActionRow{Act::Save, MenuId::File, QT_TRANSLATE_NOOP("Actions", "&Save"), "save", "Ctrl+S", QT_TRANSLATE_NOOP("Actions", "Write the level to its file"), SeparatorBefore},
    ActionRow{Act::SaveAs, MenuId::File, QT_TRANSLATE_NOOP("Actions", "Save &As…"), "save-as", "Ctrl+Shift+S", QT_TRANSLATE_NOOP("Actions", "Write the level to another file")},
    ActionRow{Act::Quit, MenuId::File, QT_TRANSLATE_NOOP("Actions", "&Quit"), "quit", "Ctrl+Q", QT_TRANSLATE_NOOP("Actions", "Leave the program"), WhilePlaying | SeparatorBefore},

    ActionRow{Act::Undo, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "&Undo"), "undo", "Ctrl+Z", QT_TRANSLATE_NOOP("Actions", "Take back the last change")},
    ActionRow{Act::Redo, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "&Redo"), "redo", "Ctrl+Shift+Z Ctrl+Y", QT_TRANSLATE_NOOP("Actions", "Make the change again")},
    ActionRow{Act::Cut, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "Cu&t"), "cut", "Ctrl+X", QT_TRANSLATE_NOOP("Actions", "Move the selection to the clipboard"), NeedsSelection | SeparatorBefore},
    ActionRow{Act::Copy, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "&Copy"), "copy", "Ctrl+C", QT_TRANSLATE_NOOP("Actions", "Copy the selection to the clipboard as text"), NeedsSelection},
    ActionRow{Act::Paste, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "&Paste"), "paste", "Ctrl+V", QT_TRANSLATE_NOOP("Actions", "Insert what is on the clipboard at the pointer")},
    ActionRow{Act::PasteInPlace, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "Paste &in Place"), "", "Ctrl+Shift+V Ctrl+Alt+V", QT_TRANSLATE_NOOP("Actions", "Insert what is on the clipboard where it was copied")},
    ActionRow{Act::Duplicate, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "&Duplicate"), "duplicate", "Ctrl+D", QT_TRANSLATE_NOOP("Actions", "Copy the selection one grid step away"), NeedsSelection},
    ActionRow{Act::Delete, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "De&lete"), "delete", "Del", QT_TRANSLATE_NOOP("Actions", "Remove the selection"), NeedsSelection},
    ActionRow{Act::SelectAll, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "Select &All"), "select-all", "Ctrl+A", QT_TRANSLATE_NOOP("Actions", "Select every object"), SeparatorBefore},
    ActionRow{Act::SelectNone, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "Select &None"), "", "Ctrl+Shift+A", QT_TRANSLATE_NOOP("Actions", "Select nothing"), NeedsSelection},
    ActionRow{Act::InvertSelection, MenuId::Edit, QT_TRANSLATE_NOOP("Actions", "In&vert Selection"), "invert", "Ctrl+I", QT_TRANSLATE_NOOP("Actions", "Select what is not selected")},

    ActionRow{Act::ZoomIn, MenuId::View, QT_TRANSLATE_NOOP("Actions", "Zoom &In"), "zoom-in", "Ctrl+= Ctrl++ + =", QT_TRANSLATE_NOOP("Actions", "Show less of the level, larger")},
    ActionRow{Act::ZoomOut, MenuId::View, QT_TRANSLATE_NOOP("Actions", "Zoom &Out"), "zoom-out", "Ctrl+- -", QT_TRANSLATE_NOOP("Actions", "Show more of the level, smaller")},
    ActionRow{Act::ZoomReset, MenuId::View, QT_TRANSLATE_NOOP("Actions", "&Original Size"), "zoom-reset", "Ctrl+0 1", QT_TRANSLATE_NOOP("Actions", "Show the level as large as in the game")},
    ActionRow{Act::FitLevel, MenuId::View, QT_TRANSLATE_NOOP("Actions", "&Fit Level"), "zoom-fit", "Ctrl+/ 4", QT_TRANSLATE_NOOP("Actions", "Show the whole level")},
    ActionRow{Act::Center, MenuId::View, QT_TRANSLATE_NOOP("Actions", "&Center Selection"), "center", "F", QT_TRANSLATE_NOOP("Actions", "Bring the selection to the middle of the view")},
    ActionRow{Act::Frame, MenuId::View, QT_TRANSLATE_NOOP("Actions", "F&rame Selection"), "", "Shift+F 3", QT_TRANSLATE_NOOP("Actions", "Show the selection as large as fits")},
    ActionRow{Act::Grid, MenuId::View, QT_TRANSLATE_NOOP("Actions", "&Grid"), "grid", "G #", QT_TRANSLATE_NOOP("Actions", "Show the grid"), Checkable | SeparatorBefore},
    ActionRow{Act::Snap, MenuId::View, QT_TRANSLATE_NOOP("Actions", "&Snap to Grid"), "snap", "Shift+G", QT_TRANSLATE_NOOP("Actions", "Let points land on the grid; Ctrl inverts it while drawing"), Checkable},

    ActionRow{Act::OverlayAabb, MenuId::Overlays, QT_TRANSLATE_NOOP("Actions", "&Bounding Boxes"), "overlay-aabb", "Alt+1", QT_TRANSLATE_NOOP("Actions", "Show the bounding box of every body"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayIncircle, MenuId::Overlays, QT_TRANSLATE_NOOP("Actions", "&Incircles"), "overlay-incircle", "Alt+2", QT_TRANSLATE_NOOP("Actions", "Show the incircle of every polygon"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayVelocity, MenuId::Overlays, QT_TRANSLATE_NOOP("Actions", "&Velocities"), "overlay-velocity", "Alt+3", QT_TRANSLATE_NOOP("Actions", "Show where every body would be in a second"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayOrientation, MenuId::Overlays, QT_TRANSLATE_NOOP("Actions", "&Orientations"), "overlay-orientation", "Alt+4", QT_TRANSLATE_NOOP("Actions", "Show which way up every body is"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayNormals, MenuId::Overlays, QT_TRANSLATE_NOOP("Actions", "&Normals"), "overlay-normals", "Alt+5", QT_TRANSLATE_NOOP("Actions", "Show the free side of every wall"), Checkable | WhilePlaying},
    ActionRow{Act::OverlayQuadtree, MenuId::Overlays, QT_TRANSLATE_NOOP("Actions", "&Quadtree"), "overlay-quadtree", "Alt+6", QT_TRANSLATE_NOOP("Actions", "Show the cells in which collisions are looked for"), Checkable | WhilePlaying},
    ActionRow{Act::OverlaysOff, MenuId::Overlays, QT_TRANSLATE_NOOP("Actions", "&All Off"), "overlay-none", "Alt+0", QT_TRANSLATE_NOOP("Actions", "Hide all overlays"), WhilePlaying | SeparatorBefore},
    ActionRow{Act::FullScreen, MenuId::View, QT_TRANSLATE_NOOP("Actions", "F&ull Screen"), "", "F11", QT_TRANSLATE_NOOP("Actions", "Use the whole screen"), Checkable | WhilePlaying | SeparatorBefore},

    ActionRow{Act::ToolSelect, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "&Select"), "select", "S Q", QT_TRANSLATE_NOOP("Actions", "Select and move objects"), Checkable | Tool},
    ActionRow{Act::ToolEdge, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "One-Way &Wall"), "edge", "E", QT_TRANSLATE_NOOP("Actions", "Draw walls that are solid from one side"), Checkable | Tool | SeparatorBefore},
    ActionRow{Act::ToolLine, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "Two-Way &Line"), "line", "L", QT_TRANSLATE_NOOP("Actions", "Draw walls that are solid from both sides"), Checkable | Tool},
    ActionRow{Act::ToolPolygon, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "&Polygon"), "polygon", "P", QT_TRANSLATE_NOOP("Actions", "Draw a solid polygon"), Checkable | Tool},
    ActionRow{Act::ToolCircle, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "&Circle"), "circle", "C", QT_TRANSLATE_NOOP("Actions", "Draw a circle from its center"), Checkable | Tool},
    ActionRow{Act::PlaceShip, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "S&hip"), "ship", "", QT_TRANSLATE_NOOP("Actions", "Place the ship; drag to turn it"), Checkable | Tool | KeyElsewhere | SeparatorBefore},
    ActionRow{Act::PlacePayload, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "Pay&load"), "payload", "", QT_TRANSLATE_NOOP("Actions", "Place the payload"), Checkable | Tool | KeyElsewhere},
    ActionRow{Act::PlaceFinish, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "&Finish"), "finish", "", QT_TRANSLATE_NOOP("Actions", "Draw the line that the payload has to cross"), Checkable | Tool | KeyElsewhere},
    ActionRow{Act::PlaceNext, MenuId::Insert, QT_TRANSLATE_NOOP("Actions", "Place S&hip, Payload, Finish"), "", "I", QT_TRANSLATE_NOOP("Actions", "Place ship, payload or finish; again for the next of them")},

    ActionRow{Act::RotateLeft, MenuId::Object, QT_TRANSLATE_NOOP("Actions", "Rotate &Left 15°"), "rotate-left", "[", QT_TRANSLATE_NOOP("Actions", "Turn the selection anticlockwise"), NeedsSelection},
    ActionRow{Act::RotateRight, MenuId::Object, QT_TRANSLATE_NOOP("Actions", "Rotate &Right 15°"), "rotate-right", "]", QT_TRANSLATE_NOOP("Actions", "Turn the selection clockwise"), NeedsSelection},
    ActionRow{Act::QuarterLeft, MenuId::Object, QT_TRANSLATE_NOOP("Actions", "Rotate Left &90°"), "", "Ctrl+[ Z", QT_TRANSLATE_NOOP("Actions", "Turn the selection a quarter anticlockwise"), NeedsSelection},
    ActionRow{Act::QuarterRight, MenuId::Object, QT_TRANSLATE_NOOP("Actions", "Rotate Right 9&0°"), "", "Ctrl+] Shift+Z", QT_TRANSLATE_NOOP("Actions", "Turn the selection a quarter clockwise"), NeedsSelection},
    ActionRow{Act::Reverse, MenuId::Object, QT_TRANSLATE_NOOP("Actions", "Re&verse Direction"), "reverse", "Shift+R", QT_TRANSLATE_NOOP("Actions", "Make one-way walls solid from the other side"), NeedsSelection | SeparatorBefore},
    ActionRow{Act::NextProblem, MenuId::Object, QT_TRANSLATE_NOOP("Actions", "&Next Problem"), "warning", "F4", QT_TRANSLATE_NOOP("Actions", "Go to the next problem of the level"), SeparatorBefore},
    ActionRow{Act::PreviousProblem, MenuId::Object, QT_TRANSLATE_NOOP("Actions", "&Previous Problem"), "", "Shift+F4", QT_TRANSLATE_NOOP("Actions", "Go to the problem before")},

    ActionRow{Act::Play, MenuId::Play, QT_TRANSLATE_NOOP("Actions", "&Play"), "play", "F5", QT_TRANSLATE_NOOP("Actions", "Play a copy of the level, here and now")},
    ActionRow{Act::Stop, MenuId::Play, QT_TRANSLATE_NOOP("Actions", "&Stop"), "stop", "F8", QT_TRANSLATE_NOOP("Actions", "Go back to the level as it was"), WhilePlaying | OnlyPlaying},
    ActionRow{Act::Pause, MenuId::Play, QT_TRANSLATE_NOOP("Actions", "Pa&use"), "pause", "F9", QT_TRANSLATE_NOOP("Actions", "Hold the game"), Checkable | WhilePlaying | OnlyPlaying | SeparatorBefore},
    ActionRow{Act::Step, MenuId::Play, QT_TRANSLATE_NOOP("Actions", "&Next Frame"), "step", "F10", QT_TRANSLATE_NOOP("Actions", "Hold the game and advance it by one update"), WhilePlaying | OnlyPlaying},
    ActionRow{Act::Restart, MenuId::Play, QT_TRANSLATE_NOOP("Actions", "&Restart"), "restart", "Ctrl+R", QT_TRANSLATE_NOOP("Actions", "Play the level from its beginning"), WhilePlaying | OnlyPlaying},

    ActionRow{Act::Keys, MenuId::Help, QT_TRANSLATE_NOOP("Actions", "&Keys…"), "keyboard", "F1", QT_TRANSLATE_NOOP("Actions", "Show what the keys do"), WhilePlaying},
    ActionRow{Act::About, MenuId::Help, QT_TRANSLATE_NOOP("Actions", "&About SpaceTow Studio…"), "info", "Ctrl+F1", QT_TRANSLATE_NOOP("Actions", "Show version and license"), WhilePlaying},
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
