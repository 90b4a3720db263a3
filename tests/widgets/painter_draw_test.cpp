#include "editor/canvas/painter_draw.h"

#include "editor/canvas/overlay_painter.h"
#include "tests/support/bodies.h"
#include "tests/support/test_main.h"

#include <QImage>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Viewport viewOf(int width, int height) {
    Viewport view;
    view.scale = 20;
    view.size = Vec2(width, height);
    return view;
}

template <class Paint>
QImage painted(const Viewport& view, const Paint& paint) {
    QImage image(static_cast<int>(view.size.x()), static_cast<int>(view.size.y()), QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    paint(Stage{painter, view, canvasTheme()});
    return image;
}

/// The smallest rectangle that holds all that is not black.
QRect inked(const QImage& image) {
    QRect box;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixelColor(x, y) != QColor(Qt::black)) {
                box |= QRect(x, y, 1, 1);
            }
        }
    }
    return box;
}

constexpr Color orange{255, 128, 0};

/// In 200 × 200 pixels, rows of ten of which every fifth is larger; with so many dots in a corner that it is a crowd.
QImage rowsOfCircles(bool filled, bool crowded) {
    return painted(viewOf(200, 200), [&](const Stage& stage) {
        stage.painter.setRenderHint(QPainter::Antialiasing);
        PainterDraw draw(stage.view.size);
        for (int i = 0; i < 80; ++i) {
            const Vec2 at(15.25 + 18 * (i % 10), 15.75 + 18 * (i / 10));
            const double radius = i % 5 == 0 ? 8 : 5.3;
            filled ? draw.filledCircle(at, radius, orange) : draw.circle(at, radius, orange);
        }
        for (int i = 0; crowded && i < 2000; ++i) {
            draw.line({190, 190}, {191, 190}, orange);
        }
        draw.paint(stage);
    });
}

} // namespace

class PainterDrawTest : public QObject {
    Q_OBJECT

  private slots:
    void eachFormCoversItsPlaceAndNoOther_data() {
        QTest::addColumn<int>("form");
        QTest::addColumn<bool>("filled");
        QTest::newRow("circle") << 0 << false;
        QTest::newRow("filled circle") << 1 << true;
        QTest::newRow("polygon") << 2 << false;
        QTest::newRow("filled polygon") << 3 << true;
        QTest::newRow("rectangle") << 4 << false;
        QTest::newRow("filled rectangle") << 5 << true;
    }
    void eachFormCoversItsPlaceAndNoOther() {
        QFETCH(int, form);
        QFETCH(bool, filled);
        const std::vector<Vec2> corners{Vec2(20, 40), Vec2(60, 40), Vec2(60, 80), Vec2(20, 80)};
        const QImage image = painted(viewOf(100, 100), [&](const Stage& stage) {
            PainterDraw draw(stage.view.size);
            switch (form) {
            case 0:
                draw.circle({40, 60}, 20, orange);
                break;
            case 1:
                draw.filledCircle({40, 60}, 20, orange);
                break;
            case 2:
                draw.polygon(corners, orange);
                break;
            case 3:
                draw.filledPolygon(corners, orange);
                break;
            case 4:
                draw.rectangle({{20, 40}, {60, 80}}, orange);
                break;
            default:
                draw.filledRectangle({{20, 40}, {60, 80}}, orange);
                break;
            }
            draw.paint(stage);
        });
        const QRect box = inked(image);
        QVERIFY(QRect(18, 38, 45, 45).contains(box) && box.contains(QRect(21, 41, 38, 38)));
        QCOMPARE(image.pixelColor(40, 60) == QColor(255, 128, 0), filled);
        QCOMPARE(image.pixelColor(40, 60) == QColor(Qt::black), !filled);
    }

    void circlesOfACrowdLookLikeThoseOfAFew_data() {
        QTest::addColumn<bool>("filled");
        QTest::newRow("outlines") << false;
        QTest::newRow("discs") << true;
    }
    void circlesOfACrowdLookLikeThoseOfAFew() {
        QFETCH(bool, filled);
        const QRect rows(0, 0, 200, 160);
        const QImage few = rowsOfCircles(filled, false).copy(rows);
        const QImage crowd = rowsOfCircles(filled, true).copy(rows);
        double inFew = 0;
        double inCrowd = 0;
        for (int y = 0; y < rows.height(); ++y) {
            for (int x = 0; x < rows.width(); ++x) {
                inFew += few.pixelColor(x, y).red();
                inCrowd += crowd.pixelColor(x, y).red();
                // Whatever is inside of one by more than a pixel has its colour in the other.
                const bool isInside = filled && x > 0 && y > 0 && few.pixelColor(x - 1, y).red() == 255 &&
                                      few.pixelColor(x + 1, y).red() == 255 && few.pixelColor(x, y - 1).red() == 255 &&
                                      few.pixelColor(x, y + 1).red() == 255;
                QVERIFY(!isInside || crowd.pixelColor(x, y).red() == 255);
            }
        }
        const double share = inCrowd / inFew; // their lines have one pixel, not one and a half
        QVERIFY2(filled ? std::abs(share - 1) < 0.08 : share > 0.5 && share < 0.75, qPrintable(QString::number(share)));
        const QRect one = inked(crowd.copy(QRect(25, 7, 17, 17))); // about (33.25, 15.75), of 5.3
        QVERIFY(one.width() >= 10 && one.width() <= 13 && one.height() >= 10 && one.height() <= 13);
    }

    void anArrowHasAHeadAtItsEnd() {
        const auto heightAt = [](const QImage& image, int from, int to) {
            return inked(image.copy(from, 0, to - from, 100)).height();
        };
        const QImage image = painted(viewOf(100, 100), [](const Stage& stage) {
            PainterDraw draw(stage.view.size);
            draw.arrow({10, 50}, {80, 50}, orange);
            draw.paint(stage);
        });
        QVERIFY(heightAt(image, 8, 40) <= 3);
        QVERIFY(heightAt(image, 70, 82) >= 5);
    }

    void whatIsOutOfViewIsLeftOutAndWhatPassesThroughIsNot() {
        const auto draws = [](const Vec2& a, const Vec2& b) {
            return !inked(painted(viewOf(100, 100), [&](const Stage& stage) {
                        PainterDraw draw(stage.view.size);
                        draw.line(a, b, orange);
                        draw.paint(stage);
                    })).isEmpty();
        };
        QVERIFY(draws({-1e6, 50}, {1e6, 50}));
        QVERIFY(!draws({-1e6, -50}, {1e6, -50}));
    }

    void aWorldLooksTheSameEveryTimeAndCirclesAreRoundInAWideWindow() {
        World world;
        add(world, ball({-3, 2}, 2));
        DebugView view;
        const Viewport window = viewOf(800, 300);
        view.view = window.transform();
        view.overlays = {};
        const auto picture = [&] {
            return painted(window, [&](const Stage& stage) {
                PainterDraw draw(stage.view.size);
                drawWorld(world, view, draw);
                draw.paint(stage);
            });
        };
        const QImage first = picture();
        QCOMPARE(picture(), first);
        QCOMPARE(picture(), first);
        const QRect box = inked(first);
        QCOMPARE(box.width(), box.height());
        QVERIFY(std::abs(box.width() - 81.5) <= 2);
        QVERIFY((Vec2(box.center().x(), box.center().y()) - window.toScreen({-3, 2})).norm() < 2);
    }

    void theVelocityStartsAtTheCentreOfMass() {
        BodyObject off;
        off.kind = BodyKind::Dynamic;
        off.shapes = {Circle{{1, 0}, 0.25}};
        off.velocity = {0, 1};
        Level level;
        level.objects.append({1, {}, off, {}});
        const Viewport view = viewOf(100, 100);
        const QRect box = inked(painted(view, [&](const Stage& stage) {
            const OverlayFlags flags{.velocity = true};
            paintLevelOverlays(stage, *overlayWorlds(level, flags), {.flags = flags});
        }));
        QVERIFY(QRect(65, 25, 11, 30).contains(box));
        QVERIFY(box.bottom() >= 49 && box.top() <= 31);
    }
};

SPACETOW_TEST(PainterDrawTest)
#include "painter_draw_test.moc"
