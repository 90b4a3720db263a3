// Each overlay as it looks: the colour of its own stands where the formula says.
#include "core/level/bounds.h"
#include "core/physics/query/contact_manifolds.h"
#include "core/physics/query/queries.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"
#include "tests/support/board.h"
#include "tests/support/cpu_time.h"
#include "tests/support/test_main.h"

#include <QImage>

#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr Color markColor{255, 0, 255};
constexpr Key ballKey = 2;
constexpr Key boxKey = 3;

Object overlayBody(Key key, BodyKind kind, LevelShape shape, const Vec2& position) {
    BodyObject made;
    made.kind = kind;
    made.shapes = {std::move(shape)};
    made.position = position;
    return {key, {}, made, {}};
}

/// A floor a metre deep at y = −4; a ball at (−5, 2) that falls at 6 m/s; a crate that stands on the floor at x = 0;
/// and a ball at (5, 1) that hangs on a spring pulled to twice its length, from (5, 5).
Level overlayLevel() {
    Level level;
    level.objects.append(
        overlayBody(1, BodyKind::Static, EdgeChain{{Vec2(-8, -4), Vec2(8, -4)}, false, 1}, Vec2(0, 0)));
    Object ball = overlayBody(ballKey, BodyKind::Dynamic, Circle{{0, 0}, 1}, Vec2(-5, 2));
    std::get<BodyObject>(ball.data).velocity = {0, -6};
    level.objects.append(ball);
    Object crate = overlayBody(boxKey, BodyKind::Dynamic, Polygon{{Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}},
                               Vec2(0, -3));
    crate.name = "crate";
    level.objects.append(crate);
    level.objects.append(overlayBody(4, BodyKind::Static, Circle{{0, 0}, 0.2}, Vec2(5, 5)));
    level.objects.append(overlayBody(5, BodyKind::Dynamic, Circle{{0, 0}, 0.2}, Vec2(5, 1)));
    ConnectorObject spring;
    spring.a = 4;
    spring.b = 5;
    spring.length = 2;
    level.objects.append({6, {}, spring, {}});
    level.tags.set(wallTag, {"WALL", 0xff00ff});
    return level;
}

/// 20 × 20 m about the origin at 20 pixels a metre.
Viewport overlayView() {
    Viewport view;
    view.scale = 20;
    view.size = Vec2(400, 400);
    return view;
}

/// On black, with one colour markColor.
QImage overlayPicture(const OverlayFlags& flags, const std::string& ink, const Level& level = overlayLevel()) {
    const Viewport view = overlayView();
    QImage image(400, 400, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    const std::vector<Key> selected{ballKey};
    paintLevelOverlays({painter, view, canvasTheme()}, *overlayWorlds(level, flags),
                       {.flags = flags, .palette = {.own = {{ink, markColor}}}, .level = &level, .selected = selected});
    return image;
}

/// The most that a pixel beside the point, by up to two, has of the markColor colour and of no other; 0 … 255.
int markedNear(const QImage& image, const Vec2& world, int reach = 2) {
    const Vec2 at = overlayView().toScreen(world);
    int most = 0;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            const QPoint pixel(static_cast<int>(at.x()) + x, static_cast<int>(at.y()) + y);
            if (image.rect().contains(pixel)) {
                const QColor color = image.pixelColor(pixel);
                most = std::max(most, std::min(color.red(), color.blue()) - color.green());
            }
        }
    }
    return most;
}

OverlayFlags onlyOverlay(const QString& name) {
    return withOverlay({.problems = false}, name.toStdString()).value_or(OverlayFlags());
}

} // namespace

class OverlayPicturesTest : public QObject {
    Q_OBJECT

  private slots:
    void trailsOfManyBodiesAreSimulatedBesideTheWindow() {
        Level level;
        for (Key key = 1; key <= 60; ++key) {
            level.objects.append(
                overlayBody(key, BodyKind::Dynamic, Circle{{0, 0}, 0.2}, Vec2(-15 + 0.5 * double(key), 3)));
        }
        Viewport view;
        view.size = Vec2(300, 200);
        BoardRequest request = boardRequest(std::make_shared<const Level>(level), view.showing(boundsOf(level)));
        Board board([] {});
        const QImage without = finishedBy(board, request);
        request.overlays.trails = true;
        QCOMPARE(shownBy(board, request), without); // not yet
        QVERIFY(finishedBy(board, request) != without);
    }

    void theColourStandsWhereTheFormulaSays_data() {
        QTest::addColumn<QString>("overlay");
        QTest::addColumn<QString>("ink");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("least"); // of 255
        QTest::newRow("box") << "aabb"
                             << "box" << -6.0 << 2.0 << 100;
        QTest::newRow("incircle") << "incircle"
                                  << "incircle" << 0.0 << -2.0 << 150;
        QTest::newRow("velocity") << "velocity"
                                  << "velocity" << -5.0 << -1.0 << 150;
        QTest::newRow("orientation") << "orientation"
                                     << "orientation" << 0.0 << -2.5 << 150;
        QTest::newRow("normal") << "normals"
                                << "normal" << 0.0 << -3.5 << 150;
        QTest::newRow("depth, filled") << "normals"
                                       << "depth" << 4.0 << -4.5 << 40;
        QTest::newRow("depth, its end") << "normals"
                                        << "depth" << 4.0 << -5.0 << 150;
        QTest::newRow("contact") << "contacts"
                                 << "touch-point" << 1.0 << -4.0 << 200;
        QTest::newRow("contact normal") << "contacts"
                                        << "contact-normal" << 1.0 << -4.4 << 150;
        QTest::newRow("tension") << "tension"
                                 << "pulled" << 5.0 << 3.0 << 200;
        QTest::newRow("trail") << "trails"
                               << "trail" << -5.0 << 0.0 << 30;
        QTest::newRow("centre of mass") << "masses"
                                        << "mass-center" << -5.0 << 2.0 << 200;
        QTest::newRow("tag") << "tags"
                             << "none" << -6.0 << 2.0 << 150;
        QTest::newRow("risk") << "risk"
                              << "safe" << -5.0 << -4.0 << 200;
        QTest::newRow("collides") << "collides"
                                  << "meets" << 0.0 << -2.0 << 150;
    }
    void theColourStandsWhereTheFormulaSays() {
        QFETCH(QString, overlay);
        QFETCH(QString, ink);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, least);
        const OverlayFlags flags = onlyOverlay(overlay);
        QVERIFY(flags.any());
        const int found = markedNear(overlayPicture(flags, ink.toStdString()), Vec2(x, y));
        QVERIFY2(found >= least, qPrintable(QString::number(found)));
        QCOMPARE(markedNear(overlayPicture({}, ink.toStdString()), Vec2(x, y)), 0);
    }

    void frictionHasAnArrowAlongTheSurface() {
        Level level = overlayLevel();
        level.gravity = Vec2(0, -9.81);
        for (int i = 0; i < level.objects.size(); ++i) {
            Object object = level.objects[i];
            auto* const body = std::get_if<BodyObject>(&object.data);
            if (body != nullptr) {
                body->friction = 1;
                body->velocity = object.key == boxKey ? Vec2(3, 0) : body->velocity; // the crate slides to the right
                level.objects.replace(i, object);
            }
        }
        const OverlayFlags flags{.contacts = true};
        const auto worlds = overlayWorlds(level, flags);
        const World& world = worlds->touched;
        const BodyId crate = world.bodies()[2];
        int tried = 0;
        for (const ContactManifold& contact : contactManifolds(world)) {
            if (contact.a != crate && contact.b != crate) {
                continue;
            }
            const UpdateParameters& parameters = world.parameters();
            const double weight = world.body(crate).mass * 9.81;
            const Vec2 force = contact.tangentImpulse * parameters.iterations / parameters.seconds / weight *
                               leftOf(contact.normal) * (contact.b == crate ? 1 : -1);
            QVERIFY2(force.x() < -0.3, qPrintable(QString::number(force.x()))); // it brakes the crate
            const Vec2 drawn = contact.b == crate ? force : Vec2(-force);
            const Vec2 at = contact.points[0].at + 0.7 * drawn;
            QVERIFY(markedNear(overlayPicture(flags, "impulse", level), at) > 150);
            level.objects.replace(2, overlayLevel().objects[2]); // which stands still
            QCOMPARE(markedNear(overlayPicture(flags, "impulse", level), at, 1), 0);
            ++tried;
        }
        QCOMPARE(tried, 1);
    }

    void aFatBoxHasRoomToMove() {
        const OverlayFlags flags{.aabb = true};
        const auto worlds = overlayWorlds(overlayLevel(), flags);
        const World& world = worlds->start;
        const Aabb fat = world.bounds(world.bodies()[1]);
        const QImage image = overlayPicture(flags, "fat-box");
        QVERIFY(fat.size().x() > 2.01);
        QVERIFY(markedNear(image, Vec2(fat.min.x(), 2)) > 150);
    }

    void cellsOfBothTreesHaveTheirBorders() {
        const OverlayFlags flags{.quadtree = true};
        const auto worlds = overlayWorlds(overlayLevel(), flags);
        int tried = 0;
        for (const QuadtreeCell& cell : occupiedCells(worlds->start)) {
            const Vec2 at(cell.box.min.x(), cell.box.center().y());
            if (overlayView().visible().contains(at)) {
                ++tried;
                QVERIFY(markedNear(overlayPicture(flags, cell.moving ? "moving-cell" : "static-cell"), at) > 100);
            }
        }
        QVERIFY(tried >= 2);
    }

    void namesStandBesideTheirBodies() {
        const QImage image = overlayPicture({.names = true}, "name");
        QVERIFY(markedNear(image, Vec2(1, -2.5), 16) > 100);
        QCOMPARE(markedNear(image, Vec2(-5, 2), 16), 0); // which has none
    }

    void bodiesHaveTheColourOfTheirIsland() {
        const OverlayFlags flags{.islands = true};
        const auto worlds = overlayWorlds(overlayLevel(), flags);
        const World& world = worlds->touched;
        const BodyId crate = world.bodies()[2];
        const auto island = islandOf(world, crate);
        QVERIFY(island);
        const Color own = overlayColors({}, Shade::Dark).islands[*island % 6];
        const Vec2 at = overlayView().toScreen(Vec2(0.3, -3.3));
        const QColor seen =
            overlayPicture(flags, "none").pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y()));
        QVERIFY(std::abs(seen.red() - own.red * 130 / 255) < 3 && std::abs(seen.green() - own.green * 130 / 255) < 3);
    }

    void everyOverlayIsInOneOfThesePictures() {
        for (const OverlayRow& row : overlayRows()) {
            if (row.ofRuns) {
                QVERIFY2(!withOverlay({}, row.name), row.name);
                continue;
            }
            const OverlayFlags flags = onlyOverlay(QString::fromLatin1(row.name));
            QVERIFY2(flags.*row.flag && flags.any(), row.name);
            QVERIFY2(overlayPicture(flags, "none") != overlayPicture({}, "none"), row.name);
        }
        QVERIFY(!withOverlay({}, "soul"));
    }

    void whatIsHiddenHasNoOverlays() {
        Level level = overlayLevel();
        for (int i = 0; i < level.objects.size(); ++i) {
            Object hidden = level.objects[i];
            hidden.visible = false;
            level.objects.replace(i, hidden);
        }
        OverlayFlags flags{.aabb = true, .velocity = true, .normals = true, .masses = true, .islands = true};
        QImage image(400, 400, QImage::Format_RGB32);
        image.fill(Qt::black);
        const QImage empty = image;
        QPainter painter(&image);
        const Viewport view = overlayView();
        paintLevelOverlays({painter, view, canvasTheme()}, *overlayWorlds(level, flags),
                           {.flags = flags, .level = &level});
        painter.end();
        QCOMPARE(image, empty);
    }

    void ofALargeLevelOnlyWhatIsInViewCostsTime() {
        Level level;
        for (int row = 0; row < 100; ++row) {
            std::vector<Vec2> corners;
            for (int i = 0; i <= 1000; ++i) {
                corners.emplace_back(0.5 * i, 5.0 * row + i % 2);
            }
            level.objects.append(
                overlayBody(static_cast<Key>(row + 1), BodyKind::Static, EdgeChain{corners, false, 0.2}, Vec2(0, 0)));
        }
        const OverlayFlags flags{.aabb = true, .normals = true, .quadtree = true, .contacts = true, .risk = true};
        const auto worlds = overlayWorlds(level, flags);
        Viewport view = overlayView();
        view.center = Vec2(200, 200);
        QImage image(400, 400, QImage::Format_ARGB32_Premultiplied);
        QPainter painter(&image);
        double best = 1e9;
        for (int i = 0; i < 3; ++i) {
            const CpuTimer timer;
            paintLevelOverlays({painter, view, canvasTheme()}, *worlds, {.flags = flags, .level = &level});
            best = std::min(best, 1000 * timer.seconds());
        }
        qInfo("a view of 100,000 edges: %.1f ms", best);
        QVERIFY2(best < 60, qPrintable(QString::number(best)));
    }

    void thousandsOfBodiesArePaintedInTimeForAFrame() {
        Level level;
        for (int i = 0; i < 2000; ++i) {
            level.objects.append(overlayBody(static_cast<Key>(i + 1), BodyKind::Dynamic, Circle{{0, 0}, 0.1},
                                             Vec2(-9.5 + 0.2 * (i % 50), -9 + 0.2 * (i / 50))));
        }
        level.objects.append(
            overlayBody(5000, BodyKind::Static, EdgeChain{{Vec2(-20, -9.1), Vec2(20, -9.1)}, false, 1}, Vec2(0, 0)));
        level.iterations = 4;
        OverlayFlags all;
        for (const OverlayRow& row : overlayRows()) {
            all.*row.flag = true;
        }
        const auto worlds = overlayWorlds(level, all);
        Viewport view = overlayView();
        view.scale = 50;
        view.size = Vec2(1280, 800);
        QImage image(1280, 800, QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::black);
        QPainter painter(&image);
        const Stage stage{painter, view, canvasTheme()};
        const auto milliseconds = [&](const OverlayFlags& flags) {
            double best = 1e9;
            for (int i = 0; i < 3; ++i) {
                const CpuTimer timer;
                paintWorldOverlays(stage, worlds->touched, {.flags = flags, .level = &level, .trails = worlds->trails});
                best = std::min(best, 1000 * timer.seconds());
            }
            return best;
        };
        for (const OverlayRow& row : overlayRows()) {
            qInfo("%s: %.1f ms", row.name, milliseconds(onlyOverlay(QString::fromLatin1(row.name))));
        }
        const double together = milliseconds(all);
        qInfo("all overlays of 2,000 circles: %.1f ms", together);
        QVERIFY2(together < 66, qPrintable(QString::number(together))); // half of it in the release build: 30 a second
    }
};

SPACETOW_TEST(OverlayPicturesTest)
#include "overlay_pictures_test.moc"
