#include "editor/editing/snap_point.h"

#include "core/level/arrange.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"
#include "editor/editing/snap_align.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {

struct SnapMemo {
    std::shared_ptr<const Level> level; // held, so that no other one comes to stand in its place
    std::shared_ptr<const SnapSubject> subject;
    SnapSettings settings;
    SnapQuery query;
    SnapAnswer answer;
};

std::shared_ptr<SnapMemo> makeSnapMemo() {
    return std::make_shared<SnapMemo>();
}

namespace {

constexpr std::size_t mostPoints = 12; // of what is dragged, by which it snaps
constexpr double firstLook = 40;       // px around the pointer, for such points
constexpr std::size_t fewObjects = 64; // whose centres are looked at too

SnapAnswer answered(const ToolContext& context, const std::shared_ptr<const SnapSubject>& subject,
                    const SnapSettings& settings, const SnapQuery& query) {
    if (!context.memo) {
        return snapAnswer(*context.edit.level, settings, *subject, query);
    }
    SnapMemo& memo = *context.memo;
    const bool same = memo.subject == subject || (memo.subject && *memo.subject == *subject);
    const bool known = memo.level == context.edit.level && same && memo.settings == settings && memo.query == query;
    if (!known) {
        memo = {context.edit.level, subject, settings, query,
                snapAnswer(*context.edit.level, settings, *subject, query)};
    }
    return memo.answer;
}

const std::shared_ptr<const SnapSubject>& nothingMoves() {
    static const auto nothing = std::make_shared<const SnapSubject>();
    return nothing;
}

SnapSettings heldIn(const ToolContext& context, const Pointer& pointer) {
    SnapSettings held = withHeld(context.snap, pointer.modifiers);
    held.guides = held.guides && context.guides;
    return held;
}

SnapQuery queryAt(const Pointer& pointer) {
    return {pointer.world, pointer.pixel, pointer.view};
}

/// Those of the points that are nearest to `near`, as seen from `origin`.
std::vector<Vec2> nearestOf(std::vector<Vec2> points, const Vec2& near, const Vec2& origin) {
    const auto away = [&](const Vec2& point) { return (point - near).squaredNorm(); };
    if (points.size() > mostPoints) {
        std::ranges::nth_element(points, points.begin() + mostPoints, {}, away);
        points.resize(mostPoints);
    }
    for (Vec2& point : points) {
        point -= origin;
    }
    return points;
}

/// Vertices in the box, and centres of what is round when these are not too many objects.
std::vector<Vec2> pointsIn(const Level& level, const std::vector<Key>& keys, const Aabb& box) {
    std::vector<Vec2> points;
    for (const Key key : keys) {
        const int place = level.objects.indexOf(key);
        if (place < 0 || !levelIndex(level).boundsOf(place).overlaps(box)) {
            continue;
        }
        levelIndex(level).visitVerticesOf(place, box,
                                          [&](const VertexRef&, const Vec2& at) { points.push_back(tidied(at)); });
    }
    return points;
}

void addCenters(std::vector<Vec2>& points, const Level& level, const std::vector<Key>& keys) {
    for (const Key key : keys) {
        const Object* object = level.objects.find(key);
        if (object == nullptr) {
            continue;
        }
        const auto* body = std::get_if<BodyObject>(&object->data);
        if (body == nullptr && !std::holds_alternative<FinishObject>(object->data)) {
            if (const std::optional<Vec2> place = placeOf(object->data)) {
                points.push_back(*place);
            }
        }
        for (const LevelShape& shape : body != nullptr ? body->shapes : ShapeList()) {
            if (const auto* circle = std::get_if<Circle>(&shape)) {
                points.push_back(
                    tidied(Transform{body->position, Rot::fromAngle(body->angle)}.toWorld(circle->center)));
            }
        }
    }
}

} // namespace

SnapAnswer snapOf(const ToolContext& context, const Pointer& pointer) {
    return answered(context, nothingMoves(), heldIn(context, pointer), queryAt(pointer));
}

SnapAnswer snapFrom(const ToolContext& context, const Pointer& pointer, const Vec2& from) {
    SnapQuery query = queryAt(pointer);
    query.from = from;
    if (pointer.modifiers.shift) {
        const Vec2 way = pointer.world - from;
        query.along = snappedDirection(way);
        query.through = from;
        query.at = from + *query.along * way.dot(*query.along);
    }
    SnapAnswer answer = answered(context, nothingMoves(), heldIn(context, pointer), query);
    if (answer.kind == SnapKind::None && pointer.modifiers.shift) {
        answer.kind = SnapKind::Angle;
    }
    return answer;
}

Vec2 snapped(const ToolContext& context, const Pointer& pointer) {
    return snapOf(context, pointer).point;
}

Vec2 snappedFrom(const ToolContext& context, const Pointer& pointer, const Vec2& from) {
    return snapFrom(context, pointer, from).point;
}

DraggedSnap::DraggedSnap(const ToolContext& context, SnapSubject subject, const Vec2& start)
    : m_context(context), m_subject(std::make_shared<const SnapSubject>(std::move(subject))), m_start(start) {}

SnapAnswer DraggedSnap::moved(const Vec2& way, const Pointer& pointer) const {
    if (!pointer.modifiers.shift) {
        return to(m_start + way, pointer);
    }
    const bool across = std::abs(way.x()) >= std::abs(way.y());
    const Vec2 target = across ? Vec2(m_start.x() + way.x(), m_start.y()) : Vec2(m_start.x(), m_start.y() + way.y());
    return to(target, pointer, across ? Vec2(1, 0) : Vec2(0, 1));
}

SnapAnswer DraggedSnap::to(const Vec2& target, const Pointer& pointer, const std::optional<Vec2>& along) const {
    SnapQuery query = queryAt(pointer);
    query.at = target;
    query.along = along;
    query.through = along ? std::optional(m_start) : std::nullopt;
    return answered(m_context, m_subject, heldIn(m_context, pointer), query);
}

SnapSubject subjectOf(const Level& level, std::vector<Key> keys, const Pointer& pointer, const Vec2& reference) {
    SnapSubject subject;
    const Aabb bounds = placedBounds(level, keys);
    if (!bounds.isEmpty()) {
        const Object* only = keys.size() == 1 ? level.objects.find(keys.front()) : nullptr;
        const Aabb aligned = only != nullptr ? alignedBox(*only, bounds) : bounds;
        subject.box = {aligned.min - reference, aligned.max - reference};
        std::vector<Vec2> points;
        for (double look = firstLook; points.empty(); look *= 4) {
            const Aabb box = Aabb{pointer.world, pointer.world}.grown(look * pointer.pixel);
            points = pointsIn(level, keys, box);
            if (box.contains(bounds)) {
                break;
            }
        }
        if (keys.size() <= fewObjects) {
            addCenters(points, level, keys);
        }
        subject.points = nearestOf(std::move(points), pointer.world, reference);
    }
    subject.keys = std::move(keys);
    return subject;
}

} // namespace spacetow
