// The overlays of what runs.
#include "editor/canvas/overlay_table.h"
#include "editor/play/trail_keeper.h"
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A ball that falls freely, beside the ship of openSpace when there is to be one.
Level fallingBall() {
    Level level;
    addBall(level, Vec2(0, 3), 0.5, Vec2(1, 0));
    return level;
}

/// In a square of so many by so many, one metre apart.
Level fallingBalls(int across) {
    Level level;
    for (int i = 0; i < across * across; ++i) {
        addBall(level, Vec2(i % across, i / across), 0.3, Vec2(5, 0));
    }
    return level;
}

/// How many pixels are magenta, or nearly so where lines are smooth.
int magentaPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor color = image.pixelColor(x, y);
            count += std::min(color.red(), color.blue()) - color.green() > 120 ? 1 : 0;
        }
    }
    return count;
}

} // namespace

class LiveOverlaysTest : public QObject {
    Q_OBJECT

  private slots:
    void everyOverlayIsDrawnFromWhatRuns_data() {
        QTest::addColumn<int>("row");
        QTest::addColumn<QString>("ink");
        for (const char* name : {"aabb", "velocity", "orientation", "masses", "trails"}) {
            for (std::size_t row = 0; row < overlayRows().size(); ++row) {
                if (QLatin1String(overlayRows()[row].name) == QLatin1String(name)) {
                    QTest::newRow(name) << static_cast<int>(row) << QString(overlayRows()[row].inks.front().name);
                }
            }
        }
    }
    void everyOverlayIsDrawnFromWhatRuns() {
        QFETCH(int, row);
        QFETCH(QString, ink);
        Game game(fallingBall(), {400, 400}, LiveRun::Kind::Simulation);
        game.view().setOverlayPalette({.own = {{ink.toStdString(), Color{255, 0, 255}}}});
        OverlayFlags flags;
        flags.*overlayRows()[static_cast<std::size_t>(row)].flag = true;
        for (int i = 0; i < 10; ++i) {
            game.run(1);
            game.scene().refresh();
        }
        QCOMPARE(magentaPixels(game.view().grab().toImage()), 0);
        game.scene().setOverlays(flags);
        for (int i = 0; i < 10; ++i) {
            game.run(1);
            game.scene().refresh();
        }
        QVERIFY(magentaPixels(game.view().grab().toImage()) > 0);
        QVERIFY(game.live().session() != nullptr);
        game.scene().setOverlays({});
        game.run(1);
        game.scene().refresh();
        QVERIFY(game.live().session() == nullptr); // nobody pays for copies that nobody looks at
        QCOMPARE(magentaPixels(game.view().grab().toImage()), 0);
    }

    void overlaysOfACrowdBelongToTheBodiesThatAreShown_data() {
        QTest::addColumn<int>("across");
        QTest::newRow("few, within the frame") << 10;
        QTest::newRow("many, beside the window") << 25;
    }
    void overlaysOfACrowdBelongToTheBodiesThatAreShown() {
        QFETCH(int, across);
        Game game(fallingBalls(across), {400, 400}, LiveRun::Kind::Simulation);
        game.view().setView(game.view().view().showing({{-1, -1}, {1.0 * across, 1.0 * across}}));
        game.view().setOverlayPalette({.own = {{"mass-center", Color{255, 0, 255}}}});
        game.scene().setOverlays({.masses = true});
        game.run(1);
        game.scene().refresh();
        QTRY_VERIFY(magentaPixels(game.view().grab().toImage()) > 0);
        for (int moment = 0; moment < 8; ++moment) {
            game.run(5);            // half of the way to where its neighbour was
            game.scene().refresh(); // the next picture may not be there yet
            const QImage image = game.view().grab().toImage();
            for (const BodyPicture& body : game.scene().picture().moving) {
                const Vec2 center = game.view().view().toScreen(body.pose.position);
                const QRect about(static_cast<int>(center.x()) - 3, static_cast<int>(center.y()) - 3, 7, 7);
                QVERIFY(!image.rect().contains(about) || magentaPixels(image.copy(about)) > 0);
            }
        }
        QTRY_COMPARE(game.scene().picture().update, game.picture()->update);
        game.run(5);
        game.scene().refresh();
        QCOMPARE(game.scene().isPaintingOverlays(), across > 20);
        game.scene().setOverlays({});
        game.scene().refresh();
        QCOMPARE(magentaPixels(game.view().grab().toImage()), 0);
    }

    void overlaysThatAreSwitchedOffWhileTheyArePaintedDoNotComeBack() {
        Game game(fallingBalls(25), {400, 400}, LiveRun::Kind::Simulation);
        game.view().setOverlayPalette({.own = {{"mass-center", Color{255, 0, 255}}}});
        game.scene().setOverlays({.masses = true});
        game.run(1);
        game.scene().refresh();
        QVERIFY(game.scene().isPaintingOverlays());
        game.scene().setOverlays({});
        QTRY_VERIFY(!game.scene().isPaintingOverlays());
        game.scene().refresh();
        QCOMPARE(magentaPixels(game.view().grab().toImage()), 0);
        QCOMPARE(game.scene().picture().update, game.picture()->update);
    }

    void aFewThatBecomeACrowdKeepTheirTrails() {
        Level level = fallingBalls(10);
        Game game(level, {400, 400}, LiveRun::Kind::Simulation);
        game.view().setOverlayPalette({.own = {{"trail", Color{255, 0, 255}}}});
        game.scene().setOverlays({.trails = true});
        for (int i = 0; i < 10; ++i) {
            game.run(1);
            game.scene().refresh();
        }
        const int before = magentaPixels(game.view().grab().toImage());
        QVERIFY(before > 0);
        for (int i = 0; i < 400; ++i) {
            addBall(level, Vec2(i, 1000), 0.3, Vec2(0, 0));
        }
        game.live().setLevel(std::make_shared<const Level>(level));
        game.run(1);
        game.scene().refresh();
        QVERIFY(game.scene().isPaintingOverlays());
        QTRY_VERIFY(!game.scene().isPaintingOverlays() && game.scene().picture().update == game.picture()->update);
        QVERIFY(magentaPixels(game.view().grab().toImage()) > before / 2);
        game.live().setLevel(std::make_shared<const Level>(fallingBalls(10)));
        game.run(1);
        game.scene().refresh();
        QVERIFY(!game.scene().isPaintingOverlays()); // they are few again
        QVERIFY(magentaPixels(game.view().grab().toImage()) > 0);
    }

    void overlaysOfACrowdFollowViewAndSelectionThoughTimeStands() {
        Game game(fallingBalls(25), {400, 400}, LiveRun::Kind::Simulation);
        game.live().setPaused(true);
        game.view().setOverlayPalette({.own = {{"mass-center", Color{255, 0, 255}}}});
        game.scene().setOverlays({.masses = true});
        game.scene().refresh();
        const auto isMarked = [&](const Vec2& at) {
            const Vec2 screen = game.view().view().toScreen(at);
            const QRect about(static_cast<int>(screen.x()) - 3, static_cast<int>(screen.y()) - 3, 7, 7);
            return magentaPixels(game.view().grab().toImage().copy(about)) > 0;
        };
        for (const double scale : {10.0, 40.0, 25.0}) {
            Viewport view = game.view().view();
            view.center = Vec2(scale / 10, 2);
            view.scale = scale;
            game.view().setView(view);
            QTRY_VERIFY(isMarked({2, 2}) && isMarked({3, 1}));
        }
        game.view().setOverlayPalette({.own = {{"meets", Color{255, 0, 255}}}});
        game.scene().setOverlays({.collides = true});
        game.scene().refresh();
        QTRY_VERIFY(!game.scene().isPaintingOverlays());
        QCOMPARE(magentaPixels(game.view().grab().toImage()), 0); // nothing is selected
        game.document().select(Selection({game.document().level().objects[7].key}));
        QTRY_VERIFY(magentaPixels(game.view().grab().toImage()) > 0);
    }

    void overlaysThatAreSwitchedOnWhileTimeStandsAreThereAtOnce() {
        for (const int across : {5, 25}) {
            Game game(fallingBalls(across), {400, 400}, LiveRun::Kind::Simulation);
            game.view().setOverlayPalette({.own = {{"mass-center", Color{255, 0, 255}}}});
            game.live().wantSession(this, true); // as the window does
            game.run(3);
            game.live().setPaused(true);
            game.scene().refresh();
            game.scene().setOverlays({.masses = true});
            QTRY_VERIFY(magentaPixels(game.view().grab().toImage()) > 0);
        }
    }

    void trailsFollowBodiesAndLoseWhatCameLaterWhenTimeGoesBack() {
        Session session(fallingBall());
        TrailKeeper keeper;
        keeper.note(session);
        const Session start = session;
        for (int i = 0; i < 5; ++i) {
            session.step(Controls{});
            keeper.note(session);
            keeper.note(session); // the same moment is looked at more than once
        }
        QCOMPARE(keeper.trails().size(), std::size_t{1});
        QCOMPARE(keeper.trails()[0].points.size(), std::size_t{6});
        QVERIFY(keeper.trails()[0].points.back() == session.world().body(session.world().bodies()[0]).massCenter);
        Session earlier = start;
        earlier.step(Controls{});
        earlier.step(Controls{});
        keeper.note(earlier);
        QCOMPARE(keeper.trails()[0].points.size(), std::size_t{3});
        QVERIFY(keeper.trails()[0].points.back() == earlier.world().body(earlier.world().bodies()[0]).massCenter);
        keeper.note(start);
        QCOMPARE(keeper.trails()[0].points.size(), std::size_t{1});
    }

    void trailsStayWithTheirBodiesWhenOthersComeAndGo() {
        Level level;
        for (int i = 0; i < 4; ++i) {
            addBall(level, Vec2(3.0 * i, 0), 0.5, Vec2(0, 1));
        }
        Session session(level);
        TrailKeeper keeper;
        keeper.note(session);
        session.step(Controls{});
        keeper.note(session);
        Level other = level;
        other.objects.erase(1);
        Object fresh = level.objects[0]; // which may take the slot
        fresh.key = 99;
        std::get<BodyObject>(fresh.data).position = Vec2(-5, 0);
        other.objects.append(fresh);
        session.step({{}, {}, std::make_shared<const Level>(other)});
        keeper.note(session);
        const std::vector<BodyId> bodies = session.world().bodies();
        QVERIFY(bodies.size() == 4 && keeper.trails().size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::vector<Vec2>& points = keeper.trails()[i].points;
            const Vec2 now = session.world().body(bodies[i]).massCenter;
            QCOMPARE(points.size(), now.x() < -4 ? std::size_t{1} : std::size_t{3});
            QVERIFY(points.back() == now && std::abs(points.front().x() - now.x()) < 0.1);
        }
    }

    void trailsAreNoLongerThanThereIsTimeFor() {
        Level level;
        for (int i = 0; i < 1000; ++i) {
            addBall(level, Vec2(3.0 * i, 0), 0.5, Vec2(0, 0));
        }
        level.iterations = 1;
        Session session(level);
        TrailKeeper keeper;
        for (int i = 0; i < 20; ++i) {
            session.step(Controls{});
            keeper.note(session);
        }
        std::size_t points = 0;
        for (const DebugTrail& trail : keeper.trails()) {
            points += trail.points.size();
        }
        QVERIFY(points <= 12000 && points >= 4000);
    }
};

SPACETOW_TEST(LiveOverlaysTest)
#include "live_overlays_test.moc"
