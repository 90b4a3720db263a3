#include "editor/editing/connector_tool.h"

#include "editor/editing/measure.h"

#include <utility>

namespace spacetow {

namespace {

constexpr double refusalPixels = 12; // the pointer moves so far until it is about something else

/// Why a connector from the first end cannot end here; empty when it can.
std::string refusalOf(const ToolContext& context, const ConnectorEnd& from, const Pointer& pointer) {
    const std::optional<ConnectorEnd> to = connectorEndAt(context, pointer);
    if (!to) {
        return isOnOtherThing(context, pointer) ? "connector.no-body" : "connector.nothing-here";
    }
    return to->body == from.body ? "connector.same-body" : "";
}

Edit connected(const ToolContext& context, const ConnectorEnd& from, const Pointer& pointer) {
    const std::optional<ConnectorEnd> to = connectorEndAt(context, pointer);
    return to && to->body != from.body ? withConnector(context, from, *to) : context.edit;
}

/// What a body is called where it has no name of its own: "named" ones get theirs as argument.
std::string kindCode(const Object& object) {
    if (!object.name.empty()) {
        return "named";
    }
    switch (std::get<BodyObject>(object.data).kind) {
    case BodyKind::Dynamic:
        return "dynamic";
    case BodyKind::Kinematic:
        return "kinematic";
    case BodyKind::Static:
        break;
    }
    return "static";
}

Hint toHint(const ToolContext& context, const ConnectorEnd& from, const Pointer& pointer) {
    if (const std::string refusal = refusalOf(context, from, pointer); !refusal.empty()) {
        return {refusal, {}};
    }
    const ConnectorEnd to = *connectorEndAt(context, pointer);
    const std::string length = lengthText((to.at - from.at).norm());
    if (faultBetween(*context.edit.level, from.body, to.body) == ConnectorFault::NothingMoves) {
        return {"connector.nothing-moves", {length}};
    }
    const Object& object = *context.edit.level->objects.find(to.body);
    const std::string code = kindCode(object);
    return code == "named" ? Hint{"connector.to-named", {length, object.name}} : Hint{"connector.to-" + code, {length}};
}

Hint fromHint(const ToolContext& context, const Pointer& pointer) {
    const std::optional<ConnectorEnd> end = connectorEndAt(context, pointer);
    if (!end) {
        return {isOnOtherThing(context, pointer) ? "connector.no-body" : "connector.start", {}};
    }
    const Object& object = *context.edit.level->objects.find(end->body);
    const std::string code = kindCode(object);
    return code == "named" ? Hint{"connector.from-named", {object.name}} : Hint{"connector.from-" + code, {}};
}

Overlay connectorDraft(const ToolContext& context, const ConnectorEnd& from, const Pointer& pointer) {
    const std::optional<ConnectorEnd> to = connectorEndAt(context, pointer);
    const bool joins = to && to->body != from.body;
    const Vec2 end = to ? to->at : pointer.world;
    Overlay overlay;
    overlay.lines.push_back({joins ? OverlayStyle::Draft : OverlayStyle::Measure, {from.at, end}});
    overlay.points.push_back({OverlayStyle::Handle, from.at});
    if (joins) {
        overlay.hovered = to->body;
    }
    if (to) {
        overlay.points.push_back({joins ? OverlayStyle::HotHandle : OverlayStyle::Snap, end});
    }
    overlay.texts.push_back({end, lengthText((end - from.at).norm()) + " m"});
    return overlay;
}

class ConnectorGesture : public Gesture {
  public:
    ConnectorGesture(const ToolContext& context, const ConnectorEnd& from) : m_context(context), m_from(from) {}

    Edit at(const Pointer& pointer) const override { return connected(m_context, m_from, pointer); }
    Label label() const override { return {"draw-connector", 1}; }
    Overlay overlay(const Pointer& pointer) const override { return connectorDraft(m_context, m_from, pointer); }
    Hint hint(const Pointer& pointer) const override { return toHint(m_context, m_from, pointer); }
    std::optional<SnapAnswer> snapAt(const Pointer& pointer) const override {
        return snapAnswerOf(connectorEndAt(m_context, pointer));
    }

  private:
    ToolContext m_context;
    ConnectorEnd m_from;
};

} // namespace

std::optional<ConnectorEnd> ConnectorTool::from(const ToolContext& context) const {
    return m_from && context.edit.level->objects.find(m_from->body) != nullptr ? m_from : std::nullopt;
}

std::unique_ptr<Gesture> ConnectorTool::press(const ToolContext& context, const Pointer& pointer) {
    m_pressedOn = context.edit.level;
    m_refusal.clear();
    const std::optional<ConnectorEnd> end = from(context) ? from(context) : connectorEndAt(context, pointer);
    return end ? std::make_unique<ConnectorGesture>(context, *end) : nullptr;
}

void ConnectorTool::dragEnded(const ToolContext& context, const Pointer& pointer) {
    const std::shared_ptr<const Level> before = std::exchange(m_pressedOn, nullptr);
    m_from.reset();
    m_refusedAt = pointer.screen;
    m_refusal = before == context.edit.level ? "connector.ended-nowhere" : "";
}

std::optional<FinishedEdit> ConnectorTool::click(const ToolContext& context, const Pointer& pointer) {
    m_refusedAt = pointer.screen;
    const std::optional<ConnectorEnd> first = from(context);
    if (!first) {
        m_from = connectorEndAt(context, pointer);
        m_refusal = m_from ? "" : isOnOtherThing(context, pointer) ? "connector.no-body" : "connector.nothing-here";
        return {};
    }
    m_refusal = refusalOf(context, *first, pointer);
    if (!m_refusal.empty()) {
        return {};
    }
    m_from.reset();
    return FinishedEdit{{"draw-connector", 1}, connected(context, *first, pointer)};
}

/// A drag that began where no body is.
std::optional<FinishedEdit> ConnectorTool::drop(const ToolContext&, const Pointer& pointer) {
    m_refusedAt = pointer.screen;
    m_refusal = "connector.began-nowhere";
    return {};
}

std::optional<FinishedEdit> ConnectorTool::secondaryClick(const ToolContext&, const Pointer&) {
    cancel();
    return {};
}

std::optional<FinishedEdit> ConnectorTool::key(const ToolContext&, ToolKey key, const Pointer&) {
    if (key == ToolKey::Backspace || key == ToolKey::Delete) {
        cancel();
    }
    return {};
}

void ConnectorTool::hover(const ToolContext& context, const Pointer& pointer) {
    if (!from(context)) {
        m_from.reset();
    }
    if ((pointer.screen - m_refusedAt).norm() > refusalPixels) {
        m_refusal.clear();
    }
}

void ConnectorTool::cancel() {
    m_from.reset();
    m_refusal.clear();
}

Overlay ConnectorTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    if (const std::optional<ConnectorEnd> first = from(context)) {
        return connectorDraft(context, *first, pointer);
    }
    Overlay overlay;
    if (const std::optional<ConnectorEnd> end = connectorEndAt(context, pointer)) {
        overlay.hovered = end->body;
        overlay.points.push_back({OverlayStyle::HotHandle, end->at});
    }
    return overlay;
}

Hint ConnectorTool::hint(const ToolContext& context, const Pointer& pointer) const {
    if (!m_refusal.empty()) {
        return {m_refusal, {}};
    }
    const std::optional<ConnectorEnd> first = from(context);
    return first ? toHint(context, *first, pointer) : fromHint(context, pointer);
}

CursorShape ConnectorTool::cursor(const ToolContext& context, const Pointer& pointer) const {
    return connectorEndAt(context, pointer) ? CursorShape::Pointing : CursorShape::Cross;
}

std::optional<SnapAnswer> ConnectorTool::snapAt(const ToolContext& context, const Pointer& pointer) const {
    return snapAnswerOf(connectorEndAt(context, pointer));
}

} // namespace spacetow
