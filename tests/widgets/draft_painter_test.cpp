// What is painted of a shape while it is drawn.

#include "editor/canvas/overlay_painter.h"

#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <QImage>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// 10 × 10 m about the origin at 20 pixels a metre.
Viewport draftView() {
    Viewport view;
    view.scale = 20;
    view.size = Vec2(200, 200);
    return view;
}

QImage paintedDraft(const Drive& drive) {
    QImage image(200, 200, QImage::Format_RGB32);
    image.fill(editingTheme().background);
    const Viewport view = draftView();
    QPainter painter(&image);
    Overlay overlay = drive.toolbox.overlay();
    overlay.texts.clear(); // a plate with numbers may lie anywhere
    const Stage stage{painter, view, editingTheme()};
    LabelPainter labels(stage);
    paintToolOverlay(stage, overlay, labels);
    return image;
}

bool isShaded(const QImage& image, const Vec2& world) {
    const Vec2 at = draftView().toScreen(world);
    return image.pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y())) != editingTheme().background;
}

} // namespace

class DraftPainterTest : public QObject {
    Q_OBJECT

  private slots:
    void theSolidSideIsShadedWhileAOneWayWallIsDrawn() {
        Drive drive;
        drive.toolbox.choose(ToolId::Edge);
        drive.click({{-3, 0}, {0, 0}});
        drive.move({3, 0});
        const QImage image = paintedDraft(drive);
        for (const double x : {-1.5, 1.5}) { // also up to the pointer
            QVERIFY(isShaded(image, Vec2(x, -0.15)));
            QVERIFY(!isShaded(image, Vec2(x, 0.3)));
            QVERIFY(!isShaded(image, Vec2(x, -1)));
        }
    }

    void whatIsSolidFromBothSidesIsNotShaded() {
        Drive drive;
        drive.toolbox.choose(ToolId::Line);
        drive.click({-3, 0});
        drive.move({3, 0});
        const QImage image = paintedDraft(drive);
        QVERIFY(!isShaded(image, Vec2(1.5, -0.25)));
        QVERIFY(!isShaded(image, Vec2(1.5, 0.25)));
    }

    void aSideThatCrossesAnotherIsMarked() {
        Drive drive;
        drive.toolbox.choose(ToolId::Polygon);
        drive.click({{-3, -3}, {3, 3}, {3, -3}});
        const auto colorBetween = [&](const Vec2& next) {
            drive.move(next);
            const Vec2 middle = draftView().toScreen(0.75 * Vec2(3, -3) + 0.25 * next);
            return paintedDraft(drive).pixelColor(static_cast<int>(middle.x()), static_cast<int>(middle.y()));
        };
        QVERIFY(colorBetween({-3, 3}) != colorBetween({-3, -4}));
    }

    void theArrowOfAVelocityIsPainted() {
        Drive drive;
        drive.toolbox.choose(ToolId::Kinematic);
        drive.drag({-1, -1}, {1, 1});
        drive.move({4, 0});
        QVERIFY(isShaded(paintedDraft(drive), Vec2(2, 0)));
    }
};

SPACETOW_TEST(DraftPainterTest)
#include "draft_painter_test.moc"
