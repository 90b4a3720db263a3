#include "core/geometry/bounds.h"
#include "core/geometry/collide.h"
#include "core/geometry/convex_parts.h"
#include "core/level/bounds.h"
#include "core/level/build.h"
#include "core/level/json_text.h"
#include "core/level/lint_findings.h"

#include <array>
#include <cmath>

namespace spacetow {

namespace {

/// Ship or payload where they start.
struct Starter {
    const char* code; // of the problem when it touches something
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
Found counted(const Level& level, Findings& findings, const char* codeOfMore) {
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

Starter starterOf(const Shape& shape, const Transform& pose, const Filter& filter) {
    return {"", 0, 0, pose, partsOf(shape), boundsOf(shape, pose), filter};
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

const char* kindOf(const BodyObject& body) {
    if (body.shapes.size() != 1) {
        return "kind-body";
    }
    constexpr std::array kinds{"kind-edges", "kind-lines", "kind-polygon", "kind-circle"}; // as in LevelShape
    return kinds[body.shapes.front().index()];
}

/// The name, and for objects without one what they are and where their middle is.
std::vector<std::string> whichObject(const Level& level, const Object& object, const BodyObject& body) {
    const Vec2 middle = boundsOf(level, object).center();
    const auto metres = [](double value) { return spelledNumber(std::round(100 * value) / 100 + 0.0); };
    return {object.name, kindOf(body), metres(middle.x()), metres(middle.y())};
}

void checkFree(const Level& level, const std::vector<Starter>& starters, Findings& findings) {
    for (int i = 0; i < level.objects.size(); ++i) {
        const Object& object = level.objects[i];
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body == nullptr || !body->tangible || findings.isBad(i)) {
            continue;
        }
        for (const Starter& starter : starters) {
            if (mayTouch(starter.filter, body->filter) && touches(starter, *body)) {
                findings.add(Severity::Error, starter.code, whichObject(level, object, *body),
                             {starter.index, starter.key, "/position"});
            }
        }
    }
}

} // namespace

void checkStart(const Level& level, Findings& findings) {
    const Found ship = counted<ShipObject>(level, findings, "several-ships");
    const Found payload = counted<PayloadObject>(level, findings, "several-payloads");
    const Found finish = counted<FinishObject>(level, findings, "several-finishes");
    if (ship.count + payload.count + finish.count == 0) {
        return; // a sandbox
    }
    const std::array missing{std::pair(ship.count, "ship-missing"), std::pair(payload.count, "payload-missing"),
                             std::pair(finish.count, "finish-missing")};
    for (const auto& [count, code] : missing) {
        if (count == 0) {
            findings.add(Severity::Error, code, {});
        }
    }
    const TagMask wall = TagMask::bit(wallTag);
    std::vector<Starter> starters;
    if (ship.count > 0 && !findings.isBad(ship.first)) {
        const Object& object = level.objects[ship.first];
        const auto& data = std::get<ShipObject>(object.data);
        const auto outline = shipOutline();
        Starter starter =
            starterOf(Polygon{{outline.begin(), outline.end()}}, {data.position, Rot::fromAngle(data.angle)},
                      {TagMask::bit(shipTag), wall | TagMask::bit(payloadTag)});
        starter.code = "ship-in-wall";
        starter.index = ship.first;
        starter.key = object.key;
        starters.push_back(std::move(starter));
    }
    if (payload.count > 0 && !findings.isBad(payload.first)) {
        const Object& object = level.objects[payload.first];
        const auto& data = std::get<PayloadObject>(object.data);
        Starter starter = starterOf(Circle{{0, 0}, data.radius}, {data.position, {}},
                                    {TagMask::bit(payloadTag), wall | TagMask::bit(shipTag)});
        starter.code = "payload-in-wall";
        starter.index = payload.first;
        starter.key = object.key;
        starters.push_back(std::move(starter));
    }
    checkFree(level, starters, findings);
}

} // namespace spacetow
