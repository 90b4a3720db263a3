#include "editor/canvas/legend.h"

#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"
#include "editor/play/hud.h"
#include "editor/window/overlay_colors_dialog.h"
#include "editor/window/preferences.h"
#include "tests/support/color_vision.h"
#include "tests/support/game_levels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QColorDialog>
#include <QScrollBar>
#include <QToolButton>

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double toldApart = 20; // ΔE

QToolButton* legendButton(Legend& legend, const char* property, const QString& name) {
    for (auto* button : legend.findChildren<QToolButton*>()) {
        if (button->property(property).toString() == name) {
            return button;
        }
    }
    return nullptr;
}

OverlayFlags everyOverlay() {
    OverlayFlags all;
    for (const OverlayRow& row : overlayRows()) {
        all.*row.flag = true;
    }
    return all;
}

double apart(const Color& a, const Color& b) {
    return difference(toQColor(a), toQColor(b));
}

void addShades() {
    QTest::addColumn<bool>("dark");
    QTest::addColumn<bool>("safe");
    for (const bool dark : {false, true}) {
        for (const bool safe : {false, true}) {
            QTest::addRow("%s, %s", dark ? "dark" : "light", safe ? "Okabe and Ito" : "standard") << dark << safe;
        }
    }
}

} // namespace

class LegendTest : public QObject {
    Q_OBJECT

  private slots:
    void itLeavesTheDisplayOfAGameFree() {
        TestWindow test;
        test.document().reset(openSpace());
        test.window->setOverlays(everyOverlay());
        test.trigger(Act::Play);
        test.trigger(Act::Pause);
        LiveRun& run = test.window->liveRun();
        for (const QSize& size : {QSize(800, 600), QSize(1280, 900)}) {
            test.window->resize(size);
            QApplication::processEvents();
            const Snapshot picture = run.picture();
            int seen = 0;
            for (const HudText& text : hudLayout({picture.phase, picture.hud, true, run.keys()}, test.canvas().size(),
                                                 test.canvas().font())) {
                const bool central = text.role == HudText::Role::Title || text.role == HudText::Role::Advice;
                QVERIFY2(central || !text.box.intersects(test.window->legend().geometry()), qPrintable(text.text));
                seen += text.role == HudText::Role::Paused || text.role == HudText::Role::Lives ? 1 : 0;
            }
            QCOMPARE(seen, 2);
        }
    }
    void itListsWhatIsOnAndHidesWhenNothingIs() {
        TestWindow test;
        Legend& legend = test.window->legend();
        QVERIFY(!legend.isVisible());
        test.trigger(Act::OverlayAabb);
        test.trigger(Act::OverlayContacts);
        QVERIFY(legend.isVisible());
        QVERIFY(legendButton(legend, "overlay", "aabb") != nullptr);
        QVERIFY(legendButton(legend, "overlay", "contacts") != nullptr);
        QVERIFY(legendButton(legend, "overlay", "velocity") == nullptr);
        for (const char* ink : {"box", "fat-box", "touch-point", "near-point", "contact-normal", "impulse"}) {
            QVERIFY2(legendButton(legend, "ink", ink) != nullptr, ink);
        }
        test.trigger(Act::OverlaysOff);
        QVERIFY(!legend.isVisible());
    }

    void itSaysWhenSomethingIsTooSmallToBeDrawn() {
        TestWindow test;
        test.drawWalls();
        test.trigger(Act::OverlayNormals);
        const auto isSaid = [&test] {
            test.canvas().finishPainting();
            QApplication::processEvents();
            const auto labels = test.window->legend().findChildren<QLabel*>();
            return std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains("too small"); });
        };
        QVERIFY(!isSaid());
        const Viewport large = test.canvas().view();
        const Viewport small = large.zoomedAt(0.5 * large.size, 0.5 / large.scale); // from further than by the wheel
        test.canvas().setView(small);
        QVERIFY(isSaid());
        test.canvas().setView(small.panned({0.6 * small.size.x(), 0})); // part of the picture stays
        QVERIFY(!isSaid());
        test.canvas().setView(small);
        QVERIFY(isSaid());
        test.trigger(Act::OverlayNormals);
        test.trigger(Act::OverlayVelocity);
        QVERIFY(!isSaid()); // of which there is none
        test.trigger(Act::OverlayNormals);
        QVERIFY(isSaid());
        test.canvas().zoomTo(60);
        QVERIFY(!isSaid());
        test.trigger(Act::Simulate);
        test.trigger(Act::Pause);
        QVERIFY(test.canvas().isLive() && !isSaid());
        test.canvas().zoomTo(0.5);
        QTRY_VERIFY(isSaid());
        test.canvas().zoomTo(60);
        QTRY_VERIFY(!isSaid()); // a moment later
    }

    void aClickOnAnOverlaySwitchesItOff() {
        TestWindow test;
        test.trigger(Act::OverlayAabb);
        test.trigger(Act::OverlayVelocity);
        legendButton(test.window->legend(), "overlay", "aabb")->click();
        QVERIFY(!test.window->overlays().aabb && test.window->overlays().velocity);
        QVERIFY(!test.window->actions()[Act::OverlayAabb].isChecked());
        QVERIFY(legendButton(test.window->legend(), "overlay", "velocity") != nullptr);
        for (auto* label : test.window->legend().findChildren<QLabel*>()) {
            if (label->property("row").isValid()) {
                QTest::mouseClick(label, Qt::LeftButton); // its name does the same
                break;
            }
        }
        QVERIFY(!test.window->overlays().any());
    }

    void aClickOnTheCanvasBelowItIsNone() {
        TestWindow test;
        test.trigger(Act::OverlayAabb);
        test.trigger(ToolId::Polygon);
        Legend& legend = test.window->legend();
        QTest::mouseClick(&legend, Qt::LeftButton, {}, legend.rect().center());
        QVERIFY(!test.window->toolbox().isBusy());
    }

    void aColourOfOnesOwnIsShownAndRemembered() {
        TestWindow test;
        test.trigger(Act::OverlayVelocity);
        QVERIFY(!test.window->actions()[Act::OverlayColorsReset].isEnabled());
        legendButton(test.window->legend(), "ink", "velocity")->click();
        auto* dialog = test.window->findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(QColor(1, 2, 3));
        dialog->accept();
        const OverlayPalette chosen = test.window->overlayPalette();
        QVERIFY((overlayColors(chosen, Shade::Dark).velocity == Color{1, 2, 3}));
        test.reopen();
        QVERIFY(test.window->overlayPalette() == chosen);
        test.trigger(Act::OverlayColorsReset);
        QVERIFY(overlayColors(test.window->overlayPalette(), Shade::Dark) == overlayColors({}, Shade::Dark));
        test.reopen();
        QVERIFY(test.window->overlayPalette().own.empty());
    }

    void theDialogOfColorsSaysAndChangesWhatTheLegendDoes() {
        TestWindow test;
        test.trigger(Act::OverlayVelocity);
        test.trigger(Act::OverlayColors);
        auto* const dialog = test.window->findChild<OverlayColorsDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        const auto button = [dialog](const char* property, const QString& name) -> QToolButton* {
            for (auto* one : dialog->findChildren<QToolButton*>()) {
                if (one->property(property).toString() == name) {
                    return one;
                }
            }
            return nullptr;
        };
        for (const OverlayInk& ink : overlayInks()) { // also of overlays that are off
            QVERIFY2(button("ink", ink.name) != nullptr && !button("reset", ink.name)->isEnabled(), ink.name);
        }
        auto* const set = dialog->findChild<QComboBox*>();
        set->setCurrentIndex(1);
        Q_EMIT set->activated(1);
        QVERIFY(test.window->overlayPalette().set == OverlayColorSet::OkabeIto);
        QVERIFY(test.window->actions()[Act::OverlayColorsSafe].isChecked());
        button("ink", QStringLiteral("velocity"))->click();
        auto* const colors = dialog->findChild<QColorDialog*>();
        QVERIFY(colors != nullptr);
        colors->setCurrentColor(QColor(1, 2, 3));
        colors->accept();
        QVERIFY((overlayColors(test.window->overlayPalette(), Shade::Dark).velocity == Color{1, 2, 3}));
        QVERIFY(button("reset", QStringLiteral("velocity"))->isEnabled());
        button("reset", QStringLiteral("velocity"))->click();
        QVERIFY(test.window->overlayPalette().own.empty());
        test.trigger(Act::OverlayColorsSafe); // elsewhere
        QCOMPARE(set->currentIndex(), 0);
        QCOMPARE(cutOffTexts(*dialog), QStringList());
        test.trigger(Act::OverlayColors); // is there already
        QCOMPARE(test.window->findChildren<OverlayColorsDialog*>().size(), 1);
    }

    void theSetIsRemembered() {
        TestWindow test;
        test.trigger(Act::OverlayColorsSafe);
        QVERIFY(test.window->overlayPalette().set == OverlayColorSet::OkabeIto);
        test.reopen();
        QVERIFY(test.window->actions()[Act::OverlayColorsSafe].isChecked());
        QVERIFY(test.window->overlayPalette().set == OverlayColorSet::OkabeIto);
    }

    void itCanBeHiddenAndStaysSo() {
        TestWindow test;
        test.trigger(Act::OverlayAabb);
        QVERIFY(test.window->legend().isVisible());
        test.trigger(Act::OverlayLegend);
        QVERIFY(!test.window->legend().isVisible());
        test.reopen();
        QVERIFY(test.window->overlays().aabb && !test.window->legend().isVisible());
        test.trigger(Act::OverlayLegend);
        QVERIFY(test.window->legend().isVisible());
    }

    void nothingIsClippedInASmallWindowWithLargeText() {
        const QFont before = QApplication::font();
        QFont large = before;
        large.setPointSizeF(1.4 * before.pointSizeF());
        QApplication::setFont(large);
        {
            TestWindow test;
            test.window->resize(800, 600);
            test.window->setOverlays(everyOverlay());
            QApplication::processEvents();
            Legend& legend = test.window->legend();
            QVERIFY(test.canvas().rect().contains(legend.geometry()));
            QCOMPARE(cutOffTexts(legend), QStringList());
            const auto* scroll = legend.findChild<QScrollArea*>();
            QVERIFY(scroll->widget()->width() <= scroll->viewport()->width());
            for (const auto* button : legend.findChildren<QToolButton*>()) {
                QVERIFY(button->width() >= button->sizeHint().width());
            }
            for (const auto* label : legend.findChildren<QLabel*>()) {
                QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(label->text()));
            }
        }
        QApplication::setFont(before);
    }

    void coloursOfAnOverlayAreToldApartWithAnyColorVision_data() { addShades(); }
    void coloursOfAnOverlayAreToldApartWithAnyColorVision() {
        QFETCH(bool, dark);
        QFETCH(bool, safe);
        const OverlayPalette palette{safe ? OverlayColorSet::OkabeIto : OverlayColorSet::Standard, {}};
        const Shade shade = dark ? Shade::Dark : Shade::Light;
        const DebugColors colors = overlayColors(palette, shade);
        for (const OverlayRow& row : overlayRows()) {
            if (!safe && row.flag == &OverlayFlags::tension) {
                continue; // the report's hues, which are what they are
            }
            for (std::size_t i = 0; i < row.inks.size(); ++i) {
                for (std::size_t k = 0; k < i; ++k) {
                    const double found = apart(colors.*row.inks[i].color, colors.*row.inks[k].color);
                    QVERIFY2(
                        found >= toldApart,
                        qPrintable(QStringLiteral("%1, %2: %3").arg(row.inks[i].name, row.inks[k].name).arg(found)));
                }
            }
        }
    }

    void standardOverlaysAreToldApartWithAnyColorVision_data() {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    /// By what marks each of them; of connectors and texts something else does.
    void standardOverlaysAreToldApartWithAnyColorVision() {
        QFETCH(bool, dark);
        const Shade shade = dark ? Shade::Dark : Shade::Light;
        const DebugColors c = overlayColors({}, shade);
        const std::vector<std::pair<const char*, Color>> marks{
            {"box", c.box},         {"incircle", c.incircle}, {"velocity", c.velocity},  {"up", c.orientation},
            {"normal", c.normal},   {"cell", c.staticCell},   {"contact", c.touchPoint}, {"trail", c.trail},
            {"mass", c.massCenter}, {"asleep", c.asleep},     {"risk", c.risky},         {"meets", c.meets}};
        for (std::size_t i = 0; i < marks.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const double found = apart(marks[i].second, marks[k].second);
                QVERIFY2(found >= toldApart,
                         qPrintable(QStringLiteral("%1, %2: %3").arg(marks[i].first, marks[k].first).arg(found)));
            }
            QVERIFY2(contrast(toQColor(marks[i].second), editingTheme(shade).background) >= 3, marks[i].first);
        }
    }

    void marksOfOneFormAreToldApartWithAnyColorVision_data() { addShades(); }
    /// Where two overlays have the same colour, one is a line and the other a box, say.
    void marksOfOneFormAreToldApartWithAnyColorVision() {
        QFETCH(bool, dark);
        QFETCH(bool, safe);
        const Shade shade = dark ? Shade::Dark : Shade::Light;
        const DebugColors c = overlayColors({safe ? OverlayColorSet::OkabeIto : OverlayColorSet::Standard, {}}, shade);
        const Color ground = toColor(editingTheme(shade).background);
        const std::vector<std::vector<Color>> forms{
            {c.velocity, c.orientation, c.normal, c.contactNormal, c.impulse, c.trail, c.massCenter}, // lines
            {c.box, c.fatBox, c.staticCell, c.movingCell},
            {c.meets, c.passes, c.incircle}, // outlines of bodies
            {c.touchPoint, c.nearPoint}};
        for (const std::vector<Color>& form : forms) {
            for (std::size_t i = 0; i < form.size(); ++i) {
                const auto told = [&](const Color& other) {
                    return qPrintable(QStringLiteral("%1, %2: %3")
                                          .arg(toQColor(form[i]).name(), toQColor(other).name())
                                          .arg(apart(form[i], other)));
                };
                for (std::size_t k = 0; k < i; ++k) {
                    QVERIFY2(apart(form[i], form[k]) >= toldApart, told(form[k]));
                }
                QVERIFY2(apart(form[i], ground) >= toldApart, told(ground));
                QVERIFY2(contrast(toQColor(form[i]), toQColor(ground)) >= 3, told(ground));
            }
        }
    }

    void inTheSafeSetSleepersAreOfNoIslandsColor_data() { addShades(); }
    void inTheSafeSetSleepersAreOfNoIslandsColor() {
        QFETCH(bool, dark);
        QFETCH(bool, safe);
        const Shade shade = dark ? Shade::Dark : Shade::Light;
        const DebugColors c = overlayColors({safe ? OverlayColorSet::OkabeIto : OverlayColorSet::Standard, {}}, shade);
        for (const Color& island : c.islands) {
            QVERIFY(!safe || apart(c.asleep, island) >= toldApart);
            QVERIFY(contrast(toQColor(island), editingTheme(shade).background) >= 3);
        }
    }

    void tensionIsOfTheReportsHueButInTheSafeSetNotRedAndGreen() {
        for (const Shade shade : {Shade::Dark, Shade::Light}) {
            const DebugColors standard = overlayColors({}, shade);
            QCOMPARE(toQColor(standard.pressed).hue(), 0);
            QCOMPARE(toQColor(standard.pulled).hue(), 120);
            const DebugColors safe = overlayColors({OverlayColorSet::OkabeIto, {}}, shade);
            QVERIFY(apart(safe.pressed, safe.pulled) > 2 * toldApart);
            QVERIFY(toQColor(safe.pulled).blue() > toQColor(safe.pulled).green());
        }
    }

    void everyOverlayHasAKeyAndEveryColourAMeaning() {
        QCOMPARE(overlayRows().size(), std::size_t{16});
        for (std::size_t i = 0; i < 9; ++i) {
            QCOMPARE(QString::fromLatin1(overlayRows()[i].keys), QStringLiteral("Alt+%1").arg(i + 1));
        }
        std::size_t explained = 0;
        for (const OverlayRow& row : overlayRows()) {
            QVERIFY(*row.keys != '\0' && *row.tip != '\0');
            explained += row.inks.size();
        }
        QCOMPARE(explained, overlayInks().size());
    }
};

SPACETOW_TEST(LegendTest)
#include "legend_test.moc"
