#include "editor/canvas/overlay_table.h"

#include <QtGlobal>

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

constexpr std::array inks{
    OverlayInk{"box", &DebugColors::box, QT_TRANSLATE_NOOP("Legend", "Bounding box")},
    OverlayInk{"fat-box", &DebugColors::fatBox,
               QT_TRANSLATE_NOOP("Legend", "Box of the broad phase, with room to move")},
    OverlayInk{"incircle", &DebugColors::incircle, QT_TRANSLATE_NOOP("Legend", "Largest circle about the centroid")},
    OverlayInk{"velocity", &DebugColors::velocity, QT_TRANSLATE_NOOP("Legend", "Way of the next second")},
    OverlayInk{"orientation", &DebugColors::orientation, QT_TRANSLATE_NOOP("Legend", "Up, 1 m")},
    OverlayInk{"normal", &DebugColors::normal, QT_TRANSLATE_NOOP("Legend", "Free side, 1 m")},
    OverlayInk{"depth", &DebugColors::depth, QT_TRANSLATE_NOOP("Legend", "Solid band behind the wall")},
    OverlayInk{"static-cell", &DebugColors::staticCell, QT_TRANSLATE_NOOP("Legend", "Cell of what stands still")},
    OverlayInk{"moving-cell", &DebugColors::movingCell, QT_TRANSLATE_NOOP("Legend", "Cell of what moves")},
    OverlayInk{"touch-point", &DebugColors::touchPoint, QT_TRANSLATE_NOOP("Legend", "Point of contact")},
    OverlayInk{"near-point", &DebugColors::nearPoint, QT_TRANSLATE_NOOP("Legend", "Near, not touching yet")},
    OverlayInk{"contact-normal", &DebugColors::contactNormal, QT_TRANSLATE_NOOP("Legend", "Normal")},
    OverlayInk{"impulse", &DebugColors::impulse,
               QT_TRANSLATE_NOOP("Legend", "Force; 1 m is the weight of the lighter one, 2 m ten times as much")},
    OverlayInk{"pressed", &DebugColors::pressed, QT_TRANSLATE_NOOP("Legend", "Pressed to half its length")},
    OverlayInk{"natural", &DebugColors::natural, QT_TRANSLATE_NOOP("Legend", "At its natural length")},
    OverlayInk{"pulled", &DebugColors::pulled, QT_TRANSLATE_NOOP("Legend", "Stretched by half its length")},
    OverlayInk{"trail", &DebugColors::trail, QT_TRANSLATE_NOOP("Legend", "Way, older ones fainter")},
    OverlayInk{"way", &DebugColors::way, QT_TRANSLATE_NOOP("Legend", "Way in the time that is kept")},
    OverlayInk{"lost-way", &DebugColors::lostWay, QT_TRANSLATE_NOOP("Legend", "Way in a future given up, dashed")},
    OverlayInk{"mass-center", &DebugColors::massCenter, QT_TRANSLATE_NOOP("Legend", "Center of mass and axes")},
    OverlayInk{"name", &DebugColors::name, QT_TRANSLATE_NOOP("Legend", "Name of the object")},
    OverlayInk{"asleep", &DebugColors::asleep, QT_TRANSLATE_NOOP("Legend", "Asleep")},
    OverlayInk{"safe", &DebugColors::safe, QT_TRANSLATE_NOOP("Legend", "Deep enough for what comes")},
    OverlayInk{"risky", &DebugColors::risky, QT_TRANSLATE_NOOP("Legend", "Passed through in one iteration")},
    OverlayInk{"meets", &DebugColors::meets, QT_TRANSLATE_NOOP("Legend", "The selection collides with it")},
    OverlayInk{"passes", &DebugColors::passes, QT_TRANSLATE_NOOP("Legend", "The selection passes through")},
};

constexpr std::span<const OverlayInk> some(std::size_t first, std::size_t count) {
    return std::span<const OverlayInk>(inks).subspan(first, count);
}

constexpr std::array rows{
    OverlayRow{"aabb", &OverlayFlags::aabb, QT_TRANSLATE_NOOP("Actions", "&Bounding Boxes"), "overlay-aabb", "Alt+1",
               QT_TRANSLATE_NOOP("Actions", "Show the bounding box of every body, and that of the broad phase"),
               some(0, 2), "", true},
    OverlayRow{"incircle", &OverlayFlags::incircle, QT_TRANSLATE_NOOP("Actions", "&Incircles"), "overlay-incircle",
               "Alt+2", QT_TRANSLATE_NOOP("Actions", "Show the incircle of every polygon"), some(2, 1), "", true},
    OverlayRow{"velocity", &OverlayFlags::velocity, QT_TRANSLATE_NOOP("Actions", "&Velocities"), "overlay-velocity",
               "Alt+3", QT_TRANSLATE_NOOP("Actions", "Show where every body would be in a second"), some(3, 1), "",
               true},
    OverlayRow{"orientation", &OverlayFlags::orientation, QT_TRANSLATE_NOOP("Actions", "&Orientations"),
               "overlay-orientation", "Alt+4", QT_TRANSLATE_NOOP("Actions", "Show which way up every body is"),
               some(4, 1), "", true},
    OverlayRow{"normals", &OverlayFlags::normals, QT_TRANSLATE_NOOP("Actions", "&Normals"), "overlay-normals", "Alt+5",
               QT_TRANSLATE_NOOP("Actions", "Show the free side of every wall, and the solid band behind it"),
               some(5, 2), "", true},
    OverlayRow{"quadtree", &OverlayFlags::quadtree, QT_TRANSLATE_NOOP("Actions", "&Quadtrees"), "overlay-quadtree",
               "Alt+6",
               QT_TRANSLATE_NOOP("Actions", "Show the cells in which collisions are looked for, and what they hold"),
               some(7, 2), "", true},
    OverlayRow{"contacts", &OverlayFlags::contacts, QT_TRANSLATE_NOOP("Actions", "&Contacts"), "overlay-contacts",
               "Alt+7", QT_TRANSLATE_NOOP("Actions", "Show where bodies touch, and the forces between them"),
               some(9, 4)},
    OverlayRow{"tension", &OverlayFlags::tension, QT_TRANSLATE_NOOP("Actions", "T&ension"), "overlay-tension", "Alt+8",
               QT_TRANSLATE_NOOP("Actions", "Show how much every rope and connector pulls"), some(13, 3)},
    OverlayRow{"trails", &OverlayFlags::trails, QT_TRANSLATE_NOOP("Actions", "T&rails"), "overlay-trails", "Alt+9",
               QT_TRANSLATE_NOOP("Actions", "Show the way that every body has gone, or will go at first"), some(16, 1)},
    OverlayRow{"ways", &OverlayFlags::ways, QT_TRANSLATE_NOOP("Actions", "Wa&ys of a Run"), "overlay-ways",
               "Alt+Shift+F",
               QT_TRANSLATE_NOOP("Actions",
                                 "Show the ways of the last minute where a run is held, and those of futures given up"),
               some(17, 2), "", false, true},
    OverlayRow{"masses", &OverlayFlags::masses, QT_TRANSLATE_NOOP("Actions", "Centers of &Mass"), "overlay-masses",
               "Ctrl+Alt+H", QT_TRANSLATE_NOOP("Actions", "Show the center of mass of every body"), some(19, 1)},
    OverlayRow{"names", &OverlayFlags::names, QT_TRANSLATE_NOOP("Actions", "Names"), "overlay-names", "Alt+Shift+V",
               QT_TRANSLATE_NOOP("Actions", "Show the name of every object that has one"), some(20, 1)},
    OverlayRow{"islands", &OverlayFlags::islands, QT_TRANSLATE_NOOP("Actions", "I&slands and Sleep"), "overlay-islands",
               "Alt+Shift+Z",
               QT_TRANSLATE_NOOP("Actions", "Show which bodies may push each other, and which ones sleep"), some(21, 1),
               QT_TRANSLATE_NOOP("Legend", "One color an island")},
    OverlayRow{"tags",
               &OverlayFlags::tags,
               QT_TRANSLATE_NOOP("Actions", "&Tags"),
               "tag",
               "Alt+Shift+O",
               QT_TRANSLATE_NOOP("Actions", "Show names and colors of the tags of every object"),
               {},
               QT_TRANSLATE_NOOP("Legend", "The color of the first tag; a dot for each further one")},
    OverlayRow{
        "risk", &OverlayFlags::risk, QT_TRANSLATE_NOOP("Actions", "Ris&k of Passing Through"), "overlay-risk",
        "Alt+Shift+P",
        QT_TRANSLATE_NOOP("Actions", "Show how far through each wall one iteration may carry what approaches it"),
        some(22, 2)},
    OverlayRow{"collides", &OverlayFlags::collides, QT_TRANSLATE_NOOP("Actions", "Sho&w What Collides"), "collides",
               "Shift+T",
               QT_TRANSLATE_NOOP("Actions", "Mark everything that the selection would collide with, by its tags"),
               some(24, 2)},
};

} // namespace

std::span<const OverlayRow> overlayRows() {
    return rows;
}

std::span<const OverlayInk> overlayInks() {
    return inks;
}

std::optional<OverlayFlags> withOverlay(OverlayFlags flags, std::string_view name) {
    const auto row = std::ranges::find_if(rows, [&](const OverlayRow& one) { return name == one.name && !one.ofRuns; });
    if (row == rows.end()) {
        return {};
    }
    flags.*row->flag = true;
    return flags;
}

} // namespace spacetow
