// How near bodies come to passing through walls, and what is drawn of it.
#include "core/physics/query/tunnelling.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/recording_draw.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

DebugView riskView() {
    DebugView view;
    view.view = {.center = {0, 0}, .scale = 100, .size = {800, 600}};
    view.shapes = false;
    view.overlays = {.risk = true};
    return view;
}

} // namespace

class TunnellingTest : public QObject {
    Q_OBJECT

  private slots:
    void riskIsTheWayOfAnIterationAgainstTheDepth_data();
    void riskIsTheWayOfAnIterationAgainstTheDepth();
    void whoPassesByOrMayNotTouchIsNoRisk();
    void sensorsAndInactiveBodiesAreNoRisk();
};

void TunnellingTest::riskIsTheWayOfAnIterationAgainstTheDepth_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("depth");
    QTest::addColumn<double>("risk");
    QTest::newRow("slow") << 1.0 << 0.5 << 1 * 0.02 / 4 / 0.5;
    QTest::newRow("half of the band") << 50.0 << 0.5 << 0.5;
    QTest::newRow("four times the band") << 200.0 << 0.25 << 4.0;
}

void TunnellingTest::riskIsTheWayOfAnIterationAgainstTheDepth() {
    QFETCH(double, speed);
    QFETCH(double, depth);
    QFETCH(double, risk);
    World world(withIterations(4, {0, 0}));
    add(world, {.kind = BodyKind::Static, .shapes = {Edge{{-2, 0}, {2, 0}, depth}}});
    for (const double share : {0.2, 1.0, 0.6}) { // the greatest counts
        BodyDef def = ball({share, 0.8}, 0.1);
        def.velocity = {0, -share * speed};
        add(world, def);
    }
    const std::vector<WallRisk> risks = wallRisks(world);
    QCOMPARE(risks.size(), std::size_t{1});
    QVERIFY(std::abs(risks[0].speed - speed) < 1e-9);
    QVERIFY(std::abs(risks[0].risk - risk) < 1e-9);
    DebugView view = riskView();
    view.colors.safe = {0, 0, 0};
    view.colors.risky = {200, 0, 0};
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(calls.size(), std::size_t{2});
    QCOMPARE(int{calls[0].color.red}, static_cast<int>(std::lround(200 * std::min(risk, 1.0))));
    QCOMPARE(QString::fromStdString(calls[1].text), QString::asprintf("%.2g", risk));
}

void TunnellingTest::whoPassesByOrMayNotTouchIsNoRisk() {
    World world(withIterations(4, {0, 0}));
    add(world, {.kind = BodyKind::Static, .shapes = {Edge{{-2, 0}, {2, 0}, 0.5}}});
    BodyDef leaves = ball({0, 1}, 0.1);
    leaves.velocity = {0, 5};
    add(world, leaves);
    BodyDef far = ball({0, 30}, 0.1);
    far.velocity = {0, -5};
    add(world, far);
    BodyDef ghost = ball({0, 1}, 0.1);
    ghost.velocity = {0, -5};
    ghost.filter.touches = TagMask::bit(3);
    add(world, ghost);
    QVERIFY(wallRisks(world).empty());
    ghost.filter.touches = TagMask::all();
    add(world, ghost);
    QCOMPARE(wallRisks(world).size(), std::size_t{1});
}

void TunnellingTest::sensorsAndInactiveBodiesAreNoRisk() {
    const auto risksOf = [](bool wallStops, bool wallIsActive, bool ballStops) {
        World world(withIterations(4, {0, 0}));
        add(world, {.kind = BodyKind::Static,
                    .shapes = {Edge{{-2, 0}, {2, 0}, 0.5}},
                    .tangible = wallStops,
                    .active = wallIsActive});
        BodyDef def = ball({0, 1}, 0.1);
        def.velocity = {0, -5};
        def.tangible = ballStops;
        add(world, def);
        return wallRisks(world).size();
    };
    QCOMPARE(risksOf(true, true, true), std::size_t{1});
    QCOMPARE(risksOf(false, true, true), std::size_t{0});
    QCOMPARE(risksOf(true, false, true), std::size_t{0});
    QCOMPARE(risksOf(true, true, false), std::size_t{0});
}

SPACETOW_TEST(TunnellingTest)
#include "tunnelling_test.moc"
