// What is painted of the way by which the ship gets out of its cave.

#include "tests/support/test_main.h"

#include "editor/canvas/way_out_painter.h"

#include "core/level/lint.h"
#include "core/level/problem_place.h"
#include "editor/window/messages.h"
#include "tests/support/body_with.h"

#include <QImage>

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// 10 × 10 m about the origin at 20 pixels a metre.
QImage paintedWay(const std::vector<Vec2>& way, bool isStrong) {
    QImage image(200, 200, QImage::Format_RGB32);
    image.fill(Qt::black);
    Viewport view;
    view.scale = 20;
    view.size = Vec2(200, 200);
    QPainter painter(&image);
    paintWayOut(Stage{painter, view, editingTheme()}, way, Qt::red, isStrong);
    return image;
}

int redPixels(const QImage& image, const QRect& area) {
    int count = 0;
    for (int x = area.left(); x <= area.right(); ++x) {
        for (int y = area.top(); y <= area.bottom(); ++y) {
            count += image.pixelColor(x, y).red() > 60 ? 1 : 0;
        }
    }
    return count;
}

/// A game in a cave of one-way walls whose last one is missing.
Level openCave() {
    Level level;
    level.objects.append({1, "ship", ShipObject{}, {}});
    level.objects.append({2, "", PayloadObject{{2, 0}}, {}});
    level.objects.append({3, "", FinishObject{{-2, -1}, {-2, 1}}, {}});
    level.objects.append(bodyWith(4, EdgeChain{{{-4, -3}, {4, -3}, {4, 3}, {-4, 3}}, false, 0.5}));
    return level;
}

} // namespace

class WayOutTest : public QObject {
    Q_OBJECT

  private slots:
    void theWayIsADashedLineWithAnArrowAtItsEnd() {
        const QImage image = paintedWay({{-4, 0}, {4, 0}}, true);
        const int along = redPixels(image, QRect(25, 94, 150, 13));
        QVERIFY(along > 150 && along < 900); // dashes of two to three pixels, and an arrow at the middle
        QVERIFY(redPixels(image, QRect(165, 90, 16, 21)) > 60);
        QCOMPARE(redPixels(image, QRect(0, 0, 200, 80)), 0);
        QVERIFY(redPixels(paintedWay({{-4, 0}, {4, 0}}, false), image.rect()) < redPixels(image, image.rect()));
    }

    void aWayThatIsNotInViewIsNotPainted() {
        const QImage image = paintedWay({{50, 0}, {60, 0}}, true);
        QCOMPARE(redPixels(image, image.rect()), 0);
        QCOMPARE(redPixels(paintedWay({}, true), image.rect()), 0);
    }

    void aLeakIsAProblemWithASentenceAPlaceAndAWayToShow() {
        const Level level = openCave();
        const std::vector<Problem> problems = lint(level);
        const auto found = std::ranges::find(problems, LevelCode("leak-not-closed"), &Problem::code);
        QVERIFY(found != problems.end());
        QCOMPARE(found->severity, Severity::Warning);
        QCOMPARE(found->object, Key{4});
        QCOMPARE(found->place.size(), std::size_t{2});
        QVERIFY(found->wayOut.size() >= 2 && found->wayOut.front() == Vec2(0, 0) && found->wayOut.back().x() < -4);
        QVERIFY2(sentence(*found).contains("6"), qPrintable(sentence(*found)));
        const std::vector<bool> hidden(problems.size(), false);
        const std::vector<ProblemMark> marks = marksOf(level, problems, hidden);
        QVERIFY(std::ranges::any_of(marks, [&](const ProblemMark& mark) { return mark.wayOut == found->wayOut; }));
    }
};

SPACETOW_TEST(WayOutTest)
#include "way_out_test.moc"
