#pragma once
// The tools, which of them is in the hand, and the gesture in progress. The canvas feeds it; it feeds the document.

#include "editor/editing/tool.h"

#include <array>
#include <memory>
#include <vector>

namespace spacetow {

enum class ToolId : std::uint8_t { Select, Edge, Line, Polygon, Circle, Place };
constexpr std::array allTools{ToolId::Select,  ToolId::Edge,   ToolId::Line,
                              ToolId::Polygon, ToolId::Circle, ToolId::Place};

/// What the place tool puts down.
enum class PlaceKind : std::uint8_t { Ship, Payload, Finish };

class Toolbox {
  public:
    /// The document must outlive the toolbox.
    explicit Toolbox(Document& document);
    ~Toolbox();

    void choose(ToolId tool);
    ToolId current() const;
    /// Choosing Place again goes on to the next kind.
    void setPlaceKind(PlaceKind kind);
    PlaceKind placeKind() const;
    SnapSettings snap; // shared by all tools

    /// Primary button. A drag starts once the pointer has moved by more than four pixels.
    void press(const Pointer& pointer);
    void move(const Pointer& pointer);
    void release(const Pointer& pointer);
    void doubleClick(const Pointer& pointer);
    /// Secondary button without a drag. False when the tool has no use for it, so that a menu may open.
    bool secondaryClick(const Pointer& pointer);
    /// Modifiers may change without the pointer moving: call with the last pointer and the new modifiers.
    /// Escape peels one layer a press: gesture, half-drawn shape, selection, then the Select tool.
    void key(ToolKey key, const Pointer& pointer);
    /// Drops gesture and half-drawn shape.
    void cancel();

    bool isBusy() const; // gesture or half-drawn shape
    Overlay overlay() const;
    Hint hint() const;
    CursorShape cursor() const;

    Signal<> changed; // overlay, hint, cursor or current tool may differ

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spacetow
