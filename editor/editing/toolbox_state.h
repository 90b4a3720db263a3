#pragma once
// What a toolbox has in hand: the tools, the gesture in progress, what is being typed. For toolbox.cpp alone.

#include "editor/editing/toolbox.h"

#include <utility>
#include <vector>

namespace spacetow {

struct Toolbox::State {
    static constexpr double dragPixels = 4;

    State(Document& edited, std::uint64_t firstSeed)
        : document(edited), level(edited.current().level), seed(firstSeed) {
        for (const ToolRow& row : toolRows()) {
            tools.push_back(row.make());
        }
    }

    Document& document;
    std::shared_ptr<const Level> level; // that the document had last, without its preview
    std::uint64_t seed;
    std::vector<std::unique_ptr<Tool>> tools; // by ToolId
    ToolId current = ToolId::Select;
    std::vector<ToolId> before; // those that were in the hand, newest last, each once

    std::unique_ptr<Gesture> gesture; // from the press on; it shows and acts once `dragging`
    std::optional<Pointer> pressed;   // while the button is held
    bool dragging = false;            // the pointer has left the spot where the button went down
    Pointer last;
    bool inside = false;     // the pointer is in the view
    bool committing = false; // the history changes by our own doing
    int connection = 0;
    std::optional<Repeatable> repeatable; // what was last done to a selection
    std::vector<Key> copies;              // that came out of that
    std::optional<TypedEntry> typing;
    std::shared_ptr<SnapMemo> memo = makeSnapMemo();

    Tool& tool() { return *tools[static_cast<std::size_t>(current)]; }
    bool typesNonsense() const { return typing && typing->faulty >= 0; }
    bool gestureShows() const { return gesture && dragging; }
    void noticeDrag(const Pointer& pointer) {
        dragging = dragging || (pressed && (pointer.screen - pressed->screen).norm() > dragPixels);
    }
    void letGo() {
        gesture.reset();
        pressed.reset();
        dragging = false;
    }
    /// Leaves the level as it was before the button went down.
    void abandon() {
        if (gestureShows()) {
            document.dropPreview();
        }
        letGo();
    }
    /// A gesture starts from the level as it was: undo or another file in the middle of it leaves nothing to go on
    /// from. Saving changes nothing. Whether something was dropped.
    bool followHistory() {
        const bool isOther = std::exchange(level, document.current().level) != document.current().level;
        if (committing || !isOther || (!pressed && !typing)) {
            return false;
        }
        abandon();
        typing.reset();
        return true;
    }
    void commit(const FinishedEdit& finished) {
        noteRepeatable(finished);
        committing = true;
        document.commit(finished.label, finished.edit, finished.mergeKey);
        committing = false;
    }
    /// A copy that is then moved, turned or scaled is repeated as one step.
    void noteRepeatable(const FinishedEdit& finished) {
        if (!finished.repeatable || finished.edit.level == document.current().level) {
            return;
        }
        const std::vector<Key>& keys = finished.edit.selection.keys();
        if (repeatable && repeatable->copies && !finished.repeatable->copies && keys == copies) {
            repeatable->map = finished.repeatable->map * repeatable->map;
            return;
        }
        repeatable = finished.repeatable;
        copies = repeatable->copies ? keys : std::vector<Key>();
    }
    void conclude(const Gesture& ended, const Pointer& pointer) {
        const Edit edit = ended.at(pointer);
        if (ended.edits()) {
            const std::optional<Affine> map = ended.map(pointer);
            commit({ended.label(), edit, {}, map ? std::optional(Repeatable{*map}) : std::nullopt});
        } else {
            document.select(edit.selection);
        }
    }
    ToolContext context(const SnapSettings& settings, bool guides) const {
        const TypedValues typed = typing ? typing->values : TypedValues();
        return {document.current(), settings, seed, gesture ? std::nullopt : pressed, repeatable, guides, typed, memo};
    }
};

} // namespace spacetow
