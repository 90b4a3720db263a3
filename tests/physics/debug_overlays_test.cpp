// What drawWorld draws that concerns more than one body, or more than its outline.
#include "core/physics/query/contact_manifolds.h"
#include "core/physics/query/queries.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/recording_draw.h"

#include <array>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double worldGravity = 9.81; // m/s²

/// A hundred units a metre, so that there is room for texts.
DebugView closeView(const OverlayFlags& overlays) {
    DebugView view;
    view.view = {.center = {0, 0}, .scale = 100, .size = {800, 600}};
    view.shapes = false;
    view.overlays = overlays;
    return view;
}

std::vector<DrawCall> callsOf(const std::vector<DrawCall>& calls, Form form, const Color& color) {
    std::vector<DrawCall> found;
    std::ranges::copy_if(calls, std::back_inserter(found),
                         [&](const DrawCall& call) { return call.form == form && call.color == color; });
    return found;
}

std::size_t texts(const std::vector<DrawCall>& calls, const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(
        calls, [&](const DrawCall& call) { return call.form == Form::Text && call.text == text; }));
}

/// Fills of any strength.
std::vector<DrawCall> fillsOf(const std::vector<DrawCall>& calls, Color color) {
    std::vector<DrawCall> found;
    for (const DrawCall& call : calls) {
        color.alpha = call.color.alpha;
        if ((call.form == Form::FilledPolygon || call.form == Form::FilledCircle) && call.color == color) {
            found.push_back(call);
        }
    }
    return found;
}

/// A box of this mass that has come to rest on the floor.
World restingBox(double mass) {
    World world(withIterations(10));
    add(world, edgeBody({-5, 0}, {5, 0}));
    BodyDef def = box({0, 0.5}, 0.5, 0.5);
    def.mass = mass;
    add(world, def);
    run(world, 1);
    return world;
}

} // namespace

class DebugOverlaysTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingIsDrawnWhileAllIsOff();
    void aWallWithoutABackHasAnOpenBand();
    void bothTreesShowWhatTheirCellsHold();
    void contactsShowTheirPointsNormalsAndForces_data();
    void contactsShowTheirPointsNormalsAndForces();
    void whatCarriesTenTimesTheWeightHasAnArrowOfTwoMetres();
    void whatIsMerelyNearHasARing();
    void circlesTouchWhereTheyMeet();
    void connectorsShowTheirTension();
    void centresOfMassHaveACrossAlongTheBody();
    void theHostNamesBodies();
    void anIslandHasOneColour();
    void sleepersLookAsleep();
    void tagsHaveTheColoursOfTheHost();
    void theSelectionTellsWhatItMeets();
    void trailsFadeWithAge();
    void aTrailIsDrawnByWhatCanBeSeenOfIt();
    void arrowsShorterThanADotAreLeftOut();
    void onlyWhatIsInViewIsDrawn();
};

void DebugOverlaysTest::nothingIsDrawnWhileAllIsOff() {
    QVERIFY(recorded(restingBox(1), closeView({})).empty());
}

void DebugOverlaysTest::aWallWithoutABackHasAnOpenBand() {
    World world;
    add(world, {.kind = BodyKind::Static, .shapes = {Edge{{-1, 0}, {1, 0}}}});
    const DebugView view = closeView({.normals = true});
    const std::vector<DrawCall> calls = recorded(world, view);
    const std::vector<DrawCall> bands = fillsOf(calls, view.colors.depth);
    QCOMPARE(bands.size(), std::size_t{1});
    QVERIFY(bands[0].points[2].y() > 300 && bands[0].points[2].y() < 330); // below the wall, not far
    QVERIFY(callsOf(calls, Form::Line, view.colors.depth).empty());
}

void DebugOverlaysTest::bothTreesShowWhatTheirCellsHold() {
    const World world = restingBox(1);
    const DebugView view = closeView({.quadtree = true});
    const std::vector<DrawCall> calls = recorded(world, view);
    std::size_t resting = 0;
    std::size_t moving = 0;
    for (const QuadtreeCell& cell : occupiedCells(world)) {
        ++(cell.moving ? moving : resting);
    }
    QVERIFY(resting > 0 && moving > 0);
    QCOMPARE(callsOf(calls, Form::Rectangle, view.colors.staticCell).size(), resting);
    QCOMPARE(callsOf(calls, Form::Rectangle, view.colors.movingCell).size(), moving);
    QVERIFY(texts(calls, "1") >= 1); // flat ones have no room for it
}

void DebugOverlaysTest::contactsShowTheirPointsNormalsAndForces_data() {
    QTest::addColumn<double>("mass");
    QTest::newRow("light") << 0.2;
    QTest::newRow("heavy") << 50.0;
}

void DebugOverlaysTest::contactsShowTheirPointsNormalsAndForces() {
    QFETCH(double, mass);
    const World world = restingBox(mass);
    const DebugView view = closeView({.contacts = true});
    const std::vector<DrawCall> calls = recorded(world, view);
    const std::vector<DrawCall> points = callsOf(calls, Form::FilledCircle, view.colors.touchPoint);
    QCOMPARE(points.size(), std::size_t{2});
    for (const DrawCall& point : points) {
        QVERIFY(std::abs(std::abs(point.points[0].x() - 400) - 50) < 1); // the corners of the box
        QVERIFY(std::abs(point.points[0].y() - 300) < 1);
    }
    for (const DrawCall& normal : callsOf(calls, Form::Line, view.colors.contactNormal)) {
        QVERIFY(std::abs(normal.points[0].x() - normal.points[1].x()) < 1e-6);
    }
    QCOMPARE(callsOf(calls, Form::Line, view.colors.contactNormal).size(), std::size_t{2});
    double metres = 0;
    for (const DrawCall& force : callsOf(calls, Form::Line, view.colors.impulse)) {
        metres += std::abs(force.points[1].y() - force.points[0].y()) / view.view.scale;
    }
    QVERIFY2(std::abs(metres - 1) < 0.02, qPrintable(QString::number(metres))); // its weight is what carries it
    double newtons = 0;
    for (const ContactManifold& contact : contactManifolds(world)) {
        for (const ContactManifold::Point& point : contact.points) {
            newtons += point.normalImpulse * 10 / 0.02;
        }
    }
    QVERIFY(std::abs(newtons - mass * worldGravity) < 0.02 * mass * worldGravity);
}

void DebugOverlaysTest::whatCarriesTenTimesTheWeightHasAnArrowOfTwoMetres() {
    World world(withIterations(20));
    add(world, edgeBody({-5, 0}, {5, 0}));
    const auto stacked = [&](double height, double mass) {
        BodyDef def = ball({0, height}, 0.25);
        def.mass = mass;
        add(world, def);
    };
    stacked(0.25, 1);
    stacked(0.75, 9);
    run(world, 2);
    const DebugView view = closeView({.contacts = true});
    std::vector<double> metres;
    for (const DrawCall& force : callsOf(recorded(world, view), Form::Line, view.colors.impulse)) {
        metres.push_back((force.points[1] - force.points[0]).norm() / view.view.scale);
    }
    std::ranges::sort(metres);
    QCOMPARE(metres.size(), std::size_t{2});
    QVERIFY(std::abs(metres[0] - (1 + std::log10(9))) < 0.02);
    QVERIFY2(std::abs(metres[1] - 2) < 0.02, qPrintable(QString::number(metres[1])));
}

void DebugOverlaysTest::whatIsMerelyNearHasARing() {
    World world(withIterations(1, {0, 0}));
    BodyDef def = box({0, 0.52}, 0.5, 0.5);
    def.velocity = {2, 0}; // so fast that the solver looks that far
    add(world, def);
    add(world, edgeBody({-5, 0}, {5, 0}));
    world.update();
    const DebugView view = closeView({.contacts = true});
    const std::vector<DrawCall> calls = recorded(world, view);
    const std::vector<ContactManifold> contacts = contactManifolds(world);
    QCOMPARE(contacts.size(), std::size_t{1});
    QVERIFY(!contacts[0].touching);
    QCOMPARE(callsOf(calls, Form::Circle, view.colors.nearPoint).size(), static_cast<std::size_t>(contacts[0].count));
    QVERIFY(callsOf(calls, Form::FilledCircle, view.colors.touchPoint).empty());
}

void DebugOverlaysTest::circlesTouchWhereTheyMeet() {
    World world(withIterations(10));
    add(world, edgeBody({-5, 0}, {5, 0}));
    add(world, ball({0, 0.5}, 0.5));
    BodyDef upper = ball({0, 1.5}, 0.5);
    upper.rotationFrozen = true;
    add(world, upper);
    run(world, 0.2);
    const std::vector<ContactManifold> contacts = contactManifolds(world);
    QCOMPARE(contacts.size(), std::size_t{2});
    std::set<int> heights;
    for (const ContactManifold& contact : contacts) {
        QVERIFY(contact.touching);
        QCOMPARE(contact.count, 1);
        QVERIFY(std::abs(std::abs(contact.normal.y()) - 1) < 1e-3);
        heights.insert(static_cast<int>(std::lround(contact.points[0].at.y())));
    }
    QVERIFY((heights == std::set<int>{0, 1}));
}

void DebugOverlaysTest::connectorsShowTheirTension() {
    World world(withIterations(10));
    BodyDef hook = ball({0, 2}, 0.1);
    hook.kind = BodyKind::Static;
    const BodyId a = add(world, hook);
    const BodyId b = add(world, ball({0, 0.5}, 0.1));
    QVERIFY(world.addConnector({.a = a, .b = b, .length = 1, .stiffness = 10}));
    world.update();
    const ConnectorState state = world.connector(world.connectors()[0]);
    const DebugView view = closeView({.tension = true});
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(calls.size(), std::size_t{2});
    const Color hue = connectorColor((state.anchorB - state.anchorA).norm(), 1, view.colors);
    QVERIFY(calls[0].form == Form::FilledPolygon && calls[0].color == hue);
    QCOMPARE(QString::fromStdString(calls[1].text), QString::asprintf("%.3g N", state.tension));
    DebugView blue = view;
    blue.colors.pressed = blue.colors.natural = blue.colors.pulled = {0, 0, 255};
    QVERIFY((recorded(world, blue)[0].color == Color{0, 0, 255}));
}

void DebugOverlaysTest::centresOfMassHaveACrossAlongTheBody() {
    World world;
    BodyDef def = box({1, 0}, 0.5, 0.5);
    def.angle = pi / 6;
    add(world, def);
    const DebugView view = closeView({.masses = true});
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(callsOf(calls, Form::Line, view.colors.massCenter).size(), std::size_t{2});
    const Vec2 along = calls[0].points[1] - calls[0].points[0];
    QVERIFY((0.5 * (calls[0].points[0] + calls[0].points[1]) - Vec2(500, 300)).norm() < 1e-9);
    QVERIFY(std::abs(along.normalized().x() + std::sin(pi / 6)) < 1e-9); // up turns to the left
    QVERIFY(along.y() < 0);
}

void DebugOverlaysTest::theHostNamesBodies() {
    World world;
    BodyDef def = box({1, 0}, 0.5, 0.5);
    def.user = 7;
    add(world, def);
    add(world, box({-1, 0}, 0.5, 0.5));
    DebugView view = closeView({.names = true});
    QVERIFY(recorded(world, view).empty());
    view.nameOf = [](std::uint64_t user) { return user == 7 ? std::string("crate") : std::string(); };
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(calls.size(), std::size_t{1});
    QCOMPARE(texts(calls, "crate"), std::size_t{1});
    QVERIFY((calls[0].points[0] - Vec2(500, 300)).norm() < 20);
}

void DebugOverlaysTest::anIslandHasOneColour() {
    World world(withIterations(10));
    add(world, edgeBody({-5, 0}, {5, 0}));
    const BodyId lower = add(world, box({0, 0.25}, 0.25, 0.25));
    const BodyId upper = add(world, box({0, 0.75}, 0.25, 0.25));
    const BodyId alone = add(world, box({3, 0.25}, 0.25, 0.25));
    run(world, 0.1);
    QVERIFY(islandOf(world, lower) && islandOf(world, lower) == islandOf(world, upper));
    QVERIFY(islandOf(world, alone) && islandOf(world, alone) != islandOf(world, lower));
    QVERIFY(!islandOf(world, world.bodies()[0])); // the floor belongs to none
    const DebugView view = closeView({.islands = true});
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(calls.size(), std::size_t{6});
    QVERIFY(calls[1].color == calls[3].color);
    QVERIFY(calls[1].color == view.colors.islands[*islandOf(world, lower) % 6]);
    QVERIFY(calls[5].color == view.colors.islands[*islandOf(world, alone) % 6]);
}

void DebugOverlaysTest::sleepersLookAsleep() {
    World world = restingBox(1);
    const DebugView view = closeView({.islands = true});
    QVERIFY(fillsOf(recorded(world, view), view.colors.asleep).empty());
    world.setSleeping(true);
    run(world, 1);
    const BodyId sleeper = world.bodies()[1];
    QVERIFY(world.body(sleeper).asleep && islandOf(world, sleeper));
    QCOMPARE(fillsOf(recorded(world, view), view.colors.asleep).size(), std::size_t{1});
    // What holds it is known as long as it sleeps.
    QCOMPARE(recorded(world, closeView({.contacts = true})).empty(), false);
}

void DebugOverlaysTest::tagsHaveTheColoursOfTheHost() {
    World world;
    BodyDef def = ball({0, 0}, 0.5);
    def.filter.tags = TagMask::bit(2) | TagMask::bit(5) | TagMask::bit(9);
    add(world, def);
    DebugView view = closeView({.tags = true});
    QVERIFY(recorded(world, view).empty());
    view.tagColor = [](int tag) {
        return tag == 9 ? std::nullopt : std::optional(Color{static_cast<std::uint8_t>(tag), 0, 0});
    };
    const std::vector<DrawCall> expected{{Form::Circle, {{400, 300}}, 50, {2, 0, 0}},
                                         {Form::FilledCircle, {{400, 300}}, 3, {5, 0, 0}}};
    QVERIFY(recorded(world, view) == expected);
}

void DebugOverlaysTest::theSelectionTellsWhatItMeets() {
    World world;
    std::array<BodyId, 5> ids;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        BodyDef def = ball({static_cast<double>(i) - 2, 0}, 0.25);
        def.user = i;
        def.tangible = i != 2;
        def.filter.tags = TagMask::bit(i == 3 ? 1 : 0);
        def.filter.touches = TagMask::bit(0);
        ids[i] = add(world, def);
    }
    QVERIFY(world.addConnector({.a = ids[0], .b = ids[4]})); // which do not collide while it holds
    world.update();
    DebugView view = closeView({.collides = true});
    QVERIFY(recorded(world, view).empty());
    view.isSelected = [](std::uint64_t user) { return user == 0; };
    const std::vector<DrawCall> calls = recorded(world, view);
    QCOMPARE(calls.size(), std::size_t{4}); // all but the selected one
    for (std::size_t i = 0; i < calls.size(); ++i) {
        QVERIFY(calls[i].color == (i == 0 ? view.colors.meets : view.colors.passes));
    }
}

void DebugOverlaysTest::trailsFadeWithAge() {
    const std::vector<DebugTrail> trails{{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}}};
    DebugView view = closeView({.trails = true});
    view.trails = trails;
    const std::vector<DrawCall> calls = recorded(World(), view);
    QCOMPARE(calls.size(), std::size_t{3});
    QVERIFY(calls[0].points == (std::vector<Vec2>{Vec2(400, 300), Vec2(500, 300)}));
    QVERIFY(calls[0].color.alpha < calls[1].color.alpha && calls[1].color.alpha < calls[2].color.alpha);
}

void DebugOverlaysTest::aTrailIsDrawnByWhatCanBeSeenOfIt() {
    std::vector<Vec2> creeping; // a quarter of a dot a point
    for (int i = 0; i <= 80; ++i) {
        creeping.emplace_back(0.0025 * i, 0);
    }
    const std::vector<DebugTrail> trails{{creeping}, {std::vector<Vec2>(20, Vec2(1, 1))}};
    DebugView view = closeView({.trails = true});
    view.trails = trails;
    QCOMPARE(recorded(World(), view).size(), std::size_t{99});
    view.area = Aabb{{-4, -3}, {4, 3}};
    const std::vector<DrawCall> seen = recorded(World(), view);
    QVERIFY(seen.size() >= 16 && seen.size() <= 20 && (seen.front().points[0] - Vec2(400, 300)).norm() < 1e-9);
    QVERIFY((seen.back().points[1] - Vec2(420, 300)).norm() < 1.5);
}

void DebugOverlaysTest::arrowsShorterThanADotAreLeftOut() {
    World world(withIterations(1, {0, 0}));
    for (const double speed : {0.009, 0.011}) {
        BodyDef def = ball({100 * speed, 0}, 0.1);
        def.velocity = {0, speed};
        add(world, def);
    }
    DebugView view = closeView({.velocity = true});
    QCOMPARE(recorded(world, view).size(), std::size_t{2});
    view.area = Aabb{{-4, -3}, {4, 3}};
    QCOMPARE(recorded(world, view).size(), std::size_t{1});
}

void DebugOverlaysTest::onlyWhatIsInViewIsDrawn() {
    World world(withIterations(4));
    std::vector<Shape> floor;
    for (int i = 0; i < 200; ++i) {
        floor.push_back(Edge{{i * 1.0, 0}, {i + 1.0, 0}, 0.5});
    }
    add(world, {.kind = BodyKind::Static, .shapes = floor});
    for (int i = 0; i < 50; ++i) {
        add(world, ball({4.0 * i + 0.5, 0.2}, 0.2));
    }
    run(world, 0.1);
    DebugView view = closeView({.aabb = true,
                                .incircle = true,
                                .velocity = true,
                                .orientation = true,
                                .normals = true,
                                .quadtree = true,
                                .contacts = true,
                                .masses = true,
                                .islands = true,
                                .risk = true});
    const std::size_t all = recorded(world, view).size();
    view.area = Aabb{{-4, -3}, {4, 3}};
    const std::vector<DrawCall> few = recorded(world, view);
    QVERIFY(few.size() > 20 && few.size() * 5 < all);
    const Aabb near = Aabb{{0, 0}, view.view.size}.grown(400);
    for (const DrawCall& call : few) {
        const bool isLarge = call.form == Form::Rectangle || call.form == Form::FilledRectangle;
        QVERIFY(isLarge || std::ranges::any_of(call.points, [&](const Vec2& p) { return near.contains(p); }));
    }
}

SPACETOW_TEST(DebugOverlaysTest)
#include "debug_overlays_test.moc"
