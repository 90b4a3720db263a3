#pragma once
// The tools, which of them is in the hand, and the gesture in progress. The canvas feeds it; it feeds the document.

#include "editor/editing/tools.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace spacetow {

class Toolbox {
  public:
    /// The document must outlive the toolbox. The seed decides the keys of new objects; without it they are random.
    explicit Toolbox(Document& document);
    Toolbox(Document& document, std::uint64_t seed);
    ~Toolbox();

    /// Drops what is half done.
    void choose(ToolId tool);
    /// One key for all that a level has one of: first the tool for what it lacks or, where it has all, the one of them
    /// that was in the hand last; while one of them is in the hand, the next.
    void choosePlaceTool();
    ToolId current() const;
    SnapSettings snap;         // shared by all tools
    bool guidesVisible = true; // what is hidden is not taken by mistake
    /// What polygons, rectangles and circles that are drawn become: rock in a cave, a body in a sandbox.
    BodyKind drawnSolids = BodyKind::Static;

    /// Primary button. A drag starts once the pointer has moved by more than four pixels. A modifier that changes
    /// while the pointer rests is a move with the last position. A double click comes instead of the second press;
    /// the release after it does nothing.
    void press(const Pointer& pointer);
    /// A drag that begins outside the view, such as on a ruler, whatever tool is in the hand; a half-drawn shape stays.
    void begin(std::unique_ptr<Gesture> gesture, const Pointer& pointer);
    void move(const Pointer& pointer);
    void release(const Pointer& pointer);
    void doubleClick(const Pointer& pointer);
    /// The mouse is somebody else's before the button came up: the drag is cancelled, a half-drawn shape stays.
    void loseMouse();
    /// The pointer has left the view: marks that follow it disappear until it is back.
    void leave();
    /// Secondary button without a drag. False when the tool has no use for it, so that a menu may open.
    bool secondaryClick(const Pointer& pointer);
    /// Escape peels one layer a press: what is typed, gesture, half-drawn shape, nodes, node tool, group that was
    /// entered, selection, then the Select tool.
    void key(ToolKey key, const Pointer& pointer);
    /// Drops gesture and half-drawn shape.
    void cancel();

    /// For verbs that need no drag: `finish(removeSelected(context()))`. Each call gives other fresh keys.
    ToolContext context();
    /// Commits what a verb made; false when it made nothing, and during a drag, which nothing may cross.
    bool finish(const std::optional<FinishedEdit>& finished);

    /// The button is down: nothing but the pointer, its modifiers and Escape acts until the drag has ended.
    bool isDragging() const;
    /// What is dragged may be taken beyond the edges of the view, which then goes along.
    bool scrolls() const;
    bool isBusy() const; // drag or half-drawn shape
    /// The edit that what is half drawn would be, as far as it goes; nothing when nothing is.
    std::optional<Edit> unfinished() const;
    /// What can be typed now, in place of being pointed at, and what the pointer and the typing so far say of it.
    std::optional<TypedMeasures> measures() const;
    const std::optional<TypedEntry>& typing() const;
    /// What the fields hold now; opens the entry where something can be typed.
    void type(const std::array<std::string, 2>& texts);
    /// Places the point as typed, as a click does. False when a text will not do; the hint then says why.
    bool enterTyped();
    /// Back to the pointer alone.
    void stopTyping();

    Overlay overlay() const;
    Hint hint() const;
    CursorShape cursor() const;
    /// The guide that a press would take, by its index in the level.
    std::optional<std::size_t> guideInReach() const;
    /// What the tool has measured, for the clipboard; empty when it has nothing.
    std::string numbers() const;
    /// What a click or a release would snap to; nothing where nothing snaps.
    std::optional<SnapAnswer> snapAnswer() const;

    Signal<> changed; // overlay, hint, cursor or current tool may differ

  private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace spacetow
