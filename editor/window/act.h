#pragma once
// The names by which the program speaks of its actions. A new one stands in a line of its own, with those of its topic.

#include "editor/editing/tools.h"

#include <cstdint>
#include <variant>

namespace spacetow {

enum class Act : std::uint8_t {
    // actions_file.cpp
    New,
    Open,
    ReopenClosed,
    QuickOpen,
    Save,
    SaveAs,
    Reload,
    Recover,
    Close,
    Quit,

    // actions_exchange.cpp
    Import,
    ExportAs,
    ExportAgain,
    Screenshot,

    // actions_edit.cpp
    Undo,
    Redo,
    Cut,
    Copy,
    Paste,
    PasteInPlace,
    Duplicate,
    DuplicateInPlace,
    Delete,
    SelectAll,
    SelectNone,
    InvertSelection,
    SelectSameKind,
    SelectSameTags,

    // actions_view.cpp
    ZoomIn,
    ZoomOut,
    ZoomReset,
    FitLevel,
    Center,
    Frame,
    Grid,
    HidePanels,
    FullScreen,
    Rulers,
    Guides,
    ClearGuides,
    AppearanceSystem,
    AppearanceLight,
    AppearanceDark,

    // actions_snap.cpp
    Snap,
    SmartSnap,
    SnapVertices,
    SnapMidpoints,
    SnapIntersections,
    SnapPerpendiculars,
    SnapEdges,
    SnapGuides,
    SnapAlignment,
    SnapAngles,
    CoarserGrid,
    FinerGrid,

    // actions_overlays.cpp; the first in the order of editor/canvas/overlay_table
    OverlayAabb,
    OverlayIncircle,
    OverlayVelocity,
    OverlayOrientation,
    OverlayNormals,
    OverlayQuadtree,
    OverlayContacts,
    OverlayTension,
    OverlayTrails,
    OverlayWays,
    OverlayMasses,
    OverlayNames,
    OverlayIslands,
    OverlayTags,
    OverlayRisk,
    ShowCollisions, // the last of those that have a row in overlay_table
    OverlaysOff,
    OverlayProblems,
    OverlayLegend,
    OverlayColors,
    OverlayColorsSafe,
    OverlayColorsReset,
    Reach,
    ReachLonger,
    ReachShorter,

    // actions_tools.cpp; each tool is an action too, under its ToolId
    PlaceNext,
    AddGuide,

    // actions_object.cpp
    RotateLeft,
    RotateRight,
    QuarterLeft,
    QuarterRight,
    Reverse,
    FlipHorizontally,
    FlipVertically,
    RepeatLast,
    TypeTransform,
    LinearArray,
    RadialArray,

    // actions_arrange.cpp
    Group,
    Ungroup,
    Hide,
    Isolate,
    ShowAll,
    Lock,
    UnlockAll,
    ToFront,
    Forward,
    Backward,
    ToBack,
    AlignLeft,
    AlignMiddleAcross,
    AlignRight,
    AlignTop,
    AlignMiddleUpright,
    AlignBottom,
    SpreadEdgesAcross,
    SpreadMiddlesAcross,
    SpreadGapsAcross,
    SpreadEdgesUpright,
    SpreadMiddlesUpright,
    SpreadGapsUpright,
    NewLayer,
    ToLayerAbove,
    ToLayerBelow,

    // actions_combine.cpp
    Unite,
    Subtract,
    Intersect,

    // actions_nodes.cpp
    InsertNode,
    InsertMidpoints,
    DeleteSegments,
    JoinNodes,
    JoinBySegment,
    BreakNodes,
    StraightenNodes,
    NextNode,
    PreviousNode,

    // actions_level.cpp
    NextProblem,
    PreviousProblem,
    FixProblem,
    FixAllProblems,
    HideProblem,

    // actions_panels.cpp
    Find,
    Rename,
    LevelProperties,
    Compare,

    // actions_play.cpp
    Play,
    Simulate,
    PlayFromHere,
    Stop,
    Pause,
    Step,
    StepBack,
    StepIteration,
    Restart,
    Slower,
    Faster,
    TimeFirst,
    TimeLast,
    Follow,
    SaveFlight,

    // actions_window.cpp
    NewWindow,
    NewView,
    NextWindow,
    Welcome,
    RestoreWindows,

    // actions_help.cpp
    CommandPalette,
    Keys,
    EditKeys,
    CopyCapsule,
    About,
};

/// What an action is called in code; taking a tool in hand is one.
using ActionId = std::variant<Act, ToolId>;

} // namespace spacetow
