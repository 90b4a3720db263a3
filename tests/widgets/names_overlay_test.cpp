// Names of bodies as an overlay: as many as do not lie on each other.
#include "editor/canvas/legend.h"
#include "editor/canvas/painter_draw.h"
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QFontMetricsF>
#include <QLabel>

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct NamedPoint {
    Vec2 at{0, 0};
    std::uint64_t user = 0;
};

QString nameOfPoint(std::uint64_t user) {
    return QStringLiteral("crate %1").arg(user);
}

std::vector<NamedPoint> gridOfNames(int across, double apart) {
    std::vector<NamedPoint> points;
    for (int i = 0; i < across * across; ++i) {
        points.push_back({Vec2(20 + apart * (i % across), 20 + apart * (i / across)), std::uint64_t(i) + 1});
    }
    return points;
}

QFontMetricsF metricsOfNames() {
    return QFontMetricsF(QFont());
}

PainterDraw placedNames(const std::vector<NamedPoint>& points, const std::function<int(std::uint64_t)>& rank) {
    PainterDraw draw(Vec2(800, 600));
    for (const NamedPoint& point : points) {
        draw.name(point.at, nameOfPoint(point.user).toStdString(), Color{255, 255, 255}, point.user);
    }
    draw.placeNames(metricsOfNames(), rank);
    return draw;
}

QRectF placeOf(const NamedPoint& point) {
    const QFontMetricsF metrics = metricsOfNames();
    return {point.at.x(), point.at.y() - metrics.ascent(), metrics.horizontalAdvance(nameOfPoint(point.user)),
            metrics.height()};
}

int alike(std::uint64_t /*user*/) {
    return 2;
}

/// In a square of so many by so many, half a metre apart, each with a name.
Level namedBalls(int across) {
    Level level;
    level.gravity = Vec2(0, 0);
    for (int i = 0; i < across * across; ++i) {
        addBall(level, Vec2(0.5 * (i % across), 0.5 * (i / across)), 0.1, Vec2(0, 0));
        Object ball = level.objects[i];
        ball.name = "M";
        level.objects.replace(i, ball);
    }
    return level;
}

constexpr Color magenta{255, 0, 255};

/// Whether the name beside the place is to be seen.
bool isNamed(const QImage& image, const Vec2& at) {
    int count = 0;
    for (int y = int(at.y()) - 14; y < int(at.y()); ++y) {
        for (int x = int(at.x()) + 4; x < int(at.x()) + 20; ++x) {
            const QColor color = image.valid(x, y) ? image.pixelColor(x, y) : QColor();
            count += std::min(color.red(), color.blue()) - color.green() > 100 ? 1 : 0;
        }
    }
    return count > 8;
}

bool saysThatNamesAreLeftOut(TestWindow& test) {
    test.canvas().finishPainting();
    QApplication::processEvents();
    const auto labels = test.window->legend().findChildren<QLabel*>();
    return std::ranges::any_of(labels, [](const QLabel* label) { return label->text().startsWith("Names that"); });
}

} // namespace

class NamesOverlayTest : public QObject {
    Q_OBJECT

  private slots:
    void namesDoNotLieOnEachOtherAndNoneIsLeftOutThatHasRoom() {
        const std::vector<NamedPoint> points = gridOfNames(40, 13);
        const PainterDraw draw = placedNames(points, alike);
        QVERIFY(draw.leavesOutNames());
        std::vector<QRectF> shown;
        for (const NamedPoint& point : points) {
            if (std::ranges::binary_search(draw.named(), point.user)) {
                shown.push_back(placeOf(point));
            }
        }
        QVERIFY(shown.size() > 20);
        for (std::size_t i = 0; i < shown.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                QVERIFY(!shown[i].intersects(shown[k]));
            }
        }
        constexpr double across = 20, down = 14; // px, that are kept free around a name, and rounding
        for (const NamedPoint& point : points) {
            const QRectF around = placeOf(point).adjusted(-across, -down, across, down);
            QVERIFY(std::ranges::any_of(shown, [&](const QRectF& one) { return one.intersects(around); }));
        }
    }

    void namesThatHaveRoomAreAllThere() {
        const std::vector<NamedPoint> points = gridOfNames(5, 110);
        const PainterDraw draw = placedNames(points, alike);
        QVERIFY(!draw.leavesOutNames());
        QCOMPARE(draw.named().size(), points.size());
    }

    void thoseOfALowerRankComeFirst() {
        const std::vector<NamedPoint> points = gridOfNames(40, 13);
        const std::vector<std::uint64_t> before = placedNames(points, alike).named();
        std::vector<std::uint64_t> unnamed;
        for (const NamedPoint& point : points) {
            if (!std::ranges::binary_search(before, point.user)) {
                unnamed.push_back(point.user);
            }
        }
        for (const std::uint64_t wanted : {unnamed.front(), unnamed[unnamed.size() / 2], unnamed.back()}) {
            const PainterDraw draw = placedNames(points, [&](std::uint64_t user) { return user == wanted ? 0 : 2; });
            QVERIFY(std::ranges::binary_search(draw.named(), wanted));
        }
    }

    void whatIsNamedStaysNamedThoughOthersComeThatWereDrawnBefore() {
        std::vector<NamedPoint> points{{Vec2(-500, 100), 1}, {Vec2(100, 100), 2}};
        const std::vector<std::uint64_t> first = placedNames(points, alike).named();
        QCOMPARE(first, (std::vector<std::uint64_t>{2}));
        points[0].at = Vec2(90, 104);
        const auto rank = [&](std::uint64_t user) { return std::ranges::binary_search(first, user) ? 1 : 2; };
        QCOMPARE(placedNames(points, rank).named(), first);
        points[1].at = Vec2(700, 400);
        QCOMPARE(placedNames(points, rank).named(), (std::vector<std::uint64_t>{1, 2}));
    }

    void theLegendSaysThatNamesAreLeftOut() {
        TestWindow test;
        test.document().reset(namedBalls(30));
        test.canvas().fitLevel();
        QVERIFY(!saysThatNamesAreLeftOut(test));
        test.trigger(Act::OverlayNames);
        QVERIFY(saysThatNamesAreLeftOut(test));
        test.canvas().zoomTo(600);
        QVERIFY(!saysThatNamesAreLeftOut(test));
        test.canvas().fitLevel();
        QVERIFY(saysThatNamesAreLeftOut(test));
        test.trigger(Act::OverlayNames);
        test.trigger(Act::OverlayMasses);
        QVERIFY(!saysThatNamesAreLeftOut(test));
    }

    void whatIsSelectedOrPointedAtIsNamed() {
        TestWindow test;
        test.document().reset(namedBalls(30));
        test.canvas().fitLevel();
        test.window->setOverlayPalette({.own = {{"name", magenta}}});
        test.trigger(Act::OverlayNames);
        const auto named = [&](int ball) {
            test.canvas().finishPainting();
            const Vec2 at(0.5 * (ball % 30), 0.5 * (ball / 30));
            return isNamed(test.canvas().grab().toImage(), test.canvas().view().toScreen(at));
        };
        int unnamed = 465; // about the middle
        while (named(unnamed)) {
            ++unnamed;
        }
        test.document().select(Selection({test.level().objects[unnamed].key}));
        QVERIFY(named(unnamed));
        test.document().select({});
        QVERIFY(!named(unnamed));
        QTest::mouseMove(&test.canvas(), test.at(0.5 * (unnamed % 30), 0.5 * (unnamed / 30)));
        QVERIFY(named(unnamed));
    }

    void inARunTooNamesOfACrowdStayFromMomentToMoment() {
        Game game(namedBalls(30), {800, 600}, LiveRun::Kind::Simulation);
        game.view().setView(game.view().view().showing({{-1, -1}, {11, 11}}));
        game.view().setOverlayPalette({.own = {{"name", magenta}}});
        game.scene().setOverlays({.names = true});
        const auto names = [&] {
            game.run(1);
            game.scene().refresh();
            game.view().grab(); // asks for what is to be seen
            const auto isThere = [&] { return !game.scene().isPaintingOverlays(); };
            if (!QTest::qWaitFor(isThere)) {
                return QImage();
            }
            return game.view().grab().toImage();
        };
        const QImage first = names();
        int seen = 0;
        for (int ball = 0; ball < 400; ++ball) {
            const Vec2 at = game.view().view().toScreen(Vec2(0.5 * (ball % 30), 0.5 * (ball / 30)));
            seen += isNamed(first, at) ? 1 : 0;
        }
        QVERIFY2(seen > 20 && seen < 300, qPrintable(QString::number(seen)));
        QVERIFY(game.scene().leftOut().names);
        for (int i = 0; i < 5; ++i) {
            QCOMPARE(names(), first); // nothing moves
        }
    }
};

SPACETOW_TEST(NamesOverlayTest)
#include "names_overlay_test.moc"
