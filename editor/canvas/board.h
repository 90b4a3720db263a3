#pragma once
// What the canvas paints of the level. What takes no time is painted at once; the rest by a thread beside, while the
// picture there is goes on being shown, shifted and scaled as the view wants it.

#include "editor/canvas/background_task.h"
#include "editor/canvas/board_picture.h"

#include <functional>
#include <optional>
#include <utility>

namespace spacetow {

class Board {
  public:
    /// `refined` is called when there is more to see than was painted last.
    explicit Board(std::function<void()> refined);

    /// Brings the picture up to date as far as there is time. The frame of the request is to be aligned to pixels.
    void prepare(const BoardRequest& request);
    /// What stands still, without background and grid; and what comes on top of it.
    void drawStill(QPainter& painter);
    void drawRest(QPainter& painter) const;
    /// Another number whenever what stands still has changed, other than by being shown in another frame.
    int stillRevision() const { return m_stillRevision; }
    /// Where it has changed since this was asked last, in device pixels of the frame of the request, as long as that is
    /// the same; nothing when it is everywhere.
    std::optional<QRegion> takeStillChanges() { return std::exchange(m_stillChanges, QRegion()); }

    /// Walls and bodies that stand still, as they were shown last, on the rock or without it, with holes where anything
    /// else was; nothing when there is much of that.
    PictureLayer groundPicture(bool onRock) const;
    /// Whether overlays have left out anything in the view.
    LeftOut leftOut() const { return m_picture.leftOut(m_wanted.frame.view); }

    /// Forgets what was painted, so that the next picture shows nothing of it: another level has been opened.
    void forget();
    /// Waits until all is painted that was asked for last.
    void finish();

  private:
    void bring(const BoardPicture::Plan& plan);
    void changeStill(const std::optional<QRegion>& where);
    void paintBeside(const BoardRequest& request);
    bool isScaled() const { return !m_picture.isOfScale(m_wanted.frame.view.scale); }

    std::function<void()> m_refined;
    BoardPicture m_picture;
    PictureLayer m_flat; // of the picture, when it is shown at another scale than its own
    BoardRequest m_wanted;
    bool m_complete = false; // the picture is what is wanted
    int m_stillRevision = 0;
    std::optional<QRegion> m_stillChanges;
    int m_generation = 0;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
