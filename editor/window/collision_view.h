#pragma once
// Shows on the canvas what the selection would collide with, for as long as it is switched on.

#include "editor/canvas/canvas.h"
#include "editor/editing/document.h"

#include <memory>

namespace spacetow {

class CollisionView {
  public:
    /// Document and canvas must outlive it.
    CollisionView(Document& document, Canvas& canvas);
    ~CollisionView();
    CollisionView(const CollisionView&) = delete;
    CollisionView& operator=(const CollisionView&) = delete;

    void setOn(bool on);
    bool isOn() const { return m_on; }

  private:
    void refresh();

    Document& m_document;
    Canvas& m_canvas;
    bool m_on = false;
    Edit m_shown; // for which the canvas was told
    int m_listener = 0;
};

} // namespace spacetow
