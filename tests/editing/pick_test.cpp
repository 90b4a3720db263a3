#include "editor/editing/pick.h"

#include "core/base/random.h"
#include "core/geometry/polygon.h"
#include "core/level/edits.h"
#include "core/level/outline.h"
#include "tests/support/drive.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numbers>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object objectWith(Key key, ObjectData data) {
    return {key, {}, std::move(data), {}};
}

LevelShape randomShape(Random& random) {
    switch (random.below(4)) {
    case 0:
        return Circle{{random.uniform(-0.5, 0.5), 0}, random.uniform(0.1, 1)};
    case 1: {
        std::vector<Vec2> corners = regularPolygon(3 + static_cast<int>(random.below(6)), random.uniform(0.2, 1.5));
        return Polygon{corners};
    }
    default:
        break;
    }
    std::vector<Vec2> points;
    for (std::uint32_t i = 0; i < 2 + random.below(5); ++i) {
        points.emplace_back(random.uniform(-2, 2), random.uniform(-2, 2));
    }
    if (random.below(2) == 0) {
        return EdgeChain{points, random.below(2) == 0, noBack};
    }
    return LineChain{points, random.below(2) == 0};
}

Level randomLevel(Random& random) {
    Level level;
    for (Key key = 1; key <= 12; ++key) {
        Object object = bodyWith(key, randomShape(random), {random.uniform(-4, 4), random.uniform(-4, 4)});
        std::get<BodyObject>(object.data).angle = random.uniform(-3, 3);
        level.objects.append(std::move(object));
    }
    level.objects.append(objectWith(13, ShipObject{{random.uniform(-4, 4), 0}, random.uniform(-3, 3)}));
    level.objects.append(objectWith(14, PayloadObject{{random.uniform(-4, 4), 1}, 0.2, 0.25}));
    level.objects.append(objectWith(15, FinishObject{{-1, random.uniform(-4, 4)}, {1, random.uniform(-4, 4)}}));
    ConnectorObject connector;
    connector.a = 1;
    connector.b = 2;
    connector.anchorA = {0.1, 0.2};
    level.objects.append(objectWith(16, connector));
    return level;
}

/// Many points on the object, filled ones included, found without the code under test.
std::vector<Vec2> samplesOf(const Outline& outline) {
    constexpr int steps = 60;
    std::vector<Vec2> samples;
    for (const OutlinePath& path : outline.paths) {
        const std::size_t count = path.points.size();
        for (std::size_t i = 0; i + (path.closed ? 0 : 1) < count; ++i) {
            for (int step = 0; step <= steps; ++step) {
                const Vec2 on =
                    path.points[i] + (path.points[(i + 1) % count] - path.points[i]) * (double(step) / steps);
                // The polygons of this test are seen whole from their centre of area.
                for (int inwards = 0; inwards <= (path.filled ? steps : 0); ++inwards) {
                    samples.emplace_back(on + (centroid(path.points) - on) * (double(inwards) / steps));
                }
            }
        }
    }
    for (const Circle& disc : outline.discs) {
        for (int turn = 0; turn < 2 * steps; ++turn) {
            for (int out = 0; out <= steps; ++out) {
                const double angle = std::numbers::pi * turn / steps;
                samples.emplace_back(disc.center +
                                     Vec2(std::cos(angle), std::sin(angle)) * (disc.radius * out / steps));
            }
        }
    }
    return samples;
}

std::vector<std::vector<Vec2>> samplesOf(const Level& level) {
    const Outlines outlines(level);
    std::vector<std::vector<Vec2>> samples;
    for (const Object& object : level.objects) {
        samples.push_back(samplesOf(outlines.of(object)));
    }
    return samples;
}

bool isIn(const std::vector<Key>& keys, Key key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

Level pileOfThree() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 3}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 1}));
    level.objects.append(bodyWith(3, Circle{{0, 0}, 1}));
    return level;
}

} // namespace

class PickTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsSampledNearThePointIsPicked();
    void whatIsSampledInTheBoxIsPicked();
    void onlyWhatLiesWhollyInTheBoxIsPicked();
    void smallGoesBeforeLargeAndLaterBeforeEarlier();
    void shipAndPayloadGoBeforeWalls();
    void movingBodiesGoBeforeWalls();
    void onlyFilledShapesHaveAnInside_data();
    void onlyFilledShapesHaveAnInside();
    void aConnectorWithoutAnEndIsNowhere();
    void theBandComesOutInTheOrderOfTheLevel();
};

/// A point sampled within the tolerance must be picked; nothing may be picked of which no sample is near.
void PickTest::whatIsSampledNearThePointIsPicked() {
    constexpr double tolerance = 0.15;
    constexpr double spacing = 0.1; // no point of an object is further from a sample
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        Random random(seed);
        const Level level = randomLevel(random);
        const std::vector<std::vector<Vec2>> samples = samplesOf(level);
        for (int i = 0; i < 20; ++i) {
            const Vec2 point(random.uniform(-5, 5), random.uniform(-5, 5));
            const std::vector<Key> keys = picked(level, point, tolerance);
            for (std::size_t j = 0; j < samples.size(); ++j) {
                double nearest = 1e9;
                for (const Vec2& sample : samples[j]) {
                    nearest = std::min(nearest, (sample - point).norm());
                }
                const bool found = isIn(keys, level.objects[static_cast<int>(j)].key);
                QVERIFY2(found || nearest > tolerance, seedText(seed));
                QVERIFY2(!found || nearest < tolerance + spacing, seedText(seed));
            }
        }
    }
}

void PickTest::whatIsSampledInTheBoxIsPicked() {
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        Random random(seed);
        const Level level = randomLevel(random);
        const std::vector<std::vector<Vec2>> samples = samplesOf(level);
        for (int i = 0; i < 20; ++i) {
            Aabb box;
            box.include(Vec2(random.uniform(-5, 5), random.uniform(-5, 5)));
            box.include(Vec2(box.min + Vec2(random.uniform(0.1, 3), random.uniform(0.1, 3))));
            const std::vector<Key> keys = pickedIn(level, box, false);
            for (std::size_t j = 0; j < samples.size(); ++j) {
                const auto inside = [&](const Aabb& area) {
                    return std::any_of(samples[j].begin(), samples[j].end(),
                                       [&](const Vec2& p) { return area.contains(p); });
                };
                const bool found = isIn(keys, level.objects[static_cast<int>(j)].key);
                QVERIFY2(found || !inside(box), seedText(seed));
                QVERIFY2(!found || inside(box.grown(0.1)), seedText(seed));
            }
        }
    }
}

void PickTest::onlyWhatLiesWhollyInTheBoxIsPicked() {
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        Random random(seed);
        const Level level = randomLevel(random);
        const std::vector<std::vector<Vec2>> samples = samplesOf(level);
        const Aabb box{{-random.uniform(1, 5), -random.uniform(1, 5)}, {random.uniform(1, 5), random.uniform(1, 5)}};
        const std::vector<Key> keys = pickedIn(level, box, true);
        for (std::size_t j = 0; j < samples.size(); ++j) {
            const auto allInside = [&](const Aabb& area) {
                return std::all_of(samples[j].begin(), samples[j].end(),
                                   [&](const Vec2& p) { return area.contains(p); });
            };
            const bool found = isIn(keys, level.objects[static_cast<int>(j)].key);
            QVERIFY2(!found || allInside(box.grown(1e-9)), seedText(seed));
            QVERIFY2(found || !allInside(box.grown(-0.01)), seedText(seed));
        }
    }
}

void PickTest::smallGoesBeforeLargeAndLaterBeforeEarlier() {
    QCOMPARE(picked(pileOfThree(), {0.5, 0}, 0.1), (std::vector<Key>{3, 2, 1}));
    QCOMPARE(picked(pileOfThree(), {2, 0}, 0.1), (std::vector<Key>{1}));
    QVERIFY(picked(pileOfThree(), {4, 0}, 0.1).empty());
}

void PickTest::shipAndPayloadGoBeforeWalls() {
    Level level;
    level.objects.append(objectWith(5, PayloadObject{{0, 0}, 2, 1}));
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.1}));
    level.objects.append(objectWith(6, ShipObject{}));
    QCOMPARE(picked(level, {0, 0.05}, 0.01), (std::vector<Key>{6, 5, 1}));
}

void PickTest::movingBodiesGoBeforeWalls() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 2}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 1}));
    Object ball = bodyWith(1, Circle{{0, 0}, 2});
    std::get<BodyObject>(ball.data).kind = BodyKind::Dynamic;
    level.objects.replace(0, ball);
    QCOMPARE(picked(level, {0, 0}, 0.01), (std::vector<Key>{1, 2}));
}

void PickTest::onlyFilledShapesHaveAnInside_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<bool>("hit");

    QTest::newRow("polygon") << 0 << true;
    QTest::newRow("circle") << 1 << true;
    QTest::newRow("closed edges") << 2 << false;
    QTest::newRow("closed lines") << 3 << false;
}

void PickTest::onlyFilledShapesHaveAnInside() {
    QFETCH(int, shape);
    QFETCH(bool, hit);
    const std::vector<Vec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    const std::array<LevelShape, 4> shapes{Polygon{square}, Circle{{0, 0}, 1.2}, EdgeChain{square, true, noBack},
                                           LineChain{square, true}};
    Level level;
    level.objects.append(bodyWith(1, shapes[static_cast<std::size_t>(shape)]));
    QCOMPARE(!picked(level, {0.2, 0.3}, 0.1).empty(), hit);
    QCOMPARE(!pickedIn(level, {{0.1, 0.1}, {0.3, 0.3}}, false).empty(), hit);
}

void PickTest::aConnectorWithoutAnEndIsNowhere() {
    Level level = pileOfThree();
    ConnectorObject connector;
    connector.a = 1;
    connector.b = 99;
    level.objects.append(objectWith(7, connector));
    QCOMPARE(picked(level, {0, 0}, 10).size(), std::size_t{3});
    QCOMPARE(pickedIn(level, {{-9, -9}, {9, 9}}, true).size(), std::size_t{3});
}

void PickTest::theBandComesOutInTheOrderOfTheLevel() {
    Level level;
    level.objects.append(bodyWith(9, Circle{}));
    level.objects.append(bodyWith(2, Circle{}));
    level.objects.append(bodyWith(5, Circle{}));
    QCOMPARE(pickedIn(level, {{-2, -2}, {2, 2}}, true), (std::vector<Key>{9, 2, 5}));
}

SPACETOW_TEST(PickTest)
#include "pick_test.moc"
