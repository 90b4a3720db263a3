#include "editor/editing/run_changes.h"

#include "core/base/random.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "tests/support/every_edit.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using RunKeys = std::vector<Key>;

Object runBall(Key key) {
    return {key, "ball", BodyObject{.shapes = {Circle{{0, 0}, 0.5}}, .position = {double(key), 0}}, {}};
}

/// Two balls, and a run of them.
struct RunDesk {
    RunDesk() : document(start()), changes(document) {
        before = levelText(document.level());
        changes.begin();
    }
    static Level start() {
        Level level;
        level.objects.append(runBall(1));
        level.objects.append(runBall(2));
        return level;
    }
    void edit(Level level, LabelCode code = "change") {
        document.commit({code, 1}, {std::make_shared<const Level>(std::move(level)), {}});
    }
    void moveBall(Key key, double way) { edit(moved(document.level(), RunKeys{key}, {way, 0}), "move"); }
    void setGravity(double gravity) {
        Level level = document.level();
        level.gravity.y() = gravity;
        edit(level);
    }
    double placeOf(Key key) { return std::get<BodyObject>(document.level().objects.find(key)->data).position.x(); }
    std::string text() { return levelText(document.level()); }
    QStringList history() {
        QStringList codes;
        for (int i = 0; i < document.historySize(); ++i) {
            codes << QString::fromUtf8(document.label(i).code.text());
        }
        return codes;
    }

    Document document;
    RunChanges changes;
    std::string before;
};

} // namespace

class RunChangesTest : public QObject {
    Q_OBJECT

  private slots:
    void aRunWithoutEditsLeavesNothingBehind() {
        RunDesk desk;
        desk.changes.end();
        QVERIFY(!desk.changes.areWaiting());
        QCOMPARE(desk.document.historySize(), 0);
        desk.changes.keepAll(); // as when the window is closed
        desk.changes.keepTicked();
        QCOMPARE(desk.document.historySize(), 0);
    }

    void onStopTheLevelIsAsBeforeAndTheChangesWait() {
        RunDesk desk;
        desk.setGravity(-3);
        desk.moveBall(1, 4);
        desk.moveBall(1, 1);
        desk.changes.end();
        QVERIFY(desk.text() == desk.before);
        QVERIFY(!desk.document.isModified());
        QCOMPARE(desk.changes.changes().size(), std::size_t(2));
        QCOMPARE(desk.changes.ticked(), 2);
        QVERIFY(desk.changes.undecided() != nullptr);
    }

    void eachKeptChangeIsOneStepWithAName() {
        RunDesk desk;
        desk.setGravity(-3);
        desk.moveBall(1, 4);
        desk.edit(added(desk.document.level(), runBall(9)));
        const std::string all = desk.text();
        desk.changes.end();
        desk.changes.keepAll();
        QVERIFY(desk.text() == all);
        QVERIFY(!desk.changes.areWaiting());
        QCOMPARE(desk.history().mid(3), (QStringList{"end-run", "keep-level", "keep-moved", "keep-added"}));
        desk.document.undo();
        QVERIFY(desk.document.level().objects.find(9) == nullptr);
        QCOMPARE(desk.placeOf(1), 5.0);
        desk.document.undo();
        QCOMPARE(desk.placeOf(1), 1.0);
        QCOMPARE(desk.document.level().gravity.y(), -3.0);
        desk.document.undo();
        QVERIFY(desk.text() == desk.before);
    }

    void manyChangesAreKeptAsOneStep() {
        RunDesk desk;
        Level level = desk.document.level();
        for (Key key = 10; key < 10 + Key(RunChanges::mostSteps); ++key) {
            level.objects.append(runBall(key));
        }
        level.gravity.y() = -3;
        desk.edit(level);
        desk.changes.end();
        QCOMPARE(desk.changes.changes().size(), RunChanges::mostSteps + 1);
        desk.changes.keepAll();
        QVERIFY(desk.document.level() == level);
        QCOMPARE(desk.history().mid(1), (QStringList{"end-run", "keep-change"}));
        QCOMPARE(desk.document.undoLabel().count, int(RunChanges::mostSteps) + 1);
        desk.document.undo();
        QVERIFY(desk.text() == desk.before);
    }

    void whatIsNotTickedIsLeftOut() {
        RunDesk desk;
        desk.setGravity(-3);
        desk.moveBall(1, 4);
        desk.moveBall(2, 4);
        desk.changes.end();
        desk.changes.setTicked(1, false);
        desk.changes.keepTicked();
        QCOMPARE(desk.document.level().gravity.y(), -3.0);
        QCOMPARE(desk.placeOf(1), 1.0);
        QCOMPARE(desk.placeOf(2), 6.0);
    }

    void discardingLeavesTheFilesBytesAndCanBeUndone() {
        RunDesk desk;
        desk.setGravity(-3);
        desk.moveBall(1, 4);
        const std::string all = desk.text();
        desk.changes.end();
        desk.changes.discard();
        QVERIFY(desk.text() == desk.before);
        QVERIFY(!desk.document.isModified());
        QVERIFY(desk.changes.undecided() == nullptr);
        desk.document.undo();
        QVERIFY(desk.text() == all);
    }

    void redoingTheEndOfTheRunListsItsChangesAgainWithTheirTicks() {
        RunDesk desk;
        desk.setGravity(-3);
        desk.moveBall(1, 4);
        desk.moveBall(2, 4);
        desk.changes.end();
        desk.changes.setTicked(1, false);
        desk.document.undo();
        QVERIFY(!desk.changes.areWaiting() && desk.changes.isEndUndone() && desk.placeOf(2) == 6.0);
        desk.document.undo(); // of what was done in the run
        QVERIFY(desk.changes.isEndUndone() && desk.placeOf(1) == 5.0 && desk.placeOf(2) == 2.0);
        desk.document.redo();
        QVERIFY(!desk.changes.areWaiting());
        desk.document.redo();
        QVERIFY(desk.text() == desk.before && desk.changes.areWaiting() && !desk.changes.isEndUndone());
        QVERIFY(desk.changes.isTicked(0) && !desk.changes.isTicked(1) && desk.changes.isTicked(2));
        desk.moveBall(2, 1); // by hand
        desk.document.undo();
        desk.document.goTo(0); // as by the list of the history
        desk.document.goTo(desk.document.historySize() - 1);
        QCOMPARE(desk.changes.changes().size(), std::size_t(3));
        desk.changes.keepTicked();
        QVERIFY(!desk.changes.areWaiting() && !desk.changes.isEndUndone());
        QVERIFY(desk.placeOf(1) == 1.0 && desk.placeOf(2) == 6.0);
    }

    void redoAlsoListsWhatHadWaitedFromTheRunBefore() {
        RunDesk desk;
        desk.moveBall(1, 4);
        desk.changes.end();
        desk.changes.begin();
        desk.moveBall(2, 4);
        desk.changes.end();
        QCOMPARE(desk.changes.changes().size(), std::size_t(2));
        desk.document.undo();
        QCOMPARE(desk.changes.changes().size(), std::size_t(1)); // the other one is in the level
        desk.document.redo();
        desk.changes.keepAll();
        QVERIFY(desk.placeOf(1) == 5.0 && desk.placeOf(2) == 6.0);
    }

    void nothingIsListedAgainOnceItIsDiscardedOrSomethingElseWasDone() {
        for (const bool discarded : {true, false}) {
            RunDesk desk;
            desk.moveBall(1, 4);
            desk.changes.end();
            if (discarded) {
                desk.changes.discard();
            }
            desk.document.undo();
            QCOMPARE(desk.changes.isEndUndone(), !discarded);
            int told = 0;
            desk.changes.changed.connect([&told] { ++told; });
            discarded ? desk.document.redo() : desk.moveBall(2, 1);
            QVERIFY(!desk.changes.areWaiting() && !desk.changes.isEndUndone() && told == (discarded ? 0 : 1));
        }
    }

    void ticksGoTogetherWhereOneNeedsTheOther() {
        RunDesk desk;
        Level level = added(desk.document.level(), runBall(9));
        desk.edit(added(level, {10, "spring", ConnectorObject{.a = 9, .b = 1}, {}}));
        desk.changes.end();
        desk.changes.setTicked(0, false); // the ball
        QCOMPARE(desk.changes.ticked(), 0);
        desk.changes.setTicked(1, true); // the spring
        QCOMPARE(desk.changes.ticked(), 2);
        desk.changes.setTicked(1, false);
        QVERIFY(desk.changes.isTicked(0));
    }

    void whatIsNeededIsAStepBeforeWhatNeedsIt() {
        RunDesk desk;
        Level level = desk.document.level();
        level.objects.append({10, "spring", ConnectorObject{.a = 9, .b = 1}, {}}); // stands before its ball
        desk.edit(added(level, runBall(9)));
        desk.changes.end();
        desk.changes.keepAll();
        QCOMPARE(desk.history().mid(1), (QStringList{"end-run", "keep-added", "keep-added"}));
        desk.document.undo();
        QVERIFY(desk.document.level().objects.find(10) == nullptr);
        QVERIFY(desk.document.level().objects.find(9) != nullptr);
    }

    void theListFollowsWhatIsDoneByHandMeanwhile() {
        RunDesk desk;
        desk.setGravity(-3);
        desk.moveBall(1, 4);
        desk.changes.end();
        desk.changes.setTicked(1, false);
        desk.setGravity(-3); // the same by hand
        QCOMPARE(desk.changes.changes().size(), std::size_t(1));
        QCOMPARE(desk.changes.ticked(), 0); // as the user left it
        desk.moveBall(2, 1);
        desk.changes.keepAll();
        QCOMPARE(desk.placeOf(1), 5.0);
        QCOMPARE(desk.placeOf(2), 3.0);
    }

    void anotherRunAddsToWhatWaits() {
        RunDesk desk;
        desk.moveBall(1, 4);
        desk.changes.end();
        desk.changes.begin();
        QCOMPARE(desk.placeOf(1), 1.0);
        desk.moveBall(2, 1);
        desk.changes.end();
        QVERIFY(desk.text() == desk.before);
        QCOMPARE(desk.changes.changes().size(), std::size_t(2));
        desk.changes.keepAll();
        QCOMPARE(desk.placeOf(1), 5.0);
        QCOMPARE(desk.placeOf(2), 3.0);
    }

    void whatAnotherRunAddsHasNoTickWhereWhatItNeedsHasNone() {
        RunDesk desk;
        desk.changes.end();
        desk.edit(added(desk.document.level(), {10, "spring", ConnectorObject{.a = 1, .b = 2}, {}}));
        const auto erase = [&desk](const RunKeys& keys) {
            Level level = desk.document.level();
            level.objects.eraseIf([&keys](const Object& object) { return std::ranges::count(keys, object.key) > 0; });
            desk.edit(std::move(level));
        };
        desk.changes.begin();
        erase({10});
        desk.changes.end();
        desk.changes.setTicked(0, false); // the spring stays
        desk.changes.begin();
        erase({1, 10});
        desk.changes.end();
        QCOMPARE(desk.changes.changes().size(), std::size_t(2));
        QCOMPARE(desk.changes.ticked(), 0); // and so does the ball that it holds
    }

    void whatIsKeptWhileTheLevelRunsAgainTakesNothingFromThatRun() {
        RunDesk desk;
        desk.moveBall(1, 4);
        desk.setGravity(-3);
        desk.changes.end();
        desk.changes.begin();
        desk.moveBall(2, 1);
        desk.changes.keepAll(); // as when the window is closed
        QVERIFY(!desk.changes.areWaiting());
        QCOMPARE(desk.placeOf(1), 5.0);
        QCOMPARE(desk.placeOf(2), 3.0);
        QCOMPARE(desk.document.level().gravity.y(), -3.0);
        desk.document.undo(); // each is a step of its own
        QCOMPARE(desk.placeOf(1), 1.0);
        QCOMPARE(desk.placeOf(2), 3.0);
        desk.document.redo();
        desk.changes.end();
        QCOMPARE(desk.placeOf(1), 5.0); // has been kept
        QCOMPARE(desk.placeOf(2), 2.0); // waits
        QCOMPARE(desk.changes.changes().size(), std::size_t(1));
        desk.changes.keepAll();
        QCOMPARE(desk.placeOf(2), 3.0);
    }

    void theJournalHasWhatWaitsAndWhatIsEditedInTheRun() {
        RunDesk desk;
        QVERIFY(desk.changes.undecided() == nullptr);
        desk.moveBall(1, 4);
        desk.changes.end();
        desk.changes.begin();
        desk.moveBall(2, 1);
        const auto placeIn = [](const Level& level, Key key) {
            return std::get<BodyObject>(level.objects.find(key)->data).position.x();
        };
        const std::shared_ptr<const Level> undecided = desk.changes.undecided();
        QVERIFY(undecided != nullptr);
        QCOMPARE(placeIn(*undecided, 1), 5.0);
        QCOMPARE(placeIn(*undecided, 2), 3.0);
        QVERIFY(desk.changes.undecided() == undecided); // the same, so that it is written once
        desk.moveBall(2, 1);
        QCOMPARE(placeIn(*desk.changes.undecided(), 2), 4.0);
        desk.changes.discard();
        QVERIFY(desk.changes.undecided() == nullptr); // the document has it all
    }

    void anEditThatIsTakenBackAtOnceDoesNotEndTheRunsList() {
        RunDesk desk;
        const auto nudge = [&](double way) {
            auto level = std::make_shared<const Level>(moved(desk.document.level(), RunKeys{1}, {way, 0}));
            desk.document.commit({"move", 1}, {std::move(level), {}}, "nudge");
        };
        nudge(1);
        nudge(-1); // the entry of both is gone
        QCOMPARE(desk.document.historySize(), 0);
        desk.moveBall(2, 1);
        desk.changes.end();
        QVERIFY(desk.text() == desk.before);
        QCOMPARE(desk.changes.changes().size(), std::size_t(1));
    }

    void ofRunsInTwoWindowsTheLastToEndMakesTheList() {
        RunDesk desk;
        desk.moveBall(1, 4);
        desk.changes.begin();
        desk.moveBall(2, 1);
        desk.changes.end();
        QVERIFY(!desk.changes.areWaiting());
        QCOMPARE(desk.placeOf(1), 5.0);
        desk.changes.end();
        QVERIFY(desk.text() == desk.before);
        QCOMPARE(desk.changes.changes().size(), std::size_t(2));
        desk.changes.end(); // of none
        QCOMPARE(desk.changes.changes().size(), std::size_t(2));
    }

    void anotherLevelEndsTheMatter() {
        RunDesk desk;
        desk.moveBall(1, 4);
        desk.changes.end();
        desk.document.reset(populatedLevel());
        QVERIFY(!desk.changes.areWaiting());
        desk.changes.begin();
        desk.document.reset(RunDesk::start());
        desk.changes.end();
        QVERIFY(!desk.changes.areWaiting());
        QCOMPARE(desk.document.historySize(), 0);
    }

    void keptOrMadeByHandTheFileIsTheSame() {
        for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(fullOrQuick(300, usualOrThin(20, 5))); ++seed) {
            Document document(soundLevel(seed));
            RunChanges changes(document);
            const std::string before = levelText(document.level());
            changes.begin();
            Random random(seed);
            for (int edits = 0; edits < 5; ++edits) {
                EditTask task(random.next(), document.level());
                const auto& row = everyEdit()[random.below(static_cast<unsigned>(everyEdit().size()))];
                document.commit({"change", 1}, {std::make_shared<const Level>(row.run(task)), {}});
            }
            const std::string byHand = levelText(document.level());
            changes.end();
            QVERIFY2(levelText(document.level()) == before, seedText(seed));
            changes.keepAll();
            QVERIFY2(levelText(document.level()) == byHand, seedText(seed));
        }
    }
};

SPACETOW_TEST(RunChangesTest)
#include "run_changes_test.moc"
