#pragma once
// What the mouse does to a run with the Select tool: a click selects what is under the pointer now, a drag of a body
// that moves pulls it by a spring, of one that stands still, or while the run is held, edits the level, and from empty
// ground draws a band.

#include "editor/editing/document.h"
#include "editor/editing/group_picking.h"
#include "editor/editing/toolbox.h"
#include "editor/play/live_run.h"

#include <QElapsedTimer>

#include <memory>
#include <optional>

namespace spacetow {

class LiveHand {
  public:
    /// All of them must outlive the hand.
    LiveHand(Document& document, Toolbox& toolbox, LiveRun& run);
    ~LiveHand();

    /// What there is to be seen; copied, as all that follows goes by it.
    void see(const Snapshot& picture);

    void press(const Pointer& pointer);
    void move(const Pointer& pointer);
    void release(const Pointer& pointer);
    /// The mouse is somebody else's before the button came up: what was dragged is back where it was.
    void loseMouse();
    /// The pointer is elsewhere.
    void leave() { m_hovered = 0; }
    bool isPressed() const { return m_pressed.has_value(); }

    /// The object or group that a click would select; 0 for none.
    Key hovered() const { return m_hovered; }
    /// What lies under the pointer now, the best pick first.
    std::vector<GroupPick> under(const Pointer& pointer) const;
    /// The body that is held by a spring.
    const std::optional<Grab>& grab() const { return m_grab; }
    /// A band that is being drawn.
    Overlay overlay() const;
    CursorShape cursor() const;

  private:
    const Edit& edit() const;
    Selection clicked(const Pointer& pointer) const;
    void beginDrag(const Pointer& pointer);
    std::optional<Grab> grabAt(const Pointer& pointer) const;
    void takeHold();
    void letGo();

    Document& m_document;
    Toolbox& m_toolbox;
    LiveRun& m_run;
    std::shared_ptr<const Snapshot> m_picture;
    mutable std::optional<Edit> m_edit; // the level as it stands in the run
    mutable std::shared_ptr<const Level> m_editOf;
    mutable std::optional<Level> m_standing; // what of it does not move
    mutable std::shared_ptr<const Level> m_standingOf;
    std::optional<Pointer> m_pressed;
    Pointer m_pointer;
    std::unique_ptr<Gesture> m_band;
    bool m_dragging = false; // by a gesture of the toolbox
    std::optional<Grab> m_grab;
    std::vector<GroupPick> m_pile; // under the press
    std::optional<Grab> m_inReach;
    QElapsedTimer m_held; // since the button went down
    Key m_hovered = 0;
};

} // namespace spacetow
