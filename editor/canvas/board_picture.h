#pragma once
// The picture of a level on the drawing board, in layers that change at different times: rock; the objects that stay
// where they are; those that a gesture moves; marks of what is selected or highlighted; debug overlays; a long
// outline that the pointer is over. Each is painted anew only where it must be, and what has merely moved is drawn
// elsewhere. A value: it may be brought up to date by any thread.

#include "core/physics/query/overlay_flags.h"
#include "editor/canvas/left_out_places.h"
#include "editor/canvas/overlay_palette.h"
#include "editor/canvas/overlay_worlds.h"
#include "editor/canvas/picture_layer.h"
#include "editor/editing/selection.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

/// What the drawing board is to show.
struct BoardRequest {
    Frame2D frame;
    const Theme* theme = nullptr;       // lives as long as the program
    std::shared_ptr<const Level> level; // shown
    std::shared_ptr<const Level> base;  // from which a gesture in progress started; else the same
    bool live = false;                  // a gesture is in progress
    Selection selection;
    Key hovered = 0; // what a click would select, where that takes time to paint; else 0
    Key pointed = 0; // what a click would select, where it is to be named; else 0
    std::shared_ptr<const std::vector<Key>> highlighted; // ascending; null for none
    OverlayFlags overlays;
    OverlayPalette palette; // of the overlays

    bool operator==(const BoardRequest&) const = default;
};

enum class BoardLayer : std::uint8_t { Rock, Objects, Moving, Overlays, Marks, Hover };

class BoardPicture {
  public:
    /// What has to be done to one of the layers.
    struct Step {
        Frame2D frame;
        QRegion region;                     // to paint, in the frame
        std::shared_ptr<const Level> level; // to paint it from
        Vec2 moved{0, 0};                   // by how much what is painted is to be drawn elsewhere, world
        bool blank = false;                 // there is nothing to see
        bool other = false;                 // than what is there, of which nothing stays
        int work = 0;                       // segments of outlines in the region, as often as they are painted
    };
    struct Plan {
        BoardRequest request;
        std::vector<int> moving;
        std::array<Step, 6> steps; // one a layer
        int work = 0;
    };

    /// How to come from what the picture shows to what is wanted. What is expensive to paint and has only moved is not
    /// painted, but drawn elsewhere.
    Plan planFor(const BoardRequest& request) const;
    void bring(const Plan& plan);
    /// Takes over by how much things have moved, without painting anything; whether what stands still has.
    bool follow(const Plan& plan);
    /// As it is, though the request may want another view or something else by now: what stands still, and what comes
    /// on top of it.
    void drawStill(QPainter& painter, const Frame2D& frame) const {
        draw(painter, frame, BoardLayer::Rock, BoardLayer::Objects);
    }
    void drawRest(QPainter& painter, const Frame2D& frame) const {
        draw(painter, frame, BoardLayer::Moving, BoardLayer::Hover);
    }
    /// Where in the frame the plan would change what stands still; nothing when it is everywhere.
    std::optional<QRegion> stillTouchedBy(const Plan& plan, const Frame2D& frame) const;

    /// Layers in one, to be drawn larger or smaller.
    PictureLayer flattened(const Theme& theme, BoardLayer first, BoardLayer last) const;
    /// Whether overlays have left out anything in the view.
    LeftOut leftOut(const Viewport& view) const { return m_leftOut.in(view); }
    /// Whether the view has come close to the border of what was painted ahead.
    bool isNearBorder(const Frame2D& frame) const;
    bool isOfScale(double scale) const { return part(BoardLayer::Objects).picture.frame().view.scale == scale; }
    /// Of what stands still.
    const Frame2D& frame() const { return part(BoardLayer::Objects).picture.frame(); }
    bool isEmpty() const { return !part(BoardLayer::Objects).picture.isValid(); }

  private:
    struct Part {
        PictureLayer picture;
        std::shared_ptr<const Level> level; // that was painted
        Vec2 moved{0, 0};
    };
    class Planner;
    /// Of the level that the overlays were painted from last.
    struct Worlds {
        std::shared_ptr<const Level> level;
        std::shared_ptr<const OverlayWorlds> worlds;
    };

    void makeWorlds(const Plan& plan);
    void draw(QPainter& painter, const Frame2D& frame, BoardLayer first, BoardLayer last) const;
    bool hasWorldsOf(const std::shared_ptr<const Level>& level, const OverlayFlags& overlays) const {
        return m_worlds && m_worlds->level == level && covers(m_worlds->worlds->made, overlays);
    }
    const Part& part(BoardLayer layer) const { return m_parts[static_cast<std::size_t>(layer)]; }

    std::array<Part, 6> m_parts;
    std::shared_ptr<const Worlds> m_worlds;
    LeftOutPlaces m_leftOut;
    BoardRequest m_shown;
    std::vector<int> m_moving; // places in the level, ascending
};

} // namespace spacetow
