#include "core/level/object_geometry.h"

#include "core/base/overloaded.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

constexpr double noTurn = 1e-12; // of the entries of a map: less is a rounding error

void include(Aabb& box, const LevelShape& shape, const Transform& pose) {
    const auto vertices = [&](const auto& of) {
        for (const Vec2& vertex : of.vertices) {
            box.include(pose.toWorld(vertex));
        }
    };
    std::visit(Overloaded{[&](const Circle& circle) {
                              const Vec2 center = pose.toWorld(circle.center);
                              box.include(Aabb{center, center}.grown(circle.radius));
                          },
                          [&](const EdgeChain& chain) { vertices(chain); },
                          [&](const LineChain& chain) { vertices(chain); },
                          [&](const Polygon& polygon) { vertices(polygon); }},
               shape);
}

double wrapped(double angle) {
    return tidied(std::remainder(angle, 2 * std::numbers::pi));
}

/// How far an object turns that stood at `angle`: the turn that is left when stretching and mirroring its own x axis
/// are taken away.
double turnedAngle(const Affine& map, double angle) {
    const Rot rotation = Rot::fromAngle(angle);
    const Vec2 right = map.linear(rotation.right());
    const Vec2 up = map.linear(rotation.up());
    // The rotation of the polar decomposition, of a mirrored map after its x axis is turned round.
    const bool mirrors = map.determinant() < 0;
    const Vec2 x = mirrors ? Vec2(-right) : right;
    const double c = x.x() + up.y();
    const double s = x.y() - up.x();
    if (std::abs(c) + std::abs(s) < noTurn) {
        return angle;
    }
    return std::atan2(s, c);
}

/// As `turnedAngle`, but to the last bit the old angle where nothing turns, and a whole quarter where a quarter does.
double angleAfter(const Affine& map, double angle) {
    const double turned = turnedAngle(map, angle);
    const double delta = std::remainder(turned - angle, 2 * std::numbers::pi);
    constexpr double quarter = std::numbers::pi / 2;
    const double quarters = std::round(delta / quarter);
    if (std::abs(delta - quarters * quarter) > noTurn) {
        return wrapped(turned);
    }
    return quarters == 0 ? angle : wrapped(angle + quarters * quarter);
}

Affine rounded(Affine map) {
    for (Vec2* axis : {&map.x, &map.y}) {
        for (double& entry : *axis) {
            const double whole = std::round(entry);
            entry = std::abs(entry - whole) < noTurn ? whole : entry;
        }
    }
    return map;
}

bool isIdentity(const Affine& map) {
    return map.x == Vec2(1, 0) && map.y == Vec2(0, 1);
}

void map(std::vector<Vec2>& vertices, const Affine& by) {
    for (Vec2& vertex : vertices) {
        vertex = tidied(by(vertex));
    }
}

void mapShape(LevelShape& shape, const Affine& by) {
    const bool mirrors = by.determinant() < 0;
    const auto chain = [&](std::vector<Vec2>& vertices, bool closed) {
        map(vertices, by);
        if (mirrors) {
            reverse(vertices, closed);
        }
    };
    std::visit(Overloaded{[&](EdgeChain& of) {
                              chain(of.vertices, of.closed);
                              of.depth = tidied(of.depth * std::sqrt(std::abs(by.determinant())));
                          },
                          [&](LineChain& of) { chain(of.vertices, of.closed); },
                          [&](Polygon& of) { chain(of.vertices, true); },
                          [&](Circle& of) {
                              of.center = tidied(by(of.center));
                              of.radius = tidied(of.radius * std::sqrt(std::abs(by.determinant())));
                          }},
               shape);
}

} // namespace

std::optional<Transform> poseOf(const ObjectData& data) {
    using Pose = std::optional<Transform>;
    return std::visit(Overloaded{[](const BodyObject& body) -> Pose {
                                     return Transform{body.position, Rot::fromAngle(body.angle)};
                                 },
                                 [](const ShipObject& ship) -> Pose {
                                     return Transform{ship.position, Rot::fromAngle(ship.angle)};
                                 },
                                 [](const PayloadObject& payload) -> Pose {
                                     return Transform{payload.position, {}};
                                 },
                                 [](const FinishObject&) -> Pose { return {}; },
                                 [](const ConnectorObject&) -> Pose { return {}; },
                                 [](const GroupObject&) -> Pose { return {}; }},
                      data);
}

std::optional<Vec2> placeOf(const ObjectData& data) {
    if (const std::optional<Transform> pose = poseOf(data)) {
        return pose->position;
    }
    const auto* finish = std::get_if<FinishObject>(&data);
    return finish == nullptr ? std::nullopt : std::optional(finish->a);
}

Aabb ownBounds(const ObjectData& data) {
    Aabb box;
    std::visit(Overloaded{[&](const BodyObject& body) {
                              const Transform pose{body.position, Rot::fromAngle(body.angle)};
                              for (const LevelShape& shape : body.shapes) {
                                  include(box, shape, pose);
                              }
                          },
                          [&](const ShipObject& ship) {
                              const Transform pose{ship.position, Rot::fromAngle(ship.angle)};
                              for (const Vec2& corner : shipOutline()) {
                                  box.include(pose.toWorld(corner));
                              }
                          },
                          [&](const PayloadObject& payload) {
                              include(box, Circle{payload.position, payload.radius}, {});
                          },
                          [&](const FinishObject& finish) {
                              box.include(finish.a);
                              box.include(finish.b);
                          },
                          [](const ConnectorObject&) {}, [](const GroupObject&) {}},
               data);
    return box;
}

std::optional<std::array<Vec2, 2>> endsOf(const ConnectorObject& connector, const ObjectList& objects) {
    std::array<Vec2, 2> ends;
    int end = 0;
    for (const auto& [key, anchor] : {std::pair(connector.a, connector.anchorA), {connector.b, connector.anchorB}}) {
        const Object* object = objects.find(key);
        if (object == nullptr || !std::holds_alternative<BodyObject>(object->data)) {
            return {};
        }
        ends[static_cast<std::size_t>(end++)] = poseOf(object->data)->toWorld(anchor);
    }
    return ends;
}

void move(ObjectData& data, const Vec2& delta) {
    const auto shift = [&delta](Vec2& point) { point = tidied(point + delta); };
    std::visit(Overloaded{[&](BodyObject& body) { shift(body.position); },
                          [&](ShipObject& ship) { shift(ship.position); },
                          [&](PayloadObject& payload) { shift(payload.position); },
                          [&](FinishObject& finish) {
                              shift(finish.a);
                              shift(finish.b);
                          },
                          [](ConnectorObject&) {}, [](GroupObject&) {}},
               data);
}

Affine localMap(const BodyObject& body, const Affine& map) {
    const Rot before = Rot::fromAngle(body.angle);
    const Rot back = Rot::fromAngle(angleAfter(map, body.angle)).inverse();
    return rounded({back * map.linear(before.right()), back * map.linear(before.up()), {0, 0}});
}

void transform(ObjectData& data, const Affine& map) {
    const auto mapPoint = [&map](Vec2& point) { point = tidied(map(point)); };
    std::visit(Overloaded{[&](BodyObject& body) {
                              const Affine local = localMap(body, map);
                              mapPoint(body.position);
                              body.angle = angleAfter(map, body.angle);
                              if (!isIdentity(local)) {
                                  for (LevelShape& shape : body.shapes) {
                                      mapShape(shape, local);
                                  }
                              }
                          },
                          [&](ShipObject& ship) {
                              mapPoint(ship.position);
                              ship.angle = angleAfter(map, ship.angle);
                          },
                          [&](PayloadObject& payload) {
                              mapPoint(payload.position);
                              payload.radius = tidied(payload.radius * std::sqrt(std::abs(map.determinant())));
                          },
                          [&](FinishObject& finish) {
                              mapPoint(finish.a);
                              mapPoint(finish.b);
                          },
                          [](ConnectorObject&) {}, [](GroupObject&) {}},
               data);
}

void reverse(std::vector<Vec2>& vertices, bool closed) {
    std::reverse(vertices.begin() + (closed && !vertices.empty() ? 1 : 0), vertices.end());
}

} // namespace spacetow
