#include "tests/support/contact_scenes.h"
#include "tests/support/rows.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

const char* const shapes[] = {"circle", "edge", "line", "polygon"};
const char* const kinds[] = {"static", "kinematic", "dynamic"};

bool isWall(const QString& shape) {
    return shape == "edge" || shape == "line";
}

BodyKind kindNamed(const QString& name) {
    return name == "static" ? BodyKind::Static : name == "kinematic" ? BodyKind::Kinematic : BodyKind::Dynamic;
}

/// Something elastic, left or right of the origin, that faces and approaches it unless it is static.
BodyDef approaching(const QString& shape, const QString& kind, double side) {
    BodyDef def{.kind = kindNamed(kind)};
    if (shape == "circle") {
        def.shapes = {Circle{{0, 0}, 0.3}};
    } else if (shape == "edge") {
        def.shapes = {Edge{{0, -0.5 * side}, {0, 0.5 * side}, 0.1}};
    } else if (shape == "line") {
        def.shapes = {Line{{0, -0.5}, {0, 0.5}}};
    } else {
        def = box({0, 0}, 0.3, 0.3);
        def.kind = kindNamed(kind);
    }
    def.position = {1.2 * side, 0};
    def.velocity = {kind == "static" ? 0 : -side, 0};
    def.restitution = 1;
    def.friction = 0;
    return def;
}

struct Met {
    int began = 0, ended = 0;
    bool solid = false;
    BodyState a, b;
};

Met meeting(const BodyDef& a, const BodyDef& b, int iterations) {
    World world(withIterations(iterations, {0, 0}));
    const BodyId idA = add(world, a);
    const BodyId idB = add(world, b);
    Met met{.a = world.body(idA), .b = world.body(idB)};
    for (int i = 0; i < 220; ++i) {
        world.update();
        met.began += static_cast<int>(world.events().began.size());
        met.ended += static_cast<int>(world.events().ended.size());
        for (const TouchEvent& event : world.events().began) {
            met.solid |= event.solid;
        }
    }
    met.a = world.body(idA);
    met.b = world.body(idB);
    return met;
}

} // namespace

class ShapePairsTest : public QObject {
    Q_OBJECT

  private slots:
    void everyPairMeetsAsItShould_data() {
        QTest::addColumn<QString>("shapeA");
        QTest::addColumn<QString>("kindA");
        QTest::addColumn<QString>("shapeB");
        QTest::addColumn<QString>("kindB");
        for (const char* shapeA : shapes) {
            for (const char* kindA : kinds) {
                for (const char* shapeB : shapes) {
                    for (const char* kindB : kinds) {
                        QTest::addRow("a %s %s and a %s %s", kindA, shapeA, kindB, shapeB)
                            << shapeA << kindA << shapeB << kindB;
                    }
                }
            }
        }
    }
    void everyPairMeetsAsItShould() {
        QFETCH(QString, shapeA);
        QFETCH(QString, kindA);
        QFETCH(QString, shapeB);
        QFETCH(QString, kindB);
        const BodyDef a = approaching(shapeA, kindA, -1);
        const BodyDef b = approaching(shapeB, kindB, 1);
        const double approach = a.velocity.x() - b.velocity.x();
        const bool dynamic = kindA == "dynamic" || kindB == "dynamic";
        const bool collides = dynamic && !(isWall(shapeA) && isWall(shapeB));
        for (const int iterations : iterationCounts) {
            const Met met = meeting(a, b, iterations);
            QCOMPARE(met.began, collides ? 1 : 0);
            QCOMPARE(met.ended, met.began);
            QCOMPARE(met.solid, collides);
            if (!collides) {
                QVERIFY(met.a.velocity == a.velocity && met.b.velocity == b.velocity);
                continue;
            }
            QVERIFY2(std::abs(met.b.velocity.x() - met.a.velocity.x() - approach) < 1e-9,
                     qPrintable(QString::number(met.b.velocity.x() - met.a.velocity.x())));
            QVERIFY(std::abs(met.a.angularVelocity) < 1e-9 && std::abs(met.b.angularVelocity) < 1e-9);
            QVERIFY(std::abs(met.a.velocity.y()) < 1e-9 && std::abs(met.b.velocity.y()) < 1e-9);
            QVERIFY(kindA == "dynamic" || met.a.velocity == a.velocity);
            QVERIFY(kindB == "dynamic" || met.b.velocity == b.velocity);
            if (kindA == "dynamic" && kindB == "dynamic") {
                const Vec2 momentum = met.a.mass * met.a.velocity + met.b.mass * met.b.velocity;
                QVERIFY((momentum - met.a.mass * a.velocity - met.b.mass * b.velocity).norm() < 1e-9);
            }
        }
    }

    void everyPairIsFeltWhenOneIsIntangible_data() { everyPairMeetsAsItShould_data(); }
    void everyPairIsFeltWhenOneIsIntangible() {
        QFETCH(QString, shapeA);
        QFETCH(QString, kindA);
        QFETCH(QString, shapeB);
        QFETCH(QString, kindB);
        const BodyDef a = approaching(shapeA, kindA, -1);
        BodyDef b = approaching(shapeB, kindB, 1);
        b.tangible = false;
        const bool moves = kindA != "static" || kindB != "static";
        for (const int iterations : iterationCounts) {
            const Met met = meeting(a, b, iterations);
            if (!(isWall(shapeA) && isWall(shapeB))) { // two parallel lines without thickness may pass between updates
                QCOMPARE(met.began, moves ? 1 : 0);
            }
            QCOMPARE(met.ended, met.began);
            QVERIFY(!met.solid);
            QVERIFY(met.a.velocity == a.velocity && met.b.velocity == b.velocity);
        }
    }
};

SPACETOW_TEST(ShapePairsTest)
#include "shape_pairs_test.moc"
