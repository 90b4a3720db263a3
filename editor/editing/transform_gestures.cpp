#include "editor/editing/transform_gestures.h"

#include "core/level/arrange.h"
#include "core/level/edits.h"
#include "editor/editing/measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double leastLength = 1e-3; // m, of what is scaled
constexpr double pivotReach = 8;     // px, within which the pivot snaps to a corner

HandleSide opposite(const HandleSide& side) {
    return {-side.x, -side.y};
}

std::vector<Vec2> cornersOf(const HandleFrame& frame) {
    return {pointOf(frame, {-1, -1}), pointOf(frame, {1, -1}), pointOf(frame, {1, 1}), pointOf(frame, {-1, 1})};
}

/// What slants meets the grid nowhere in particular.
ToolContext gridless(const HandleDrag& drag) {
    ToolContext context = drag.context;
    if (drag.frame.isTurned()) {
        context.snap.grid = false;
        context.snap.smart = true;
    }
    return context;
}

Edit mapped(const Edit& edit, const std::vector<Key>& keys, const Affine& map) {
    return {std::make_shared<const Level>(transformed(*edit.level, keys, map)), edit.selection};
}

/// Ctrl has another meaning at handles, so Alt takes its part.
Pointer atHandle(Pointer pointer) {
    pointer.modifiers = {false, pointer.modifiers.alt, false};
    return pointer;
}

std::string percent(double factor) {
    return std::to_string(std::lround(100 * factor));
}

} // namespace

ScaleGesture::ScaleGesture(const HandleDrag& drag)
    : m_drag(drag), m_keys(unlockedKeys(*drag.context.edit.level, drag.context.edit.selection.keys())),
      m_snap(gridless(drag), {.keys = m_keys}, pointOf(drag.frame, drag.side)) {}

/// Where the dragged side lands. What keeps its shape cannot be made to reach a point, only a grid line.
std::optional<SnapAnswer> ScaleGesture::snapAt(const Pointer& pointer) const {
    if (keepsShape(pointer)) {
        return {};
    }
    const Rot& turn = m_drag.frame.turn;
    Vec2 way = inFrame(pointer.world - m_drag.start);
    way.x() = m_drag.side.x != 0 ? way.x() : 0;
    way.y() = m_drag.side.y != 0 ? way.y() : 0;
    const Vec2 target = pointOf(m_drag.frame, m_drag.side) + turn * way;
    std::optional<Vec2> along;
    if (!m_drag.side.isCorner()) {
        along = turn * (m_drag.side.x != 0 ? Vec2(1, 0) : Vec2(0, 1));
    }
    if (!m_drag.frame.isTurned()) {
        return m_snap.to(target, atHandle(pointer), along);
    }
    if (!withHeld(m_drag.context.snap, atHandle(pointer).modifiers).smart) {
        return {};
    }
    Pointer plain = pointer;
    plain.modifiers = {};
    const SnapAnswer answer = m_snap.to(target, plain, along);
    return answer.kind == SnapKind::None ? std::nullopt : std::optional(answer);
}

Vec2 ScaleGesture::targetAt(const Pointer& pointer) const {
    if (const std::optional<SnapAnswer> answer = snapAt(pointer)) {
        return inFrame(answer->point);
    }
    const Vec2 target = pointOf(m_drag.frame.box, m_drag.side) + inFrame(pointer.world - m_drag.start);
    const SnapSettings& settings = m_drag.context.snap;
    if (!snaps(settings, atHandle(pointer).modifiers)) {
        return target;
    }
    return m_drag.frame.isTurned() ? inSteps(pointer, target) : onGrid(settings, target);
}

/// As far from what stays as makes the sides of the whole multiples of the step.
Vec2 ScaleGesture::inSteps(const Pointer& pointer, const Vec2& target) const {
    const Vec2 fixed = inFrame(fixedPoint(pointer));
    const bool bothWays = pointer.modifiers.shift && !m_drag.context.edit.selection.pivot();
    const double share = bothWays ? 0.5 : 1;
    return fixed + share * onGrid(m_drag.context.snap, Vec2((target - fixed) / share));
}

Vec2 ScaleGesture::fixedPoint(const Pointer& pointer) const {
    if (!pointer.modifiers.shift) {
        return pointOf(m_drag.frame, opposite(m_drag.side));
    }
    return m_drag.context.edit.selection.pivot().value_or(pointOf(m_drag.frame, {}));
}

Vec2 ScaleGesture::factorsAt(const Pointer& pointer) const {
    const SnapSettings& settings = m_drag.context.snap;
    const bool onSteps = snaps(settings, atHandle(pointer).modifiers);
    const Vec2 fixed = inFrame(fixedPoint(pointer));
    const Vec2 grabbed = pointOf(m_drag.frame.box, m_drag.side);
    const Vec2 target = targetAt(pointer);
    const int sides[] = {m_drag.side.x, m_drag.side.y};
    Vec2 factors(1, 1);
    for (int axis = 0; axis < 2; ++axis) {
        const double span = grabbed[axis] - fixed[axis];
        if (sides[axis] == 0 || std::abs(span) < leastLength) {
            continue; // the pivot lies on this very side
        }
        const double factor = (target[axis] - fixed[axis]) / span;
        const double least = std::fmax(onSteps ? settings.fineStep() : pointer.pixel, leastLength) / std::abs(span);
        factors[axis] = std::copysign(std::fmax(std::abs(factor), std::fmin(least, 1)), factor);
    }
    if (keepsShape(pointer)) {
        const bool byWidth = sides[1] == 0 || (sides[0] != 0 && std::abs(factors.x() - 1) >= std::abs(factors.y() - 1));
        const double common = std::abs(factors[byWidth ? 0 : 1]);
        factors = {std::copysign(common, factors.x()), std::copysign(common, factors.y())};
    }
    return factors;
}

std::optional<Affine> ScaleGesture::map(const Pointer& pointer) const {
    return scalingIn(m_drag.frame, fixedPoint(pointer), factorsAt(pointer));
}

Edit ScaleGesture::at(const Pointer& pointer) const {
    const Edit& before = m_drag.context.edit;
    if (factorsAt(pointer) == Vec2(1, 1)) {
        return before;
    }
    const Affine scaling = *map(pointer);
    Edit edit = mapped(before, m_keys, scaling);
    if (const std::optional<Vec2>& pivot = before.selection.pivot()) {
        edit.selection = before.selection.withPivot(scaling(*pivot));
    }
    return edit;
}

Label ScaleGesture::label() const {
    return {"scale", m_drag.context.edit.selection.size()};
}

Overlay ScaleGesture::overlay(const Pointer& pointer) const {
    const Affine scaling = *map(pointer);
    const Vec2 factors = factorsAt(pointer).cwiseAbs();
    const Vec2 size = m_drag.frame.box.size().cwiseProduct(factors);
    const Vec2 target = scaling(pointOf(m_drag.frame, m_drag.side));
    Overlay overlay;
    OverlayLine frame{OverlayStyle::Measure, cornersOf(m_drag.frame), true};
    std::ranges::transform(frame.points, frame.points.begin(), scaling);
    overlay.lines.push_back(std::move(frame));
    overlay.points.push_back({OverlayStyle::Pivot, fixedPoint(pointer)});
    overlay.points.push_back({OverlayStyle::HotHandle, target});
    overlay.texts.push_back({target, lengthText(size.x()) + " × " + lengthText(size.y()) + " m"});
    return overlay;
}

Hint ScaleGesture::hint(const Pointer& pointer) const {
    const Vec2 factors = factorsAt(pointer);
    const Vec2 size = m_drag.frame.box.size().cwiseProduct(factors.cwiseAbs());
    return {"select.scaling", {lengthText(size.x()), lengthText(size.y()), percent(factors.x()), percent(factors.y())}};
}

TurnGesture::TurnGesture(const HandleDrag& drag)
    : m_drag(drag), m_keys(unlockedKeys(*drag.context.edit.level, drag.context.edit.selection.keys())) {}

Vec2 TurnGesture::pivotAt(const Pointer& pointer) const {
    return pointer.modifiers.shift ? pointOf(m_drag.frame, opposite(m_drag.side)) : m_drag.frame.pivot;
}

double TurnGesture::angleAt(const Pointer& pointer) const {
    const Vec2 pivot = pivotAt(pointer);
    const Vec2 from = m_drag.start - pivot;
    const Vec2 to = pointer.world - pivot;
    const double angle = std::atan2(cross(from, to), from.dot(to));
    constexpr double step = std::numbers::pi / 12;
    return pointer.modifiers.ctrl ? step * std::round(angle / step) : angle;
}

std::optional<Affine> TurnGesture::map(const Pointer& pointer) const {
    return Affine::rotation(pivotAt(pointer), angleAt(pointer));
}

Edit TurnGesture::at(const Pointer& pointer) const {
    const Edit& before = m_drag.context.edit;
    if (angleAt(pointer) == 0) {
        return before;
    }
    const Affine turn = *map(pointer);
    Edit edit = mapped(before, m_keys, turn);
    // Without a pivot of its own the selection would have another one after each turn, and four quarters would not
    // bring it back.
    edit.selection = before.selection.withPivot(tidied(turn(m_drag.frame.pivot)));
    return edit;
}

Label TurnGesture::label() const {
    return {"rotate", m_drag.context.edit.selection.size()};
}

Overlay TurnGesture::overlay(const Pointer& pointer) const {
    const Vec2 pivot = pivotAt(pointer);
    const Affine turn = *map(pointer);
    const Vec2 reached = turn(m_drag.start);
    Overlay overlay;
    OverlayLine frame{OverlayStyle::Measure, cornersOf(m_drag.frame), true};
    std::ranges::transform(frame.points, frame.points.begin(), turn);
    overlay.lines.push_back(std::move(frame));
    overlay.lines.push_back({OverlayStyle::Measure, {m_drag.start, pivot, reached}});
    overlay.points.push_back({OverlayStyle::Pivot, pivot});
    overlay.points.push_back({OverlayStyle::HotHandle, reached});
    overlay.texts.push_back({reached, degreesText(angleAt(pointer)) + "°"});
    return overlay;
}

Hint TurnGesture::hint(const Pointer& pointer) const {
    return {"select.turning", {degreesText(angleAt(pointer))}};
}

std::optional<SnapAnswer> PivotGesture::snapAt(const Pointer& pointer) const {
    const Vec2 wanted = m_drag.frame.pivot + pointer.world - m_drag.start;
    const SnapSettings held = withHeld(m_drag.context.snap, pointer.modifiers);
    std::optional<SnapAnswer> nearest;
    double distance = pivotReach * pointer.pixel;
    for (int y = -1; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            const HandleSide side{x, y};
            const Vec2 point = pointOf(m_drag.frame, side);
            if ((held.grid || held.smart) && (point - wanted).norm() <= distance) {
                const SnapKind kind = side.isPivot()    ? SnapKind::Center
                                      : side.isCorner() ? SnapKind::Vertex
                                                        : SnapKind::Midpoint;
                nearest = SnapAnswer{.point = point, .kind = kind, .mark = point};
                distance = (point - wanted).norm();
            }
        }
    }
    return nearest ? nearest : m_snap.to(wanted, pointer);
}

Edit PivotGesture::at(const Pointer& pointer) const {
    const Edit& before = m_drag.context.edit;
    return {before.level, before.selection.withPivot(placeAt(pointer))};
}

Overlay PivotGesture::overlay(const Pointer& pointer) const {
    Overlay overlay;
    overlay.lines.push_back({OverlayStyle::Measure, cornersOf(m_drag.frame), true});
    overlay.points.push_back({OverlayStyle::Pivot, placeAt(pointer)});
    return overlay;
}

Hint PivotGesture::hint(const Pointer& pointer) const {
    const Vec2 place = placeAt(pointer);
    return {"select.pivot", {lengthText(place.x()), lengthText(place.y())}};
}

} // namespace spacetow
