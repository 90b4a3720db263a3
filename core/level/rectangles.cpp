#include "core/level/rectangles.h"

#include "core/level/edits.h"
#include "core/level/object_geometry.h"

#include <array>
#include <cmath>

namespace spacetow {

namespace {

constexpr double leastExtent = 1e-6; // m: rounding would put corners that are nearer onto each other
constexpr Field widthField{.name = "width", .unit = "m", .min = leastExtent, .max = limits::coordinate};
constexpr Field heightField{.name = "height", .unit = "m", .min = leastExtent, .max = limits::coordinate};
constexpr std::array sizeFields{&widthField, &heightField};

struct RectangleFrame {
    std::array<Vec2, 2> axes; // unit vectors along width and height, in coordinates of the body
    Vec2 size;
    Vec2 middle;
};

const Polygon* onlyPolygon(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body == nullptr || body->shapes.size() != 1 ? nullptr : std::get_if<Polygon>(&body->shapes.front());
}

std::optional<RectangleFrame> rectangleFrame(const Object& object) {
    constexpr double rounding = 1e-9;
    const Polygon* polygon = onlyPolygon(object);
    if (polygon == nullptr || polygon->vertices.size() != 4) {
        return {};
    }
    const std::vector<Vec2>& corners = polygon->vertices;
    const std::array<Vec2, 2> sides{corners[1] - corners[0], corners[2] - corners[1]};
    const Vec2 lengths(sides[0].norm(), sides[1].norm());
    const Vec2 gap = corners[3] - corners[0] - sides[1];
    const bool isRight = lengths.minCoeff() > 0 && gap.norm() <= rounding * lengths.maxCoeff() &&
                         std::abs(sides[0].dot(sides[1])) <= rounding * lengths.x() * lengths.y();
    if (!isRight) {
        return {};
    }
    // At 45° rounding does not decide.
    const std::size_t along = std::abs(sides[0].x()) >= (1 - rounding) * std::abs(sides[0].y()) ? 0 : 1;
    const std::size_t across = 1 - along;
    const Vec2 size(lengths[static_cast<int>(along)], lengths[static_cast<int>(across)]);
    return RectangleFrame{
        {sides[along] / size.x(), sides[across] / size.y()}, tidied(size), 0.5 * (corners[0] + corners[2])};
}

/// The rectangle's corners so far from the middle along this unit vector of the body, to the last bit.
void setExtent(Object& object, const Vec2& way, double extent) {
    std::vector<Vec2>& corners = std::get<Polygon>(std::get<BodyObject>(object.data).shapes.front()).vertices;
    const Vec2 middle = 0.5 * (corners[0] + corners[2]);
    for (Vec2& corner : corners) {
        const double from = (corner - middle).dot(way);
        corner = tidied(Vec2(corner + way * (std::copysign(0.5 * extent, from) - from)));
    }
}

Level resized(Level level, Key key, int axis, double extent) {
    const Object& object = *level.objects.find(key);
    const RectangleFrame frame = *rectangleFrame(object);
    const Transform pose = *poseOf(object);
    const Vec2 way = pose.rotation * frame.axes[static_cast<std::size_t>(axis)];
    const double more = extent / frame.size[axis] - 1;
    const Vec2 x(1 + more * way.x() * way.x(), more * way.x() * way.y());
    const Vec2 y(more * way.x() * way.y(), 1 + more * way.y() * way.y());
    Level after = transformed(std::move(level), {&key, 1}, Affine::about(pose.toWorld(frame.middle), x, y));
    Object made = *after.objects.find(key);
    setExtent(made, frame.axes[static_cast<std::size_t>(axis)], extent); // such a map does not turn the body
    return withObject(std::move(after), std::move(made));
}

} // namespace

std::optional<Vec2> rectangleSize(const Object& object) {
    const std::optional<RectangleFrame> frame = rectangleFrame(object);
    return frame ? std::optional(frame->size) : std::nullopt;
}

void SizeSurvey::add(const Object& object) {
    const std::optional<Vec2> size = rectangleSize(object);
    if (!size) {
        return;
    }
    for (std::size_t axis = 0; axis < sizeFields.size(); ++axis) {
        const FieldValue value((*size)[static_cast<int>(axis)]);
        if (m_sizes.size() == axis) {
            FieldSummary made;
            made.id = sizeFields[axis]->name;
            made.field = *sizeFields[axis];
            made.value = value;
            made.mayBeUnset = false;
            made.isOfShape = true;
            made.isSeen = true;
            m_sizes.push_back(std::move(made));
        }
        FieldSummary& summary = m_sizes[axis];
        summary.isMixed = summary.isMixed || !(summary.value == value);
        ++summary.count;
    }
}

std::vector<FieldSummary> SizeSurvey::summaries() const {
    return m_sizes;
}

bool isSizeField(const std::string& id) {
    return id == widthField.name || id == heightField.name;
}

FieldEditResult withSizeEdited(Level level, std::span<const Key> keys, const FieldEdit& edit) {
    const int axis = edit.id == widthField.name ? 0 : 1;
    FieldEditResult result{std::move(level), 0, 0};
    for (const Key key : keys) {
        const Object* object = result.level.objects.find(key);
        const std::optional<Vec2> size = object == nullptr ? std::nullopt : rectangleSize(*object);
        if (!size) {
            continue;
        }
        const std::optional<FieldValue> next = edit.change(FieldValue((*size)[axis]));
        const double* extent = next ? std::get_if<double>(&*next) : nullptr;
        if (extent == nullptr || !(*extent >= leastExtent) || *extent > limits::coordinate) {
            ++result.refused;
        } else if (*extent != (*size)[axis]) {
            result.level = resized(std::move(result.level), key, axis, *extent);
            ++result.changed;
        }
    }
    return result;
}

} // namespace spacetow
