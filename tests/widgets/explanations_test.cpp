#include "editor/window/explanations.h"

#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDockWidget>
#include <QFile>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level levelToExplain() {
    Level level;
    level.gravity = {0, -10};
    level.iterations = 4;
    BodyObject floor;
    floor.shapes = {EdgeChain{{{-10, 0}, {10, 0}}}};
    level.objects.append({1, "floor", floor, {}});
    BodyObject ball;
    ball.kind = BodyKind::Dynamic;
    ball.shapes = {Circle{{0, 0}, 0.5}};
    ball.position = {0, 0.5};
    ball.mass = 2;
    level.objects.append({2, "ball", ball, {}});
    return level;
}

/// A window with a run whose updates the test makes.
struct ExplainedRun {
    TestWindow test;

    ExplainedRun() {
        test.window->document().reset(levelToExplain());
        test.window->document().select(Selection({2}));
    }
    QDockWidget& dock(const char* name) { return test.window->panels().dock(QLatin1String(name)); }
    void show(const char* name) {
        dock(name).show();
        dock(name).raise();
        QApplication::processEvents();
    }
    /// Until the window has seen so many updates.
    bool seen(std::int64_t updates) {
        return QTest::qWaitFor([&] { return test.window->liveRun().updates() >= updates; }, 10'000);
    }
};

} // namespace

class ExplanationsTest : public QObject {
    Q_OBJECT

  private slots:
    void theyWaitInTheMenuAndHaveKeys() {
        ExplainedRun run;
        for (const char* name : {"explain", "plots", "profile"}) {
            QVERIFY2(!run.dock(name).isVisible(), name);
        }
        QCOMPARE(run.dock("explain").toggleViewAction()->shortcut(), QKeySequence("Ctrl+Shift+X"));
    }

    void aRunIsTimedOnlyWhileSomebodyLooks() {
        ExplainedRun run;
        run.test.window->simulate();
        QVERIFY(run.seen(2));
        QVERIFY(run.test.window->liveRun().frame()->profile == nullptr);
        run.show("profile");
        const auto isTimed = [&] { return run.test.window->liveRun().frame()->profile != nullptr; };
        QVERIFY(QTest::qWaitFor(isTimed, 10'000));
        run.dock("profile").hide();
        QVERIFY(QTest::qWaitFor([&] { return !isTimed(); }, 10'000));
        run.test.window->stopPlaying();
    }

    void whatIsSelectedIsExplainedWithArrowsOnTheCanvas() {
        ExplainedRun run;
        run.show("explain");
        run.test.window->simulate();
        ExplainPanel& panel = run.test.window->explanations().panel();
        const auto both = [&] { // gravity, and the floor
            return run.test.canvas().forces().size() == 2 && panel.rows().topLevelItemCount() > 0;
        };
        QVERIFY(QTest::qWaitFor(both, 10'000));
        const std::vector<ForceArrow> arrows = run.test.canvas().forces();
        QVERIFY(std::abs(arrows[0].force.y() + 20) < 1e-9);
        QVERIFY(std::abs(arrows[1].force.y() - 20) < 0.1);
        QVERIFY(arrows[1].source == ForceArrow::Source::Contact && std::abs(arrows[1].at.y()) < 0.01);
        const QImage with = run.test.canvas().grab().toImage();
        run.dock("explain").hide();
        QVERIFY(run.test.canvas().forces().empty());
        QVERIFY(run.test.canvas().grab().toImage() != with);
        run.test.window->stopPlaying();
    }

    void withoutARunTheStartOfTheLevelIsExplained() {
        ExplainedRun run;
        run.show("explain");
        Explanations& explanations = run.test.window->explanations();
        explanations.start().finish();
        explanations.panel().refresh();
        QCOMPARE(run.test.canvas().forces().size(), std::size_t(1)); // nothing has touched yet
        run.test.window->document().select(Selection({1, 2}));
        explanations.panel().refresh();
        QVERIFY2(explanations.panel().answer().text().contains("overlap") ||
                     explanations.panel().answer().text().contains("apart"),
                 qPrintable(explanations.panel().answer().text()));
        Level masked = run.test.level();
        Object ball = masked.objects[1];
        std::get<BodyObject>(ball.data).filter.touches = TagMask::bit(9);
        masked.objects.replace(1, ball);
        run.test.window->document().commit({"change-tags", 1},
                                           {std::make_shared<const Level>(masked), Selection({1, 2})});
        explanations.start().finish();
        explanations.panel().refresh();
        QVERIFY(explanations.panel().answer().text().contains("does not touch what"));
        explanations.panel().cure().click();
        explanations.start().finish();
        explanations.panel().refresh();
        QVERIFY(!explanations.panel().answer().text().contains("does not touch what"));
        run.test.window->document().undo();
        QVERIFY(run.test.level() == masked);
    }

    void plotsAreWrittenWhereTheUserWants() {
        ExplainedRun run;
        run.show("plots");
        run.test.window->simulate();
        PlotPanel& plots = run.test.window->explanations().plots();
        QVERIFY(QTest::qWaitFor([&] { return plots.history().size() >= 5; }, 10'000));
        run.test.window->stopPlaying();
        const std::size_t rows = plots.history().size();
        const QString path = run.test.file("plots.csv");
        run.test.window->explanations().whereToWrite = [&](const QString& suggested) {
            return suggested.endsWith(".csv") ? path : QString();
        };
        plots.exportButton().click();
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(static_cast<std::size_t>(file.readAll().count('\n')), rows + 1);
    }

    void aWindowComesBackNoLargerThanItWas() {
        ExplainedRun run;
        run.show("explain");
        run.test.window->resize(1100, 700);
        QApplication::processEvents();
        run.test.unsaved = Unsaved::Discard;
        run.test.window->close();
        run.test.reopen();
        QApplication::processEvents();
        QVERIFY(run.dock("explain").isVisible());
        QCOMPARE(run.test.window->size(), QSize(1100, 700));
    }

    void nothingIsClippedInASmallWindow() {
        ExplainedRun run;
        for (const char* name : {"explain", "plots", "profile"}) {
            run.show(name);
        }
        run.test.window->resize(800, 600);
        QApplication::processEvents();
        QCOMPARE(run.test.window->size(), QSize(800, 600));
        for (const char* name : {"explain", "plots", "profile"}) {
            run.show(name);
            run.test.window->simulate();
            QVERIFY(run.seen(3));
            const QStringList cut = cutOffTexts(run.dock(name));
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join(" | ")));
            run.test.window->stopPlaying();
        }
    }
};

SPACETOW_TEST(ExplanationsTest)
#include "explanations_test.moc"
