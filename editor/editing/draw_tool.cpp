#include "editor/editing/draw_tool.h"

#include "core/geometry/polygon.h"
#include "core/math/affine.h"
#include "editor/editing/chain_pick.h"
#include "editor/editing/draw_overlay.h"
#include "editor/editing/drawn_body.h"
#include "editor/editing/measure.h"
#include "editor/editing/outline_faults.h"
#include "editor/editing/snap_point.h"
#include "editor/editing/typed_point.h"

#include <utility>

namespace spacetow {

namespace {

constexpr double closePixels = 10;      // how near the first point closes the shape
constexpr std::size_t leastToClose = 3; // two walls there and back enclose nothing

std::vector<Vec2> relativeTo(const Vec2& origin, std::vector<Vec2> points) {
    for (Vec2& point : points) {
        point = tidied(Vec2(point - origin));
    }
    return points;
}

/// Near enough for the hand. What is typed is exact.
bool isNear(const ToolContext& context, const Pointer& pointer, const Vec2& end) {
    return !context.typed.any() && (pointer.world - end).norm() <= closePixels * pointer.pixel;
}

LabelCode drawingLabel(DrawKind kind) {
    switch (kind) {
    case DrawKind::Edge:
        return "draw-edge";
    case DrawKind::Line:
        return "draw-line";
    case DrawKind::Kinematic:
        return "draw-kinematic";
    case DrawKind::Polygon:
        break;
    }
    return "draw-polygon";
}

} // namespace

std::string DrawTool::code() const {
    switch (m_kind) {
    case DrawKind::Edge:
        return "edge";
    case DrawKind::Line:
        return "line";
    case DrawKind::Kinematic:
        return "kinematic";
    case DrawKind::Polygon:
        break;
    }
    return "polygon";
}

/// What moves is drawn as polygons are, and only said to be something else at the start.
std::string DrawTool::hintCode(const std::string& state) const {
    const bool own = m_kind != DrawKind::Kinematic || state == "start";
    return "draw-" + (own ? code() : std::string("polygon")) + "." + state;
}

DrawTool::Start DrawTool::startAt(const ToolContext& context, const Pointer& pointer) const {
    const Vec2 landed = snapped(context, pointer);
    if (isPolygon() || pointer.modifiers.alt) {
        return {landed, {}};
    }
    const ChainKind kind = m_kind == DrawKind::Edge ? ChainKind::Edges : ChainKind::Lines;
    std::optional<ChainEnd> end = chainEndAt(context.edit, pointer, kind);
    if (!end) {
        constexpr double exactly = 1e-10; // m
        end = chainEndAt(context.edit, {landed, pointer.screen, pointer.modifiers, exactly}, kind);
    }
    return end ? Start{openChain(*context.edit.level, *end)->at, end} : Start{landed, {}};
}

std::optional<DrawTool::Start> DrawTool::start(const ToolContext& context) const {
    if (!m_points.empty()) {
        return Start{m_points.front(), m_chain};
    }
    return context.pressed ? std::optional(startAt(context, *context.pressed)) : std::nullopt;
}

/// The points placed so far, and the one that a first drag is about to place.
std::vector<Vec2> DrawTool::pointsWith(const ToolContext& context) const {
    const std::optional<Start> first = start(context);
    return m_points.empty() && first ? std::vector{first->at} : m_points;
}

Vec2 DrawTool::nextPoint(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<Vec2> points = pointsWith(context);
    return points.empty() ? startAt(context, pointer).at : pointFrom(context, points.back(), pointer);
}

bool DrawTool::closesAt(const ToolContext& context, const Pointer& pointer) const {
    return !m_chain && m_points.size() >= leastToClose &&
           (isNear(context, pointer, m_points.front()) || nextPoint(context, pointer) == m_points.front());
}

std::optional<Vec2> DrawTool::ringAt(const ToolContext& context, const Pointer& pointer) const {
    const std::optional<Start> first = start(context);
    const auto chain = first && first->chain ? openChain(*context.edit.level, *first->chain) : std::nullopt;
    const std::size_t drawn = pointsWith(context).size();
    if (!chain || static_cast<std::size_t>(chain->vertices) + drawn - 1 < leastToClose) {
        return {};
    }
    const bool near = isNear(context, pointer, chain->other) || nextPoint(context, pointer) == chain->other;
    return near ? std::optional(chain->other) : std::nullopt;
}

std::optional<TypedMeasures> DrawTool::measures(const ToolContext& context, const Pointer& pointer) const {
    if (m_points.empty()) {
        return {};
    }
    return polarMeasures(TypedKind::LengthAngle, nextPoint(context, pointer) - m_points.back());
}

/// Why a point was not placed is of no interest any more once the pointer has moved on; why a shape was not finished
/// is.
void DrawTool::hover(const ToolContext& context, const Pointer& pointer) {
    if (m_refusal == hintCode("same-point") && nextPoint(context, pointer) != m_points.back()) {
        m_refusal.clear();
    }
}

void DrawTool::cancel() {
    m_points.clear();
    m_chain.reset();
    m_crossed.reset();
    m_refusal.clear();
}

void DrawTool::begin(const Start& start) {
    cancel();
    m_points.push_back(start.at);
    m_chain = start.chain;
}

std::optional<FinishedEdit> DrawTool::refuse(const std::string& state) {
    m_refusal = hintCode(state);
    return {};
}

std::optional<FinishedEdit> DrawTool::click(const ToolContext& context, const Pointer& pointer) {
    if (m_points.empty()) {
        begin(startAt(context, pointer));
        return {};
    }
    if (closesAt(context, pointer) || ringAt(context, pointer)) {
        return finish(context, true);
    }
    const Vec2 point = nextPoint(context, pointer);
    if (point == m_points.back()) {
        return refuse("same-point");
    }
    if (isPolygon() && m_points.size() == 2 && point == m_points.front()) {
        return refuse("too-few");
    }
    if (isPolygon() && !m_crossed && crossesEarlier(m_points, point)) {
        m_crossed = m_points.size() + 1;
    }
    m_points.push_back(point);
    m_refusal.clear();
    return {};
}

std::optional<FinishedEdit> DrawTool::drop(const ToolContext& context, const Pointer& pointer) {
    if (m_points.empty()) {
        begin(start(context).value_or(startAt(context, pointer)));
        if (nextPoint(context, pointer) == m_points.front()) {
            return {}; // a drag that came back is a click
        }
    }
    return click(context, pointer);
}

std::optional<FinishedEdit> DrawTool::end(const ToolContext& context) {
    if (m_points.empty()) {
        return {};
    }
    if (m_chain && m_points.size() == 1) {
        cancel(); // nothing was added to the chain
        return {};
    }
    if (m_points.size() < leastPoints()) {
        return refuse("too-few");
    }
    return finish(context, isPolygon());
}

std::optional<Edit> DrawTool::unfinished(const ToolContext& context) const {
    if (m_points.empty()) {
        return {};
    }
    DrawTool ended = *this;
    std::optional<FinishedEdit> finished = ended.end(context);
    if (!finished && isPolygon()) {
        ended = *this; // what is no polygon yet, or crosses itself, is kept as a line
        ended.m_kind = DrawKind::Line;
        finished = ended.end(context);
    }
    return finished ? std::optional(finished->edit) : std::nullopt;
}

std::optional<FinishedEdit> DrawTool::doubleClick(const ToolContext& context, const Pointer&) {
    return end(context);
}

std::optional<FinishedEdit> DrawTool::secondaryClick(const ToolContext& context, const Pointer&) {
    return end(context);
}

std::optional<FinishedEdit> DrawTool::key(const ToolContext& context, ToolKey key, const Pointer&) {
    if (key == ToolKey::Enter) {
        return end(context);
    }
    if ((key == ToolKey::Backspace || key == ToolKey::Delete) && !m_points.empty()) {
        m_points.pop_back();
        m_refusal.clear();
        if (m_points.empty()) {
            cancel();
        } else if (!crosses()) {
            m_crossed.reset();
        }
    }
    return {};
}

std::optional<FinishedEdit> DrawTool::finish(const ToolContext& context, bool closed) {
    return isPolygon() ? finishPolygon(context) : finishChain(context, closed);
}

std::optional<FinishedEdit> DrawTool::finishChain(const ToolContext& context, bool closed) {
    const std::vector<Vec2> points = m_points;
    const std::optional<ChainEnd> end = m_chain;
    cancel();
    const std::optional<OpenChain> chain = end ? openChain(*context.edit.level, *end) : std::nullopt;
    if (chain && chain->at == points.front()) {
        const std::span<const Vec2> added = std::span(points).subspan(1);
        Level level = extended(*context.edit.level, *end, added, closed);
        return FinishedEdit{{"extend-chain", 1},
                            {std::make_shared<const Level>(std::move(level)), Selection({end->key})}};
    }
    const Vec2 origin = points.front();
    const bool encloses = closed && points.size() >= leastToClose;
    std::vector<Vec2> vertices = relativeTo(origin, points);
    LevelShape shape = LineChain{vertices, encloses};
    if (m_kind == DrawKind::Edge) {
        shape = EdgeChain{std::move(vertices), encloses, noBack};
    }
    return FinishedEdit{{drawingLabel(m_kind), 1}, withDrawnBody(context, std::move(shape), origin)};
}

std::optional<FinishedEdit> DrawTool::finishPolygon(const ToolContext& context) {
    if (isFlat(m_points)) {
        return refuse("flat");
    }
    if (!isSimple(m_points)) {
        return refuse("crosses");
    }
    std::vector<Vec2> outline = m_points;
    cancel();
    const BodyKind kind = m_kind == DrawKind::Kinematic ? BodyKind::Kinematic : context.solids;
    return FinishedEdit{{drawingLabel(m_kind), 1}, withDrawnPolygon(context, std::move(outline), kind)};
}

Overlay DrawTool::startOverlay(const ToolContext& context, const Pointer& pointer) const {
    const Start at = startAt(context, pointer);
    Overlay overlay;
    overlay.points.push_back({at.chain ? OverlayStyle::HotHandle : OverlayStyle::Snap, at.at});
    return overlay;
}

Overlay DrawTool::overlay(const ToolContext& context, const Pointer& pointer) const {
    const std::optional<Start> first = start(context);
    if (!first) {
        return startOverlay(context, pointer);
    }
    Draft draft;
    draft.points = pointsWith(context);
    draft.closes = closesAt(context, pointer);
    draft.ring = ringAt(context, pointer);
    draft.next = draft.closes ? draft.points.front() : draft.ring.value_or(nextPoint(context, pointer));
    draft.fills = isPolygon();
    draft.pixel = pointer.pixel;
    if (m_kind == DrawKind::Edge) {
        const auto chain = first->chain ? openChain(*context.edit.level, *first->chain) : std::nullopt;
        draft.walls = first->chain && first->chain->first ? DraftWalls::Against : DraftWalls::Along;
        draft.depth = chain ? chain->depth : noBack;
    }
    if (crosses()) {
        draft.crossing.push_back({m_points[*m_crossed - 2], m_points[*m_crossed - 1]});
    }
    if (isPolygon() && !draft.closes && crossesEarlier(draft.points, draft.next)) {
        draft.crossing.push_back({draft.points.back(), draft.next});
    }
    return draftOverlay(draft);
}

std::optional<SnapAnswer> DrawTool::snapAt(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<Vec2> points = pointsWith(context);
    if (points.empty()) {
        return startAt(context, pointer).chain ? std::nullopt : std::optional(snapOf(context, pointer));
    }
    const bool ends = closesAt(context, pointer) || ringAt(context, pointer);
    return ends ? std::nullopt : std::optional(snapFrom(context, pointer, points.back()));
}

Hint DrawTool::hint(const ToolContext& context, const Pointer& pointer) const {
    if (!m_refusal.empty()) {
        return {m_refusal, {}};
    }
    if (!start(context)) {
        return {hintCode(startAt(context, pointer).chain ? "extend" : "start"), {}};
    }
    return nextHint(context, pointer);
}

Hint DrawTool::nextHint(const ToolContext& context, const Pointer& pointer) const {
    const std::vector<Vec2> points = pointsWith(context);
    const std::string count = std::to_string(points.size());
    if (crosses()) {
        return {hintCode("crossed"), {}};
    }
    if (ringAt(context, pointer)) {
        return {hintCode("close-chain"), {}};
    }
    if (closesAt(context, pointer)) {
        return {hintCode("close"), {count}};
    }
    const Vec2 next = nextPoint(context, pointer);
    if (isPolygon() && crossesEarlier(points, next)) {
        return {hintCode("crossing"), {}};
    }
    const Vec2 way = next - points.back();
    return {hintCode("next"), {count, lengthText(way.norm()), degreesText(directionOf(way))}};
}

CursorShape DrawTool::cursor(const ToolContext& context, const Pointer& pointer) const {
    const bool ends =
        closesAt(context, pointer) || ringAt(context, pointer) || (!start(context) && startAt(context, pointer).chain);
    return ends ? CursorShape::Pointing : CursorShape::Cross;
}

} // namespace spacetow
