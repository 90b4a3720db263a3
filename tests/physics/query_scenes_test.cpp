#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

#include "core/base/random.h"
#include "core/geometry/bounds.h"
#include "core/geometry/closest.h"
#include "core/geometry/convex_parts.h"
#include "core/geometry/intersect.h"
#include "core/physics/query/queries.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::uint64_t sceneCount() {
    return usualOrThin(10000, 2000);
}

Vec2 randomPoint(Random& random, double reach) {
    const double x = random.uniform(-reach, reach);
    return {x, random.uniform(-reach, reach)};
}

/// Simple, and concave in many places.
Polygon randomStar(Random& random) {
    const int corners = 3 + static_cast<int>(random.below(8));
    Polygon star;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * (i + random.uniform(0, 0.7)) / corners;
        star.vertices.push_back(random.uniform(0.2, 1) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return star;
}

Shape randomQueryShape(Random& random) {
    switch (random.below(5)) {
    case 0: {
        const Vec2 center = randomPoint(random, 0.5);
        return Circle{center, random.uniform(0.05, 0.8)};
    }
    case 1: {
        const Vec2 a = randomPoint(random, 1);
        const Vec2 b = randomPoint(random, 1);
        return Edge{a, b, random.below(2) == 0 ? noBack : random.uniform(0, 0.5)};
    }
    case 2: {
        const Vec2 a = randomPoint(random, 1);
        return Line{a, randomPoint(random, 1)};
    }
    case 3:
        return Polygon{regularPolygon(3 + static_cast<int>(random.below(9)), random.uniform(0.1, 0.8))};
    default:
        for (;;) {
            const Polygon star = randomStar(random);
            if (isSimple(star.vertices) && signedArea(star.vertices) > 0) {
                return star;
            }
        }
    }
}

World randomQueryWorld(Random& random) {
    World world;
    const std::uint32_t count = random.below(14);
    for (std::uint32_t i = 0; i < count; ++i) {
        BodyDef def{.shapes = {randomQueryShape(random)}, .position = randomPoint(random, 4)};
        if (random.below(4) == 0) {
            def.shapes.push_back(randomQueryShape(random));
        }
        def.kind = static_cast<BodyKind>(random.below(3));
        def.angle = random.uniform(-3, 3);
        def.active = random.below(8) != 0;
        def.tangible = random.below(4) != 0;
        def.filter.tags = TagMask{random.below(8) << 29};
        add(world, def);
    }
    return world;
}

/// A shape in the world, as an outline (closed for polygons) or a circle.
struct Placed {
    const Shape& shape;
    Transform pose;

    Vec2 operator()(const Vec2& local) const { return pose.toWorld(local); }

    /// Each side; what is solid lies to its left.
    template <class Visit>
    void forEachSide(const Visit& visit) const {
        if (const auto* polygon = std::get_if<Polygon>(&shape)) {
            for (std::size_t i = 0; i < polygon->vertices.size(); ++i) {
                visit((*this)(polygon->vertices[i]), (*this)(polygon->vertices[(i + 1) % polygon->vertices.size()]));
            }
        } else if (const auto* line = std::get_if<Line>(&shape)) {
            visit((*this)(line->a), (*this)(line->b));
            visit((*this)(line->b), (*this)(line->a));
        } else if (const auto* edge = std::get_if<Edge>(&shape)) {
            visit((*this)(edge->b), (*this)(edge->a)); // free on its left
        }
    }

    const Circle* circle() const { return std::get_if<Circle>(&shape); }
};

/// Where the ray first comes in from outside; nothing, if it does not.
std::optional<double> bruteRay(const Placed& placed, const Vec2& from, const Vec2& to) {
    const Vec2 way = to - from;
    if (const Circle* circle = placed.circle()) {
        const Vec2 s = from - placed(circle->center);
        const double half = s.dot(way) / way.squaredNorm();
        const double root = half * half - (s.squaredNorm() - circle->radius * circle->radius) / way.squaredNorm();
        const double t = root >= 0 ? -half - std::sqrt(root) : -1;
        return t >= 0 && t <= 1 ? std::optional<double>(t) : std::nullopt;
    }
    std::optional<double> first;
    placed.forEachSide([&](const Vec2& a, const Vec2& b) {
        const Vec2 outward = -leftOf(b - a);
        const double along = outward.dot(way);
        if (along >= 0) {
            return;
        }
        const double t = outward.dot(a - from) / along;
        const double s = (from + t * way - a).dot(b - a) / (b - a).squaredNorm();
        if (t >= 0 && t <= 1 && s >= 0 && s <= 1 && (!first || t < *first)) {
            first = t;
        }
    });
    return first;
}

bool isInside(const Placed& placed, const Vec2& p) {
    if (const Circle* circle = placed.circle()) {
        return (p - placed(circle->center)).norm() <= circle->radius;
    }
    const auto* polygon = std::get_if<Polygon>(&placed.shape);
    return polygon != nullptr && contains(polygon->vertices, placed.pose.toLocal(p));
}

double distanceFrom(const Placed& placed, const Vec2& p) {
    if (isInside(placed, p)) {
        return 0;
    }
    if (const Circle* circle = placed.circle()) {
        return (p - placed(circle->center)).norm() - circle->radius;
    }
    double least = noBack;
    placed.forEachSide(
        [&](const Vec2& a, const Vec2& b) { least = std::min(least, (closestOnSegment(a, b, p) - p).norm()); });
    return least;
}

Aabb boxOf(const Placed& placed) {
    Aabb box;
    if (const Circle* circle = placed.circle()) {
        box.include(placed(circle->center));
        return box.grown(circle->radius);
    }
    placed.forEachSide([&](const Vec2& a, const Vec2& b) {
        box.include(a);
        box.include(b);
    });
    if (const auto* edge = std::get_if<Edge>(&placed.shape)) {
        const double depth = std::isinf(edge->depth) ? noBackReach : edge->depth;
        const Vec2 back = placed.pose.rotation * (-depth * leftOf(edge->b - edge->a).normalized());
        box.include(placed(edge->a) + back);
        box.include(placed(edge->b) + back);
    }
    return box;
}

template <class Visit>
void forEachShape(const World& world, const Visit& visit) {
    for (const BodyId id : world.bodies()) {
        if (world.body(id).active) {
            for (const Shape& shape : world.shapes(id)) {
                visit(id, Placed{shape, world.body(id).pose});
            }
        }
    }
}

Aabb boxOf(const World& world, BodyId id) {
    Aabb box;
    for (const Shape& shape : world.shapes(id)) {
        box.include(boxOf(Placed{shape, world.body(id).pose}));
    }
    return box;
}

/// Some bodies have been added, moved or told to go since the last update, which nothing but the tree needs to know.
World unsettledWorld(Random& random) {
    World world = randomQueryWorld(random);
    const std::uint32_t change = random.below(4);
    if (change == 0) {
        return world;
    }
    world.setParameters({.gravity = {0, 0}, .iterations = 1});
    for (const BodyId id : world.bodies()) {
        world.setTangible(id, false);
    }
    world.update();
    if (change > 1 && world.bodyCount() > 0) {
        const std::vector<BodyId> ids = world.bodies();
        const BodyId id = ids[random.below(static_cast<std::uint32_t>(ids.size()))];
        world.setPose(id, randomPoint(random, 4), random.uniform(-3, 3));
        add(world, {.kind = static_cast<BodyKind>(random.below(3)),
                    .shapes = {randomQueryShape(random)},
                    .position = randomPoint(random, 4)});
    }
    if (change > 2 && world.bodyCount() > 0) {
        world.removeBody(world.bodies().front());
        world.setActive(world.bodies().back(), false);
        world.update();
    }
    return world;
}

} // namespace

class QueryScenesTest : public QObject {
    Q_OBJECT

  private slots:
    void raysAgreeWithEverySideOfEveryShape() {
        int hits = 0;
        for (std::uint64_t seed = 1; seed <= sceneCount(); ++seed) {
            Random random(seed);
            const World world = unsettledWorld(random);
            for (int ray = 0; ray < 10; ++ray) {
                const Vec2 from = randomPoint(random, 6);
                const Vec2 to = randomPoint(random, 6);
                const TagMask mask = random.below(2) == 0 ? TagMask::all() : TagMask{random.below(8) << 29};
                std::optional<double> first;
                forEachShape(world, [&](BodyId id, const Placed& placed) {
                    const auto t = bruteRay(placed, from, to);
                    if (t && world.body(id).filter.tags.intersects(mask) && (!first || *t < *first)) {
                        first = t;
                    }
                });
                const auto hit = rayCast(world, from, to, mask);
                QVERIFY2(hit.has_value() == first.has_value(), seedText(seed));
                if (!hit) {
                    continue;
                }
                ++hits;
                QVERIFY2(std::abs(hit->fraction - *first) < 1e-9, seedText(seed));
                QVERIFY2((hit->point - from - hit->fraction * (to - from)).norm() < 1e-12, seedText(seed));
                QVERIFY2(hit->normal.dot(to - from) < 0 && std::abs(hit->normal.norm() - 1) < 1e-9, seedText(seed));
                double nearest = noBack;
                for (const Shape& shape : world.shapes(hit->body)) {
                    const auto t = bruteRay({shape, world.body(hit->body).pose}, from, to);
                    nearest = t ? std::min(nearest, std::abs(*t - hit->fraction)) : nearest;
                }
                QVERIFY2(nearest < 1e-9, seedText(seed));
            }
        }
        QVERIFY(hits > static_cast<int>(sceneCount()));
    }

    void pointsAgreeWithEveryShape() {
        int found = 0;
        for (std::uint64_t seed = 1; seed <= sceneCount(); ++seed) {
            Random random(seed);
            const World world = unsettledWorld(random);
            for (int i = 0; i < 10; ++i) {
                const Vec2 p = randomPoint(random, 4);
                std::vector<BodyId> expected;
                forEachShape(world, [&](BodyId id, const Placed& placed) {
                    if (isInside(placed, p) && (expected.empty() || expected.back() != id)) {
                        expected.push_back(id);
                    }
                });
                found += static_cast<int>(expected.size());
                QVERIFY2(bodiesAt(world, p) == expected, seedText(seed));
            }
        }
        QVERIFY2(found > static_cast<int>(sceneCount()) / 4, qPrintable(QString::number(found)));
    }

    void boxesAgreeWithTheShapesOfEveryBody() {
        int hits = 0;
        for (std::uint64_t seed = 1; seed <= sceneCount(); ++seed) {
            Random random(seed);
            const World world = unsettledWorld(random);
            for (int i = 0; i < 10; ++i) {
                const Vec2 corner = randomPoint(random, 5);
                const Vec2 size(random.uniform(0, 2), random.uniform(0, 2));
                const Aabb area{corner, corner + size};
                std::vector<BodyId> expected;
                for (const BodyId id : world.bodies()) {
                    if (world.body(id).active && boxOf(world, id).overlaps(area)) {
                        expected.push_back(id);
                    }
                }
                hits += static_cast<int>(expected.size());
                QVERIFY2(bodiesIn(world, area) == expected, seedText(seed));
            }
        }
        QVERIFY(hits > 1000);
    }

    void theClosestBodyIsTheNearestOfAll() {
        int found = 0;
        for (std::uint64_t seed = 1; seed <= sceneCount(); ++seed) {
            Random random(seed);
            const World world = unsettledWorld(random);
            for (int i = 0; i < 10; ++i) {
                const Vec2 p = randomPoint(random, random.below(4) == 0 ? 100 : 6);
                const TagMask mask = random.below(2) == 0 ? TagMask::all() : TagMask{random.below(8) << 29};
                const double reach = random.below(2) == 0 ? noBack : random.uniform(0, 5);
                double least = noBack;
                BodyId first;
                forEachShape(world, [&](BodyId id, const Placed& placed) {
                    const double distance = distanceFrom(placed, p);
                    if (world.body(id).filter.tags.intersects(mask) && distance < least - 1e-9) {
                        least = distance;
                        first = id;
                    }
                });
                const auto nearest = closestBody(world, p, {reach, mask});
                if (std::abs(least - reach) < 1e-9) {
                    continue;
                }
                QVERIFY2(nearest.has_value() == (least < reach), seedText(seed));
                if (!nearest) {
                    continue;
                }
                ++found;
                QVERIFY2(std::abs(nearest->distance - least) < 1e-9, seedText(seed));
                QVERIFY2(std::abs((nearest->point - p).norm() - nearest->distance) < 1e-12, seedText(seed));
                double ofBody = noBack;
                for (const Shape& shape : world.shapes(nearest->body)) {
                    ofBody = std::min(ofBody, distanceFrom({shape, world.body(nearest->body).pose}, nearest->point));
                }
                QVERIFY2(ofBody < 1e-9, seedText(seed));
                QVERIFY2(least > 0 || nearest->body == first, seedText(seed)); // inside of several: the first of them
            }
        }
        QVERIFY(found > static_cast<int>(sceneCount()));
    }

    void theClosestPointIsAsNearAsAnyOfTheOutline() {
        for (std::uint64_t seed = 1; seed <= sceneCount(); ++seed) {
            Random random(seed);
            const World world = randomQueryWorld(random);
            const Vec2 p = randomPoint(random, 5);
            forEachShape(world, [&](BodyId, const Placed& placed) {
                double least = noBack;
                Vec2 nearest(0, 0);
                for (const Part& part : partsOf(placed.shape)) {
                    const Vec2 on = closestPoint(part, placed.pose, p);
                    nearest = (on - p).norm() < least ? on : nearest;
                    least = std::min(least, (on - p).norm());
                }
                QVERIFY2(std::abs(least - distanceFrom(placed, p)) < 1e-9, seedText(seed));
                QVERIFY2(distanceFrom(placed, nearest) < 1e-9, seedText(seed));
            });
        }
    }
};

SPACETOW_TEST(QueryScenesTest)
#include "query_scenes_test.moc"
