#include "editor/editing/snap_search.h"

#include "core/level/bounds.h"
#include "core/level/nodes.h"
#include "editor/editing/snap_point.h"
#include "tests/support/body_with.h"
#include "tests/support/snap_switches.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double smallPixel = 0.01; // m

/// Key 1: a line from (0, 0) to (4, 0) and on to (4, 3). Key 2: one that crosses the first at (1, 0). Key 3: a ball of
/// radius 1 at (8, 5).
Level corner() {
    Level level;
    level.objects.append(bodyWith(1, LineChain{{{0, 0}, {4, 0}, {4, 3}}}, {0, 0}));
    level.objects.append(bodyWith(2, LineChain{{{0, -1}, {2, 1}}}, {0, 0}));
    level.objects.append(bodyWith(3, Circle{{0, 0}, 1}, {8, 5}));
    return level;
}

SnapAnswer at(const Level& level, const SnapSettings& settings, const Vec2& point) {
    return snapAnswer(level, settings, {}, {point, smallPixel, {{-20, -20}, {20, 20}}});
}

void compare(const SnapAnswer& answer, SnapKind kind, const Vec2& point, Key key) {
    QCOMPARE(static_cast<int>(answer.kind), static_cast<int>(kind));
    QVERIFY2((answer.point - point).norm() < 1e-9,
             qPrintable(QString("%1, %2").arg(answer.point.x()).arg(answer.point.y())));
    QCOMPARE(answer.key, key);
    QVERIFY(answer.mark == answer.point);
}

} // namespace

class SnapSearchTest : public QObject {
    Q_OBJECT

  private slots:
    void eachKindIsFoundAndNamed_data();
    void eachKindIsFoundAndNamed();
    void eachKindCanBeSwitchedOff_data() { eachKindIsFoundAndNamed_data(); }
    void eachKindCanBeSwitchedOff();
    void pointsGoBeforeLinesAndThoseBeforeTheGrid();
    void alongAnEdgeTheGridStillCounts();
    void twoObjectsAreAlignedWithAtOnce();
    void aBoxAlignsByItsSidesAndItsMiddle();
    void anAlignmentMeetsAnEdge();
    void aShipIsInLineByItsPlace();
    void theGridGoesBeforeAnAlignmentBesideIt();
    void whatIsHiddenIsNotSnappedTo();
    void whatMovesDoesNotSnapToItself();
    void aNodeLeavesItsOwnSegmentsAlone();
    void thePointOfAnObjectThatIsNearestSnaps();
    void nothingInReachLeavesThePointWhereItIs();
};

void SnapSearchTest::eachKindIsFoundAndNamed_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<Vec2>("pointer");
    QTest::addColumn<Vec2>("expected");
    QTest::addColumn<Key>("key");

    const auto row = [](const char* name, SnapKind kind, const Vec2& pointer, const Vec2& expected, Key key) {
        QTest::newRow(name) << static_cast<int>(kind) << pointer << expected << key;
    };
    row("vertex", SnapKind::Vertex, {4.05, 3.04}, {4, 3}, 1);
    row("center", SnapKind::Center, {8.03, 4.96}, {8, 5}, 3);
    row("intersection", SnapKind::Intersection, {1.02, 0.06}, {1, 0}, 1);
    row("midpoint", SnapKind::Midpoint, {4.03, 1.45}, {4, 1.5}, 1);
    row("edge", SnapKind::Edge, {3.1, 0.07}, {3.1, 0}, 1);
    row("rim", SnapKind::Edge, {9.06, 5}, {9, 5}, 3);
    row("perpendicular", SnapKind::Perpendicular, {3.04, 0.03}, {3, 0}, 1);
    row("guide", SnapKind::Guide, {-3.04, 7}, {-3, 7}, 0);
    row("alignment", SnapKind::Alignment, {6.97, -4}, {7, -4}, 0);
    row("angle", SnapKind::Angle, {5, 4.03}, {5.015, 4.015}, 0);
    row("grid", SnapKind::Grid, {-5.2, -5.3}, {-5.25, -5.25}, 0);
}

namespace {

/// As the rows of the table have it: a guide at x = −3, and the point before where its kind needs one.
SnapAnswer answerFor(SnapKind kind, const Vec2& pointer, const SnapSettings& settings) {
    Level level = corner();
    level.guides.push_back({{-3, 1}, std::numbers::pi / 2, "Floor"});
    SnapQuery query{pointer, smallPixel, {{-10, -10}, {10, 10}}};
    if (kind == SnapKind::Perpendicular) {
        query.from = Vec2(3, 2.5);
    } else if (kind == SnapKind::Angle) {
        query.from = Vec2(1, 0);
    }
    return snapAnswer(level, settings, {}, query);
}

bool SnapSettings::*switchOf(SnapKind kind) {
    switch (kind) {
    case SnapKind::Intersection:
        return &SnapSettings::intersections;
    case SnapKind::Midpoint:
        return &SnapSettings::midpoints;
    case SnapKind::Perpendicular:
        return &SnapSettings::perpendiculars;
    case SnapKind::Edge:
        return &SnapSettings::edges;
    case SnapKind::Guide:
        return &SnapSettings::guides;
    case SnapKind::Alignment:
        return &SnapSettings::alignment;
    case SnapKind::Angle:
        return &SnapSettings::angles;
    case SnapKind::Grid:
        return &SnapSettings::grid;
    default:
        return &SnapSettings::vertices;
    }
}

} // namespace

void SnapSearchTest::eachKindIsFoundAndNamed() {
    QFETCH(int, kind);
    QFETCH(Vec2, pointer);
    QFETCH(Vec2, expected);
    QFETCH(Key, key);
    const auto wanted = static_cast<SnapKind>(kind);
    const SnapAnswer alone = answerFor(wanted, pointer, only({switchOf(wanted)}));
    compare(alone, wanted, expected, key);
    if (wanted == SnapKind::Guide) {
        QCOMPARE(alone.guide, 0);
    }
    if (wanted == SnapKind::Alignment) {
        QCOMPARE(alone.lines.size(), std::size_t{1});
        QCOMPARE(alone.lines[0].key, Key{3});
        QVERIFY(alone.lines[0].from == Vec2(7, -4) && alone.lines[0].to == Vec2(7, 5));
    }
    if (wanted != SnapKind::Angle) { // those that are on do not hide each other
        compare(answerFor(wanted, pointer, SnapSettings()), wanted, expected, key);
    }
}

void SnapSearchTest::eachKindCanBeSwitchedOff() {
    QFETCH(int, kind);
    QFETCH(Vec2, pointer);
    const auto wanted = static_cast<SnapKind>(kind);
    SnapSettings settings;
    settings.angles = true;
    settings.*switchOf(wanted) = false;
    QVERIFY(answerFor(wanted, pointer, settings).kind != wanted);
    SnapSettings off = only({switchOf(wanted)});
    off.smart = false;
    QCOMPARE(answerFor(wanted, pointer, off).kind == wanted, wanted == SnapKind::Grid);
}

void SnapSearchTest::pointsGoBeforeLinesAndThoseBeforeTheGrid() {
    const Level level = corner();
    compare(at(level, SnapSettings(), {3.93, 0.0}), SnapKind::Vertex, {4, 0}, 1);   // on the edge
    compare(at(level, SnapSettings(), {2.06, 0.0}), SnapKind::Midpoint, {2, 0}, 1); // likewise
    compare(at(level, SnapSettings(), {3.31, 0.08}), SnapKind::Edge, {3.25, 0}, 1); // and not (3.25, 0.00) by the grid
    compare(at(level, SnapSettings(), {1.03, 0.01}), SnapKind::Intersection, {1, 0}, 1);
}

void SnapSearchTest::alongAnEdgeTheGridStillCounts() {
    const Level level = corner();
    compare(at(level, only({&SnapSettings::edges, &SnapSettings::grid}), {3.3, 0.04}), SnapKind::Edge, {3.25, 0}, 1);
    compare(at(level, only({&SnapSettings::edges, &SnapSettings::grid}), {3.37, 0.04}), SnapKind::Edge, {3.37, 0}, 1);
    // Where it is steep the rows of the grid count. The one at 0.75 is out of reach of the foot.
    const SnapAnswer slope = at(level, only({&SnapSettings::edges, &SnapSettings::grid}), {1.52, 0.48});
    compare(slope, SnapKind::Edge, {1.5, 0.5}, 2);
}

void SnapSearchTest::twoObjectsAreAlignedWithAtOnce() {
    const Level level = corner();
    const SnapAnswer answer = at(level, only({&SnapSettings::alignment}), {6.98, 3.03}); // ball's left, corner's top
    compare(answer, SnapKind::Alignment, {7, 3}, 0);
    std::set<Key> keys;
    for (const SnapLine& line : answer.lines) {
        keys.insert(line.key);
        QVERIFY(line.from == answer.point);
    }
    QCOMPARE(keys, (std::set<Key>{1, 3}));
}

void SnapSearchTest::aBoxAlignsByItsSidesAndItsMiddle() {
    const Level level = corner();
    SnapSubject subject;
    subject.box = {{-0.5, -0.5}, {0.5, 0.5}};
    const auto moved = [&](const Vec2& place) {
        return snapAnswer(level, only({&SnapSettings::alignment}), subject,
                          {place, smallPixel, {{-20, -20}, {20, 20}}});
    };
    QVERIFY((moved({9.52, -9}).point - Vec2(9.5, -9)).norm() < 1e-12); // left side to the ball's right one
    QVERIFY((moved({8.03, -9}).point - Vec2(8, -9)).norm() < 1e-12);   // middle to middle
    QVERIFY((moved({6.47, -9}).point - Vec2(6.5, -9)).norm() < 1e-12);
    QCOMPARE(moved({8.03, -9}).lines.size(), std::size_t{1});
    QVERIFY(moved({6.47, -9}).lines[0].from == Vec2(7, -9)); // where the side comes to lie
}

void SnapSearchTest::anAlignmentMeetsAnEdge() {
    Level level;
    level.objects.append(bodyWith(1, LineChain{{{0, 0}, {10, 5}}}, {0, 0}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 1}, {3, 9}));
    const SnapAnswer answer = at(level, only({&SnapSettings::edges, &SnapSettings::alignment}), {4.03, 1.97});
    compare(answer, SnapKind::Edge, {4, 2}, 1);
    QCOMPARE(answer.lines.size(), std::size_t{1});
    QCOMPARE(answer.lines[0].key, Key{2});
}

void SnapSearchTest::aShipIsInLineByItsPlace() {
    Level level;
    level.objects.append({1, "", ShipObject{{-3.3, 1.7}, 0}, {}});
    const SnapSettings settings = only({&SnapSettings::alignment});
    compare(at(level, settings, {2.7, 1.73}), SnapKind::Alignment, {2.7, 1.7}, 0);
    compare(at(level, settings, {-3.28, 5}), SnapKind::Alignment, {-3.3, 5}, 0);
    const Aabb hull = boundsOf(level);
    for (const double side : {hull.min.y(), hull.max.y()}) { // further from its place than alignments reach
        QVERIFY(at(level, settings, {2.7, side}).kind == SnapKind::None);
    }
    // It comes into line by its place too.
    level.objects.append(bodyWith(2, Circle{{0, 0}, 1}, {4, 4}));
    const Pointer grabbed{{-3.3, 1.6}, {}, {}, smallPixel, {}};
    const SnapSubject ship = subjectOf(level, {1}, grabbed, {-3.3, 1.7});
    const SnapAnswer answer = snapAnswer(level, settings, ship, {{0, 3.97}, smallPixel, {{-20, -20}, {20, 20}}});
    compare(answer, SnapKind::Alignment, {0, 4}, 0);
    QCOMPARE(answer.lines.size(), std::size_t{1});
}

void SnapSearchTest::theGridGoesBeforeAnAlignmentBesideIt() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.4}, {-3.3, 1.765}));
    const SnapSettings both = only({&SnapSettings::alignment, &SnapSettings::grid});
    compare(at(level, both, {2.74, 1.77}), SnapKind::Grid, {2.75, 1.75}, 0);
    compare(at(level, only({&SnapSettings::alignment}), {2.74, 1.77}), SnapKind::Alignment, {2.74, 1.765}, 0);
    // Nobody builds by the rim of the payload.
    Level towed;
    PayloadObject payload;
    payload.position = {-3, -1.75};
    payload.radius = 0.2;
    towed.objects.append({1, "", payload, {}});
    compare(at(towed, both, {1.2, -1.56}), SnapKind::Grid, {1.25, -1.5}, 0);
    compare(at(towed, both, {1.24, -1.76}), SnapKind::Alignment, {1.25, -1.75}, 0);
    // Seen from nearer they are two places, and the nearer one draws.
    const SnapQuery near{{2.74, 1.7655}, smallPixel / 10, {{-20, -20}, {20, 20}}};
    QVERIFY(snapAnswer(level, both, {}, near).kind == SnapKind::Alignment);
    const SnapQuery between{{2.7505, 1.7615}, smallPixel / 5, {{-20, -20}, {20, 20}}};
    QVERIFY(snapAnswer(level, both, {}, between).kind == SnapKind::Alignment);
    const SnapQuery beyond{{2.7505, 1.7569}, smallPixel / 5, {{-20, -20}, {20, 20}}};
    QVERIFY(snapAnswer(level, both, {}, beyond).kind == SnapKind::Grid);
    // From so far that the grid is finer than the pointer is steady, objects are what counts.
    const SnapQuery far{{2.74, 1.79}, 4 * smallPixel, {{-20, -20}, {20, 20}}};
    QVERIFY(snapAnswer(level, both, {}, far).kind == SnapKind::Alignment);
}

void SnapSearchTest::whatIsHiddenIsNotSnappedTo() {
    Level level = corner();
    Object group;
    group.key = 9;
    group.data = GroupObject{};
    group.visible = false;
    level.objects.append(group);
    Object first = level.objects[0];
    const Vec2 end(4.02, 3.01);
    QVERIFY(at(level, only({&SnapSettings::vertices, &SnapSettings::alignment}), end).kind == SnapKind::Vertex);
    first.parent = 9;
    level.objects.replace(0, first);
    QVERIFY(at(level, only({&SnapSettings::vertices, &SnapSettings::alignment}), end).kind == SnapKind::None);
}

void SnapSearchTest::whatMovesDoesNotSnapToItself() {
    Level level = corner();
    ConnectorObject rope;
    rope.a = 1;
    rope.b = 3;
    level.objects.append({4, "rope", rope, {}});
    const SnapSubject subject{.keys = {1}};
    const SnapSettings settings = only({&SnapSettings::vertices, &SnapSettings::edges});
    for (const Vec2& point : {Vec2(4.02, 3.01), Vec2(3.3, 0.02), Vec2(4, 2.5)}) { // the last one on the rope too
        QVERIFY(snapAnswer(level, settings, subject, {point, smallPixel, {}}).kind == SnapKind::None);
    }
}

void SnapSearchTest::aNodeLeavesItsOwnSegmentsAlone() {
    const Level level = corner();
    const SnapSubject subject{.nodes = {{1, 0, 2}}}; // (4, 3)
    const SnapSettings settings = only({&SnapSettings::vertices, &SnapSettings::edges});
    const auto kindAt = [&](const Vec2& point) {
        return snapAnswer(level, settings, subject, {point, smallPixel, {}}).kind;
    };
    QVERIFY(kindAt({4, 3}) == SnapKind::None);
    QVERIFY(kindAt({4.02, 2}) == SnapKind::None);
    QVERIFY(kindAt({4.02, 0.01}) == SnapKind::Vertex); // the next one stays
    QVERIFY(kindAt({3, 0.01}) == SnapKind::Edge);
}

void SnapSearchTest::thePointOfAnObjectThatIsNearestSnaps() {
    const Level level = corner();
    const SnapSubject subject{.points = {{1, 1}, {-1, 1}}};
    const SnapAnswer answer =
        snapAnswer(level, only({&SnapSettings::vertices}), subject, {{5.03, 2.05}, smallPixel, {}});
    QVERIFY(answer.kind == SnapKind::Vertex);
    QVERIFY(answer.mark == Vec2(4, 3));
    QVERIFY((answer.point - Vec2(5, 2)).norm() < 1e-12);
}

void SnapSearchTest::nothingInReachLeavesThePointWhereItIs() {
    SnapSettings settings;
    settings.grid = false;
    const SnapAnswer answer = snapAnswer(corner(), settings, {}, {{-30, 40}, smallPixel, {}});
    QVERIFY(answer.kind == SnapKind::None && answer.point == Vec2(-30, 40) && answer.lines.empty());
}

SPACETOW_TEST(SnapSearchTest)
#include "snap_search_test.moc"
