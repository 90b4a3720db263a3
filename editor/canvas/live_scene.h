#pragma once
// What a canvas shows in place of its board while something runs. The view, the selection and the tools stay the
// canvas's own; the scene says what is where now, and takes those events that are the run's.

#include "editor/canvas/left_out.h"
#include "editor/canvas/picture_layer.h"
#include "editor/editing/tool.h"

class QEvent;
class QPainter;

namespace spacetow {

class LiveScene {
  public:
    virtual ~LiveScene() = default;

    /// Fills the whole view with what runs. The view of the frame is aligned to pixels.
    virtual void paint(QPainter& painter, const Frame2D& frame) = 0;
    /// What comes above the marks of the tools: selection, readings.
    virtual void paintOver(QPainter& painter, const Frame2D& frame) = 0;
    /// Whether overlays have left out anything.
    virtual LeftOut leftOut() const = 0;
    /// Whether marks of the tool in the hand mean something in this scene.
    virtual bool showsTool() const = 0;
    /// Whether plain keys and the secondary button are the run's, as those of a game are.
    virtual bool isGame() const = 0;
    virtual CursorShape cursor() const = 0;
    /// Every event of the canvas comes here first. True when it is the run's, and nobody else's.
    virtual bool take(QEvent& event) = 0;
};

} // namespace spacetow
