#include "core/level/level_index.h"

#include "core/geometry/intersect.h"
#include "core/level/bounds.h"
#include "core/level/edits.h"
#include "tests/support/full_run.h"
#include "tests/support/move_object.h"
#include "tests/support/random_level.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A wall that wanders about, long enough for a tree of its own.
Object wanderer(Random& random, Key key) {
    std::vector<Vec2> points;
    Vec2 at(0, 0);
    for (unsigned i = 2 + random.below(300); i > 0; --i) {
        points.push_back(at);
        at += Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
    }
    BodyObject body;
    body.position = Vec2(random.uniform(-10, 10), random.uniform(-10, 10));
    body.angle = random.below(3) == 0 ? 0 : random.uniform(-3, 3);
    const bool closed = random.below(2) == 0;
    switch (random.below(3)) {
    case 0:
        body.shapes.emplace_back(EdgeChain{points, closed, random.below(2) == 0 ? noBack : random.uniform(0, 2)});
        break;
    case 1:
        body.shapes.emplace_back(LineChain{points, closed});
        break;
    default:
        body.shapes.emplace_back(Circle{{1, 1}, random.uniform(0.1, 2)});
        body.shapes.emplace_back(Polygon{points});
    }
    return {key, {}, std::move(body), {}};
}

Object connectorBetween(Random& random, const Level& level, Key key) {
    ConnectorObject connector;
    const auto some = [&] {
        return level.objects[static_cast<int>(random.below(static_cast<unsigned>(level.objects.size())))].key;
    };
    connector.a = some();
    connector.b = random.below(6) == 0 ? 1 : some(); // the key 1 is nobody's
    connector.anchorA = Vec2(random.uniform(-1, 1), 0);
    return {key, {}, connector, {}};
}

Level manyObjects(Random& random) {
    Level level = randomLevel(random.next(), static_cast<int>(random.below(20)));
    // Where levels may be, see fields.h; further out segments are too long for the arithmetic.
    const Level far = level;
    level.objects.eraseIf([&far](const Object& object) {
        const Aabb box = boundsOf(far, object);
        return !box.isEmpty() && std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff()) > 1e6;
    });
    for (unsigned i = random.below(600); i > 0; --i) {
        const Key key = freshKey(level, random.next());
        level.objects.append(i % 7 == 0 && !level.objects.empty() ? connectorBetween(random, level, key)
                                                                  : wanderer(random, key));
    }
    return level;
}

std::vector<Key> someKeys(Random& random, const Level& level) {
    std::vector<Key> keys;
    const unsigned share = 1 + random.below(60);
    for (const Object& object : level.objects) {
        if (random.below(share) == 0) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

/// As tools and panels do it, and a little worse.
Level edited(Level level, Random& random) {
    const std::vector<Key> keys = someKeys(random, level);
    switch (random.below(7)) {
    case 0:
        return moved(std::move(level), keys, Vec2(random.uniform(-3, 3), random.uniform(-3, 3)));
    case 1:
        return removed(std::move(level), keys);
    case 2:
        return rotated(std::move(level), keys, Vec2(1, 2), random.uniform(-2, 2));
    case 3:
        return reversed(std::move(level), keys);
    case 4:
        level.objects.insert(static_cast<int>(random.below(static_cast<unsigned>(level.objects.size()) + 1)),
                             wanderer(random, freshKey(level, random.next())));
        return level;
    case 5:
        if (level.objects.size() > 1) {
            moveObject(level.objects, 0, static_cast<int>(random.below(static_cast<unsigned>(level.objects.size()))));
        }
        return level;
    default:
        level.objects.append(wanderer(random, freshKey(level, random.next())));
        return level;
    }
}

Aabb randomBox(Random& random) {
    const Vec2 corner(random.uniform(-15, 15), random.uniform(-15, 15));
    return {corner, corner + Vec2(random.uniform(0, 6), random.uniform(0, 6))};
}

struct Segment {
    SegmentRef ref;
    Vec2 a, b;
    bool operator==(const Segment&) const = default;
};

/// Every segment, without an index.
std::vector<Segment> segmentsOf(const Level& level) {
    std::vector<Segment> all;
    const auto add = [&all](int object, int shape, const std::vector<Vec2>& points, bool closed) {
        const std::size_t count = points.size();
        for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
            all.push_back({{object, shape, static_cast<int>(i)}, points[i], points[(i + 1) % count]});
        }
    };
    for (int i = 0; i < level.objects.size(); ++i) {
        const ObjectData& data = level.objects[i].data;
        if (const auto* body = std::get_if<BodyObject>(&data)) {
            const Transform pose{body->position, Rot::fromAngle(body->angle)};
            int number = 0;
            for (const LevelShape& shape : body->shapes) {
                std::vector<Vec2> points;
                bool closed = true;
                if (const auto* edges = std::get_if<EdgeChain>(&shape)) {
                    points = edges->vertices;
                    closed = edges->closed;
                } else if (const auto* lines = std::get_if<LineChain>(&shape)) {
                    points = lines->vertices;
                    closed = lines->closed;
                } else if (const auto* polygon = std::get_if<Polygon>(&shape)) {
                    points = polygon->vertices;
                }
                for (Vec2& point : points) {
                    point = pose.toWorld(point);
                }
                add(i, number++, points, closed);
            }
        } else if (const auto* ship = std::get_if<ShipObject>(&data)) {
            const Transform pose{ship->position, Rot::fromAngle(ship->angle)};
            std::vector<Vec2> points;
            for (const Vec2& corner : shipOutline()) {
                points.push_back(pose.toWorld(corner));
            }
            add(i, 0, points, true);
        } else if (const auto* finish = std::get_if<FinishObject>(&data)) {
            add(i, 0, {finish->a, finish->b}, false);
        } else if (const auto* connector = std::get_if<ConnectorObject>(&data)) {
            const Object* a = level.objects.find(connector->a);
            const Object* b = level.objects.find(connector->b);
            const auto* bodyA = a == nullptr ? nullptr : std::get_if<BodyObject>(&a->data);
            const auto* bodyB = b == nullptr ? nullptr : std::get_if<BodyObject>(&b->data);
            if (bodyA != nullptr && bodyB != nullptr) {
                add(i, 0,
                    {Transform{bodyA->position, Rot::fromAngle(bodyA->angle)}.toWorld(connector->anchorA),
                     Transform{bodyB->position, Rot::fromAngle(bodyB->angle)}.toWorld(connector->anchorB)},
                    false);
            }
        }
    }
    return all;
}

bool hasNodes(const ObjectData& data) {
    return std::holds_alternative<BodyObject>(data) || std::holds_alternative<FinishObject>(data);
}

/// Nothing, or what the index of the level says wrongly.
QByteArray fault(const Level& level, Random& random) {
    const LevelIndex& index = levelIndex(level);
    Aabb all;
    for (int i = 0; i < level.objects.size(); ++i) {
        const Aabb box = boundsOf(level, level.objects[i]);
        const bool isGroup = std::holds_alternative<GroupObject>(level.objects[i].data);
        const Aabb& found = index.boundsOf(i);
        if (!isGroup &&
            (found.isEmpty() != box.isEmpty() || (!box.isEmpty() && (found.min != box.min || found.max != box.max)))) {
            return "bounds of object " + QByteArray::number(i);
        }
        all.include(found);
    }
    if (all.isEmpty() != index.bounds().isEmpty() || (!all.isEmpty() && all.min != index.bounds().min)) {
        return "bounds of all";
    }
    const std::vector<Segment> segments = segmentsOf(level);
    for (int i = 0; i < 5; ++i) {
        const Aabb box = randomBox(random);
        std::vector<int> objects;
        std::vector<int> expectedObjects;
        index.visitObjects(box, [&](int object) { objects.push_back(object); });
        for (int object = 0; object < level.objects.size(); ++object) {
            if (index.boundsOf(object).overlaps(box)) {
                expectedObjects.push_back(object);
            }
        }
        std::vector<Segment> found;
        std::vector<Segment> expected;
        index.visitSegments(box, [&](const SegmentRef& ref, const Vec2& a, const Vec2& b) {
            found.push_back({ref, a, b});
        });
        std::vector<VertexRef> vertices;
        std::vector<VertexRef> expectedVertices;
        index.visitVertices(box, [&](const VertexRef& ref, const Vec2&) { vertices.push_back(ref); });
        for (const Segment& segment : segments) {
            if (segmentMeets(segment.a, segment.b, box)) {
                expected.push_back(segment);
            }
            const auto& [object, shape, number] = segment.ref;
            if (!hasNodes(level.objects[object].data)) {
                continue;
            }
            if (box.contains(segment.a)) {
                expectedVertices.push_back({object, shape, number});
            }
            const bool last = &segment == &segments.back() || (&segment + 1)->ref.object != object ||
                              (&segment + 1)->ref.shape != shape;
            const bool open =
                last && (segments[static_cast<std::size_t>(&segment - segments.data() - number)].a != segment.b);
            if (open && box.contains(segment.b)) {
                expectedVertices.push_back({object, shape, number + 1});
            }
        }
        if (objects != expectedObjects) {
            return "objects in a box";
        }
        if (found != expected) {
            const auto place = std::ranges::mismatch(found, expected);
            const Segment& at = place.in2 != expected.end() ? *place.in2 : *place.in1;
            return "segments in a box, first of object " + QByteArray::number(at.ref.object) + ", shape " +
                   QByteArray::number(at.ref.shape) + ", segment " + QByteArray::number(at.ref.segment);
        }
        if (vertices != expectedVertices) {
            return "vertices in a box";
        }
    }
    return {};
}

} // namespace

class LevelIndexTest : public QObject {
    Q_OBJECT

  private slots:
    void itFindsWhatBruteForceFindsAfterWhateverEdits() {
        const unsigned seeds = usualOrThin(fullOrQuick(300U, 16U), 6U);
        for (unsigned seed = 0; seed < seeds; ++seed) {
            Random random(seed);
            Level level = manyObjects(random);
            for (int i = 0; i < 12; ++i) {
                const QByteArray wrong = fault(level, random);
                QVERIFY2(wrong.isEmpty(), seedText(seed) + ": " + wrong);
                Level next = edited(level, random);
                if (random.below(3) == 0) {
                    next = edited(next, random); // without an index in between
                }
                level = random.below(4) == 0 ? level : next;
            }
        }
    }

    void theIndexOfALevelIsNotThatOfItsEditedCopy() {
        Random random(3);
        Level before;
        for (Key key = 1; key < 400; ++key) {
            before.objects.append(wanderer(random, key));
        }
        const Aabb box = levelIndex(before).bounds();
        const Level after = moved(before, std::array<Key, 2>{100, 300}, Vec2(500, 0));
        QVERIFY(levelIndex(after).bounds().max.x() > box.max.x() + 100);
        QCOMPARE(levelIndex(before).bounds().max.x(), box.max.x());
    }

    void matterReachesBehindWallsAsFarAsTheyAreDeep() {
        Level level;
        const auto add = [&level](bool closed, double depth) {
            BodyObject body;
            body.shapes.emplace_back(EdgeChain{{{0, 0}, {1, 0}, {1, 1}}, closed, depth});
            level.objects.append({static_cast<Key>(level.objects.size() + 1), {}, body, {}});
        };
        add(false, 2);
        add(false, noBack);
        add(true, noBack);
        const auto reaching = [&level](const Vec2& at) {
            std::vector<int> found;
            levelIndex(level).visitReaching({at, at}, [&](int object) { found.push_back(object); });
            return found;
        };
        QCOMPARE(reaching({0.5, -2}), (std::vector{0, 2}));
        QCOMPARE(reaching({0.5, -100}), (std::vector{2}));
        QCOMPARE(reaching({0.5, 0}), (std::vector{0, 1, 2}));
    }
};

SPACETOW_TEST(LevelIndexTest)
#include "level_index_test.moc"
