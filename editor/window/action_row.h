#pragma once
// An action is said in one row: what it is called, where it is found, when it is possible and what it does. The rows
// stand in actions_<topic>.cpp; a new topic is declared here and listed in actions.cpp.

#include "editor/window/act.h"
#include "editor/window/menus.h"

#include <QString>

#include <span>

namespace spacetow {

class MainWindow;
struct HintText;

/// Flags of an action. Without WhilePlaying an action rests while a game is running: plain keys are the game's then.
enum ActionFlag : unsigned {
    NoFlag = 0,
    WhilePlaying = 1u << 0,
    OnlyPlaying = 1u << 1, // with WhilePlaying: not while editing
    NeedsSelection = 1u << 2,
    NeedsSeveral = 1u << 3, // at least two objects selected
    NeedsNodes = 1u << 4,   // at least one node selected
    SeparatorBefore = 1u << 5,
    KeyElsewhere = 1u << 6, // has no key of its own because another action leads there; see PlaceNext
    OnMainBar = 1u << 7,
    OnToolsBar = 1u << 8,     // as every tool is
    KeyOfCanvas = 1u << 9,    // its key does something else in panels, as Tab does
    WithoutLevel = 1u << 10,  // also while the welcome page is shown; all others rest then
    WhileStarting = 1u << 11, // with OnlyPlaying: also while what is to run is being read or built
    WithPanels = 1u << 12,    // while a game is running as well, once its panels are shown
    YieldsToGame = 1u << 13,  // with WhilePlaying: a key that the game has is the game's first
    // Of what is selected, at least one thing must be so; see editor/editing/selected_kinds.h.
    NeedsCopyable = 1u << 14,
    NeedsDirection = 1u << 15,
    NeedsGroup = 1u << 16,
    NeedsOutline = 1u << 17,
    NeedsUnlocked = 1u << 18,
};

struct ActionRow {
    ActionId id;
    MenuId menu;
    const char* text;      // with mnemonic; translate in the context "Actions"
    const char* icon = ""; // name of a resource
    const char* keys = ""; // separated by blanks, the first is the one that is shown
    const char* tip;       // a sentence for the status bar
    unsigned flags = NoFlag;

    /// What it does; an action that is on or off has `toggle` and `isOn` instead, and a tool none of the three.
    void (*run)(MainWindow&) = nullptr;
    void (*toggle)(MainWindow&, bool on) = nullptr;
    bool (*isOn)(const MainWindow&) = nullptr;
    /// What the flags cannot say of when it is possible.
    bool (*isPossible)(const MainWindow&) = nullptr;
    /// A sentence that says what is missing while `isPossible` says no; translate in the context "Actions".
    const char* why = "";
    /// What the status bar says while the tool is in the hand, for tools; see messages_table.h.
    std::span<const HintText> (*hints)() = nullptr;
    /// A text that changes with the document, in place of `text`; translated, with mnemonic.
    QString (*name)(const MainWindow&) = nullptr;
};

std::span<const ActionRow> fileActions();
std::span<const ActionRow> exchangeActions();
std::span<const ActionRow> leaveActions(); // the last ones of the menu of files
std::span<const ActionRow> editActions();
std::span<const ActionRow> viewActions();
std::span<const ActionRow> snapActions();
std::span<const ActionRow> overlayActions();
std::span<const ActionRow> toolActions();
std::span<const ActionRow> objectActions();
std::span<const ActionRow> nodeActions();
std::span<const ActionRow> arrangeActions();
std::span<const ActionRow> combineActions();
std::span<const ActionRow> levelActions();
std::span<const ActionRow> panelActions();
std::span<const ActionRow> playActions();
std::span<const ActionRow> windowActions();
std::span<const ActionRow> helpActions();

} // namespace spacetow
