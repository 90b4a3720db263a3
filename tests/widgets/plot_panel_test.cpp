#include "editor/panels/plot_panel.h"

#include "editor/panels/plot_names.h"
#include "editor/panels/profile_panel.h"
#include "tests/support/pixels.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QSignalSpy>

#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level levelToPlot() {
    Level level;
    level.gravity = {0, -10};
    level.iterations = 4;
    for (const Key key : {Key{1}, Key{2}}) {
        BodyObject made;
        made.kind = BodyKind::Dynamic;
        made.shapes = {Circle{{0, 0}, 0.2}};
        made.position = {5.0 * key, 0};
        made.velocity = {1, 0};
        level.objects.append({key, key == 1 ? "Ball" : "", made, {}});
    }
    level.objects.append({3, "Spring", ConnectorObject{.a = 1, .b = 2, .stiffness = 1}, {}});
    return level;
}

struct PlotFixture {
    PlotFixture() : document(levelToPlot()), panel(document), session(document.level()) {
        panel.resize(420, 340);
        panel.show();
    }
    void run(int updates) {
        for (int i = 0; i < updates; ++i) {
            session.step(Controls{});
            panel.showSession(std::make_shared<const Session>(session), true);
        }
    }
    void addQuantity(PlotQuantity quantity, Key key) {
        document.select(key == 0 ? Selection() : Selection({key}));
        panel.quantities().setCurrentText(curveName(document.level(), {key, quantity}));
        panel.addButton().click();
    }

    Document document;
    PlotPanel panel;
    Session session;
};

} // namespace

class PlotPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aCurveOfTheSelectionGrowsWithTheRun() {
        PlotFixture test;
        test.panel.view().showAll();
        test.addQuantity(PlotQuantity::Speed, 1);
        test.addQuantity(PlotQuantity::Tension, 3);
        const std::vector<PlotSource>& sources = test.panel.history().sources();
        QCOMPARE(sources.size(), std::size_t(5)); // three there were
        QVERIFY((sources[3] == PlotSource{1, PlotQuantity::Speed}));
        QVERIFY((sources[4] == PlotSource{3, PlotQuantity::Tension}));
        test.run(30);
        QCOMPARE(test.panel.history().size(), std::size_t(30));
        QVERIFY(test.panel.history().column(3).back() > 5);
        QVERIFY(test.panel.totals().text().contains("drift"));
        QVERIFY(test.panel.totals().text().contains("J since the start"));
        QCOMPARE(test.panel.curveButtons().size(), std::size_t(5));
        test.addQuantity(PlotQuantity::Speed, 1); // there already
        QCOMPARE(sources.size(), std::size_t(5));
        test.panel.curveButtons()[0]->click();
        QCOMPARE(test.panel.history().sources().size(), std::size_t(4));
        QCOMPARE(test.panel.history().size(), std::size_t(30));
    }

    void curvesArePaintedInTheirColours() {
        PlotFixture test;
        test.run(60);
        const QImage image = test.panel.view().grab().toImage();
        for (std::size_t i = 0; i < 3; ++i) {
            const QColor color = PlotView::curveColor(i, test.panel.view().palette());
            QVERIFY2(pixelsLike(image, color, 40) > 60, qPrintable(color.name()));
        }
    }

    void thePointerReadsOffTheCurves() {
        PlotFixture test;
        test.run(50);
        PlotView& view = test.panel.view();
        for (const std::size_t row : {std::size_t(0), std::size_t(20), std::size_t(49)}) {
            const QPointF at = view.pointAt(0, row);
            QVERIFY(view.rowAt({at.x(), view.height() / 2.0}) == row);
        }
        QVERIFY(!view.rowAt({0, 0}));
        const QStringList lines = view.readout(24);
        QCOMPARE(lines.size(), 4);
        QCOMPARE(lines[0], QString("0.50 s"));
        QVERIFY(lines[1].startsWith("energy of everything: ") && lines[1].endsWith(" J"));
    }

    void theWheelZoomsAboutThePointerAndADoubleClickShowsAll() {
        PlotFixture test;
        test.run(100);
        PlotView& view = test.panel.view();
        const PlotRange all = view.shownRange();
        QVERIFY(all.from < 0.03 && all.to > 1.99);
        const QPointF at = view.pointAt(0, 50);
        QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                          false);
        QApplication::sendEvent(&view, &wheel);
        QVERIFY(view.shownRange().size() < 0.7 * all.size());
        QVERIFY(std::abs(view.pointAt(0, 50).x() - at.x()) < 3); // labels may have become wider
        QTest::mouseDClick(&view, Qt::LeftButton);
        QVERIFY(view.shownRange() == all);
    }

    void twoQuantitiesMakeAPhasePlot() {
        PlotFixture test;
        while (!test.panel.history().sources().empty()) {
            test.panel.remove(0);
        }
        QVERIFY(!test.panel.phaseButton().isEnabled());
        test.panel.add({1, PlotQuantity::X});
        test.panel.add({1, PlotQuantity::Y});
        test.panel.phaseButton().click();
        QVERIFY(test.panel.view().isPhase());
        test.run(40);
        const QPointF first = test.panel.view().pointAt(0, 0);
        const QPointF last = test.panel.view().pointAt(0, 39);
        QVERIFY(last.x() > first.x() && last.y() > first.y()); // to the right, and down
        QVERIFY(test.panel.view().rowAt(last) == std::size_t(39));
        QVERIFY(pixelsLike(test.panel.view().grab().toImage(), PlotView::curveColor(0, test.panel.palette()), 40) > 60);
    }

    void aPhasePlotShowsAllOfItAndWhereTheRunIsNow() {
        PlotFixture test;
        test.panel.view().setPhase(true);
        while (!test.panel.history().sources().empty()) {
            test.panel.remove(0);
        }
        test.panel.add({1, PlotQuantity::X});
        test.panel.add({1, PlotQuantity::Y});
        std::vector<Session> moments{test.session};
        for (int i = 0; i < 40; ++i) {
            test.run(1);
            moments.push_back(test.session);
        }
        const auto dotAt = [&](std::size_t row) {
            const QImage image = test.panel.view().grab().toImage();
            const QPoint at = (test.panel.view().pointAt(0, row) * image.devicePixelRatio()).toPoint();
            return pixelsLike(image.copy(at.x() - 3, at.y() - 3, 7, 7),
                              PlotView::curveColor(1, test.panel.view().palette()), 40) > 15;
        };
        QVERIFY(dotAt(39) && !dotAt(10));
        test.panel.showSession(std::make_shared<const Session>(moments[11]), true); // turned back
        QVERIFY(dotAt(10) && !dotAt(39));
        PlotView& view = test.panel.view();
        view.setPhase(false);
        for (int i = 0; i < 3; ++i) {
            QTest::keyClick(&view, Qt::Key_Plus);
        }
        QVERIFY(view.shownRange().size() < 0.7);
        view.setPhase(true); // metres are not zoomed as the seconds were
        QVERIFY(view.shownRange().from < 5.02 && view.shownRange().to > 5.8);
    }

    void anotherFutureTakesThePlaceOfTheOldOneWhicheverUpdatesAreSeen() {
        PlotFixture test;
        while (!test.panel.history().sources().empty()) {
            test.panel.remove(0);
        }
        test.panel.add({1, PlotQuantity::X});
        Runner runner(test.document.level(), Runner::Mode::Manual);
        runner.wantSession(true);
        const auto see = [&] {
            test.panel.showTimeline(*runner.frame()->timeline);
            test.panel.showSession(runner.frame()->session, true);
        };
        const auto advance = [&](int times, int updates) { // between two frames
            for (int i = 0; i < times; ++i) {
                runner.advance(updates);
                see();
            }
        };
        advance(20, 3); // 3, 6, 9, …
        const PlotHistory& history = test.panel.history();
        QCOMPARE(history.size(), std::size_t(20));
        runner.seek(30);
        see();
        QCOMPARE(history.size(), std::size_t(20)); // merely looked at
        for (int i = 0; i < 4; ++i) {
            runner.stepIteration();
            see();
        }
        QCOMPARE(history.size(), std::size_t(21)); // update 31; not what was on the way there
        QCOMPARE(history.column(0)[10], runner.frame()->session->snapshot()->moving[0].pose.position.x());
        runner.seek(30);
        runner.setGrab(Grab{1, Vec2(0, 0), Vec2(-50, 0)});
        runner.resume();
        advance(5, 4); // 34, 38, …
        QCOMPARE(history.size(), std::size_t(15));
        for (std::size_t row = 10; row < 15; ++row) {
            QVERIFY(history.column(0)[row] < 5); // nothing of the old future between, in which it went to the right
        }
        runner.restart();
        advance(2, 5);
        QCOMPARE(history.size(), std::size_t(2));
    }

    void theTableIsExportedWithItsUnits() {
        PlotFixture test;
        test.run(3);
        QSignalSpy wanted(&test.panel, &PlotPanel::exportWanted);
        test.panel.exportButton().click();
        QCOMPARE(wanted.size(), 1);
        const QByteArray csv = wanted[0][0].toByteArray();
        QVERIFY(csv.startsWith("s,energy of everything (J),"));
        QCOMPARE(csv.count('\n'), 4);
    }

    void anotherRunBeginsAnewAndWhatHasEndedStays() {
        PlotFixture test;
        test.run(20);
        test.panel.showSession(std::make_shared<const Session>(test.document.level()), false);
        QCOMPARE(test.panel.history().size(), std::size_t(20));
        test.session = Session(test.document.level());
        test.run(5);
        QCOMPARE(test.panel.history().size(), std::size_t(5));
    }

    void ticksAreRoundAndWithinTheRange() {
        QVERIFY((roundTicks({0, 10}, 5) == std::vector<double>{0, 2, 4, 6, 8, 10}));
        QVERIFY((roundTicks({-0.11, 0.11}, 4) == std::vector<double>{-0.1, -0.05, 0, 0.05, 0.1}));
        QVERIFY(roundTicks({1, 1}, 4).empty());
        const std::vector<double> flat(10, 3.0);
        QVERIFY(rangeAround({&flat}, 0, 10).size() > 0.5);
        const std::vector<double> nothing(10, std::nan(""));
        QVERIFY(rangeAround({&nothing}, 0, 10).size() > 0);
        QVERIFY(std::abs(zoomed({0, 10}, 0.25, 2).at(0.25) - 2.5) < 1e-12);
    }

    void theProfileShowsStagesAndCounters() {
        Level level = levelToPlot();
        ProfilePanel panel;
        panel.resize(340, 480);
        panel.show();
        QCOMPARE(panel.rows().topLevelItem(0)->text(1), QString("–"));
        auto profile = std::make_shared<StepProfile>();
        StepProfile::Stages stages{};
        stages[static_cast<std::size_t>(StepStage::Solver)] = 0.004F;
        profile->note(stages);
        stages[static_cast<std::size_t>(StepStage::Solver)] = 0.002F;
        profile->note(stages);
        panel.showSession(std::make_shared<const Session>(level), profile);
        panel.refresh();
        QTreeWidgetItem* const solver = panel.rows().topLevelItem(static_cast<int>(StepStage::Solver));
        QCOMPARE(solver->text(1), QString("2.000"));
        QCOMPARE(solver->text(2), QString("3.000"));
        QCOMPARE(solver->text(3), QString("4.000"));
        QCOMPARE(panel.rows().topLevelItem(stepStageCount)->text(3), QString("4.000"));
        QCOMPARE(panel.rows().topLevelItem(stepStageCount + 3)->text(1), QString("2")); // dynamic bodies
        QVERIFY(std::abs(panel.chart().top() - 0.005) < 1e-9);
        const QImage image = panel.chart().grab().toImage();
        QVERIFY(pixelsLike(image, ProfileChart::stageColor(StepStage::Solver, panel.palette()), 40) > 50);
    }
};

SPACETOW_TEST(PlotPanelTest)
#include "plot_panel_test.moc"
