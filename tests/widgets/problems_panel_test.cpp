#include "editor/panels/problems_panel.h"

#include "core/base/random.h"
#include "core/level/lint.h"
#include "editor/canvas/palette.h"
#include "editor/window/messages.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QListView>
#include <QSignalSpy>
#include <QToolButton>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

Object crossed(Key key) {
    BodyObject body;
    body.shapes = {Polygon{{Vec2(0, 0), Vec2(2, 2), Vec2(2, 0), Vec2(0, 1)}}};
    return {key, {}, body, {}};
}

QString code(const Problem& problem) {
    return QString::fromUtf8(problem.code.text());
}

QString labelCode(const Label& label) {
    return QString::fromUtf8(label.code.text());
}

/// A wall with a repeated vertex and a polygon that runs clockwise.
Level tidyable() {
    Level level;
    BodyObject wall;
    wall.shapes = {LineChain{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 0), Vec2(2, 1)}, false}};
    level.objects.append({1, "wall", wall, {}});
    BodyObject rock;
    rock.shapes = {Polygon{{Vec2(5, 0), Vec2(5, 1), Vec2(6, 0)}}};
    level.objects.append({2, "rock", rock, {}});
    return level;
}

} // namespace

class ProblemsPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void theMarksAreSeenInLightAndInDark() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code);
        for (const Shade shade : {Shade::Dark, Shade::Light, Shade::Dark}) {
            panel.setPalette(panelPalette(shade));
            QCoreApplication::processEvents();
            for (const QToolButton* button : panel.findChildren<QToolButton*>()) {
                const QImage mark = button->icon().pixmap(64, 64).toImage();
                int ink = 0;
                int onGround = 0; // of light marks on dark ground, and the other way round
                for (int y = 0; y < mark.height(); ++y) {
                    for (int x = 0; x < mark.width(); ++x) {
                        const QColor color = mark.pixelColor(x, y);
                        ink += color.alpha() > 200 ? 1 : 0;
                        onGround += color.alpha() > 200 && (color.lightness() > 140) == (shade == Shade::Dark) ? 1 : 0;
                    }
                }
                QVERIFY2(ink > 50 && onGround == ink, qPrintable(button->toolTip()));
            }
        }
    }

    void whatLintFindsIsListedAfterAnEdit() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code);
        QCOMPARE(panel.errors(), 0);
        QSignalSpy changed(&panel, &ProblemsPanel::problemsChanged);
        Level level;
        level.objects.append(crossed(5));
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(level), Selection()});
        panel.check();
        QCOMPARE(panel.problems(), lint(level));
        QVERIFY(panel.errors() > 0);
        QCOMPARE(changed.count(), 1);
        QCOMPARE(panel.findChild<QListView*>()->model()->rowCount(), static_cast<int>(panel.problems().size()));
        document.undo();
        panel.check();
        QCOMPARE(panel.errors(), 0);
    }

    void anObjectWithoutANameIsToldByKindAndPlace() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, [](const Problem& problem) { return sentence(problem); });
        BodyObject body;
        body.shapes = {Circle{Vec2(0, 0), 1}};
        body.position = Vec2(0.5, -0.25);
        Level level;
        level.objects.append({1, "", body, {}});
        level.objects.append({2, "", ShipObject{}, {}});
        level.objects.append({3, "", PayloadObject{Vec2(20, 0)}, {}});
        level.objects.append({4, "", FinishObject{Vec2(10, 0), Vec2(10, 2)}, {}});
        level.objects.append(crossed(5));
        document.commit({"draw-circle", 1}, {std::make_shared<Level>(level), Selection()});
        panel.check();
        QStringList texts;
        const QAbstractItemModel& list = *panel.findChild<QListView*>()->model();
        for (int row = 0; row < list.rowCount(); ++row) {
            texts << list.index(row, 0).data().toString();
        }
        const QString all = texts.join('\n');
        QVERIFY2(all.contains("The ship starts in touch with the circle at 0.5; -0.25 m"), qPrintable(all));
        QVERIFY2(all.contains("Polygon at "), qPrintable(all));
        QVERIFY2(!all.contains(QString::fromUtf8("“”")), qPrintable(all));
    }

    void theCheckFollowsAnEditByItself() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code);
        Level level;
        level.objects.append(crossed(5));
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(level), Selection()});
        QTRY_VERIFY(panel.errors() > 0);
    }

    void goingRoundLeadsToEachObjectInTurn() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code);
        Level level;
        level.objects.append(crossed(5));
        level.objects.append(crossed(6));
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(level), Selection()});
        panel.check();
        std::vector<Key> wanted;
        connect(&panel, &ProblemsPanel::objectWanted, this, [&wanted](Key key) { wanted.push_back(key); });
        const std::size_t count = panel.problems().size();
        for (std::size_t i = 0; i < count + 1; ++i) {
            panel.go(1);
        }
        QCOMPARE(wanted.size(), count + 1);
        QCOMPARE(wanted.front(), Key{5});
        QCOMPARE(wanted.back(), Key{5});
        QVERIFY(std::ranges::find(wanted, Key{6}) != wanted.end());
        panel.go(-1);
        QCOMPARE(wanted.back(), Key{6});
    }

    void keysThatMoveInTheListAreNotTheWindows() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code);
        Level level;
        level.objects.append(crossed(5));
        level.objects.append(crossed(6));
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(level), Selection()});
        panel.check();
        panel.show();
        auto& list = *panel.findChild<QListView*>();
        for (const int key : {Qt::Key_Home, Qt::Key_End, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_Up}) {
            QKeyEvent asked(QEvent::ShortcutOverride, key, Qt::NoModifier);
            asked.ignore();
            QApplication::sendEvent(&list, &asked);
            QVERIFY(asked.isAccepted());
        }
        list.setCurrentIndex(list.model()->index(0, 0));
        QTest::keyClick(&list, Qt::Key_End);
        QCOMPARE(list.currentIndex().row(), list.model()->rowCount() - 1);
    }

    void fiftyThousandProblemsTakeUpNoTimeUntilTheyAreLookedAt() {
        Document document;
        int sentences = 0;
        LevelCheck check(document);
        ProblemsPanel panel(check, [&sentences](const Problem& problem) {
            ++sentences;
            return code(problem);
        });
        panel.resize(300, 200);
        panel.show();
        Level level;
        for (Key key = 1; key <= 50'000; ++key) {
            BodyObject body; // without a shape
            level.objects.append({key, {}, body, {}});
        }
        document.commit({"paste", 1}, {std::make_shared<Level>(level), Selection()});
        panel.check();
        QVERIFY(panel.errors() >= 50'000);
        QCoreApplication::processEvents();
        QVERIFY2(sentences < 5000, QByteArray::number(sentences));
    }

    void whatCannotBeCuredIsSaid() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code, labelCode);
        QSignalSpy said(&panel, &ProblemsPanel::said);
        Random random(3);
        Polygon scribble;
        for (int i = 0; i < 300; ++i) {
            scribble.vertices.emplace_back(random.uniform(-5, 5), random.uniform(-5, 5));
        }
        Level level;
        level.objects.append({1, {}, BodyObject{.shapes = {scribble}}, {}});
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(level), Selection()});
        panel.check();
        panel.go(1);
        QVERIFY(panel.canFixCurrent());
        const int before = document.position();
        panel.fixCurrent();
        QCOMPARE(document.position(), before);
        QCOMPARE(said.count(), 1);
    }

    void playBeginsWithoutWaitingForTheCheckThatTellsErrors() {
        TestWindow test;
        Level level;
        level.objects.append({5, {}, BodyObject(), {}}); // without a shape
        test.document().commit({"draw-polygon", 1}, {std::make_shared<const Level>(level), {}});
        const int checks = test.window->openLevel()->check.checks();
        test.window->play();
        QVERIFY(test.window->isPlaying());
        QCOMPARE(test.window->openLevel()->check.checks(), checks); // it comes beside
        QTRY_VERIFY(!test.window->messageBar().text().isEmpty());
        const QString said = test.window->messageBar().text();
        QVERIFY2(said.contains("may not play as it should"), qPrintable(said));
        test.window->messageBar().dismiss();
        test.window->stopPlaying();
        test.window->play(); // and at once where it is known
        QCOMPARE(test.window->messageBar().text(), said);
    }

    void aFixIsOneStepThatCanBeUndone() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code, labelCode);
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(tidyable()), Selection()});
        panel.check();
        QVERIFY(!panel.canFixCurrent());
        panel.go(1);
        QVERIFY(panel.canFixCurrent());
        const int before = document.position();
        panel.fixCurrent();
        QCOMPARE(document.position(), before + 1);
        QCOMPARE(QString::fromUtf8(document.undoLabel().code.text()), QString("fix-merge-points"));
        panel.check();
        QCOMPARE(panel.warnings(), 1); // the clockwise polygon is left
        document.undo();
        QCOMPARE(*document.current().level, tidyable());
    }

    void theButtonInARowFixesThatRow() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code, labelCode);
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(tidyable()), Selection()});
        panel.check();
        panel.resize(320, 240);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto& list = *panel.findChild<QListView*>();
        const QModelIndex row = list.model()->index(1, 0);
        const auto& delegate = static_cast<const ProblemDelegate&>(*list.itemDelegate());
        const QRect button = delegate.buttonIn(list.visualRect(row), row);
        QVERIFY(list.viewport()->rect().contains(button));
        QSignalSpy wanted(&panel, &ProblemsPanel::objectWanted);
        QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, button.center());
        QCOMPARE(QString::fromUtf8(document.undoLabel().code.text()), QString("fix-turn-outline"));
        QCOMPARE(wanted.count(), 0); // it is no wish to see the place
    }

    void allThatIsSafeIsFixedInOneStep() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code, labelCode);
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(tidyable()), Selection()});
        panel.check();
        QCOMPARE(panel.safeFixes(), 2);
        panel.fixAll();
        QTRY_COMPARE(QString::fromUtf8(document.undoLabel().code.text()), QString("fix-all"));
        QTRY_COMPARE(panel.problems().size(), std::size_t{0});
        document.undo();
        QCOMPARE(*document.current().level, tidyable());
    }

    void aHiddenProblemIsShownOnlyOnDemand() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code, labelCode);
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(tidyable()), Selection()});
        panel.check();
        auto& list = *panel.findChild<QListView*>();
        panel.go(1);
        panel.hideCurrent();
        QCOMPARE(document.current().level->hiddenProblems, (std::vector<HiddenProblem>{{"zero-length-wall", 1}}));
        panel.check();
        QCOMPARE(panel.warnings(), 1);
        QCOMPARE(panel.marks()->size(), std::size_t{1});
        QCOMPARE(list.model()->rowCount(), 1);
        panel.setFilter({.hidden = true});
        QCOMPARE(list.model()->rowCount(), 2);
        QVERIFY(list.model()->index(0, 0).data(Qt::FontRole).value<QFont>().strikeOut());
        panel.go(-1);
        panel.go(1);
        list.setCurrentIndex(list.model()->index(0, 0));
        panel.hideCurrent();
        panel.check();
        QCOMPARE(panel.warnings(), 2);
        QVERIFY(document.current().level->hiddenProblems.empty());
    }

    void errorsAndWarningsCanBeFilteredOut() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code, labelCode);
        Level level = tidyable();
        level.objects.append(crossed(9));
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(level), Selection()});
        panel.check();
        const QAbstractItemModel& rows = *panel.findChild<QListView*>()->model();
        QCOMPARE(rows.rowCount(), 3);
        QCOMPARE(rows.index(0, 0).data().toString().right(22), QString("polygon-crosses-itself")); // the worst first
        panel.setFilter({.severities = {true, false, true}});
        QCOMPARE(rows.rowCount(), 1);
        QCOMPARE(rows.index(0, 0).data().toString().right(22), QString("polygon-crosses-itself"));
        panel.setFilter({.severities = {true, true, false}});
        QCOMPARE(rows.rowCount(), 2);
        QCOMPARE(panel.errors(), 1); // they are counted all the same
    }

    void whereAProblemIsIsMarkedAndGoneTo() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code, labelCode);
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(tidyable()), Selection()});
        panel.check();
        QCOMPARE(panel.marks()->size(), std::size_t{2});
        QCOMPARE(panel.marks()->front().at, Vec2(1, 0));
        QSignalSpy places(&panel, &ProblemsPanel::placeWanted);
        panel.go(1);
        QCOMPARE(places.count(), 1);
        QCOMPARE(places[0][0].value<std::vector<Vec2>>(), std::vector<Vec2>{Vec2(1, 0)});
        QCOMPARE(panel.current(), 0);
        panel.goTo(panel.problems()[1]);
        QCOMPARE(panel.current(), 1);
        QCOMPARE(places.count(), 2);
        QCOMPARE(panel.shown().size(), std::size_t{2});
    }

    void anEditDuringACheckIsCheckedAfterIt() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code);
        for (Key key = 1; key < 40; ++key) {
            Level level = *document.current().level;
            level.objects.append(crossed(key));
            document.commit({"draw-polygon", 1}, {std::make_shared<Level>(level), Selection()});
            QCoreApplication::processEvents();
        }
        QTRY_COMPARE(panel.problems(), lint(*document.current().level));
    }

    void eachLevelIsCheckedOnceForAllThatShowIt() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel one(check, code);
        ProblemsPanel two(check, code);
        QCOMPARE(check.checks(), 1);
        document.commit({"draw-polygon", 1}, {std::make_shared<Level>(tidyable()), Selection()});
        QTRY_COMPARE(one.warnings(), 2);
        QCOMPARE(check.checks(), 2);
        QCOMPARE(two.warnings(), 2);
        QCOMPARE(&two.problems(), &one.problems());
        QCOMPARE(two.marks(), one.marks());
        two.check();
        QCOMPARE(check.checks(), 2);
        const ProblemsPanel late(check, code);
        QCOMPARE(late.warnings(), 2);
        QCOMPARE(check.checks(), 2);
    }

    void aPreviewIsNotCheckedBeforeItEnds() {
        Document document;
        LevelCheck check(document);
        ProblemsPanel panel(check, code);
        Level level;
        level.objects.append(crossed(5));
        document.preview({std::make_shared<Level>(level), Selection()});
        panel.check();
        QCOMPARE(panel.errors(), 0);
    }
};

SPACETOW_TEST(ProblemsPanelTest)
#include "problems_panel_test.moc"
