#include "editor/canvas/board.h"

#include "core/base/random.h"
#include "core/level/bounds.h"
#include "core/level/edits.h"
#include "core/level/groups.h"
#include "editor/canvas/scene_painter.h"
#include "editor/editing/verbs.h"
#include "tests/support/board.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

#include <cmath>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A closed or open wall, a line, a polygon or a circle about the place.
LevelShape someShape(Random& random, unsigned vertices) {
    std::vector<Vec2> points;
    const double radius = random.uniform(0.3, 3);
    const double sense = random.below(2) == 0 ? 1 : -1;
    for (unsigned i = 0; i < vertices; ++i) {
        const double angle = sense * 2 * std::numbers::pi * i / vertices;
        points.push_back((radius + random.uniform(0, 0.2)) * Vec2(std::cos(angle), std::sin(angle)));
    }
    const bool closed = random.below(2) == 0;
    switch (random.below(5)) {
    case 0:
        return EdgeChain{points, closed, random.uniform(0.05, 1)};
    case 1:
        return LineChain{points, closed};
    case 2:
        return Polygon{points};
    case 3:
        return Circle{{0.2, 0.1}, radius};
    default:
        return EdgeChain{points, closed, noBack};
    }
}

Object someObject(Random& random, Key key) {
    BodyObject body;
    body.kind = static_cast<BodyKind>(random.below(3));
    body.position = Vec2(random.uniform(-9, 9), random.uniform(-6, 6));
    body.angle = random.uniform(-3, 3);
    body.shapes.push_back(someShape(random, 3 + random.below(random.below(4) == 0 ? 300 : 12)));
    return {key, {}, std::move(body), {}};
}

Level someLevel(Random& random, unsigned objects) {
    Level level;
    level.objects.append({1, {}, ShipObject{{0, 0}, 0.3}, {}});
    level.objects.append({2, {}, PayloadObject{{1, -1}, 0.2, 0.25}, {}});
    level.objects.append({3, {}, FinishObject{{-2, 2}, {-1, 3}}, {}});
    for (Key key = 10; key < 10 + objects; ++key) {
        level.objects.append(someObject(random, key));
        if (key % 5 == 4) {
            ConnectorObject connector;
            connector.a = key - 1;
            connector.b = key - 3;
            level.objects.append({key + 1000, {}, connector, {}});
        }
    }
    return level;
}

std::vector<Key> someKeys(Random& random, const Level& level, unsigned share) {
    std::vector<Key> keys;
    for (const Object& object : level.objects) {
        if (random.below(share) == 0) {
            keys.push_back(object.key);
        }
    }
    return keys;
}

BoardRequest requestFor(const Level& level, double pixelRatio) {
    Viewport view;
    view.size = Vec2(301, 223);
    view.scale = 30;
    return boardRequest(std::make_shared<const Level>(level), view, pixelRatio);
}

/// The number of pixels that anybody could tell apart; rounding is worth a few levels of grey.
int differences(const QImage& a, const QImage& b) {
    constexpr int rounding = 6;
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y);
            const QColor q = b.pixelColor(x, y);
            const int most =
                std::max({std::abs(p.red() - q.red()), std::abs(p.green() - q.green()), std::abs(p.blue() - q.blue())});
            count += most > rounding ? 1 : 0;
        }
    }
    return count;
}

/// Something that happens on a drawing board.
void change(BoardRequest& request, Random& random) {
    const Level& level = *request.base;
    const auto commit = [&request](Level after) {
        request.level = std::make_shared<const Level>(std::move(after));
        request.base = request.level;
        request.live = false;
    };
    const auto preview = [&request](Level after) {
        request.level = std::make_shared<const Level>(std::move(after));
        request.live = true;
    };
    const Vec2 delta(random.uniform(-1, 1), random.uniform(-1, 1));
    switch (random.below(14)) {
    case 0:
        request.frame.view = request.frame.view.panned(Vec2(random.below(40) - 20.0, random.below(40) - 20.0));
        break;
    case 1:
        request.frame.view = request.frame.view.panned(Vec2(random.below(900) - 450.0, random.below(600) - 300.0));
        break;
    case 2:
        request.frame.view =
            request.frame.view.zoomedAt(Vec2(random.below(300), random.below(200)), random.uniform(0.6, 1.6));
        break;
    case 3:
        request.selection = Selection(someKeys(random, level, 1 + random.below(20)));
        break;
    case 4:
        commit(moved(level, someKeys(random, level, 1 + random.below(20)), delta));
        break;
    case 5:
        commit(removed(level, someKeys(random, level, 10 + random.below(20))));
        break;
    case 6: {
        Level after = level;
        after.objects.append(someObject(random, freshKey(level, random.next())));
        commit(std::move(after));
        break;
    }
    case 7:
        commit(withVisible(level, someKeys(random, level, 8), random.below(3) == 0));
        break;
    case 8:
        request.level = request.base;
        request.live = random.below(2) == 0;
        break;
    case 9:
        commit(reversed(level, someKeys(random, level, 3 + random.below(9))));
        break;
    case 10:
        request.highlighted = std::make_shared<const std::vector<Key>>(someKeys(random, level, 3 + random.below(9)));
        break;
    case 11:
        request.overlays.quadtree = random.below(3) == 0;
        break;
    case 12: {
        const std::vector<Key> keys = someKeys(random, level, 1 + random.below(9));
        request.hovered = keys.empty() ? 0 : keys.front();
        break;
    }
    default:
        preview(random.below(2) == 0 ? moved(level, someKeys(random, level, 1 + random.below(20)), delta)
                                     : rotated(level, someKeys(random, level, 1 + random.below(20)), {1, 1}, 0.3));
    }
    request.selection = request.selection.within(*request.level);
}

/// Many waves side by side, more than is painted while somebody waits.
Level largeLevel() {
    Level level;
    for (Key key = 1; key <= 60; ++key) {
        BodyObject body;
        EdgeChain chain;
        for (int i = 0; i <= 100; ++i) {
            chain.vertices.emplace_back(0.1 * i - 5, 0.4 * std::sin(0.5 * i));
        }
        body.position = Vec2(0, 0.1 * static_cast<double>(key) - 3);
        body.shapes.emplace_back(std::move(chain));
        level.objects.append({key, {}, std::move(body), {}});
    }
    return level;
}

Level someLevelOfOne() {
    Random random(1);
    Level level;
    level.objects.append(someObject(random, 1));
    return level;
}

QByteArray boardSeed(unsigned seed) {
    return "seed " + QByteArray::number(seed);
}

} // namespace

class BoardTest : public QObject {
    Q_OBJECT

  private slots:
    void whateverHappensItIsThePictureThatIsPaintedFromScratch() {
        const unsigned seeds = fullOrQuick(120U, 14U);
        for (unsigned seed = 0; seed < seeds; ++seed) {
            Random random(seed);
            BoardRequest request = requestFor(someLevel(random, 4 + random.below(30)), 1 + 0.5 * random.below(3));
            Board board([] {});
            for (int i = 0; i < 14; ++i) {
                const QImage kept = finishedBy(board, request);
                const int wrong = differences(kept, fromScratch(request));
                // At the seams of what is painted at different times an outline may be cut a hair differently, and the
                // dots along the back of a jagged wall may begin elsewhere.
                const int few = kept.width() * kept.height() / 300;
                // While something is dragged, it may lie on top of what it lay under before.
                QVERIFY2(wrong <= few || request.live,
                         boardSeed(seed) + ", step " + QByteArray::number(i) + ": " + QByteArray::number(wrong));
                change(request, random);
            }
        }
    }

    void whatTakesTimeIsShownScaledUntilItIsPainted() {
        int refined = 0;
        Board board([&refined] { ++refined; });
        BoardRequest request = requestFor(largeLevel(), 1);
        const QImage before = finishedBy(board, request);
        QCOMPARE(differences(before, fromScratch(request)), 0);
        request.frame.view = request.frame.view.zoomedAt(Vec2(150, 110), 1.3);
        const QImage scaled = shownBy(board, request);
        const QImage wanted = fromScratch(request);
        QVERIFY(differences(scaled, wanted) > 0);
        QVERIFY(differences(scaled, before) > 0);
        board.finish();
        QVERIFY(refined > 0);
        QCOMPARE(differences(shownBy(board, request), wanted), 0);
    }

    void afterAZoomPanningNearbyPaintsNothing() {
        Board board([] {});
        BoardRequest request = requestFor(largeLevel(), 1);
        shownBy(board, request);
        request.frame.view = request.frame.view.zoomedAt(Vec2(150, 110), 1.3);
        finishedBy(board, request);
        request.frame.view = request.frame.view.panned(Vec2(25, -17));
        QCOMPARE(differences(shownBy(board, request), fromScratch(request)), 0); // without waiting for anything
    }

    void whatIsDraggedFollowsThePointerThoughItTakesLongToPaint() {
        Board board([] {});
        const Level level = largeLevel();
        BoardRequest request = requestFor(level, 1);
        shownBy(board, request);
        const auto dragBy = [&](const Vec2& delta) {
            request.level = std::make_shared<const Level>(
                moved(level, selectAll({std::make_shared<const Level>(level), {}}).keys(), delta));
            request.live = true;
        };
        dragBy({0.1, 0});
        finishedBy(board, request);
        dragBy({1, 0.5}); // by whole pixels
        QCOMPARE(differences(shownBy(board, request), fromScratch(request)), 0);
        request.base = request.level;
        request.live = false;
        QCOMPARE(differences(finishedBy(board, request), fromScratch(request)), 0);
    }

    void aLongOutlineUnderThePointerIsPaintedBesideTheWindow() {
        Board board([] {});
        Level level;
        BodyObject body;
        EdgeChain chain;
        for (int i = 0; i <= 5000; ++i) {
            chain.vertices.emplace_back(0.002 * i - 5, 0.4 * std::sin(0.1 * i));
        }
        body.shapes.emplace_back(std::move(chain));
        level.objects.append({1, {}, std::move(body), {}});
        BoardRequest request = requestFor(level, 1);
        QVERIFY(isLongToHover(level, 1, request.frame.view.visible()));
        const QImage before = finishedBy(board, request);
        request.hovered = 1;
        QCOMPARE(differences(shownBy(board, request), before), 0);
        board.finish();
        const QImage hovered = shownBy(board, request);
        QVERIFY(differences(hovered, before) > 1000);
        QCOMPARE(differences(hovered, fromScratch(request)), 0);
        request.hovered = 0;
        QCOMPARE(differences(shownBy(board, request), before), 0);
        QVERIFY(!isLongToHover(someLevelOfOne(), 1, request.frame.view.visible()));
    }

    void whatStandsStillSaysWhereItHasChanged() {
        Random random(7);
        Board board([] {});
        BoardRequest request = requestFor(someLevel(random, 12), 1);
        const QImage before = shownBy(board, request);
        board.takeStillChanges();
        QVERIFY(board.takeStillChanges()->isEmpty());
        request.level = request.base =
            std::make_shared<const Level>(moved(*request.base, std::array{Key{2}}, {0.5, 0}));
        const QImage after = shownBy(board, request);
        const std::optional<QRegion> changes = board.takeStillChanges();
        QVERIFY(changes && !changes->isEmpty());
        QVERIFY(changes->boundingRect().width() < before.width() / 2);
        QVERIFY(differences(before, after) > 0);
        QImage outside = before;
        QPainter painter(&outside);
        painter.setClipRegion(*changes);
        painter.drawImage(0, 0, after);
        painter.end();
        QCOMPARE(differences(outside, after), 0);
        board.forget();
        QVERIFY(!board.takeStillChanges());
    }

    void ofAPictureThatIsMostlyEmptyOnlyWhatShowsSomethingIsDrawn() {
        PictureLayer layer;
        Frame2D frame;
        frame.view.size = Vec2(640, 512);
        layer.shiftTo(frame);
        layer.paint(frame.all(), editingTheme(), [](const Stage& stage) {
            stage.painter.fillRect(QRect(30, 20, 2, 400), Qt::red);
            stage.painter.fillRect(QRect(30, 420, 500, 3), Qt::red);
        });
        const auto drawnBy = [](const PictureLayer& picture, const Frame2D& shown) {
            QImage image(640, 512, QImage::Format_ARGB32_Premultiplied);
            image.fill(Qt::transparent);
            QPainter painter(&image);
            picture.draw(painter, shown);
            return image;
        };
        const auto drawn = [&layer] {
            int pixels = 0;
            for (const QRect& spot : layer.spots()) {
                pixels += spot.width() * spot.height();
            }
            return pixels;
        };
        QCOMPARE(drawn(), 64 * 64 * (6 + 9));
        QCOMPARE(layer.spots().size(), std::size_t{2});
        const QImage before = drawnBy(layer, frame);
        QCOMPARE(before.pixelColor(30, 20), QColor(Qt::red));
        QCOMPARE(before.pixelColor(529, 422), QColor(Qt::red));
        Frame2D shifted = frame;
        shifted.view = alignedToPixels(shifted.view.panned(Vec2(-40, 0)), 1);
        layer.shiftTo(shifted);
        QCOMPARE(drawnBy(layer, shifted), before.copy(-shifted.movedFrom(frame).x(), 0, 640, 512));
        QCOMPARE(layer.spots().front().left(), 0);
        layer.wipe();
        QVERIFY(layer.spots().empty());
    }

    void afterForgettingNothingOfTheOldLevelIsShown() {
        Board board([] {});
        shownBy(board, requestFor(largeLevel(), 1));
        board.forget();
        Random random(4);
        const BoardRequest other = requestFor(someLevel(random, 8), 1);
        QCOMPARE(differences(shownBy(board, other), fromScratch(other)), 0);
    }

    void aPictureThatIsOutdatedBeforeItIsFinishedIsNotShownForTheOtherLevel() {
        Board board([] {});
        BoardRequest request = requestFor(largeLevel(), 1);
        shownBy(board, request);
        request.frame.view = request.frame.view.zoomedAt(Vec2(150, 110), 1.3);
        shownBy(board, request);
        board.forget();
        Random random(5);
        const BoardRequest other = requestFor(someLevel(random, 8), 1);
        shownBy(board, other);
        board.finish();
        QCOMPARE(differences(shownBy(board, other), fromScratch(other)), 0);
    }

    void viewsAreAlignedByLessThanHalfAPixel() {
        for (unsigned seed = 0; seed < 500; ++seed) {
            Random random(seed);
            Viewport view;
            view.size = Vec2(1 + random.below(900), 1 + random.below(700));
            view.scale = std::exp(random.uniform(-0.6, 9));
            view.center = Vec2(random.uniform(-1000, 1000), random.uniform(-1000, 1000));
            const double ratio = 1 + 0.25 * random.below(5);
            const Viewport aligned = alignedToPixels(view, ratio);
            const Vec2 origin = aligned.toScreen(Vec2(0, 0)) * ratio;
            QVERIFY2((origin - Vec2(std::round(origin.x()), std::round(origin.y()))).norm() < 1e-4, boardSeed(seed));
            QVERIFY2(((aligned.center - view.center) * view.scale * ratio).cwiseAbs().maxCoeff() < 0.5001,
                     boardSeed(seed));
        }
    }
};

SPACETOW_TEST(BoardTest)
#include "board_test.moc"
