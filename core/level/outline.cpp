#include "core/level/outline.h"

#include "core/base/overloaded.h"
#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <limits>

namespace spacetow {

namespace {

std::vector<Vec2> inWorld(std::vector<Vec2> points, const Transform& pose) {
    for (Vec2& point : points) {
        point = pose.toWorld(point);
    }
    return points;
}

void addShape(Outline& outline, const LevelShape& shape, const Transform& pose) {
    std::visit(Overloaded{[&](const EdgeChain& chain) {
                              outline.paths.push_back({inWorld(chain.vertices, pose), chain.closed, false});
                          },
                          [&](const LineChain& chain) {
                              outline.paths.push_back({inWorld(chain.vertices, pose), chain.closed, false});
                          },
                          [&](const Polygon& polygon) {
                              outline.paths.push_back({inWorld(polygon.vertices, pose), true, true});
                          },
                          [&](const Circle& circle) {
                              outline.discs.push_back({pose.toWorld(circle.center), circle.radius});
                          }},
               shape);
}

/// Calls `visit` with both ends of each segment until it returns true; a lone point is a segment of no length.
template <class Visit>
bool anySegment(const OutlinePath& path, Visit visit) {
    const std::size_t count = path.points.size();
    const std::size_t segments = path.closed || count < 2 ? count : count - 1;
    for (std::size_t i = 0; i < segments; ++i) {
        if (visit(path.points[i], path.points[(i + 1) % count])) {
            return true;
        }
    }
    return false;
}

} // namespace

Outline Outlines::of(const Object& object) const {
    Outline outline;
    const std::optional<Transform> pose = poseOf(object);
    std::visit(Overloaded{[&](const BodyObject& body) {
                              for (const LevelShape& shape : body.shapes) {
                                  addShape(outline, shape, *pose);
                              }
                          },
                          [&](const ShipObject&) {
                              const auto hull = shipOutline();
                              outline.paths.push_back({inWorld({hull.begin(), hull.end()}, *pose), true, true});
                          },
                          [&](const PayloadObject& payload) {
                              outline.discs.push_back({payload.position, payload.radius});
                          },
                          [&](const FinishObject& finish) {
                              outline.paths.push_back({{finish.a, finish.b}, false, false});
                          },
                          [&](const ConnectorObject& connector) {
                              if (const auto ends = endsOf(connector, m_objects)) {
                                  outline.paths.push_back({{ends->front(), ends->back()}, false, false});
                              }
                          },
                          [](const GroupObject&) {}},
               object.data);
    std::erase_if(outline.paths, [](const OutlinePath& path) { return path.points.empty(); });
    return outline;
}

Aabb boundsOf(const Outline& outline) {
    Aabb box;
    for (const OutlinePath& path : outline.paths) {
        for (const Vec2& point : path.points) {
            box.include(point);
        }
    }
    for (const Circle& disc : outline.discs) {
        box.include(Aabb{disc.center, disc.center}.grown(disc.radius));
    }
    return box;
}

double distanceTo(const Outline& outline, const Vec2& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const OutlinePath& path : outline.paths) {
        if (path.filled && contains(path.points, point)) {
            return 0;
        }
        anySegment(path, [&](const Vec2& a, const Vec2& b) {
            nearest = std::min(nearest, (closestOnSegment(a, b, point) - point).norm());
            return false;
        });
    }
    for (const Circle& disc : outline.discs) {
        nearest = std::min(nearest, std::max(0.0, (point - disc.center).norm() - disc.radius));
    }
    return nearest;
}

bool touches(const Outline& outline, const Aabb& box) {
    for (const OutlinePath& path : outline.paths) {
        // With no side in the box, either all of the box lies inside the path or nothing of it.
        if (anySegment(path, [&](const Vec2& a, const Vec2& b) { return segmentMeets(a, b, box); }) ||
            (path.filled && contains(path.points, box.center()))) {
            return true;
        }
    }
    return std::any_of(outline.discs.begin(), outline.discs.end(), [&](const Circle& disc) {
        const Vec2 nearest = disc.center.cwiseMax(box.min).cwiseMin(box.max);
        return (nearest - disc.center).norm() <= disc.radius;
    });
}

PointSum pointsOf(const Outline& outline) {
    PointSum points;
    for (const OutlinePath& path : outline.paths) {
        for (const Vec2& point : path.points) {
            points.sum += point;
            ++points.count;
        }
    }
    for (const Circle& disc : outline.discs) {
        points.sum += disc.center;
        ++points.count;
    }
    return points;
}

} // namespace spacetow
