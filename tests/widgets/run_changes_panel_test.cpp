#include "editor/window/run_changes_panel.h"

#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/window/state_folder.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDockWidget>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Two balls, of which a run has moved one, and given the level another gravity; ball 9 is new.
struct RanWindow : TestWindow {
    RanWindow() {
        document().reset(twoBallsAtOneSpot());
        before = levelText(level());
        changes().begin();
        Level edited = level();
        edited.gravity.y() = -3;
        edit(edited);
        edit(moved(level(), std::vector<Key>{1}, {4, 0}));
        edit(added(level(), {9, "new", BodyObject{.shapes = {Circle{}}, .position = {50, 0}}, {}}));
        after = levelText(level());
        changes().end();
        QApplication::processEvents();
    }
    void edit(Level made) { document().commit({"change", 1}, {std::make_shared<const Level>(std::move(made)), {}}); }
    RunChanges& changes() { return window->openLevel()->runChanges; }
    RunChangesPanel& panel() { return window->runChangesPanel(); }
    QDockWidget& dock() { return window->panels().dock(QStringLiteral("runChanges")); }
    QListView& list() { return *panel().findChild<QListView*>(); }
    QStringList texts() {
        QStringList all;
        for (int i = 0; i < list().model()->rowCount(); ++i) {
            all << list().model()->index(i, 0).data().toString();
        }
        return all;
    }
    QPushButton& button(const QString& words) {
        for (QPushButton* each : panel().findChildren<QPushButton*>()) {
            if (each->text().remove(QLatin1Char('&')) == words) {
                return *each;
            }
        }
        qFatal("no such button");
    }
    QString text() { return QString::fromStdString(levelText(level())); }

    std::string before, after;
};

} // namespace

class RunChangesPanelTest : public QObject {
    Q_OBJECT

  private slots:
    void whenTheRunEndsItsChangesAreListed() {
        RanWindow test;
        QVERIFY(test.dock().isVisible());
        QVERIFY(test.panel().isVisible());
        const QStringList texts = test.texts();
        QCOMPARE(texts.size(), 3);
        QVERIFY2(texts[0].startsWith("Level: ") && texts[0].contains(QString::fromUtf8("→")), qPrintable(texts[0]));
        QVERIFY2(texts[2].contains("new") && texts[2].endsWith("added"), qPrintable(texts[2]));
        QCOMPARE(cutOffTexts(test.panel()), QStringList());
        QVERIFY(test.text() == QString::fromStdString(test.before));
    }

    void keepAllMakesTheLevelThatRan() {
        RanWindow test;
        test.button("Keep All").click();
        QVERIFY(test.text() == QString::fromStdString(test.after));
        QVERIFY(!test.dock().isVisible());
        test.trigger(Act::Undo);
        QVERIFY(test.level().objects.find(9) == nullptr);
    }

    void discardAllLeavesTheLevelAndUndoBringsTheChangesBack() {
        RanWindow test;
        test.button("Discard All").click();
        QVERIFY(test.text() == QString::fromStdString(test.before));
        QVERIFY(!test.window->isWindowModified());
        QVERIFY(!test.dock().isVisible());
        test.trigger(Act::Undo);
        QVERIFY(test.text() == QString::fromStdString(test.after));
    }

    void undoOfTheEndOfTheRunIsToldWhereTheListWasAndRedoListsAgain() {
        RanWindow test;
        test.changes().setTicked(1, false);
        test.trigger(Act::Undo);
        QVERIFY(test.text() == QString::fromStdString(test.after));
        QVERIFY(test.dock().isVisible() && !test.button("Keep All").isVisible());
        const auto labels = test.panel().findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains("Redo"); }));
        QApplication::processEvents(); // the text is another, and is laid out a moment later
        QCOMPARE(cutOffTexts(test.panel()), QStringList());
        test.trigger(Act::Redo);
        QVERIFY(test.text() == QString::fromStdString(test.before));
        QVERIFY(test.button("Keep All").isVisible());
        QCOMPARE(test.texts().size(), 3);
        QCOMPARE(test.changes().ticked(), 2);
        test.trigger(Act::Undo);
        test.edit(moved(test.level(), std::vector<Key>{1}, {1, 0})); // nothing can be redone
        QVERIFY(!test.dock().isVisible());
    }

    void whatTheKeyboardUnticksIsNotKept() {
        RanWindow test;
        test.list().setFocus();
        test.list().setCurrentIndex(test.list().model()->index(1, 0));
        QTest::keyClick(&test.list(), Qt::Key_Space);
        QCOMPARE(test.changes().ticked(), 2);
        QTest::keyClick(&test.list(), Qt::Key_Up);
        QTest::keyClick(&test.list(), Qt::Key_Space);
        QTest::keyClick(&test.list(), Qt::Key_Space);
        QCOMPARE(test.changes().ticked(), 2);
        test.button("Keep Ticked").click();
        QCOMPARE(test.level().gravity.y(), -3.0);
        QVERIFY(test.level().objects.find(9) != nullptr);
        QCOMPARE(std::get<BodyObject>(test.level().objects.find(1)->data).position.x(), 0.0);
    }

    void theMouseTicksAndShowsTheObject() {
        RanWindow test;
        const QRect row = test.list().visualRect(test.list().model()->index(1, 0));
        QTest::mouseClick(test.list().viewport(), Qt::LeftButton, {}, row.center());
        QCOMPARE(test.document().selection().keys(), std::vector<Key>{1});
        QCOMPARE(test.changes().ticked(), 3);
        QTest::mouseClick(test.list().viewport(), Qt::LeftButton, {}, QPoint(row.left() + 10, row.center().y()));
        QCOMPARE(test.changes().ticked(), 2);
        const QRect third = test.list().visualRect(test.list().model()->index(2, 0));
        QTest::mouseClick(test.list().viewport(), Qt::LeftButton, {}, third.center());
        QVERIFY(test.canvas().view().visible().contains(Vec2(50, 0))); // which is not in the level
    }

    void whoClosesTheLevelIsAskedAboutThem() {
        RanWindow test;
        QVERIFY(!test.window->isWindowModified());
        QVERIFY(!test.window->close()); // the answer is Cancel
        QCOMPARE(test.asked, 1);
        QVERIFY(test.text() == QString::fromStdString(test.after));
    }

    void theJournalHoldsThemUntilTheyAreSettled() {
        RanWindow test;
        QVERIFY(test.window->recovery().flush());
        const auto journal = [] {
            for (const auto& entry : std::filesystem::directory_iterator(journalFolder())) {
                QFile file(QString::fromStdString(entry.path().string()));
                if (entry.path().extension() == ".journal" && file.open(QIODevice::ReadOnly)) {
                    return parsedJournal(file.readAll().toStdString());
                }
            }
            return std::optional<JournalEntry>();
        };
        QVERIFY(journal().has_value());
        QVERIFY(journal()->text == test.after);
        test.button("Discard All").click();
        QVERIFY(test.window->recovery().flush());
        QVERIFY(!journal().has_value());
    }
};

SPACETOW_TEST(RunChangesPanelTest)
#include "run_changes_panel_test.moc"
