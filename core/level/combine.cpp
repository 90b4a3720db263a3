#include "core/level/combine.h"

#include "core/geometry/polygon.h"
#include "core/level/arrange.h"
#include "core/level/codes.h"
#include "core/level/edits.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

constexpr double farthest = 5e5; // m

/// World coordinates; nothing when a shape of the body is no polygon.
std::optional<PolygonSet> areasOf(const BodyObject& body) {
    const Transform pose = *poseOf(ObjectData(body));
    PolygonSet areas;
    for (const LevelShape& shape : body.shapes) {
        const auto* polygon = std::get_if<Polygon>(&shape);
        if (polygon == nullptr) {
            return {};
        }
        std::vector<Vec2>& area = areas.emplace_back();
        for (const Vec2& vertex : polygon->vertices) {
            area.push_back(tidied(pose.toWorld(vertex)));
        }
    }
    return areas;
}

bool isFar(const PolygonSet& areas) {
    return std::ranges::any_of(areas, [](const std::vector<Vec2>& area) {
        return std::ranges::any_of(area, [](const Vec2& at) { return !(at.cwiseAbs().maxCoeff() < farthest); });
    });
}

std::vector<LevelShape> shapesOf(const PolygonSet& areas, const BodyObject& body) {
    const Rot back = Rot::fromAngle(body.angle).inverse();
    std::vector<LevelShape> shapes;
    for (const std::vector<Vec2>& area : areas) {
        Polygon polygon;
        for (const Vec2& at : area) {
            polygon.vertices.push_back(tidied(back * Vec2(at - body.position)));
        }
        shapes.emplace_back(std::move(polygon));
    }
    return shapes;
}

} // namespace

Result<CombinedBodies> combinedBodies(Level level, std::span<const Key> keys, PolygonBoolean how) {
    const std::vector<Key> wanted = unlockedKeys(level, keys);
    PolygonSet areas;
    PolygonSet others; // what a difference takes away
    std::vector<Key> gone;
    Object first;
    for (const Object& object : level.objects) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body == nullptr || !std::ranges::binary_search(wanted, object.key)) {
            continue;
        }
        const std::optional<PolygonSet> own = areasOf(*body);
        if (!own) {
            return object.name.empty() ? Error{LevelCode("combine-unnamed-no-polygon"), {}}
                                       : Error{LevelCode("combine-no-polygon"), {object.name}};
        }
        if (isFar(*own)) {
            return Error{LevelCode("combine-too-far"), {}};
        }
        if (first.key == 0) {
            first = object;
            areas = *own;
            continue;
        }
        gone.push_back(object.key);
        if (how == PolygonBoolean::Intersection) {
            areas = combined(areas, *own, how);
        } else {
            others.insert(others.end(), own->begin(), own->end());
        }
    }
    if (gone.empty()) {
        return Error{LevelCode("combine-too-few"), {}};
    }
    if (how != PolygonBoolean::Intersection) {
        areas = combined(areas, others, how);
    }
    if (areas.empty()) {
        return Error{LevelCode("combine-empty"), {}};
    }
    if (!std::ranges::all_of(areas, [](const std::vector<Vec2>& area) { return isSimple(area); })) {
        return Error{LevelCode("combine-not-simple"), {}};
    }
    auto& body = std::get<BodyObject>(first.data);
    body.shapes = shapesOf(areas, body);
    const Key key = first.key;
    level = withObject(removed(std::move(level), gone), std::move(first));
    return CombinedBodies{std::move(level), key};
}

} // namespace spacetow
