// The keys that people know from other programs, for what both have. Keys are those of Tiled 1.10, Inkscape 1.2 and
// Blender 3.4; where the other program has none for what lost its key, one that is free stands beside.
#include "editor/window/actions.h"
#include "editor/window/key_bindings.h"

#include <algorithm>

namespace spacetow {

namespace {

struct PresetKeys {
    ActionId id;
    const char* keys; // all of them, separated by blanks
};

constexpr PresetKeys tiledKeys[] = {
    {Act::Grid, "Ctrl+G G"},          {Act::Group, "Ctrl+J"},          {Act::SmartSnap, "Shift+S"},
    {Act::Snap, "Shift+G"},           {Act::QuarterRight, "Z Ctrl+]"}, {Act::QuarterLeft, "Shift+Z Ctrl+["},
    {Act::ZoomIn, "Ctrl++ Ctrl+= +"},
};

constexpr PresetKeys inkscapeKeys[] = {
    {ToolId::Select, "S F1"},
    {ToolId::Nodes, "N F2"},
    {ToolId::Rectangle, "R F4"},
    {ToolId::Circle, "E F5"},
    {ToolId::Edge, "P F6"},
    {ToolId::Polygon, "* Shift+F9"},
    {ToolId::Connector, "O Ctrl+F2"},
    {ToolId::Measure, "M"},
    {Act::Keys, "Shift+F1"},
    {Act::Rename, "Shift+F2"},
    {Act::NextProblem, "F3"},
    {Act::PreviousProblem, "Shift+F3"},
    {Act::Play, "Ctrl+F5"},
    {Act::PlayFromHere, "Shift+F6"},
    {Act::Simulate, "Ctrl+F8"},
    {Act::FlipHorizontally, "H"},
    {Act::FlipVertically, "V"},
    {Act::Hide, "Alt+Shift+H"},
    {Act::Group, "Ctrl+G Ctrl+U"},
    {Act::Ungroup, "Ctrl+Shift+G Ctrl+Shift+U"},
    {Act::PasteInPlace, "Ctrl+Alt+V"},
    {Act::InvertSelection, "! Ctrl+I"},
    {Act::DeleteSegments, "Alt+Del"},
    {Act::Find, "Ctrl+F"},
    {Act::LevelProperties, "Ctrl+Shift+D"},
    {Act::LinearArray, "Ctrl+Alt+A"},
    {Act::TypeTransform, "Ctrl+Shift+M"},
    {Act::Unite, "Ctrl++"},
    {Act::Subtract, "Ctrl+-"},
    {Act::Intersect, "Ctrl+*"},
    {Act::ZoomIn, "+ ="},
    {Act::ZoomOut, "-"},
    {Act::ZoomReset, "1"},
    {Act::FitLevel, "4 5"},
    {Act::Frame, "3"},
    {Act::Grid, "# G"},
    {Act::Guides, "| Ctrl+Alt+G"},
    {Act::SmartSnap, "% Shift+S"},
    {Act::Rulers, "Ctrl+R"},
    {Act::Reload, "Ctrl+Alt+R"},
};

constexpr PresetKeys blenderKeys[] = {
    {ToolId::Select, "W"},
    {ToolId::Kinematic, "Alt+Shift+N"},
    {Act::SelectAll, "A Ctrl+A"},
    {Act::SelectNone, "Alt+A Ctrl+Shift+A"},
    {Act::InvertSelection, "Ctrl+I"},
    {Act::Delete, "X Del"},
    {Act::FlipHorizontally, "Ctrl+M"},
    {Act::FlipVertically, "Ctrl+Shift+Y"},
    {Act::DuplicateInPlace, "Shift+D"},
    {Act::RepeatLast, "Shift+R"},
    {Act::Reverse, "Alt+N"},
    {Act::JoinNodes, "Ctrl+J"},
    {Act::BreakNodes, "V"},
    {Act::JoinBySegment, "F"},
    {Act::Center, "Shift+C"},
    {Act::FitLevel, "Home"},
    {Act::ToFront, "Ctrl+Home"},
    {Act::ToBack, "Ctrl+End"},
    {Act::Play, "F5"},
    {Act::CommandPalette, "F3 Ctrl+Shift+P"},
};

/// The keys of the table, taken from who has them with us.
KeyBindings boundTo(std::span<const PresetKeys> table) {
    KeyBindings bindings;
    std::vector<std::pair<const KeyOwner*, QList<QKeySequence>>> wanted;
    for (const PresetKeys& row : table) {
        const KeyOwner* const owner = keyOwner(codeOf(*std::ranges::find(actionRows(), row.id, &ActionRow::id)));
        bindings.setKeys(*owner, {});
        wanted.emplace_back(owner, keysIn(row.keys));
    }
    for (const auto& [owner, keys] : wanted) {
        for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
            bindings.give(*owner, *key);
        }
    }
    return bindings;
}

constexpr KeyPreset presets[] = {
    {"SpaceTow Studio", [] { return KeyBindings(); }},
    {"Tiled", [] { return boundTo(tiledKeys); }},
    {"Inkscape", [] { return boundTo(inkscapeKeys); }},
    {"Blender", [] { return boundTo(blenderKeys); }},
};

} // namespace

std::span<const KeyPreset> keyPresets() {
    return presets;
}

} // namespace spacetow
