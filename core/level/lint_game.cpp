// Whether the game of a level can be won, as far as one can see without playing it.
#include "core/geometry/intersect.h"
#include "core/level/bounds.h"
#include "core/level/json_text.h"
#include "core/level/level_index.h"
#include "core/level/lint_findings.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

bool isWallShape(const LevelShape& shape) {
    return std::holds_alternative<EdgeChain>(shape) || std::holds_alternative<LineChain>(shape);
}

bool hasOnlyWalls(const BodyObject& body) {
    return !body.shapes.empty() && std::ranges::all_of(body.shapes, isWallShape);
}

void checkFinish(const Level& level, Findings& findings) {
    const Object* const finish = firstOf<FinishObject>(level);
    if (finish == nullptr) {
        return;
    }
    const int index = level.objects.indexOf(finish->key);
    const auto& line = std::get<FinishObject>(finish->data);
    if (findings.isBad(index)) {
        return;
    }
    if (line.a == line.b) {
        findings.add(Severity::Error, "finish-without-length", {}, {index, finish->key, "/b", {line.a}});
        return;
    }
    const Object* const payload = firstOf<PayloadObject>(level);
    if (payload == nullptr || findings.isBad(level.objects.indexOf(payload->key))) {
        return;
    }
    const auto& ball = std::get<PayloadObject>(payload->data);
    if ((closestOnSegment(line.a, line.b, ball.position) - ball.position).norm() < ball.radius) {
        findings.add(Severity::Warning, "payload-on-finish", {},
                     {level.objects.indexOf(payload->key), payload->key, "/position", {ball.position}});
    }
}

void checkGravity(const Level& level, Findings& findings) {
    const double gravity = level.gravity.norm();
    const Object* const payload = firstOf<PayloadObject>(level);
    if (firstOf<ShipObject>(level) == nullptr || !std::isfinite(gravity)) {
        return;
    }
    const double load = payload == nullptr ? 0 : std::get<PayloadObject>(payload->data).mass;
    const double weight = level.rules.shipMass * gravity;
    const double together = (level.rules.shipMass + load) * gravity;
    const std::string thrust = spelledNumber(level.rules.thrust);
    if (weight >= level.rules.thrust) {
        findings.add(Severity::Warning, "gravity-too-strong", {metres(weight), thrust}, {.path = "/gravity"});
    } else if (together >= level.rules.thrust) {
        findings.add(Severity::Warning, "payload-too-heavy", {metres(together), thrust},
                     {level.objects.indexOf(payload->key), payload->key, "/mass", {}});
    }
}

void checkBackground(const Level& level, Findings& findings) {
    const std::string& name = level.rules.background;
    if (std::ranges::find(shippedBackgrounds, name) == shippedBackgrounds.end()) {
        findings.add(Severity::Warning, "background-unknown", {name}, {.path = "/rules/background"});
    }
}

/// What wants to touch the ship, but is no wall to it. Debris is meant to be flown through.
void checkWallTags(const Level& level, Findings& findings) {
    if (firstOf<ShipObject>(level) == nullptr) {
        return;
    }
    const TagMask players = TagMask::bit(shipTag) | TagMask::bit(payloadTag);
    const TagMask known = players | TagMask::bit(wallTag) | TagMask::bit(debrisTag);
    int index = -1;
    for (const Object& object : level.objects) {
        ++index;
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body != nullptr && body->kind == BodyKind::Static && body->tangible && body->filter.tags.bits != 0 &&
            !body->filter.tags.intersects(known) && body->filter.touches.intersects(players) && hasOnlyWalls(*body)) {
            findings.add(Severity::Warning, "wall-not-tagged", {level.tags[wallTag].name},
                         {index, object.key, "/tags"});
        }
    }
}

/// What the body could fall onto: the first body of nothing but walls that the way of its box meets.
const Object* wallsBelow(const Level& level, const Object& object, const BodyObject& body) {
    Aabb way = boundsOf(level, object);
    const Aabb all = levelIndex(level).bounds();
    if (level.gravity != Vec2(0, 0) && !way.isEmpty()) {
        const double far = all.size().norm();
        const Vec2 fall = far * level.gravity.normalized();
        way.include(Vec2(way.min + fall));
        way.include(Vec2(way.max + fall));
    }
    const Object* found = nullptr;
    double nearest = 0;
    levelIndex(level).visitObjects(way, [&](int place) {
        const Object& other = level.objects[place];
        const auto* walls = std::get_if<BodyObject>(&other.data);
        if (walls == nullptr || other.key == object.key || !walls->tangible || !hasOnlyWalls(*walls) ||
            !mayTouch(body.filter, walls->filter)) {
            return;
        }
        const double distance = (levelIndex(level).boundsOf(place).center() - body.position).norm();
        if (found == nullptr || distance < nearest) {
            found = &other;
            nearest = distance;
        }
    });
    return found;
}

void checkWallsOnWalls(const Level& level, Findings& findings) {
    int told = 0;
    constexpr int enough = 1000; // each takes a look at all that lies below
    int index = -1;
    for (const Object& object : level.objects) {
        ++index;
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body == nullptr || body->kind != BodyKind::Dynamic || !body->tangible || body->frozen ||
            findings.isBad(index) || !hasOnlyWalls(*body)) {
            continue;
        }
        if (++told > enough || findings.isStopped()) {
            return;
        }
        if (const Object* below = wallsBelow(level, object, *body)) {
            findings.add(Severity::Warning, "walls-never-meet",
                         whichObject(level, *below, std::get<BodyObject>(below->data)), {index, object.key, "/shapes"});
        }
    }
}

} // namespace

void checkGame(const Level& level, Findings& findings) {
    for (const auto check : {checkFinish, checkGravity, checkBackground, checkWallTags, checkWallsOnWalls}) {
        check(level, findings);
    }
}

} // namespace spacetow
