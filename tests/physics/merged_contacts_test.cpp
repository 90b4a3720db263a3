// One contact stands for several in one plane, for as long as what it is made of lasts.

#include "tests/support/contact_scenes.h"

#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double tileWidth = 1; // m; tiles are about x = −4, −3 … 4, and level with y = 0
constexpr int farthest = 4;

struct Tiled {
    World world;
    std::map<int, BodyId> tiles; // by x
    BodyId body;
};

BodyDef tile(const QString& floor, int at) {
    const Vec2 left(at - 0.5 * tileWidth, 0);
    const Vec2 right(at + 0.5 * tileWidth, 0);
    if (floor == "boxes") {
        return box({static_cast<double>(at), -0.5}, 0.5 * tileWidth, 0.5);
    }
    return floor == "lines" ? lineBody(left, right) : edgeBody(left, right);
}

/// Four metres wide and one high, as one box or as two.
BodyDef wide(const QString& what) {
    BodyDef def = box({0.1, 0.51}, 2, 0.5);
    if (what == "two boxes") {
        const auto half = [](double from, double to) {
            return Polygon{{{from, -0.5}, {to, -0.5}, {to, 0.5}, {from, 0.5}}};
        };
        def.shapes = {half(-2, 0), half(0, 2)};
    }
    return def;
}

/// The scene of the current row, with that velocity.
Tiled tiled(const Vec2& velocity = {0, 0}) {
    QFETCH(QString, floor);
    QFETCH(QString, what);
    QFETCH(int, iterations);
    BodyDef body = wide(what);
    body.velocity = velocity;
    Tiled scene{World(withIterations(iterations)), {}, {}};
    body.friction = 0.5;
    for (int at = -farthest; at <= farthest; ++at) {
        BodyDef def = tile(floor, at);
        def.kind = BodyKind::Static;
        def.friction = 0.5;
        scene.tiles[at] = add(scene.world, def);
    }
    scene.body = add(scene.world, body);
    return scene;
}

void addRows() {
    QTest::addColumn<QString>("floor");
    QTest::addColumn<QString>("what");
    QTest::addColumn<int>("iterations");
    for (const char* floor : {"edges", "lines", "boxes"}) {
        for (const char* what : {"one box", "two boxes"}) {
            for (const int iterations : {1, 4, 20}) {
                QTest::addRow("%s on %s, %d iterations", what, floor, iterations) << floor << what << iterations;
            }
        }
    }
}

/// How often each tile's touch has begun and ended.
struct Touches {
    std::map<int, int> began, ended;

    void update(Tiled& scene, int updates) {
        for (int i = 0; i < updates; ++i) {
            scene.world.update();
            for (const auto& [at, id] : scene.tiles) {
                const auto ofTile = [id = id](const TouchEvent& touch) { return touch.a == id; };
                const Events& events = scene.world.events();
                began[at] += static_cast<int>(std::count_if(events.began.begin(), events.began.end(), ofTile));
                ended[at] += static_cast<int>(std::count_if(events.ended.begin(), events.ended.end(), ofTile));
            }
        }
    }
};

} // namespace

class MergedContactsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatStandsOnTilesTouchesAllOfThemUntilItIsLifted_data() { addRows(); }
    void whatStandsOnTilesTouchesAllOfThemUntilItIsLifted() {
        Tiled scene = tiled();
        Touches touches;
        touches.update(scene, 90);
        QVERIFY(std::abs(scene.world.body(scene.body).angle) < 1e-9); // it came down flat
        for (const auto& [at, id] : scene.tiles) {
            QCOMPARE(touches.began[at], std::abs(at) <= 2 ? 1 : 0);
            QCOMPARE(touches.ended[at], 0);
        }
        scene.world.setVelocity(scene.body, {0, 2}, 0);
        touches.update(scene, 6);
        for (const auto& [at, id] : scene.tiles) {
            QCOMPARE(touches.began[at], std::abs(at) <= 2 ? 1 : 0);
            QCOMPARE(touches.ended[at], touches.began[at]);
        }
    }

    void tilesThatAreTakenAwayBearNothing_data() { addRows(); }
    void tilesThatAreTakenAwayBearNothing() {
        Tiled scene = tiled();
        run(scene.world, 1);
        for (int at = 1; at <= farthest; ++at) {
            scene.world.removeBody(scene.tiles[at]);
        }
        run(scene.world, 0.5); // its centre is at 0.1, and the floor now ends at 0.5
        QVERIFY(std::abs(scene.world.body(scene.body).angle) < 1e-3);
        scene.world.removeBody(scene.tiles[0]);
        run(scene.world, 0.5);
        QVERIFY(scene.world.body(scene.body).angle < -0.1);
    }

    /// What is found anew in every update is what would have been kept.
    void keptMergersMoveABodyAsNewOnesDo_data() { addRows(); }
    void keptMergersMoveABodyAsNewOnesDo() {
        Tiled keeping = tiled({1.5, 0});
        Tiled forgetting = keeping;
        for (int i = 0; i < 120; ++i) {
            forgetting.world.setFilter(forgetting.body, forgetting.world.body(forgetting.body).filter);
            keeping.world.update();
            forgetting.world.update();
            const BodyState a = keeping.world.body(keeping.body);
            const BodyState b = forgetting.world.body(forgetting.body);
            QVERIFY2((a.massCenter - b.massCenter).norm() < 1e-4 && std::abs(a.angle - b.angle) < 1e-4,
                     qPrintable(QString("update %1").arg(i)));
        }
        QVERIFY(keeping.world.body(keeping.body).massCenter.x() > 0.2); // it has slid, and stopped
        QVERIFY(std::abs(keeping.world.body(keeping.body).velocity.x()) < 1e-6);
    }
};

SPACETOW_TEST(MergedContactsTest)
#include "merged_contacts_test.moc"
