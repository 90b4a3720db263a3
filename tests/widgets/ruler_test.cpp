#include "editor/canvas/ruler.h"

#include "editor/canvas/canvas_frame.h"
#include "editor/canvas/theme.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QPainter>

#include <cmath>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double quarter = std::numbers::pi / 2;

/// Counts how much of it is painted.
class CountedRuler : public Ruler {
  public:
    using Ruler::Ruler;
    long painted = 0; // pixels
    QRegion where;

  protected:
    void paintEvent(QPaintEvent* event) override {
        where += event->region();
        for (const QRect& rect : event->region()) {
            painted += long(rect.width()) * rect.height();
        }
        Ruler::paintEvent(event);
    }
};

Viewport rulerView(int width, int height, double scale) {
    Viewport view;
    view.size = Vec2(width, height);
    view.scale = scale;
    return view;
}

/// As the mouse does it: pressed on the ruler, moved and released over the canvas.
void dragOut(TestWindow& test, QWidget& source, const QPoint& to) {
    const QPoint from = source.rect().center();
    const auto onSource = [&](const QPoint& inCanvas) {
        return source.mapFromGlobal(test.canvas().mapToGlobal(inCanvas));
    };
    QTest::mousePress(&source, Qt::LeftButton, {}, from);
    QTest::mouseMove(&source, onSource(to / 2));
    QTest::mouseMove(&source, onSource(to));
    QTest::mouseRelease(&source, Qt::LeftButton, {}, onSource(to));
}

int reddish(const QImage& image, const QColor& color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            count += image.pixelColor(x, y) == color ? 1 : 0;
        }
    }
    return count;
}

} // namespace

class RulerTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void stepsAreRoundNumbersThatLeaveRoomForTheirText() {
        for (double scale = Viewport::minScale; scale <= Viewport::maxScale; scale *= 1.17) {
            for (const double least : {40.0, 60.0, 90.0}) {
                const RulerSteps steps = rulerSteps(scale, least);
                QVERIFY(steps.major * scale >= least * (1 - 1e-9));
                QVERIFY(steps.major * scale <= 2.5 * least * (1 + 1e-9) || steps.major * scale <= 2.6 * least);
                const double digits = steps.major / std::pow(10, std::floor(std::log10(steps.major) + 1e-9));
                QVERIFY(std::abs(digits - 1) < 1e-6 || std::abs(digits - 2) < 1e-6 || std::abs(digits - 5) < 1e-6);
                QVERIFY(steps.major / steps.parts * scale >= 4);
                // As many decimals as the number has, and no more.
                const double shifted = steps.major * std::pow(10, steps.decimals);
                QVERIFY(std::abs(shifted - std::round(shifted)) < 1e-6);
                QVERIFY(steps.decimals == 0 || std::fmod(std::round(shifted), 10) != 0);
            }
        }
    }

    void aMovingPointerRepaintsNoMoreThanItsMarks() {
        CountedRuler ruler(Qt::Horizontal);
        ruler.resize(1000, ruler.sizeHint().height());
        ruler.setView(rulerView(1000, 700, 66));
        ruler.show();
        QApplication::processEvents();
        ruler.painted = 0;
        ruler.setPointer(Vec2(1, 0));
        QApplication::processEvents();
        ruler.setPointer(Vec2(2, 0));
        QApplication::processEvents();
        QVERIFY(ruler.painted > 0);
        QVERIFY2(ruler.painted < 4L * 20 * ruler.height(), qPrintable(QString::number(ruler.painted)));
        ruler.painted = 0;
        ruler.setPointer(Vec2(2, 5)); // along the other ruler
        QApplication::processEvents();
        QCOMPARE(ruler.painted, 0L);
    }

    void aPartThatIsPaintedAnewLooksAsInTheWhole() {
        CountedRuler ruler(Qt::Horizontal);
        ruler.resize(1000, ruler.sizeHint().height());
        ruler.setView(rulerView(1000, 700, 66));
        ruler.show();
        QApplication::processEvents();
        const QImage fresh = ruler.grab().toImage();
        for (double x = -7; x < 7; x += 0.31) { // over every number and tick
            QImage part = fresh;
            ruler.render(&part, QPoint(int(500 + 66 * x), 0), QRect(int(500 + 66 * x), 0, 13, ruler.height()));
            QCOMPARE(part, fresh);
        }
    }

    void aBarThatMovesLeavesNothingBehind_data() {
        QTest::addColumn<int>("orientation");
        QTest::newRow("above") << int(Qt::Horizontal);
        QTest::newRow("at the left") << int(Qt::Vertical);
    }
    void aBarThatMovesLeavesNothingBehind() {
        QFETCH(int, orientation);
        CountedRuler ruler(static_cast<Qt::Orientation>(orientation));
        ruler.resize(orientation == Qt::Horizontal ? QSize(600, ruler.sizeHint().height())
                                                   : QSize(ruler.sizeHint().width(), 600));
        ruler.setView(rulerView(600, 600, 66));
        ruler.show();
        QApplication::processEvents();
        QImage seen = ruler.grab().toImage();
        for (int i = 0; i < 40; ++i) {
            ruler.where = {};
            ruler.setExtent(i % 4 == 3 ? Aabb()
                                       : Aabb{Vec2(0.013 * i, 0.017 * i), Vec2(0.4 + 0.013 * i, 1 + 0.01 * i)});
            QApplication::processEvents();
            const QRegion where = ruler.where; // rendering paints as well
            ruler.render(&seen, where.boundingRect().topLeft(), where);
            QCOMPARE(seen, ruler.grab().toImage());
        }
    }

    void theSelectionHasABarAndThePointerAMark() {
        for (const bool dark : {false, true}) {
            TestWindow test;
            test.window->setAppearance(dark ? Appearance::Dark : Appearance::Light);
            const QColor color = editingTheme(dark ? Shade::Dark : Shade::Light).selection;
            test.drawWalls();
            test.document().select({});
            QApplication::processEvents();
            Ruler& top = test.window->canvasFrame().top();
            top.setPointer({});
            const QImage before = top.grab().toImage();
            QCOMPARE(reddish(before, color), 0);
            test.trigger(Act::SelectAll);
            QApplication::processEvents();
            const int bar = reddish(top.grab().toImage(), color);
            const double width = 4 * test.canvas().view().scale; // of the walls
            QVERIFY2(bar >= width && bar <= 2.5 * width + 20, qPrintable(QString::number(bar)));
            test.document().select({});
            top.setPointer(Vec2(0.5, 0));
            QVERIFY(top.grab().toImage() != before);
            top.setPointer({});
            QCOMPARE(top.grab().toImage(), before);
        }
    }

    void theyGoWithTheView() {
        TestWindow test;
        Ruler& left = test.window->canvasFrame().left();
        QApplication::processEvents();
        const QImage before = left.grab().toImage();
        test.canvas().zoom(2);
        QVERIFY(left.grab().toImage() != before);
        test.canvas().zoom(0.5);
        QCOMPARE(left.grab().toImage(), before);
        QCOMPARE(left.height(), test.canvas().height());
        QCOMPARE(test.window->canvasFrame().top().width(), test.canvas().width());
    }

    void theyAreHiddenAndShownAndThatIsRemembered() {
        TestWindow test;
        Ruler& top = test.window->canvasFrame().top();
        QVERIFY(top.isVisible());
        test.trigger(Act::Rulers);
        QVERIFY(!top.isVisible() && !test.window->canvasFrame().left().isVisible());
        QVERIFY(!test.window->files().preferences.rulers());
        test.trigger(Act::Rulers);
        QVERIFY(top.isVisible());
    }

    void guidesComeOutOfThem_data() {
        QTest::addColumn<int>("which");
        QTest::addColumn<double>("angle");
        QTest::newRow("level ones from above") << 0 << 0.0;
        QTest::newRow("upright ones from the left") << 1 << quarter;
        QTest::newRow("slanting ones from the corner") << 2 << quarter / 2;
    }
    void guidesComeOutOfThem() {
        QFETCH(int, which);
        QFETCH(double, angle);
        TestWindow test;
        CanvasFrame& frame = test.window->canvasFrame();
        QWidget* const sources[] = {&frame.top(), &frame.left(), &frame.corner()};
        const QPoint target = test.at(1, -1);
        dragOut(test, *sources[which], target);
        QCOMPARE(test.level().guides.size(), std::size_t{1});
        QCOMPARE(test.level().guides[0].angle, angle);
        QVERIFY((test.level().guides[0].point - Vec2(1, -1)).norm() < 2 * test.canvas().view().pixel());
        test.trigger(Act::Undo);
        QVERIFY(test.level().guides.empty());
        // The next press is the tool's again.
        test.drawWalls();
        QCOMPARE(test.level().objects.size(), 1);
    }

    void escapeEndsADragOutOfARuler() {
        TestWindow test;
        Ruler& top = test.window->canvasFrame().top();
        QTest::mousePress(&top, Qt::LeftButton, {}, top.rect().center());
        const QPoint inside = top.mapFromGlobal(test.canvas().mapToGlobal(test.at(0, 0)));
        QTest::mouseMove(&top, inside);
        QCOMPARE(test.level().guides.size(), std::size_t{1});
        test.key(Qt::Key_Escape);
        QVERIFY(test.level().guides.empty());
        QTest::mouseMove(&top, inside + QPoint(0, 30));
        QTest::mouseRelease(&top, Qt::LeftButton, {}, inside);
        QVERIFY(test.level().guides.empty());
        QVERIFY(!test.document().canUndo());
    }

    void aGuideIsDrawnAndLightsUpUnderThePointer() {
        TestWindow test;
        const auto guideColor = [&test] {
            return reddish(test.canvas().grab().toImage(), editingTheme(shadeOf(test.window->palette())).guide);
        };
        QTest::mouseMove(&test.canvas(), test.at(0, 2));
        QCOMPARE(guideColor(), 0);
        dragOut(test, test.window->canvasFrame().top(), test.at(1, -1));
        test.click(0, 2); // the test's mouse is the ruler's until another is pressed
        QTest::mouseMove(&test.canvas(), test.at(0, 3));
        const int drawn = guideColor();
        QVERIFY(drawn > test.canvas().width() / 2);
        QTest::mouseMove(&test.canvas(), test.at(0, -1));
        QVERIFY(guideColor() > drawn);
        test.trigger(Act::Guides);
        QCOMPARE(guideColor(), 0);
        test.trigger(Act::Guides);
        QVERIFY(guideColor() > 0);
    }
};

SPACETOW_TEST(RulerTest)
#include "ruler_test.moc"
