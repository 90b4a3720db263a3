#include "editor/canvas/scene_painter.h"

#include "core/level/edits.h"
#include "editor/canvas/body_painter.h"
#include "editor/canvas/grid_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "tests/support/board.h"
#include "tests/support/color_vision.h"
#include "tests/support/test_main.h"

#include <QImage>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object body(Key key, LevelShape shape, BodyKind kind = BodyKind::Static) {
    BodyObject made;
    made.kind = kind;
    made.shapes = {std::move(shape)};
    return {key, {}, made, {}};
}

/// A square with a side of 4 m about the origin, anticlockwise or clockwise.
std::vector<Vec2> square(bool anticlockwise) {
    std::vector<Vec2> corners{Vec2(-2, -2), Vec2(2, -2), Vec2(2, 2), Vec2(-2, 2)};
    if (!anticlockwise) {
        std::ranges::reverse(corners);
    }
    return corners;
}

/// 10 × 10 m about the origin at 20 pixels a metre.
Viewport sceneView() {
    Viewport view;
    view.scale = 20;
    view.size = Vec2(200, 200);
    return view;
}

template <class Paint>
QImage paintedScene(const Viewport& view, const Paint& paint) {
    QImage image(static_cast<int>(view.size.x()), static_cast<int>(view.size.y()), QImage::Format_RGB32);
    image.fill(canvasTheme().background);
    QPainter painter(&image);
    paint(Stage{painter, view, canvasTheme()});
    return image;
}

QImage picture(const Level& level, const Viewport& view = sceneView()) {
    return paintedScene(view, [&](const Stage& stage) { paintLevel(stage, level, Selection()); });
}

bool isBackground(const QImage& image, double x, double y, const Viewport& view = sceneView()) {
    const Vec2 at = view.toScreen(Vec2(x, y));
    return image.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y())) == canvasTheme().background;
}

Level levelOf(std::vector<Object> objects) {
    Level level;
    for (Object& object : objects) {
        level.objects.append(std::move(object));
    }
    return level;
}

Level mixedLevel() {
    Level level = levelOf({body(1, EdgeChain{square(true), true, noBack}),
                           body(2, Polygon{{Vec2(-1, -1), Vec2(0, -1), Vec2(0, 0)}}, BodyKind::Dynamic),
                           body(3, Circle{Vec2(0.5, 0.5), 0.4}, BodyKind::Kinematic)});
    level.objects.append({4, {}, ShipObject{Vec2(1, -1), 0.5}, {}});
    level.objects.append({5, {}, PayloadObject{Vec2(-1, 1), 0.2, 0.25}, {}});
    level.objects.append({6, {}, FinishObject{Vec2(-1.5, 0.5), Vec2(0, 1.5)}, {}});
    level.objects.append({7, {}, ConnectorObject{2, 3}, {}});
    return level;
}

} // namespace

class ScenePainterTest : public QObject {
    Q_OBJECT

  private slots:
    void theSolidSideOfAWallIsMarked_data() {
        QTest::addColumn<double>("depth");
        QTest::addColumn<double>("behind"); // m, where the band must be seen
        QTest::addColumn<double>("beyond"); // m, where there must be nothing any more
        QTest::newRow("thin") << 0.5 << 0.25 << 0.8;
        QTest::newRow("thick") << 2.0 << 1.7 << 2.3;
        QTest::newRow("no back fades out") << noBack << 0.2 << 2.0;
    }
    void theSolidSideOfAWallIsMarked() {
        QFETCH(double, depth);
        QFETCH(double, behind);
        QFETCH(double, beyond);
        const QImage image = picture(levelOf({body(1, EdgeChain{{Vec2(-3, 0), Vec2(3, 0)}, false, depth})}));
        // Travelling to the right the free side is above.
        QVERIFY(!isBackground(image, 0, -behind));
        QVERIFY(isBackground(image, 0, -beyond));
        QVERIFY(isBackground(image, 0, 0.3));
        const Vec2 line = sceneView().toScreen(Vec2(0, 0));
        QVERIFY(image.pixelColor(static_cast<int>(line.x()), static_cast<int>(line.y())).lightness() > 150);
    }

    void rockLiesBehindClosedWallsWithoutABack_data() {
        QTest::addColumn<bool>("anticlockwise");
        QTest::newRow("a cave") << true;
        QTest::newRow("a pillar") << false;
    }
    void rockLiesBehindClosedWallsWithoutABack() {
        QFETCH(bool, anticlockwise);
        const QImage image = picture(levelOf({body(1, EdgeChain{square(anticlockwise), true, noBack})}));
        QCOMPARE(isBackground(image, 0, 0), anticlockwise);
        QCOMPARE(isBackground(image, 4.5, 4.5), !anticlockwise);
    }

    void aPillarInACaveIsSolid() {
        std::vector<Vec2> pillar = square(false);
        for (Vec2& corner : pillar) {
            corner *= 0.25;
        }
        const QImage image = picture(
            levelOf({body(1, EdgeChain{square(true), true, noBack}), body(2, EdgeChain{pillar, true, noBack})}));
        QVERIFY(!isBackground(image, 0, 0));
        QVERIFY(isBackground(image, 1.2, 1.2));
        QVERIFY(!isBackground(image, 4, 4));
    }

    void theBandOfAThinPillarStaysInside() {
        const std::vector<Vec2> thin{Vec2(-2, -0.1), Vec2(-2, 0.1), Vec2(2, 0.1), Vec2(2, -0.1)};
        const QImage image = picture(levelOf({body(1, EdgeChain{thin, true, noBack})}));
        QVERIFY(!isBackground(image, 0, 0));
        QVERIFY(isBackground(image, 0, 0.3));
        QVERIFY(isBackground(image, 0, -0.3));
    }

    void kindsDifferNotInColourAlone() {
        // In grey, so that only fill, dash and mark are left.
        std::vector<QImage> images;
        for (const BodyKind kind : {BodyKind::Static, BodyKind::Kinematic, BodyKind::Dynamic}) {
            images.push_back(
                picture(levelOf({body(1, Polygon{square(true)}, kind)})).convertToFormat(QImage::Format_Grayscale8));
        }
        QVERIFY(images[0] != images[1] && images[1] != images[2] && images[0] != images[2]);
    }

    void whatIsIntangibleIsDashed() {
        Object object = body(1, LineChain{{Vec2(-4, 0), Vec2(4, 0)}, false});
        std::get<BodyObject>(object.data).tangible = false;
        const QImage image = picture(levelOf({object}));
        int gaps = 0;
        for (int x = 25; x < 175; ++x) {
            gaps += image.pixelColor(x, 100) == canvasTheme().background ? 1 : 0;
        }
        QVERIFY(gaps > 20);
    }

    void connectorsAreRedWhenPressedAndGreenWhenPulled_data() {
        QTest::addColumn<double>("ratio");
        QTest::addColumn<double>("hue");
        QTest::newRow("a quarter") << 0.25 << 0.0;
        QTest::newRow("half") << 0.5 << 0.0;
        QTest::newRow("at rest") << 1.0 << 60.0;
        QTest::newRow("pulled") << 1.25 << 90.0;
        QTest::newRow("one and a half") << 1.5 << 120.0;
        QTest::newRow("far") << 40.0 << 120.0;
    }
    void connectorsAreRedWhenPressedAndGreenWhenPulled() {
        QFETCH(double, ratio);
        QFETCH(double, hue);
        const QColor color = Theme::connector(2 * ratio, 2);
        QVERIFY(std::abs(color.hueF() * 360 - hue) < 0.1);
        QCOMPARE(color.saturation(), 255);
        QCOMPARE(Theme::connector(1, 0), Theme::connector(1, 1));
    }

    void paintingLeavesThePainterAsItWas() {
        QImage image(200, 200, QImage::Format_RGB32);
        QPainter painter(&image);
        painter.setPen(Qt::magenta);
        painter.setBrush(Qt::green);
        const Viewport view = sceneView();
        OverlayFlags all{true, true, true, true, true, true};
        paintLevel({painter, view, canvasTheme()}, mixedLevel(), Selection({1, 2, 3, 4, 5, 6, 7}));
        paintLevelOverlays({painter, view, canvasTheme()}, *overlayWorlds(mixedLevel(), all), {.flags = all});
        QVERIFY(painter.pen().color() == Qt::magenta && painter.brush().color() == Qt::green);
        QVERIFY(!painter.hasClipping() && painter.transform().isIdentity());
    }

    void eachOverlayShowsSomething_data() {
        QTest::addColumn<int>("which");
        for (int i = 0; i < 6; ++i) {
            QTest::addRow("%d", i) << i;
        }
    }
    void eachOverlayShowsSomething() {
        QFETCH(int, which);
        OverlayFlags flags;
        bool* const switches[] = {&flags.aabb,        &flags.incircle, &flags.velocity,
                                  &flags.orientation, &flags.normals,  &flags.quadtree};
        *switches[which] = true;
        Level level = mixedLevel();
        Object moving = level.objects[1];
        std::get<BodyObject>(moving.data).velocity = Vec2(1, 1);
        level.objects.replace(1, moving);
        Viewport view = sceneView();
        view.scale = 5; // the boxes of walls without a back reach far
        const QImage without = picture(level, view);
        const QImage with = paintedScene(view, [&](const Stage& stage) {
            paintLevel(stage, level, Selection());
            paintLevelOverlays(stage, *overlayWorlds(level, flags), {.flags = flags, .level = &level});
        });
        QVERIFY(with != without);
    }

    void theSolidSideIsSeenAtEveryZoom_data() {
        QTest::addColumn<double>("depth");
        QTest::addColumn<bool>("closed");
        QTest::newRow("a wall without a back") << noBack << false;
        QTest::newRow("a thick wall") << 0.5 << false;
        QTest::newRow("a thin wall") << 0.05 << false;
        QTest::newRow("a cave") << noBack << true;
    }
    void theSolidSideIsSeenAtEveryZoom() {
        QFETCH(double, depth);
        QFETCH(bool, closed);
        for (const Shade shade : {Shade::Light, Shade::Dark}) {
            for (double scale = Viewport::minScale; scale <= Viewport::maxScale; scale *= 1.9) {
                Viewport view = sceneView();
                view.scale = scale;
                // From left to right, so that what is below is solid; its ends are out of view.
                const double far = 200 / scale;
                const std::vector<Vec2> corners =
                    closed ? std::vector{Vec2(-far, 0), Vec2(far, 0), Vec2(far, far), Vec2(-far, far)}
                           : std::vector{Vec2(-far, 0), Vec2(far, 0)};
                const Level level = levelOf({body(1, EdgeChain{corners, closed, depth})});
                QImage image(200, 200, QImage::Format_RGB32);
                image.fill(editingTheme(shade).background);
                QPainter painter(&image);
                paintLevel({painter, view, editingTheme(shade)}, level, Selection());
                painter.end();
                const double apart = difference(image.pixelColor(100, 103), image.pixelColor(100, 97));
                QVERIFY2(apart > 10, qPrintable(QStringLiteral("%1 at %2 pixels a metre").arg(apart).arg(scale)));
            }
        }
    }

    void theSamePictureComesOutEveryTime() {
        const Level level = mixedLevel();
        const QImage first = picture(level);
        QCOMPARE(picture(level), first);
        QCOMPARE(picture(level), first);
    }

    void aSnapshotShowsWhatTheLevelShows() {
        // A wall as the game has it: one edge a side, strung together again for painting.
        const std::vector<Vec2> corners = square(true);
        auto look = std::make_shared<BodyLook>(BodyLook{1, 1, BodyRole::Object, BodyKind::Static, true, 1, {}});
        for (std::size_t i = 0; i < corners.size(); ++i) {
            look->shapes.emplace_back(Edge{corners[i], corners[(i + 1) % corners.size()], noBack});
        }
        Snapshot snapshot;
        snapshot.statics = std::make_shared<const BodyPictures>(BodyPictures{{look, Transform{}, Vec2(0, 0), 0}});
        const QImage played = paintedScene(sceneView(), [&](const Stage& stage) { paintSnapshot(stage, snapshot); });
        QCOMPARE(played, picture(levelOf({body(1, EdgeChain{corners, true, noBack})})));
    }

    void extremeViewsAndValuesDoNoHarm_data() {
        QTest::addColumn<double>("scale");
        QTest::addColumn<double>("x");
        QTest::newRow("far out") << Viewport::minScale << 0.0;
        QTest::newRow("far in") << Viewport::maxScale << 2.0;
        QTest::newRow("far away") << 66.0 << 1e6;
    }
    void extremeViewsAndValuesDoNoHarm() {
        QFETCH(double, scale);
        QFETCH(double, x);
        Viewport view = sceneView();
        view.scale = scale;
        view.center = Vec2(x, 0);
        Level level = mixedLevel();
        level.objects.append(body(8, EdgeChain{{Vec2(0, 0), Vec2(0, 0)}, true, 0}));
        level.objects.append(body(9, EdgeChain{{Vec2(-1e6, 1), Vec2(1e6, 1)}, false, 1e6}));
        level.objects.append(body(10, Polygon{}));
        level.objects.append(body(11, EdgeChain{}));
        level.objects.append(body(12, LineChain{{Vec2(1, 1)}, true}));
        const QImage image = paintedScene(view, [&](const Stage& stage) {
            paintGrid(stage, 0.25);
            paintLevel(stage, level, Selection({8, 9, 10, 11, 12}));
            const OverlayFlags all{true, true, true, true, true, true, true, true,
                                   true, true, true, true, true, true, true};
            paintLevelOverlays(stage, *overlayWorlds(level, all), {.flags = all, .level = &level});
        });
        QCOMPARE(image.size(), QSize(200, 200));
    }

    void gridLinesAreMultiplesOfTheSnapStepAndNeverCrowded_data() {
        QTest::addColumn<double>("step");
        for (const double step : {0.05, 0.1, 0.25, 0.5, 1.0}) {
            QTest::addRow("%g", step) << step;
        }
    }
    void gridLinesAreMultiplesOfTheSnapStepAndNeverCrowded() {
        QFETCH(double, step);
        for (double scale = Viewport::minScale; scale <= Viewport::maxScale; scale *= 1.3) {
            const GridSteps steps = gridSteps(step, scale);
            QVERIFY(steps.minor * scale >= 8.9);
            const double times = steps.minor / step;
            QVERIFY(std::abs(times - std::round(times)) < 1e-6);
            const double majors = steps.major / steps.minor;
            QVERIFY(majors >= 3.9 && std::abs(majors - std::round(majors)) < 1e-6);
        }
    }

    void aShiftedLayerIsThePictureOfTheNewView_data() {
        QTest::addColumn<double>("ratio");
        QTest::newRow("plain") << 1.0;
        QTest::newRow("fine display") << 2.0;
    }
    void aShiftedLayerIsThePictureOfTheNewView() {
        QFETCH(double, ratio);
        const auto level = std::make_shared<const Level>(mixedLevel());
        BoardRequest request = boardRequest(level, sceneView(), ratio);
        Board board([] {});
        shownBy(board, request);
        for (const Vec2& by : {Vec2(7, 0), Vec2(-3, 11), Vec2(0, -40), Vec2(150, 90)}) {
            request.frame.view = request.frame.view.panned(by);
            const QImage shifted = shownBy(board, request);
            const QImage fresh = fromScratch(request);
            // Pens at the seam of a strip may be blended a shade differently.
            int differing = 0;
            for (int y = 0; y < fresh.height(); ++y) {
                for (int x = 0; x < fresh.width(); ++x) {
                    const QColor a = shifted.pixelColor(x, y);
                    const QColor b = fresh.pixelColor(x, y);
                    differing += std::abs(a.lightness() - b.lightness()) > 24 ? 1 : 0;
                }
            }
            QVERIFY2(differing <= fresh.width() * fresh.height() / 1000, qPrintable(QString::number(differing)));
        }
    }

    void aPartOfALevelShowsOnlyItsObjects() {
        const Level level = levelOf({body(1, Polygon{square(true)}), body(2, Circle{Vec2(3.5, 0), 1})});
        const std::vector<int> first{0};
        const auto shows = [&](const PaintedPart& part) {
            const QImage image =
                paintedScene(sceneView(), [&](const Stage& stage) { paintObjects(stage, level, part); });
            return std::pair(!isBackground(image, 0, 0), !isBackground(image, 3.5, 0));
        };
        QVERIFY(shows({}) == std::pair(true, true));
        QVERIFY(shows({.without = &first}) == std::pair(false, true));
        QVERIFY(shows({.only = &first}) == std::pair(true, false));
    }

    void whatIsSmallerThanAPixelIsStillSeen_data() {
        QTest::addColumn<bool>("circle");
        QTest::newRow("circle") << true;
        QTest::newRow("polygon") << false;
    }
    void whatIsSmallerThanAPixelIsStillSeen() {
        QFETCH(bool, circle);
        Viewport view = sceneView();
        view.scale = 0.01;
        const Level level =
            levelOf({body(1, circle ? LevelShape(Circle{{0, 0}, 1}) : LevelShape(Polygon{square(true)}))});
        const QImage image = picture(level, view);
        const QColor line = canvasTheme().body(BodyKind::Static, Circle{}).line;
        const QColor background = canvasTheme().background;
        QVERIFY(std::abs(image.pixelColor(100, 100).lightness() - background.lightness()) >
                0.8 * std::abs(line.lightness() - background.lightness()));
    }
};

SPACETOW_TEST(ScenePainterTest)
#include "scene_painter_test.moc"
