#pragma once
// What stands still in a running game, kept as a picture: rock, walls, static bodies. It is painted some way beyond the
// view, so that most frames only shift it; where there is so much of it that the window would stand still meanwhile,
// beside the window.

#include "core/game/snapshot.h"
#include "editor/canvas/background_task.h"
#include "editor/canvas/picture_layer.h"
#include "editor/canvas/wall_painter.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace spacetow {

class GroundPicture {
  public:
    /// Walls and bodies that are painted within the frame that asks for them.
    static constexpr std::size_t few = 2000;

    /// The frame's view is aligned to pixels. Of what is being painted beside the window, the last picture is shown.
    void draw(QPainter& painter, const Frame2D& frame, const Snapshot& snapshot, const Theme& theme);
    /// Another level: until its picture is there, what is much is shown as in this one.
    void forget(const PictureLayer& meanwhile = {});
    /// Once what was painted beside the window is there.
    std::function<void()> painted;
    bool isPainting() const { return m_task.isRunning(); }
    /// Waits for what is being painted.
    void finish() { m_task.finish(); }

  private:
    /// What stands, and its walls once they are asked for, which is by one thread at a time.
    struct Standing {
        std::shared_ptr<const BodyPictures> bodies;
        std::unique_ptr<const Ground> ground;
        bool isMuch = false;
    };
    static std::shared_ptr<Standing> standing(const Snapshot& snapshot);
    static void paint(PictureLayer& layer, const Frame2D& frame, Standing& standing, const Theme& theme);
    bool shows(const Frame2D& frame) const;
    void paintBeside(const Frame2D& frame, const Theme& theme);

    std::shared_ptr<Standing> m_standing;
    std::shared_ptr<const BodyPictures> m_seen; // last
    const Theme* m_theme = nullptr;             // in whose colours it is
    PictureLayer m_layer;
    bool m_isOld = false;      // the layer shows what stood before
    std::uint64_t m_epoch = 0; // how often all was forgotten
    BackgroundTask m_task;
};

} // namespace spacetow
