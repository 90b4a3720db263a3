// Snapping in random levels, compared with what going through everything finds.
#include "editor/editing/snap_search.h"

#include "core/base/random.h"
#include "core/geometry/intersect.h"
#include "core/level/level_index.h"
#include "core/level/outline.h"
#include "tests/support/body_with.h"
#include "tests/support/cpu_time.h"
#include "tests/support/full_run.h"
#include "tests/support/snap_switches.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double finePixel = 0.01; // m

Level randomLines(Random& random, int count) {
    Level level;
    for (int i = 0; i < count; ++i) {
        std::vector<Vec2> points{{random.uniform(-2, 2), random.uniform(-2, 2)}};
        for (std::uint64_t more = 1 + random.below(4); more > 0; --more) {
            points.emplace_back(points.back() + Vec2(random.uniform(-1, 1), random.uniform(-1, 1)));
        }
        Object object = random.below(4) == 0 ? bodyWith(static_cast<Key>(i + 1), Circle{{0.1, 0}, 0.3}, points.front())
                                             : bodyWith(static_cast<Key>(i + 1), LineChain{points}, {0.5, 0});
        std::get<BodyObject>(object.data).angle = random.uniform(-3, 3);
        object.visible = random.below(5) != 0;
        level.objects.append(std::move(object));
    }
    level.guides.push_back({{random.uniform(-2, 2), random.uniform(-2, 2)}, random.uniform(-3, 3), "a"});
    level.guides.push_back({{random.uniform(-2, 2), 0}, std::numbers::pi / 2, "b"});
    return level;
}

/// What a point may snap to, by going through everything: the best cost, infinite when there is nothing in reach.
class Everything {
  public:
    Everything(const Level& level, const Vec2& point, double reach) : m_point(point), m_reach(reach) {
        std::vector<std::pair<Vec2, Vec2>> segments;
        for (const Object& object : level.objects) {
            if (!object.visible) {
                continue;
            }
            for (const OutlinePath& path : Outlines(level).of(object).paths) {
                for (std::size_t i = 0; i < path.points.size(); ++i) {
                    offer(SnapKind::Vertex, path.points[i]);
                    if (i > 0) {
                        segments.emplace_back(path.points[i - 1], path.points[i]);
                    }
                }
            }
            for (const Circle& disc : Outlines(level).of(object).discs) {
                offer(SnapKind::Center, disc.center);
                offer(SnapKind::Edge, disc.center + disc.radius * (point - disc.center).normalized());
            }
        }
        for (std::size_t i = 0; i < segments.size(); ++i) {
            const auto& [a, b] = segments[i];
            offer(SnapKind::Midpoint, 0.5 * (a + b));
            offer(SnapKind::Edge, closestOnSegment(a, b, point));
            for (std::size_t k = 0; k < i; ++k) {
                const auto met = segmentIntersection(a, b, segments[k].first, segments[k].second);
                if (met && *met != a && *met != b) {
                    offer(SnapKind::Intersection, *met);
                }
            }
        }
    }
    double cost = std::numeric_limits<double>::infinity();

  private:
    void offer(SnapKind kind, const Vec2& target) {
        const double away = (target - m_point).norm();
        if (away <= m_reach) {
            cost = std::min(cost, away + snapHandicap(kind) * m_reach);
        }
    }

    Vec2 m_point;
    double m_reach;
};

} // namespace

class SnapRandomTest : public QObject {
    Q_OBJECT

  private slots:
    void aWayThatIsKeptToIsNeverLeft();
    void theAnswerIsTheBestThereIs();
    void theAnswerIsNearThePointer();
    void zoomingChangesNothing();
    void aHoverTakesNoTimeInALargeLevel();
};

void SnapRandomTest::aWayThatIsKeptToIsNeverLeft() {
    const int rounds = 300;
    for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
        Random random(seed);
        const Level level = randomLines(random, 30);
        const Vec2 along = snappedDirection(Vec2(random.uniform(-1, 1), random.uniform(-1, 1)));
        const Vec2 from(random.uniform(-2, 2), random.uniform(-2, 2));
        SnapQuery query{from + random.uniform(-2, 2) * along, 0.02, {{-3, -3}, {3, 3}}, from, along, from};
        SnapSettings settings;
        settings.grid = random.below(2) == 0;
        settings.angles = true;
        const SnapAnswer answer = snapAnswer(level, settings, {}, query);
        QVERIFY2(std::abs(cross(Vec2(answer.point - from), along)) < 1e-7, qPrintable(QString("seed %1").arg(seed)));
        if (answer.kind != SnapKind::Grid) {
            QVERIFY2((answer.point - query.at).norm() <= 0.2 + 1e-9, qPrintable(QString("seed %1").arg(seed)));
        }
    }
}

void SnapRandomTest::theAnswerIsTheBestThereIs() {
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        Random random(seed);
        const Level level = randomLines(random, 25);
        const Vec2 point(random.uniform(-2, 2), random.uniform(-2, 2));
        const SnapSettings settings = only(
            {&SnapSettings::vertices, &SnapSettings::edges, &SnapSettings::midpoints, &SnapSettings::intersections});
        const double reach = settings.reach * finePixel;
        const SnapAnswer answer = snapAnswer(level, settings, {}, {point, finePixel, {}});
        const Everything everything(level, point, reach);
        const double cost = answer.kind == SnapKind::None
                                ? std::numeric_limits<double>::infinity()
                                : (answer.point - point).norm() + snapHandicap(answer.kind) * reach;
        QVERIFY2(cost == everything.cost || std::abs(cost - everything.cost) < 1e-7,
                 qPrintable(QString("seed %1: %2 for %3").arg(seed).arg(cost).arg(everything.cost)));
    }
}

void SnapRandomTest::theAnswerIsNearThePointer() {
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        Random random(seed);
        const Level level = randomLines(random, 25);
        SnapSettings settings;
        settings.grid = random.below(2) == 0;
        settings.angles = random.below(2) == 0;
        SnapQuery query{{random.uniform(-2, 2), random.uniform(-2, 2)}, finePixel, {{-3, -3}, {3, 3}}};
        if (random.below(2) == 0) {
            query.from = Vec2(random.uniform(-2, 2), random.uniform(-2, 2));
        }
        const SnapAnswer answer = snapAnswer(level, settings, {}, query);
        const double away = (answer.point - query.at).norm() / finePixel;
        const double most = answer.kind == SnapKind::Grid ? settings.step / finePixel : std::sqrt(2.0) * settings.reach;
        QVERIFY2(away <= most + 1e-6, qPrintable(QString("seed %1: %2 px").arg(seed).arg(away)));
        QCOMPARE(answer.point == query.at, answer.kind == SnapKind::None || away == 0);
    }
}

void SnapRandomTest::zoomingChangesNothing() {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Random random(seed);
        const Level level = randomLines(random, 20);
        const double larger = 4; // all of it, and its pixels; the numbers are exact
        Level zoomed = level;
        for (int i = 0; i < level.objects.size(); ++i) {
            Object object = level.objects[i];
            auto& body = std::get<BodyObject>(object.data);
            body.position *= larger;
            for (LevelShape& shape : body.shapes) {
                if (auto* chain = std::get_if<LineChain>(&shape)) {
                    for (Vec2& vertex : chain->vertices) {
                        vertex *= larger;
                    }
                } else {
                    auto& circle = std::get<Circle>(shape);
                    circle = {larger * circle.center, larger * circle.radius};
                }
            }
            zoomed.objects.replace(i, object);
        }
        for (Guide& guide : zoomed.guides) {
            guide.point *= larger;
        }
        SnapSettings settings;
        settings.grid = false;
        const Vec2 point(random.uniform(-2, 2), random.uniform(-2, 2));
        const SnapAnswer a = snapAnswer(level, settings, {}, {point, finePixel, {{-3, -3}, {3, 3}}});
        const SnapAnswer b =
            snapAnswer(zoomed, settings, {}, {larger * point, larger * finePixel, {{-12, -12}, {12, 12}}});
        QVERIFY2(a.kind == b.kind && a.key == b.key && (larger * a.point - b.point).norm() < 1e-6,
                 qPrintable(QString("seed %1").arg(seed)));
    }
}

void SnapRandomTest::aHoverTakesNoTimeInALargeLevel() {
    Level level;
    const int side = usualOrThin(316, 60); // squared: some 100,000 edges, one body each
    for (int i = 0; i < side * side; ++i) {
        level.objects.append(
            bodyWith(static_cast<Key>(i + 1), LineChain{{{0, 0}, {0.7, 0.3}}}, Vec2(i % side, i / side)));
    }
    levelIndex(level); // made when the file is opened
    const CpuTimer clock;
    constexpr int hovers = 200;
    int found = 0;
    for (int i = 0; i < hovers; ++i) {
        const Vec2 point(0.3 * side + 0.1 * i, 0.5 * side + 0.07 * i);
        found += snapAnswer(level, SnapSettings(), {}, {point, 0.015, {{80, 140}, {130, 180}}}).kind != SnapKind::None;
    }
    QVERIFY(found > 0);
    const double milliseconds = clock.seconds() * 1000 / hovers;
    QVERIFY2(isSanitized || milliseconds < 1, qPrintable(QString::number(milliseconds)));
}

SPACETOW_TEST(SnapRandomTest)
#include "snap_random_test.moc"
