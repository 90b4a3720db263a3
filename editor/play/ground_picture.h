#pragma once
// What stands still in a running game, kept as a picture: rock, walls, static bodies. It is painted some way beyond the
// view, so that most frames only shift it.

#include "core/game/snapshot.h"
#include "editor/canvas/picture_layer.h"
#include "editor/canvas/wall_painter.h"

#include <vector>

namespace spacetow {

class GroundPicture {
  public:
    /// The frame's view is aligned to pixels.
    void draw(QPainter& painter, const Frame2D& frame, const Snapshot& snapshot, const Theme& theme);
    void forget() { *this = {}; }

  private:
    struct Standing {
        std::shared_ptr<const BodyLook> look;
        Vec2 position;
        Rot rotation;

        bool operator==(const Standing&) const = default;
    };
    bool stillStands(const Snapshot& snapshot) const;
    void take(const Snapshot& snapshot);

    std::vector<Standing> m_standing;
    Ground m_ground; // their walls
    PictureLayer m_layer;
};

} // namespace spacetow
