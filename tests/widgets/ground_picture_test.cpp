#include "editor/play/ground_picture.h"

#include "core/game/session.h"
#include "editor/canvas/scene_painter.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <algorithm>
#include <map>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level cave() {
    Level level = openSpace();
    addWall(level, Vec2(3, 1), Vec2(-3, 1));
    BodyObject rock;
    rock.shapes.emplace_back(EdgeChain{{{-6, -4}, {6, -4}, {6, 4}, {0, 5}, {-6, 4}}, true, noBack});
    rock.filter.tags = TagMask::bit(wallTag);
    level.objects.append({500, {}, rock, {}});
    BodyObject pillar;
    pillar.position = Vec2(2, -2);
    pillar.shapes.emplace_back(Polygon{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
    level.objects.append({501, {}, pillar, {}});
    return level;
}

Frame2D frameAt(const Vec2& center, double scale) {
    Viewport view;
    view.size = Vec2(240, 160);
    view.center = center;
    view.scale = scale;
    return {alignedToPixels(view, 1), 1};
}

/// With so many walls that they are painted beside the window.
Level manyWalls() {
    Level level = cave();
    BodyObject wave;
    std::vector<Vec2> points;
    for (int i = 0; i <= static_cast<int>(GroundPicture::few); ++i) {
        points.emplace_back(-5 + 10.0 * i / static_cast<double>(GroundPicture::few), i % 2 == 0 ? -2.0 : -2.3);
    }
    wave.shapes.emplace_back(EdgeChain{points, false, 0.2});
    wave.filter.tags = TagMask::bit(wallTag);
    level.objects.append({600, {}, wave, {}});
    return level;
}

template <class Paint>
QImage paintedFrame(const Frame2D& frame, Paint paint) {
    QImage image(frame.deviceSize(), QImage::Format_ARGB32_Premultiplied);
    image.fill(canvasTheme().background);
    QPainter painter(&image);
    paint(painter);
    return image;
}

QImage fromScratch(const Frame2D& frame, const Snapshot& snapshot) {
    return paintedFrame(frame, [&](QPainter& painter) {
        paintStatics({painter, frame.view, canvasTheme()}, *snapshot.statics, groundOf(*snapshot.statics));
    });
}

QImage kept(GroundPicture& ground, const Frame2D& frame, const Snapshot& snapshot) {
    return paintedFrame(frame, [&](QPainter& painter) { ground.draw(painter, frame, snapshot, canvasTheme()); });
}

bool alike(const QImage& a, const QImage& b) {
    constexpr int rounding = 6;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            if (std::abs(p.red() - q.red()) > rounding || std::abs(p.green() - q.green()) > rounding ||
                std::abs(p.blue() - q.blue()) > rounding) {
                return false;
            }
        }
    }
    return true;
}

Level wallsWithPillarAt(const Vec2& position) {
    Level level = manyWalls();
    Object pillar = *level.objects.find(501);
    std::get<BodyObject>(pillar.data).position = position;
    level.objects.replace(level.objects.indexOf(501), pillar);
    return level;
}

/// How many pixels of the canvas are other than most of their row.
int marksIn(const QImage& image) {
    int marks = 0;
    for (int y = 0; y < image.height(); ++y) {
        std::map<QRgb, int> colors;
        for (int x = 0; x < image.width(); ++x) {
            ++colors[image.pixel(x, y)];
        }
        const auto most = std::ranges::max_element(colors, {}, &std::pair<const QRgb, int>::second);
        marks += image.width() - most->second;
    }
    return marks;
}

} // namespace

class GroundPictureTest : public QObject {
    Q_OBJECT

  private slots:
    void whereverTheCameraGoesItIsThePicturePaintedFromScratch() {
        const Session session(cave());
        const auto snapshot = session.snapshot();
        GroundPicture ground;
        Vec2 center(0, 0);
        for (int i = 0; i < 60; ++i) {
            center += Vec2(0.11 * (i % 7) - 0.3, 0.07 * (i % 5) - 0.1);
            const Frame2D frame = frameAt(center, i < 40 ? 45 : 30);
            QVERIFY2(alike(kept(ground, frame, *snapshot), fromScratch(frame, *snapshot)), QByteArray::number(i));
        }
    }

    void anotherLevelIsAnotherPicture() {
        const auto first = Session(cave()).snapshot();
        const auto second = Session(openSpace()).snapshot();
        const Frame2D frame = frameAt({0, 0}, 40);
        GroundPicture ground;
        kept(ground, frame, *first);
        QVERIFY(alike(kept(ground, frame, *second), fromScratch(frame, *second)));
        QVERIFY(!alike(kept(ground, frame, *first), fromScratch(frame, *second)));
    }

    void whatIsMuchIsPaintedBesideTheWindow() {
        const auto snapshot = Session(manyWalls()).snapshot();
        const Frame2D frame = frameAt({0, 0}, 40);
        const QImage blank = paintedFrame(frame, [](QPainter&) {});
        GroundPicture ground;
        int told = 0;
        ground.painted = [&told] { ++told; };
        QCOMPARE(kept(ground, frame, *snapshot), blank); // and nobody has waited
        QTRY_COMPARE(told, 1);
        QVERIFY(alike(kept(ground, frame, *snapshot), fromScratch(frame, *snapshot)));
        QVERIFY(!ground.isPainting());
        const Frame2D further = frameAt({0.5, 0.2}, 40); // within what was painted beyond the view
        QVERIFY(alike(kept(ground, further, *snapshot), fromScratch(further, *snapshot)));
        QVERIFY(ground.isPainting()); // what comes next
        ground.finish();
        const Frame2D next = frameAt({1.2, 0.4}, 40);
        QVERIFY(alike(kept(ground, next, *snapshot), fromScratch(next, *snapshot)));
    }

    void theLastPictureStaysUntilTheNextIsThere() {
        const auto first = Session(manyWalls()).snapshot();
        const auto second = Session(wallsWithPillarAt({-2, 0})).snapshot();
        const Frame2D frame = frameAt({0, 0}, 40);
        GroundPicture ground;
        kept(ground, frame, *first);
        ground.finish();
        QVERIFY(alike(kept(ground, frame, *second), fromScratch(frame, *first)));
        ground.finish();
        QVERIFY(alike(kept(ground, frame, *second), fromScratch(frame, *second)));
    }

    void whatMovesInEveryFrameIsShownALittleLate() {
        const auto at = [](double x) { return Session(wallsWithPillarAt({x, 0})).snapshot(); };
        const auto first = at(-3), second = at(-2), third = at(-1), fourth = at(0);
        const Frame2D frame = frameAt({0, 0}, 40);
        GroundPicture ground;
        kept(ground, frame, *first);
        kept(ground, frame, *second); // it moves on while the first is being painted
        ground.finish();
        QVERIFY(alike(kept(ground, frame, *third), fromScratch(frame, *first)));
        kept(ground, frame, *fourth);
        ground.finish();
        QVERIFY(alike(kept(ground, frame, *fourth), fromScratch(frame, *third)));
        ground.finish();
        QVERIFY(alike(kept(ground, frame, *fourth), fromScratch(frame, *fourth)));
    }

    void untilItIsPaintedWhatTheBoardShowedStandsInItsPlace() {
        const auto snapshot = Session(manyWalls()).snapshot();
        const Frame2D frame = frameAt({0, 0}, 40);
        PictureLayer board;
        board.shiftTo(frame);
        board.paint(frame.all(), canvasTheme(),
                    [&](const Stage& stage) { paintStatics(stage, *snapshot->statics, groundOf(*snapshot->statics)); });
        GroundPicture ground;
        ground.forget(board);
        const Frame2D aside = frameAt({0.25, 0}, 40);
        const QImage first = kept(ground, aside, *snapshot);
        const QRect known(0, 0, 220, 160); // the rest was beyond the board
        QVERIFY(alike(first.copy(known), fromScratch(aside, *snapshot).copy(known)));
        ground.finish();
        QVERIFY(alike(kept(ground, aside, *snapshot), fromScratch(aside, *snapshot)));
        ground.forget(board);
        const Frame2D nearer = frameAt({0, 0}, 70);
        QVERIFY(kept(ground, nearer, *snapshot) != paintedFrame(nearer, [](QPainter&) {})); // enlarged
        const auto few = Session(openSpace()).snapshot();
        ground.forget(board);
        QVERIFY(alike(kept(ground, frame, *few), fromScratch(frame, *few))); // painted at once
    }

    void whatStandsInForTheGroundHasNothingOfWhatDoesNotStand() {
        Level level = manyWalls();
        level.objects.append({700, {}, FinishObject{Vec2(-4, 0), Vec2(-3, 0)}, {}});
        addBall(level, Vec2(4, -1), 0.5, Vec2(0, 0));
        TestWindow test;
        test.document().reset(level);
        test.canvas().fitLevel();
        test.document().select(Selection({600, 700}));
        test.canvas().finishPainting();
        const Frame2D frame = test.canvas().frame();
        QImage image(frame.deviceSize(), QImage::Format_ARGB32_Premultiplied);
        image.fill(Qt::transparent);
        QPainter painter(&image);
        test.canvas().groundPicture(true).draw(painter, frame);
        painter.end();
        const auto isPaintedAbout = [&](double x, double y) {
            const QPoint at = test.at(x, y);
            bool any = false;
            for (int i = -6; i <= 6; ++i) {
                for (int k = -6; k <= 6; ++k) {
                    any = any || image.pixelColor(at.x() + i, at.y() + k).alpha() > 0;
                }
            }
            return any;
        };
        QVERIFY(isPaintedAbout(-2, -2.1) && isPaintedAbout(2, -2.1)); // walls
        for (const double x : {-4.0, -3.5, -3.0}) {
            QVERIFY(!isPaintedAbout(x, 0)); // the finish
        }
        QVERIFY(!isPaintedAbout(4, -1) && !isPaintedAbout(4.4, -1)); // the ball
    }

    void nothingBlinksWhenALargeLevelIsRun() {
        for (const Act act : {Act::Simulate, Act::Play}) {
            TestWindow test;
            test.document().reset(manyWalls());
            test.canvas().fitLevel();
            test.canvas().finishPainting();
            test.trigger(act);
            QTRY_VERIFY(test.window->isPlaying());
            const QRect cave(test.at(-5, -1.9), test.at(5, -2.4));
            const QImage first = test.canvas().grab(cave).toImage();
            QVERIFY2(marksIn(first) > first.width(), qPrintable(QString::number(marksIn(first))));
        }
    }

    void whatIsForgottenWhileItIsPaintedIsNotShown() {
        const auto snapshot = Session(manyWalls()).snapshot();
        const Frame2D frame = frameAt({0, 0}, 40);
        const QImage blank = paintedFrame(frame, [](QPainter&) {});
        GroundPicture ground;
        kept(ground, frame, *snapshot);
        ground.forget();
        ground.finish();
        QCOMPARE(kept(ground, frame, *snapshot), blank);
        ground.finish();
        QVERIFY(alike(kept(ground, frame, *snapshot), fromScratch(frame, *snapshot)));
    }
};

SPACETOW_TEST(GroundPictureTest)
#include "ground_picture_test.moc"
