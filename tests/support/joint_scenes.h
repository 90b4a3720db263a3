#pragma once
// A body that lies on a floor of two pieces, or slides over it, so that a corner of it passes the joint as near as one
// likes. SI units.

#include "tests/support/contact_scenes.h"

#include "core/base/random.h"

namespace spacetow::test {

/// Of two pieces that meet at the origin: as two bodies or one, straight ahead but for `miss`.
struct JointedFloor {
    QString walls; // "edges", "thin edges", "lines", "boxes", "uneven boxes"
    QString then;  // the second piece, where that is of another kind
    bool oneBody = false;
    double angle = 0;   // rad
    Vec2 miss{0, 0};    // m, of the second piece, along the floor and above it
    bool whole = false; // one piece only, to compare with
};

/// Of a floor at this angle.
inline Shape pieceOf(const QString& walls, const Rot& rotation, const Vec2& a, const Vec2& b, double thick) {
    const Vec2 from = rotation * a;
    const Vec2 to = rotation * b;
    if (walls == "lines") {
        return Line{from, to};
    }
    if (walls == "edges" || walls == "thin edges") {
        return Edge{from, to, walls == "edges" ? noBack : 0};
    }
    const Vec2 down = rotation * Vec2(0, -thick);
    return Polygon{{from, from + down, to + down, to}};
}

inline void addJointedFloor(World& world, const JointedFloor& floor) {
    const Vec2 end(60, 0);
    const Rot rotation = Rot::fromAngle(floor.angle);
    const double secondThick = floor.walls == "uneven boxes" ? 2 : 1;
    std::vector<Shape> shapes{pieceOf(floor.walls, rotation, {-10, 0}, floor.whole ? end : Vec2(0, 0), 1)};
    if (!floor.whole) {
        const QString& second = floor.then.isEmpty() ? floor.walls : floor.then;
        shapes.push_back(pieceOf(second, rotation, floor.miss, end + floor.miss, secondThick));
    }
    BodyDef body{.kind = BodyKind::Static, .friction = 0};
    for (const Shape& shape : shapes) {
        body.shapes.push_back(shape);
        if (!floor.oneBody) {
            add(world, body);
            body.shapes.clear();
        }
    }
    if (floor.oneBody) {
        add(world, body);
    }
}

/// A polygon that lies flat, with its centroid at the origin.
struct Lying {
    Polygon outline;
    double left = 0, right = 0, low = 0; // m, of its base
};

/// Turned until the side of its convex hull that is over the centroid lies on the ground; nothing when there is none.
inline std::optional<Lying> lying(Polygon outline) {
    const Vec2 center = centroid(outline.vertices);
    for (Vec2& v : outline.vertices) {
        v -= center;
    }
    const std::vector<Vec2> corners = outline.vertices;
    for (const Vec2& a : corners) {
        for (const Vec2& b : corners) {
            const Vec2 along = b - a;
            const double share = along.dot(-a) / along.squaredNorm();
            const bool isSide = a != b && std::all_of(corners.begin(), corners.end(),
                                                      [&](const Vec2& c) { return cross(along, c - a) > -1e-12; });
            if (!isSide || share < 0.1 || share > 0.9) {
                continue;
            }
            const Rot back = Rot::fromAngle(-std::atan2(along.y(), along.x()));
            Lying result{outline, (back * a).x(), (back * b).x(), (back * a).y()};
            for (Vec2& v : result.outline.vertices) {
                v = back * v;
                v.y() = std::abs(v.y() - result.low) < 1e-12 ? result.low : v.y();
            }
            return result;
        }
    }
    return std::nullopt;
}

/// Round `count` corners at the radii that `radius` gives.
template <class Radius>
Polygon randomOutline(Random& random, int count, const Radius& radius) {
    Polygon outline;
    for (int i = 0; i < count; ++i) {
        const Rot direction = Rot::fromAngle(2 * pi * (i + random.uniform(-0.3, 0.3)) / count);
        outline.vertices.push_back(radius(i) * direction.right());
    }
    return outline;
}

inline Polygon lyingShapeOf(const QString& what, Random& random) {
    if (what == "bar") {
        return Polygon{{{-0.5, -0.01}, {0.5, -0.01}, {0.5, 0.01}, {-0.5, 0.01}}};
    }
    if (what == "convex") {
        return randomOutline(random, 3 + static_cast<int>(random.below(5)), [](int) { return 0.3; });
    }
    if (what == "concave") {
        const int count = 5 + static_cast<int>(random.below(6));
        return randomOutline(random, count,
                             [&](int i) { return i % 2 == 1 ? random.uniform(0.1, 0.2) : random.uniform(0.24, 0.3); });
    }
    return std::get<Polygon>(dropped(what, {0, 0}).shapes.front());
}

/// How a corner of the base passes the joint.
struct Crossing {
    Polygon outline;
    bool leading = false; // its right corner
    double beside = 0;    // m: there it is at the beginning of an iteration
    double speed = 0;     // m/s
    int iterations = 4;
};

/// The worst that happens to what should not feel the joint.
struct Felt {
    double speed = 0; // m/s, of change
    double turn = 0;  // rad
    double hop = 0;   // m
};

inline Felt passed(const JointedFloor& floor, const Crossing& passage, const Lying& body) {
    const Rot rotation = Rot::fromAngle(floor.angle);
    World world(withIterations(passage.iterations, rotation * Vec2(0, -9.81)));
    addJointedFloor(world, floor);
    const double perIteration = passage.speed * 0.02 / passage.iterations;
    const double before = passage.speed > 0 ? std::ceil((passage.leading ? 0.1 : 0.05) / perIteration) : 0;
    const double corner = passage.leading ? body.right : body.left;
    BodyDef def{.shapes = {body.outline}, .friction = 0};
    def.position = rotation * Vec2(passage.beside - corner - before * perIteration, -body.low);
    def.angle = floor.angle;
    def.velocity = rotation * Vec2(passage.speed, 0);
    const BodyId id = add(world, def);
    const Vec2 start = rotation.inverse() * world.body(id).massCenter;
    const int updates = passage.speed > 0 ? static_cast<int>(before / passage.iterations) + 12 : 20;
    Felt felt;
    for (int i = 0; i < updates; ++i) {
        world.update();
        const BodyState state = world.body(id);
        const Vec2 velocity = rotation.inverse() * state.velocity;
        const Vec2 center = rotation.inverse() * state.massCenter;
        felt.speed = std::max(felt.speed, std::abs(velocity.x() - passage.speed));
        felt.turn = std::max(felt.turn, std::abs(std::remainder(state.angle - floor.angle, 2 * pi)));
        felt.hop = std::max(felt.hop, std::abs(center.y() - start.y()));
    }
    return felt;
}

} // namespace spacetow::test
