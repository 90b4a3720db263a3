#pragma once
// Every action of the program as one table: menus, tool bars, tooltips and the overview of keys are made from it.

#include <QAction>
#include <QActionGroup>
#include <QKeySequence>
#include <QList>
#include <QString>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

class QPalette;
class QWidget;

namespace spacetow {

// clang-format off
enum class Act : std::uint8_t {
    New, Open, Save, SaveAs, Quit,
    Undo, Redo, Cut, Copy, Paste, PasteInPlace, Duplicate, Delete, SelectAll, SelectNone, InvertSelection,
    ZoomIn, ZoomOut, ZoomReset, FitLevel, Center, Frame, Grid, Snap,
    OverlayAabb, OverlayIncircle, OverlayVelocity, OverlayOrientation, OverlayNormals, OverlayQuadtree, OverlaysOff,
    FullScreen,
    ToolSelect, ToolEdge, ToolLine, ToolPolygon, ToolCircle, PlaceShip, PlacePayload, PlaceFinish, PlaceNext,
    RotateLeft, RotateRight, QuarterLeft, QuarterRight, Reverse,
    NextProblem, PreviousProblem,
    Play, Stop, Pause, Step, Restart,
    Keys, About,
};
// clang-format on

enum class MenuId : std::uint8_t { File, Edit, View, Overlays, Insert, Object, Play, Help };

struct ActionRow {
    Act act;
    MenuId menu;
    const char* text; // with mnemonic; translate in the context "Actions"
    const char* icon; // name of a resource, "" for none
    const char* keys; // separated by blanks, the first is the one that is shown
    const char* tip;  // a sentence for the status bar
    unsigned flags = 0;
};

/// Flags of an action.
enum : unsigned {
    Checkable = 1,
    WhilePlaying = 2, // stays available while a game is running; then plain keys belong to the game
    OnlyPlaying = 4,  // available then alone
    NeedsSelection = 8,
    SeparatorBefore = 16,
    KeyElsewhere = 32, // has no key of its own because another action leads there; see PlaceNext
    Tool = 64,         // one of the tools, of which one is checked
};

std::span<const ActionRow> actionRows();
/// Translated, without mnemonic and ellipsis.
QString plainText(const ActionRow& row);
QList<QKeySequence> keysOf(const ActionRow& row);

class Actions {
  public:
    /// Adds the actions to the window, which must outlive this.
    explicit Actions(QWidget& window);

    QAction& operator[](Act act) const { return *m_actions[static_cast<std::size_t>(act)]; }
    void on(Act act, std::function<void()> handler) const;
    void onToggled(Act act, std::function<void(bool)> handler) const;
    /// Draws the icons in the colours of the palette.
    void tint(const QPalette& palette) const;
    /// Switches on what can be done at this moment.
    void setSituation(bool playing, bool selection) const;

  private:
    QActionGroup m_tools;
    std::vector<std::unique_ptr<QAction>> m_actions; // by Act
};

} // namespace spacetow
