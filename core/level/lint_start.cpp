#include "core/geometry/bounds.h"
#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/polygon.h"
#include "core/level/bounds.h"
#include "core/level/build.h"
#include "core/level/json_text.h"
#include "core/level/level_index.h"
#include "core/level/lint_findings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

/// Ship or payload where they start.
struct Starter {
    LevelCode code; // of the problem when it touches something
    int index;
    Key key;
    Transform pose;
    std::vector<Part> parts;
    Aabb bounds;
    Filter filter; // as in core/game/rules.h
};

struct Found {
    int count = 0;
    int first = -1;
};

/// Counts the objects of one kind; all but the first are too many.
template <class T>
Found counted(const Level& level, Findings& findings, LevelCode codeOfMore) {
    Found found;
    for (int i = 0; i < level.objects.size(); ++i) {
        if (std::holds_alternative<T>(level.objects[i].data)) {
            if (++found.count == 1) {
                found.first = i;
            } else {
                findings.add(Severity::Error, codeOfMore, {}, {i, level.objects[i].key, {}});
            }
        }
    }
    return found;
}

/// Of the ship or the payload; of other objects nothing.
std::optional<Starter> starterOf(const Object& object, int index) {
    const TagMask wall = TagMask::bit(wallTag);
    const auto made = [&](LevelCode code, const Shape& shape, const Transform& pose, const Filter& filter) {
        return Starter{code, index, object.key, pose, partsOf(shape), boundsOf(shape, pose), filter};
    };
    if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        const auto outline = shipOutline();
        return made("ship-in-wall", Polygon{{outline.begin(), outline.end()}},
                    {ship->position, Rot::fromAngle(ship->angle)},
                    {TagMask::bit(shipTag), wall | TagMask::bit(payloadTag)});
    }
    if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
        return made("payload-in-wall", Circle{{0, 0}, payload->radius}, {payload->position, {}},
                    {TagMask::bit(payloadTag), wall | TagMask::bit(shipTag)});
    }
    return {};
}

/// The parts of the body near the box, with the joints between its walls.
std::vector<Part> partsNear(const BodyObject& body, const Transform& pose, const Aabb& box) {
    std::vector<Part> parts;
    for (const Shape& shape : physicsShapes(body)) {
        const Aabb bounds = boundsOf(shape, pose);
        const bool isWall = std::holds_alternative<Edge>(shape) || std::holds_alternative<Line>(shape);
        if (bounds.overlaps(isWall ? box.grown(1) : box)) {
            for (const Part& part : partsOf(shape)) {
                parts.push_back(part);
            }
        }
    }
    std::vector<WallPart*> walls;
    for (Part& part : parts) {
        if (auto* wall = std::get_if<WallPart>(&part)) {
            walls.push_back(wall);
        }
    }
    joinWalls(walls);
    return parts;
}

bool touches(const Starter& starter, const BodyObject& body) {
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    for (const Part& part : partsNear(body, pose, starter.bounds)) {
        for (const Part& own : starter.parts) {
            if (collide(own, starter.pose, part, pose, 0).count > 0) {
                return true;
            }
        }
    }
    return false;
}

/// `take(object, body)` for each body that touches it, of those that `isSound(object)`: others cannot be asked.
template <class IsSound, class Take>
void visitTouching(const Level& level, const Starter& starter, IsSound isSound, Take take) {
    levelIndex(level).visitReaching(starter.bounds, [&](int i) {
        const Object& object = level.objects[i];
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body != nullptr && body->tangible && isSound(i) && mayTouch(starter.filter, body->filter) &&
            touches(starter, *body)) {
            take(i, *body);
        }
    });
}

/// m², of the closed one-way wall that goes round the point: positive when it is free inside, negative when it is rock
/// there, 0 when the shape does not go round it.
double areaAround(const LevelShape& shape, const BodyObject& body, const Vec2& point) {
    const auto* chain = std::get_if<EdgeChain>(&shape);
    const Vec2 local = Transform{body.position, Rot::fromAngle(body.angle)}.toLocal(point);
    return chain != nullptr && chain->closed && contains(chain->vertices, local) ? signedArea(chain->vertices) : 0;
}

std::optional<Vec2> placeInGame(const Object& object) {
    if (const auto* finish = std::get_if<FinishObject>(&object.data)) {
        return (finish->a + finish->b) / 2;
    }
    if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        return ship->position;
    }
    const auto* payload = std::get_if<PayloadObject>(&object.data);
    return payload != nullptr ? std::optional(payload->position) : std::nullopt;
}

/// Whether another of ship, payload and finish is in the same rock, or there is none.
bool hasCompany(const Level& level, const Starter& starter, const BodyObject& body, const LevelShape& rock) {
    int others = 0, inside = 0;
    for (const Object& object : level.objects) {
        const std::optional<Vec2> place = object.key == starter.key ? std::nullopt : placeInGame(object);
        others += place ? 1 : 0;
        inside += place && areaAround(rock, body, *place) < 0 ? 1 : 0;
    }
    return inside > 0 || others == 0;
}

bool isInCave(const Level& level, const Starter& starter) {
    bool isInside = false;
    levelIndex(level).visitReaching(starter.bounds, [&](int i) {
        const auto* body = std::get_if<BodyObject>(&level.objects[i].data);
        isInside |= body != nullptr && std::ranges::any_of(body->shapes, [&](const LevelShape& shape) {
                        return areaAround(shape, *body, starter.pose.position) > 0;
                    });
    });
    return isInside;
}

/// Who draws a cave clockwise gets a rock of its shape, and ship and payload in it.
bool isInsideOut(const Level& level, const Starter& starter, int index, Findings& findings) {
    const auto& body = std::get<BodyObject>(level.objects[index].data);
    const auto rock = std::ranges::find_if(
        body.shapes, [&](const LevelShape& shape) { return areaAround(shape, body, starter.pose.position) < 0; });
    if (rock == body.shapes.end() || isInCave(level, starter) || !hasCompany(level, starter, body, *rock)) {
        return false; // a rock in a cave is meant
    }
    findings.add(Severity::Error, "cave-inside-out", {},
                 {index,
                  level.objects[index].key,
                  "/shapes/" + std::to_string(rock - body.shapes.begin()),
                  {starter.pose.position}});
    return true;
}

void checkFree(const Level& level, const Starter& starter, Findings& findings) {
    std::vector<std::pair<int, const BodyObject*>> touched;
    visitTouching(
        level, starter, [&findings](int i) { return !findings.isBad(i); },
        [&touched](int i, const BodyObject& body) { touched.emplace_back(i, &body); });
    for (const auto& [i, body] : touched) {
        if (isInsideOut(level, starter, i, findings)) {
            continue;
        }
        findings.add(Severity::Error, starter.code, whichObject(level, level.objects[i], *body),
                     {starter.index, starter.key, "/position", {starter.pose.position}});
    }
}

LevelCode kindOf(const BodyObject& body) {
    if (body.shapes.size() != 1) {
        return "kind-body";
    }
    constexpr std::array<LevelCode, 4> kinds{"kind-edges", "kind-lines", "kind-polygon",
                                             "kind-circle"}; // as in LevelShape
    return kinds[body.shapes.front().index()];
}

} // namespace

std::string metres(double value) {
    return spelledNumber(std::round(100 * value) / 100 + 0.0);
}

std::vector<std::string> whichObject(const Level& level, const Object& object, const BodyObject& body) {
    const Vec2 middle = boundsOf(level, object).center();
    return {object.name, std::string(kindOf(body).text()), metres(middle.x()), metres(middle.y())};
}

bool startsFree(const Level& level, const Object& object, const std::set<Key>& unsound) {
    bool isFree = true;
    if (const auto starter = starterOf(object, 0)) {
        visitTouching(
            level, *starter, [&](int i) { return !unsound.contains(level.objects[i].key); },
            [&isFree](int, const BodyObject&) { isFree = false; });
    }
    return isFree;
}

void checkStart(const Level& level, Findings& findings) {
    const Found ship = counted<ShipObject>(level, findings, "several-ships");
    const Found payload = counted<PayloadObject>(level, findings, "several-payloads");
    const Found finish = counted<FinishObject>(level, findings, "several-finishes");
    if (ship.count + payload.count + finish.count == 0) {
        return; // a sandbox
    }
    const std::array missing{std::pair(ship.count, LevelCode("ship-missing")),
                             std::pair(payload.count, LevelCode("payload-missing")),
                             std::pair(finish.count, LevelCode("finish-missing"))};
    for (const auto& [count, code] : missing) {
        if (count == 0) {
            findings.add(Severity::Error, code, {});
        }
    }
    for (const Found& found : {ship, payload}) {
        if (found.count > 0 && !findings.isBad(found.first)) {
            checkFree(level, *starterOf(level.objects[found.first], found.first), findings);
        }
    }
}

} // namespace spacetow
