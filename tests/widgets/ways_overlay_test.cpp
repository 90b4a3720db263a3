// The ways of a run that is held, and those of futures given up, as an overlay like the others.
#include "editor/canvas/legend.h"
#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"
#include "tests/support/color_vision.h"
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QToolButton>

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Without gravity: a ball that flies to the right from the origin.
Level ballOnItsWay() {
    Level level;
    level.gravity = Vec2(0, 0);
    addBall(level, Vec2(0, 0), 0.3, Vec2(2, 0));
    return level;
}

/// Pixels of this colour, or nearly so where lines are smooth.
int pixelsLike(const QImage& image, const Color& color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor seen = image.pixelColor(x, y);
            count += std::abs(seen.red() - color.red) + std::abs(seen.green() - color.green) +
                                 std::abs(seen.blue() - color.blue) <
                             200
                         ? 1
                         : 0;
        }
    }
    return count;
}

bool explains(TestWindow& test, const char* property, const char* name) {
    const auto buttons = test.window->legend().findChildren<QToolButton*>();
    return test.window->legend().isVisible() && std::ranges::any_of(buttons, [&](const QToolButton* button) {
               return button->property(property).toString() == QLatin1String(name);
           });
}

} // namespace

class WaysOverlayTest : public QObject {
    Q_OBJECT

  private slots:
    void waysOfARunHaveTheColoursThatWereChosenAndCanBeSwitchedOff() {
        constexpr Color magenta{255, 0, 255};
        constexpr Color lime{0, 255, 0};
        Game game(ballOnItsWay(), {400, 400}, LiveRun::Kind::Simulation);
        game.view().setOverlayPalette({.own = {{"way", magenta}, {"lost-way", lime}}});
        game.run(60);
        game.scene().refresh();
        QVERIFY(!game.scene().hasWays());
        QCOMPARE(pixelsLike(game.view().grab().toImage(), magenta), 0); // it is not held
        game.live().setPaused(true);
        game.live().seek(20);
        game.scene().refresh();
        QVERIFY(game.scene().hasWays());
        QVERIFY(pixelsLike(game.view().grab().toImage(), magenta) > 20);
        game.live().setPaused(false);
        game.run(1); // another future
        game.scene().refresh();
        QVERIFY(game.scene().hasWays());
        QCOMPARE(pixelsLike(game.view().grab().toImage(), magenta), 0);
        QVERIFY(pixelsLike(game.view().grab().toImage(), lime) > 20);
        game.live().setPaused(true);
        game.scene().setOverlays({.ways = false});
        QCOMPARE(pixelsLike(game.view().grab().toImage(), magenta), 0);
        QCOMPARE(pixelsLike(game.view().grab().toImage(), lime), 0);
        game.scene().setOverlays({});
        QVERIFY(pixelsLike(game.view().grab().toImage(), magenta) > 20);
    }

    void theLegendExplainsThemAsLongAsThereAreAny() {
        TestWindow test;
        test.document().reset(ballOnItsWay());
        QVERIFY(!test.window->legend().isVisible()); // though they are on
        test.trigger(Act::Simulate);
        QVERIFY(!test.window->legend().isVisible());
        test.trigger(Act::Pause);
        QVERIFY(explains(test, "overlay", "ways"));
        QVERIFY(explains(test, "ink", "way") && explains(test, "ink", "lost-way"));
        test.trigger(Act::Pause);
        QVERIFY(!test.window->legend().isVisible());
        test.trigger(Act::Pause);
        QVERIFY(test.window->legend().isVisible());
        test.trigger(Act::Stop);
        QVERIFY(!test.window->legend().isVisible());
    }

    void theirSwitchIsRemembered() {
        TestWindow test;
        QVERIFY(test.window->actions()[Act::OverlayWays].isChecked()); // they are on at first
        test.document().reset(ballOnItsWay());
        test.trigger(Act::Simulate);
        test.trigger(Act::Pause);
        const auto buttons = test.window->legend().findChildren<QToolButton*>();
        const auto ways = std::ranges::find_if(
            buttons, [](const QToolButton* one) { return one->property("overlay").toString() == "ways"; });
        QVERIFY(ways != buttons.end());
        (*ways)->click();
        QVERIFY(!test.window->legend().isVisible() && !test.window->overlays().ways);
        test.trigger(Act::Stop);
        test.reopen();
        QVERIFY(!test.window->actions()[Act::OverlayWays].isChecked());
        test.trigger(Act::OverlayWays);
        test.reopen();
        QVERIFY(test.window->overlays().ways);
        test.trigger(Act::OverlaysOff);
        QVERIFY(!test.window->overlays().ways);
    }

    void theyAreToldApartFromEachOtherAndFromTrails_data() {
        QTest::addColumn<bool>("dark");
        QTest::addColumn<bool>("safe");
        for (const bool dark : {false, true}) {
            for (const bool safe : {false, true}) {
                QTest::addRow("%s, %s", dark ? "dark" : "light", safe ? "Okabe and Ito" : "standard") << dark << safe;
            }
        }
    }
    void theyAreToldApartFromEachOtherAndFromTrails() {
        QFETCH(bool, dark);
        QFETCH(bool, safe);
        const Shade shade = dark ? Shade::Dark : Shade::Light;
        const DebugColors c = overlayColors({safe ? OverlayColorSet::OkabeIto : OverlayColorSet::Standard, {}}, shade);
        const QColor ground = editingTheme(shade).background;
        const std::vector<Color> lines{c.way, c.lostWay, c.trail, c.velocity, toColor(ground)};
        for (std::size_t i = 0; i < lines.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const double apart = difference(toQColor(lines[i]), toQColor(lines[k]));
                QVERIFY2(apart >= 20, qPrintable(QStringLiteral("%1, %2: %3").arg(i).arg(k).arg(apart)));
            }
        }
        QVERIFY(contrast(toQColor(c.way), ground) >= 4.5); // it is a thin line
        QVERIFY(contrast(toQColor(c.lostWay), ground) >= 3);
    }
};

SPACETOW_TEST(WaysOverlayTest)
#include "ways_overlay_test.moc"
