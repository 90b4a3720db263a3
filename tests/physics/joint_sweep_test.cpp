#include "tests/support/joint_scenes.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

const char* const jointedWalls[] = {"edges", "thin edges", "lines", "boxes", "uneven boxes"};
const char* const mixedWalls[][2] = {
    {"edges", "lines"}, {"lines", "edges"}, {"thin edges", "lines"}, {"lines", "thin edges"}, {"edges", "thin edges"}};
const char* const passingBodies[] = {"box", "ship", "bar", "hexagon", "convex", "concave"};

/// 0, or a power of ten from 10^low to 10^high with either sign.
double tiny(Random& random, int low, int high) {
    const auto exponents = static_cast<std::uint32_t>(high - low + 1);
    const auto which = static_cast<int>(random.below(2 * exponents + 1));
    const double size = std::pow(10.0, low + (which - 1) / 2);
    return which == 0 ? 0 : (which % 2 == 0 ? size : -size);
}

template <class T, std::size_t n>
T anyOf(Random& random, const T (&list)[n]) {
    return list[random.below(n)];
}

QString described(const JointedFloor& floor, const Crossing& passage, const Felt& felt) {
    return QString("%1%2 at %3°, missing by (%4, %5) m; %6 corner at %7 m, %8 m/s, %9 iterations: ")
               .arg(floor.then.isEmpty() ? floor.walls : floor.walls + ", then " + floor.then,
                    floor.oneBody ? " of one body" : "")
               .arg(floor.angle * 180 / pi)
               .arg(floor.miss.x())
               .arg(floor.miss.y())
               .arg(passage.leading ? "leading" : "trailing")
               .arg(passage.beside)
               .arg(passage.speed)
               .arg(passage.iterations) +
           QString("%1 m/s, %2 rad, %3 m").arg(felt.speed).arg(felt.turn).arg(felt.hop);
}

} // namespace

class JointSweepTest : public QObject {
    Q_OBJECT

  private slots:
    void noJointIsFelt_data();
    void noJointIsFelt();
    void aCrateSlidesOverAChainFromAnyPointOfTheGrid();
    void wallsThatMeetButForTheLastBitAreOneSurface();
    void aBoxRestsBesideAJoint();
    void aShipRestsInTheTipOfAHollow();
    void aHexagonRestsShortOfAJoint();
};

void JointSweepTest::noJointIsFelt_data() {
    QTest::addColumn<QString>("what");
    QTest::addColumn<bool>("exact");
    QTest::addColumn<bool>("mixed");
    for (const char* what : passingBodies) {
        for (const bool mixed : {false, true}) {
            QTest::addRow("%s, pieces%s that meet", what, mixed ? " of two kinds" : "") << what << true << mixed;
            QTest::addRow("%s, pieces%s that nearly meet", what, mixed ? " of two kinds" : "")
                << what << false << mixed;
        }
    }
}

void JointSweepTest::noJointIsFelt() {
    QFETCH(QString, what);
    QFETCH(bool, exact);
    QFETCH(bool, mixed);
    constexpr double speeds[] = {0, 0.1, 0.5, 1, 3, 5, 9, 20, 50};
    constexpr int counts[] = {1, 4, 20, 100};
    const unsigned usual = mixed ? 60 : 160;
    for (unsigned seed = 0; seed < fullOrQuick(2000u, usualOrThin(usual, 20u)); ++seed) {
        Random random(seed);
        JointedFloor floor{.walls = anyOf(random, jointedWalls), .oneBody = random.below(2) == 0};
        if (mixed) {
            const auto& kinds = mixedWalls[random.below(std::size(mixedWalls))];
            floor.walls = kinds[0];
            floor.then = kinds[1];
        }
        floor.angle = random.below(24) * pi / 12;
        if (!exact) {
            floor.miss = {tiny(random, -16, -6), tiny(random, -16, -6)};
        }
        Crossing passage{.outline = lyingShapeOf(what, random), .leading = random.below(2) == 0};
        passage.beside = tiny(random, -16, -4);
        passage.speed = anyOf(random, speeds);
        passage.iterations = anyOf(random, counts);
        const std::optional<Lying> body = lying(passage.outline);
        if (!body) {
            continue;
        }
        const Felt felt = passed(floor, passage, *body);
        // A step is felt for what it is. Two parts of one body that are nearly in one plane are balanced by the
        // solver within some 1e-4 rad only, on a single wall as well.
        const double miss = std::abs(floor.miss.x()) + std::abs(floor.miss.y());
        const double rounding = what == "concave" ? 3e-4 : 1e-9;
        const bool fine = felt.speed <= (what == "concave" ? 1e-5 : 1e-6) && felt.turn <= rounding + 20 * miss &&
                          felt.hop <= 0.1 * rounding + 2 * miss;
        QVERIFY2(fine, qPrintable(QString("seed %1, ").arg(seed) + described(floor, passage, felt)));
    }
}

void JointSweepTest::aCrateSlidesOverAChainFromAnyPointOfTheGrid() {
    for (const bool oneWay : {false, true}) {
        for (int i = 0; i < 66; ++i) {
            const double x = -0.4 - 0.1 * i;
            World world;
            BodyDef floor{.kind = BodyKind::Static, .friction = 0};
            for (const auto& [from, to] : {std::pair(-10.0, 0.0), std::pair(0.0, 60.0)}) {
                floor.shapes.push_back(oneWay ? Shape(Edge{{from, 0}, {to, 0}}) : Shape(Line{{from, 0}, {to, 0}}));
            }
            add(world, floor);
            BodyDef crate = box({x, 0.25}, 0.25, 0.25);
            crate.friction = 0;
            crate.velocity = {5, 0};
            const BodyId id = add(world, crate);
            run(world, (1 - x) / 5);
            QVERIFY2(std::abs(world.body(id).angle) < 1e-9 && std::abs(world.body(id).velocity.x() - 5) < 1e-9,
                     qPrintable(QString("from %1").arg(x)));
        }
    }
}

void JointSweepTest::wallsThatMeetButForTheLastBitAreOneSurface() {
    int missing = 0;
    for (int i = -40; i <= 40; ++i) {
        const double x = i / 10.0; // as the mouse puts it on a grid of 0.1
        const double end = (i + 10) / 10.0;
        missing += x + 1 != end ? 1 : 0;
        World world;
        for (const auto& [at, length] : {std::pair(x, 1.0), std::pair(end, 3.8)}) {
            BodyDef wall = lineBody({0, 0}, {length, 0});
            wall.position = {at, 3};
            wall.friction = 0;
            add(world, wall);
        }
        BodyDef crate = box({x + 0.3, 3.3}, 0.3, 0.3);
        crate.friction = 0;
        crate.velocity = {3, 0};
        const BodyId id = add(world, crate);
        run(world, 0.6);
        QVERIFY2(std::abs(world.body(id).velocity.x() - 3) < 1e-9 && std::abs(world.body(id).angle) < 1e-9,
                 qPrintable(QString("at %1").arg(x)));
    }
    QVERIFY(missing > 5);
}

void JointSweepTest::aBoxRestsBesideAJoint() {
    for (const int iterations : {1, 4, 20, 100}) {
        for (int exponent = -16; exponent <= -4; ++exponent) {
            World world(withIterations(iterations));
            add(world, edgeBody({-5, 0}, {0, 0}));
            add(world, edgeBody({0, 0}, {5, 0}));
            const BodyId id = add(world, box({0.2 + std::pow(10.0, exponent), 0.2}, 0.2, 0.2));
            run(world, 1);
            const BodyState state = world.body(id);
            QVERIFY2(std::abs(state.angle) < 1e-9 && std::abs(state.massCenter.y() - 0.2) < 1e-9,
                     qPrintable(QString("1e%1 m beside it, %2 iterations").arg(exponent).arg(iterations)));
        }
    }
}

void JointSweepTest::aShipRestsInTheTipOfAHollow() {
    const Polygon ship = std::get<Polygon>(dropped("ship", {0, 0}).shapes.front());
    const Rot half = Rot::fromAngle(75 * pi / 180); // of the opening
    const Vec2 left(-20 * half.s, 20 * half.c);
    const Vec2 right(20 * half.s, 20 * half.c);
    const Vec2 flank = ship.vertices[1] - ship.vertices[0];
    const double angle = std::atan2(right.y(), right.x()) - std::atan2(flank.y(), flank.x());
    const Vec2 inward = (leftOf(right) + right).normalized();
    for (const int iterations : {1, 4, 10, 20, 100}) {
        World world(withIterations(iterations, {0, 0}));
        add(world, edgeBody(left, {0, 0}));
        add(world, edgeBody({0, 0}, right));
        BodyDef def = dropped("ship", {0, 0});
        def.angle = angle;
        def.position = 1.4142e-9 * inward - Rot::fromAngle(angle) * ship.vertices[0];
        const BodyId id = add(world, def);
        world.update();
        QVERIFY(std::abs(std::remainder(world.body(id).angle - angle, 2 * pi)) < 1e-9);
        QVERIFY((world.body(id).pose.position - def.position).norm() < 1e-9);
    }
}

void JointSweepTest::aHexagonRestsShortOfAJoint() {
    for (const int iterations : {1, 4, 20, 100}) {
        for (const double shortBy : {1e-6, 1e-5, 2e-5, 4.5e-5, 1e-3}) {
            World world(withIterations(iterations));
            add(world, edgeBody({-5, 0}, {0, 0}));
            add(world, edgeBody({0, 0}, {5, 0}));
            const std::optional<Lying> lies = lying(std::get<Polygon>(hexagon({0, 0}).shapes.front()));
            BodyDef def{.shapes = {lies->outline}, .position = {-shortBy - lies->right, -lies->low}};
            const BodyId id = add(world, def);
            for (int i = 0; i < 5; ++i) {
                world.update();
                QVERIFY(std::abs(world.body(id).angularVelocity) < 1e-9);
                QVERIFY(std::abs(world.body(id).velocity.y()) < 1e-9);
            }
        }
    }
}

SPACETOW_TEST(JointSweepTest)
#include "joint_sweep_test.moc"
