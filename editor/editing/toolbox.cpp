#include "editor/editing/toolbox.h"

#include "editor/editing/group_picking.h"
#include "editor/editing/guide_gestures.h"
#include "editor/editing/snap_point.h"
#include "editor/editing/toolbox_state.h"
#include "editor/editing/typing_hint.h"
#include "editor/editing/verbs.h"

#include <algorithm>
#include <random>
#include <utility>

namespace spacetow {

namespace {

std::uint64_t randomSeed() {
    std::random_device device;
    return std::uint64_t{device()} << 32 | device();
}

} // namespace

Toolbox::Toolbox(Document& document) : Toolbox(document, randomSeed()) {}

Toolbox::Toolbox(Document& document, std::uint64_t seed) : m_state(std::make_unique<State>(document, seed)) {
    m_state->connection = document.historyChanged.connect([this] {
        if (m_state->followHistory()) {
            changed.emit();
        }
    });
}

Toolbox::~Toolbox() {
    m_state->document.historyChanged.disconnect(m_state->connection);
}

void Toolbox::choose(ToolId tool) {
    State& state = *m_state;
    cancel();
    const Selection& selection = state.document.selection();
    if (state.current == ToolId::Nodes && tool != ToolId::Nodes && !selection.nodes().empty()) {
        state.document.select(selection.withNodes({})); // what other tools do is done to objects
    }
    std::erase(state.before, tool);
    state.before.push_back(tool);
    state.current = tool;
    changed.emit();
}

void Toolbox::choosePlaceTool() {
    const std::span<const ToolId> tools = placeTools;
    const std::vector<ToolId>& before = m_state->before;
    const auto current = std::ranges::find(tools, m_state->current);
    if (current != tools.end()) {
        choose(tools[static_cast<std::size_t>(current - tools.begin() + 1) % tools.size()]);
        return;
    }
    const Level& level = m_state->document.level();
    const auto lacking = std::ranges::find_if(tools, [&](ToolId tool) { return !hasPlaced(level, tool); });
    const auto last = std::find_first_of(before.rbegin(), before.rend(), tools.begin(), tools.end());
    choose(lacking != tools.end() ? *lacking : last != before.rend() ? *last : tools.front());
}

ToolId Toolbox::current() const {
    return m_state->current;
}

void Toolbox::press(const Pointer& pointer) {
    State& state = *m_state;
    state.abandon(); // a release that was never reported
    state.last = pointer;
    state.inside = true;
    state.gesture = state.tool().press(context(), pointer);
    state.pressed = pointer;
    changed.emit();
}

void Toolbox::begin(std::unique_ptr<Gesture> gesture, const Pointer& pointer) {
    State& state = *m_state;
    state.abandon();
    state.last = pointer;
    state.gesture = std::move(gesture);
    state.pressed = pointer;
    state.dragging = true; // a click is none of the tool's
    changed.emit();
}

void Toolbox::move(const Pointer& pointer) {
    State& state = *m_state;
    state.last = pointer;
    state.inside = true;
    state.noticeDrag(pointer);
    if (state.gestureShows()) {
        state.gesture->follow(pointer);
        state.document.preview(state.gesture->at(pointer));
    } else {
        state.tool().hover(state.context(snap, guidesVisible), pointer);
    }
    changed.emit();
}

void Toolbox::release(const Pointer& pointer) {
    State& state = *m_state;
    if (!state.pressed) {
        return;
    }
    state.last = pointer;
    state.noticeDrag(pointer); // it may have gone in one jump
    const bool dragged = state.dragging;
    ToolContext before = context();
    const std::unique_ptr<Gesture> gesture = std::move(state.gesture);
    if (state.typesNonsense()) {
        state.abandon();
        changed.emit();
        return;
    }
    state.letGo();
    state.typing.reset(); // it has gone into the context
    if (gesture && dragged) {
        state.conclude(*gesture, pointer);
        state.tool().dragEnded(context(), pointer);
    } else if (dragged) {
        finish(state.tool().drop(before, pointer));
    } else {
        before.pressed.reset();
        finish(state.tool().click(before, pointer));
    }
    changed.emit();
}

void Toolbox::doubleClick(const Pointer& pointer) {
    m_state->abandon();
    m_state->typing.reset();
    m_state->last = pointer;
    if (!finish(m_state->tool().doubleClick(context(), pointer))) {
        if (const std::optional<ToolId> next = m_state->tool().toolAfterDoubleClick(context(), pointer)) {
            choose(*next);
        }
    }
    changed.emit();
}

void Toolbox::loseMouse() {
    if (isDragging()) {
        m_state->abandon();
        changed.emit();
    }
}

void Toolbox::leave() {
    m_state->inside = false;
    changed.emit();
}

bool Toolbox::secondaryClick(const Pointer& pointer) {
    State& state = *m_state;
    if (state.pressed) {
        return true;
    }
    state.last = pointer;
    const bool busy = state.tool().isBusy();
    state.typing.reset();
    finish(state.tool().secondaryClick(context(), pointer));
    changed.emit();
    return busy;
}

void Toolbox::key(ToolKey key, const Pointer& pointer) {
    State& state = *m_state;
    state.last = pointer;
    const bool busy = state.tool().isBusy();
    if (state.typing && !state.pressed && key == ToolKey::Enter) {
        enterTyped();
        return;
    }
    if (std::exchange(state.typing, std::nullopt) && key == ToolKey::Escape) {
        changed.emit();
        return;
    }
    if (key == ToolKey::Escape) {
        if (state.pressed) {
            state.abandon();
        } else if (busy) {
            state.tool().cancel();
        } else if (!state.document.selection().nodes().empty()) {
            state.document.select(state.document.selection().withNodes({}));
        } else if (state.current == ToolId::Nodes) {
            choose(ToolId::Select);
        } else if (const std::optional<Selection> outside = leaving(state.document.current())) {
            state.document.select(*outside);
        } else if (!state.document.selection().empty()) {
            state.document.select({});
        } else {
            choose(ToolId::Select);
        }
    } else if (!state.pressed) {
        finish(state.tool().key(context(), key, pointer));
        if (!busy && (key == ToolKey::Delete || key == ToolKey::Backspace)) {
            finish(removeSelected(context()));
        }
    }
    changed.emit();
}

void Toolbox::cancel() {
    m_state->abandon();
    m_state->typing.reset();
    m_state->tool().cancel();
    changed.emit();
}

std::optional<TypedMeasures> Toolbox::measures() const {
    State& state = *m_state;
    return state.pressed ? std::nullopt : state.tool().measures(state.context(snap, guidesVisible), state.last);
}

const std::optional<TypedEntry>& Toolbox::typing() const {
    return m_state->typing;
}

void Toolbox::type(const std::array<std::string, 2>& texts) {
    State& state = *m_state;
    const std::optional<TypedMeasures> can = measures();
    state.typing = can ? std::optional(typedEntry(can->kind, texts)) : std::nullopt;
    state.tool().hover(state.context(snap, guidesVisible), state.last);
    changed.emit();
}

bool Toolbox::enterTyped() {
    State& state = *m_state;
    if (!state.typing || state.typesNonsense()) {
        changed.emit();
        return false;
    }
    const ToolContext typed = context();
    state.typing.reset();
    if (typed.typed.any()) {
        finish(state.tool().click(typed, state.last));
    }
    changed.emit();
    return true;
}

void Toolbox::stopTyping() {
    m_state->typing.reset();
    changed.emit();
}

ToolContext Toolbox::context() {
    constexpr std::uint64_t stride = 0x9e3779b97f4a7c15ull; // odd, so that no seed comes twice
    m_state->seed += stride;
    ToolContext context = m_state->context(snap, guidesVisible);
    context.solids = drawnSolids;
    return context;
}

bool Toolbox::finish(const std::optional<FinishedEdit>& finished) {
    if (!finished || isDragging()) {
        return false;
    }
    m_state->commit(*finished);
    return true;
}

bool Toolbox::isDragging() const {
    return m_state->pressed.has_value();
}

bool Toolbox::scrolls() const {
    return m_state->dragging && (!m_state->gesture || m_state->gesture->scrolls());
}

bool Toolbox::isBusy() const {
    return isDragging() || m_state->tool().isBusy();
}

std::optional<Edit> Toolbox::unfinished() const {
    return m_state->tool().unfinished(m_state->context(snap, guidesVisible));
}

Overlay Toolbox::overlay() const {
    State& state = *m_state;
    if (!state.gestureShows() && !state.inside && !state.tool().isBusy()) {
        return state.tool().standing(state.context(snap, guidesVisible), state.last.pixel);
    }
    Overlay overlay = state.gestureShows() ? state.gesture->overlay(state.last)
                                           : state.tool().overlay(state.context(snap, guidesVisible), state.last);
    if (state.typing) {
        overlay.texts.clear(); // the fields stand there and say the same
    }
    overlay.snap = snapAnswer();
    return overlay;
}

std::optional<SnapAnswer> Toolbox::snapAnswer() const {
    State& state = *m_state;
    if (state.typing || (!state.gestureShows() && !state.inside)) {
        return {}; // what is typed decides
    }
    const auto answer = state.gestureShows() ? state.gesture->snapAt(state.last)
                                             : state.tool().snapAt(state.context(snap, guidesVisible), state.last);
    return answer && answer->kind != SnapKind::None ? answer : std::nullopt;
}

std::string Toolbox::numbers() const {
    return m_state->tool().numbers();
}

Hint Toolbox::hint() const {
    State& state = *m_state;
    return state.gestureShows() ? state.gesture->hint(state.last)
           : state.typing       ? typingHint(*state.typing)
                                : state.tool().hint(state.context(snap, guidesVisible), state.last);
}

CursorShape Toolbox::cursor() const {
    return m_state->gestureShows() ? m_state->gesture->cursor(m_state->last)
                                   : m_state->tool().cursor(m_state->context(snap, guidesVisible), m_state->last);
}

std::optional<std::size_t> Toolbox::guideInReach() const {
    const bool takes = m_state->current == ToolId::Select && m_state->inside && !m_state->pressed;
    return takes ? spacetow::guideInReach(m_state->context(snap, guidesVisible), m_state->last) : std::nullopt;
}

} // namespace spacetow
