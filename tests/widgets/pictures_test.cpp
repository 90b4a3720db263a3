#include "editor/canvas/scene_painter.h"

#include "core/game/session.h"
#include "core/level/edits.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/painter_draw.h"
#include "editor/play/scene_marks.h"
#include "tests/support/board.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"

#include <QImage>

#include <functional>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// 20 × 20 m about the origin at 10 pixels a metre.
Viewport smallView() {
    Viewport view;
    view.scale = 10;
    view.size = Vec2(200, 200);
    return view;
}

QImage painted(const std::function<void(const Stage&)>& paint,
               QPainter::CompositionMode mode = QPainter::CompositionMode_SourceOver) {
    QImage image(200, 200, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.setCompositionMode(mode);
    const Viewport view = smallView();
    paint({painter, view, canvasTheme()});
    return image;
}

QImage picture(const Session& session, const OverlayFlags& overlays) {
    return painted([&](const Stage& stage) {
        paintSnapshot(stage, *session.snapshot());
        paintWorldOverlays(stage, session.world(), {.flags = overlays});
    });
}

/// A body about the origin, in a box of 10 × 10 m.
QImage picture(const Shape& shape, const OverlayFlags& overlays, BodyRole role = BodyRole::Object,
               QPainter::CompositionMode mode = QPainter::CompositionMode_SourceOver) {
    Snapshot snapshot;
    const std::vector<Shape> shapes{shape};
    auto look = std::make_shared<BodyLook>(BodyLook{1, 1, role, BodyKind::Dynamic, true, 1, shapes});
    snapshot.moving.push_back({look, Transform{}, Vec2(0, 0), 0});
    return painted(
        [&](const Stage& stage) {
            paintSnapshot(stage, snapshot);
            DebugView view;
            view.view = stage.view.transform();
            view.shapes = false;
            view.overlays = overlays;
            PainterDraw draw(stage.view.size);
            drawBody({.kind = BodyKind::Dynamic, .shapes = shapes, .bounds = Aabb{Vec2(-5, -5), Vec2(5, 5)}}, view,
                     draw);
            draw.paint(stage);
        },
        mode);
}

int brightPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += image.pixelColor(x, y).lightness() > 20 ? 1 : 0;
        }
    }
    return count;
}

Level twoBoxes() {
    Level level;
    for (const double x : {-4.0, 4.0}) {
        BodyObject made;
        made.kind = BodyKind::Static;
        made.shapes = {Polygon{{Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}}};
        made.position = Vec2(x, 0);
        level.objects.append({static_cast<Key>(level.objects.size() + 1), {}, made, {}});
    }
    return level;
}

} // namespace

class PicturesTest : public QObject {
    Q_OBJECT

  private slots:
    void theSameSnapshotGivesTheSamePicture_data() {
        QTest::addColumn<bool>("overlays");
        QTest::newRow("painted three times: no vertex is turned into pixels for good") << false;
        QTest::newRow("painted three times with all overlays") << true;
    }
    void theSameSnapshotGivesTheSamePicture() {
        QFETCH(bool, overlays);
        const OverlayFlags flags{overlays, overlays, overlays, overlays, overlays, overlays};
        Session session = towing(openSpace());
        const QImage first = picture(session, flags);
        QVERIFY(brightPixels(first) > 20);
        QCOMPARE(picture(session, flags), first);
        QCOMPARE(picture(session, flags), first);
    }

    void movingAStaticObjectShows_data() {
        QTest::addColumn<bool>("kept");
        QTest::newRow("in a new picture") << false;
        QTest::newRow("in a picture that is kept between frames") << true;
    }
    void movingAStaticObjectShows() {
        QFETCH(bool, kept);
        const std::vector<Key> keys{1};
        const BoardRequest before = boardRequest(std::make_shared<const Level>(twoBoxes()), smallView());
        const BoardRequest after =
            boardRequest(std::make_shared<const Level>(moved(*before.level, keys, Vec2(0, 5))), smallView());
        Board board([] {});
        const QImage old = shownBy(board, before);
        const QImage fresh = fromScratch(after);
        QVERIFY(fresh != old);
        QCOMPARE(kept ? shownBy(board, after) : fresh, fresh);
        QCOMPARE(fresh.pixelColor(60, 100), editingTheme().background); // where it was
        QVERIFY(fresh.pixelColor(60, 50) != editingTheme().background); // where it is
    }

    void eachBoxIsDrawnOnce_data() {
        QTest::addColumn<int>("shape");
        QTest::newRow("of a circle") << 0;
        QTest::newRow("of an edge, its ends included") << 1;
        QTest::newRow("of a line, its ends included") << 2;
        QTest::newRow("of a polygon, its incircle included") << 3;
    }
    /// By exclusive or: what is drawn twice is gone again.
    void eachBoxIsDrawnOnce() {
        QFETCH(int, shape);
        const Shape shapes[] = {Circle{Vec2(0, 0), 1}, Edge{Vec2(-1, 0), Vec2(1, 0), 0.5},
                                Line{Vec2(-1, 0), Vec2(1, 0)}, Polygon{{Vec2(-1, -1), Vec2(1, -1), Vec2(0, 1)}}};
        const auto mode = QPainter::RasterOp_SourceXorDestination;
        const QImage without = picture(shapes[shape], {.incircle = true, .normals = true}, BodyRole::Object, mode);
        const QImage with =
            picture(shapes[shape], {.aabb = true, .incircle = true, .normals = true}, BodyRole::Object, mode);
        int seen = 0;
        for (int i = 60; i < 140; ++i) { // along the box's lower side, 5 m below the middle
            bool differs = false;
            for (int y = 148; y <= 152; ++y) {
                differs |= with.pixel(i, y) != without.pixel(i, y);
            }
            seen += differs ? 1 : 0;
        }
        QVERIFY2(seen > 30, qPrintable(QString::number(seen)));
    }

    void theGameHasPicturesOfItsOwn_data() {
        QTest::addColumn<int>("role");
        QTest::newRow("the ship is not a bare polygon") << int(BodyRole::Ship);
        QTest::newRow("the payload is not a bare circle") << int(BodyRole::Payload);
        QTest::newRow("the finish is not a bare line") << int(BodyRole::Finish);
    }
    void theGameHasPicturesOfItsOwn() {
        QFETCH(int, role);
        const Shape shapes[] = {Circle{}, Polygon{{Vec2(0, 2.3), Vec2(-2, -1.7), Vec2(0, -0.7), Vec2(2, -1.7)}},
                                Circle{Vec2(0, 0), 2}, Line{Vec2(-2, 0), Vec2(2, 1)}};
        const QImage plain = picture(shapes[role], {});
        QVERIFY(picture(shapes[role], {}, static_cast<BodyRole>(role)) != plain);
        QVERIFY(!OverlayFlags().any()); // what helps to find mistakes is an addition
        QVERIFY(picture(shapes[role], {.aabb = true}) != plain);
    }

    void theThrusterHasAFlame() {
        Session session = towing(openSpace());
        const auto flamePixels = [&session] {
            QImage image(200, 200, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            const Viewport view = smallView();
            paintFlame({painter, view, canvasTheme()}, *session.snapshot());
            return brightPixels(image);
        };
        session.step(idle);
        QCOMPARE(flamePixels(), 0);
        session.step({.thrust = true});
        QVERIFY(flamePixels() > 0);
    }
};

SPACETOW_TEST(PicturesTest)
#include "pictures_test.moc"
