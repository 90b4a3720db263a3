#pragma once
// Tools turn pointer and keys into edits; they know no toolkit. A drag is a Gesture, a pure function of the pointer:
// preview, commit, cancel and undo are written once, in the toolbox.

#include "core/base/result.h"
#include "core/math/affine.h"
#include "editor/editing/document.h"
#include "editor/editing/input.h"
#include "editor/editing/overlay.h"
#include "editor/editing/snap.h"
#include "editor/editing/snap_answer.h"
#include "editor/editing/typed_entry.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spacetow {

/// What the status bar says: a code that editor/window/messages turns into a sentence, with its numbers.
struct Hint {
    std::string code; // e.g. "draw-edge.next", see codes.h
    std::vector<std::string> arguments;

    bool operator==(const Hint&) const = default;
};

enum class ToolId : std::uint8_t; // see tools.h
struct SnapMemo;                  // see snap_point.h
/// The last four are double arrows: to the right, upwards, and along the diagonals that rise and fall to the right.
enum class CursorShape : std::uint8_t {
    Arrow,
    Cross,
    Move,
    OpenHand,
    Pointing,
    Insert,
    SizeAcross,
    SizeUpright,
    SizeRising,
    SizeFalling,
};

/// What the selection last went through, so that it can go through it again.
struct Repeatable {
    Affine map;
    bool copies = false; // it happened to a copy
};

/// Lives as long as a drag; made from the edit it starts with.
class Gesture {
  public:
    virtual ~Gesture() = default;
    /// The edit that releasing at this pointer would make.
    virtual Edit at(const Pointer& pointer) const = 0;
    /// The pointer goes on; for drags that depend on the way, as a lasso does. Called before `at`.
    virtual void follow(const Pointer&) {}
    virtual Label label() const = 0;
    virtual Overlay overlay(const Pointer&) const { return {}; }
    virtual Hint hint(const Pointer& pointer) const = 0;
    virtual CursorShape cursor(const Pointer&) const { return CursorShape::Cross; }
    /// What releasing here would do to all that is selected, for those that can be repeated.
    virtual std::optional<Affine> map(const Pointer&) const { return {}; }
    /// False for gestures that end beyond the edges of the view, so that it stays.
    virtual bool scrolls() const { return true; }
    /// False for gestures that only select: they add no history entry.
    virtual bool edits() const { return true; }
    /// What releasing here would snap to, for those that snap. The toolbox shows it.
    virtual std::optional<SnapAnswer> snapAt(const Pointer&) const { return {}; }
};

/// An edit that is ready without a drag.
struct FinishedEdit {
    Label label;
    Edit edit;
    std::string mergeKey = {}; // see Document::commit
    std::optional<Repeatable> repeatable = {};
    std::vector<Error> notes = {}; // what the user should know beside
};

/// What a tool needs to know beside the pointer.
struct ToolContext {
    Edit edit; // current, without preview
    SnapSettings snap;
    std::uint64_t seed = 1;              // for fresh keys; another at every call
    std::optional<Pointer> pressed = {}; // where the button went down, while it is held without a gesture
    std::optional<Repeatable> last = {}; // what `repeated` would do once more
    bool guides = true;                  // are shown, so that they can be taken
    TypedValues typed = {};              // what has been typed and stands in place of what is pointed at
    std::shared_ptr<SnapMemo> memo = {}; // without it every question makes a search
    BodyKind solids = BodyKind::Static;  // what polygons, rectangles and circles become
};

class Tool {
  public:
    virtual ~Tool() = default;

    /// Stable code, e.g. "select", "edge", "line", "polygon", "circle", "ship".
    virtual std::string code() const = 0;
    /// A press may start a gesture…
    virtual std::unique_ptr<Gesture> press(const ToolContext& context, const Pointer& pointer) = 0;
    /// …or, for tools that work click by click, finish an edit at a click (press and release without a drag).
    virtual std::optional<FinishedEdit> click(const ToolContext&, const Pointer&) { return {}; }
    /// What the drag of a gesture made is in the document now.
    virtual void dragEnded(const ToolContext&, const Pointer&) {}
    /// A drag for which press() started no gesture ends here.
    virtual std::optional<FinishedEdit> drop(const ToolContext& context, const Pointer& pointer) {
        return click(context, pointer);
    }
    virtual std::optional<FinishedEdit> doubleClick(const ToolContext&, const Pointer&) { return {}; }
    /// The tool that goes on where a double click has finished nothing.
    virtual std::optional<ToolId> toolAfterDoubleClick(const ToolContext&, const Pointer&) const { return {}; }
    virtual std::optional<FinishedEdit> secondaryClick(const ToolContext&, const Pointer&) { return {}; }
    virtual std::optional<FinishedEdit> key(const ToolContext&, ToolKey, const Pointer&) { return {}; }
    /// The pointer moved without a gesture, whether the button is down or not.
    virtual void hover(const ToolContext&, const Pointer&) {}
    /// What can be typed now, in place of being pointed at, and what the pointer says of it.
    virtual std::optional<TypedMeasures> measures(const ToolContext&, const Pointer&) const { return {}; }
    /// Whether a shape is half drawn; Escape then cancels it before anything else.
    virtual bool isBusy() const { return false; }
    /// What is half drawn, as an edit that loses none of its points, for the journal; asked beside the work.
    virtual std::optional<Edit> unfinished(const ToolContext&) const { return {}; }
    /// Forgets what is half done.
    virtual void cancel() {}

    virtual Overlay overlay(const ToolContext& context, const Pointer& pointer) const = 0;
    /// What of it stays while the pointer is elsewhere. `pixel` is the size of one, m.
    virtual Overlay standing(const ToolContext&, double /*pixel*/) const { return {}; }
    virtual Hint hint(const ToolContext& context, const Pointer& pointer) const = 0;
    virtual CursorShape cursor(const ToolContext& context, const Pointer& pointer) const = 0;
    /// What a click here would snap to, for tools whose clicks do. The toolbox shows it.
    virtual std::optional<SnapAnswer> snapAt(const ToolContext&, const Pointer&) const { return {}; }
    /// What copying takes in place of the selection.
    virtual std::string numbers() const { return {}; }
};

} // namespace spacetow
