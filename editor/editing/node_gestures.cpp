#include "editor/editing/node_gestures.h"

#include "core/geometry/polygon.h"
#include "core/level/node_edits.h"
#include "editor/editing/measure.h"
#include "editor/editing/node_pick.h"

#include <algorithm>

namespace spacetow {

MoveNodesGesture::MoveNodesGesture(const ToolContext& context, NodeDrag drag)
    : m_edit(context.edit), m_drag(std::move(drag)), m_together(withCompany(*m_edit.level, m_drag.nodes)),
      m_snap(context, {.nodes = m_together}, m_drag.reference) {}

std::optional<SnapAnswer> MoveNodesGesture::snapAt(const Pointer& pointer) const {
    return m_snap.moved(pointer.world - m_drag.start, pointer);
}

Edit MoveNodesGesture::at(const Pointer& pointer) const {
    const Vec2 delta = deltaAt(pointer);
    if (delta == Vec2(0, 0)) {
        return m_edit;
    }
    const std::vector<NodeRef>& nodes = pointer.modifiers.alt ? m_drag.nodes : m_together;
    Level level = withMappedNodes(*m_edit.level, nodes, Affine::translation(delta));
    return {std::make_shared<const Level>(std::move(level)), m_edit.selection};
}

Label MoveNodesGesture::label() const {
    return {"move-nodes", static_cast<int>(m_drag.nodes.size())};
}

Overlay MoveNodesGesture::overlay(const Pointer& pointer) const {
    const Vec2 target = m_drag.reference + deltaAt(pointer);
    Overlay overlay;
    overlay.nodes = OverlayNodes{keysInEdit(m_edit), {}, {}};
    overlay.lines.push_back({OverlayStyle::Measure, {m_drag.reference, target}});
    overlay.points.push_back({OverlayStyle::Snap, target});
    overlay.texts.push_back({pointer.world, wayText(target - m_drag.reference)});
    return overlay;
}

Hint MoveNodesGesture::hint(const Pointer& pointer) const {
    const Edit moved = at(pointer);
    const std::vector<NodeRef>& nodes = pointer.modifiers.alt ? m_drag.nodes : m_together;
    switch (faultAt(*moved.level, nodes)) {
    case NodeFault::Crosses:
        return {"nodes.crosses", {}};
    case NodeFault::Together:
        return {"nodes.together", {}};
    case NodeFault::None:
        break;
    }
    const Vec2 delta = deltaAt(pointer);
    const bool company = m_together.size() > m_drag.nodes.size();
    return {company ? "nodes.moving-together" : "nodes.moving", {lengthText(delta.x()), lengthText(delta.y())}};
}

NodeBandGesture::NodeBandGesture(const Edit& edit, const Vec2& start, MarqueeShape shape, bool extends)
    : MarqueeGesture(edit, start, shape), m_keys(keysInEdit(edit)), m_extends(extends) {}

Edit NodeBandGesture::at(const Pointer& pointer) const {
    const std::vector<Vec2> line = lineAt(pointer);
    const Selection& before = edit().selection;
    std::vector<NodeRef> nodes = nodesIn(*edit().level, m_keys, boxAt(pointer));
    if (isLasso()) {
        std::erase_if(nodes, [&](const NodeRef& node) {
            return !contains(line, nodePosition(*edit().level, node).value_or(line.front()));
        });
    }
    if (m_extends) {
        nodes.insert(nodes.end(), before.nodes().begin(), before.nodes().end());
    }
    return {edit().level, Selection(before.keys(), std::move(nodes)).entering(before.entered())};
}

Overlay NodeBandGesture::overlay(const Pointer& pointer) const {
    Overlay overlay = MarqueeGesture::overlay(pointer);
    overlay.nodes = OverlayNodes{m_keys, {}, {}};
    return overlay;
}

Hint NodeBandGesture::hint(const Pointer& pointer) const {
    return {isLasso() ? "nodes.lasso" : "nodes.band", {std::to_string(at(pointer).selection.nodes().size())}};
}

} // namespace spacetow
