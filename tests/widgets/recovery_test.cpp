#include "core/level/edits.h"
#include "core/level/file.h"
#include "editor/editing/backups.h"
#include "editor/window/quit_signals.h"
#include "editor/window/state_folder.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"
#include "tests/support/windows.h"

#include <QFile>
#include <QMenu>
#include <QSignalSpy>

#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>

using namespace spacetow;
using spacetow::test::cutOffTexts;
using spacetow::test::TestWindow;

namespace {

/// A window whose program has gone without a word, and another that was started then.
void killAndRestart(TestWindow& test) {
    QVERIFY(test.window->recovery().flush());
    test.unsaved = Unsaved::Discard;
    test.reopen();
    test.window->offerRecovery();
    QTRY_VERIFY(!test.window->recoveryBar().isLooking());
    QApplication::processEvents();
}

std::size_t entriesLeft() {
    return orphans(journalFolder()).size();
}

std::vector<std::filesystem::path> entriesOfAll() {
    std::vector<std::filesystem::path> journals;
    for (const auto& entry : std::filesystem::directory_iterator(journalFolder())) {
        if (entry.path().extension() == ".journal") {
            journals.push_back(entry.path());
        }
    }
    return journals;
}

/// A level file with one ball, opened.
QString openBall(TestWindow& test) {
    const QString path = test.file("ball.json");
    Level level = TestWindow::twoBallsAtOneSpot();
    level.objects.erase(1);
    writeLevel(path.toStdString(), level);
    test.window->open(path);
    return path;
}

} // namespace

class RecoveryTest : public QObject {
    Q_OBJECT

  private slots:
    void aLevelThatWasNeverSavedComesBack() {
        TestWindow test;
        test.drawWalls();
        const Level drawn = test.level();
        killAndRestart(test);
        RecoveryBar& bar = test.window->recoveryBar();
        QVERIFY(bar.isVisible());
        QCOMPARE(bar.rows().size(), std::size_t{1});
        RecoveryRow& row = *bar.rows().front();
        QVERIFY(row.details().contains("never saved") && row.details().contains("1 objects"));
        QVERIFY(!row.found().picture.isNull());
        row.compare.click(); // beside nothing, as there is no file
        QVERIFY(test.window->differences().isComparing());
        QCOMPARE(test.level().objects.size(), 0);
        row.restore.click();
        QVERIFY(test.level() == drawn);
        QVERIFY(test.window->isWindowModified());
        QVERIFY(test.window->files().path().isEmpty());
        QTRY_VERIFY(!bar.isVisible());
        QCOMPARE(entriesLeft(), std::size_t{0}); // it is this window's own now
        killAndRestart(test);
        QCOMPARE(test.window->recoveryBar().rows().size(), std::size_t{1});
    }

    void aLevelThatHasAFileStillKnowsIt() {
        TestWindow test;
        const QString path = openBall(test);
        const Level saved = test.level();
        test.drawWalls();
        const Level drawn = test.level();
        killAndRestart(test);
        RecoveryRow& row = *test.window->recoveryBar().rows().at(0);
        row.compare.click();
        QVERIFY2(row.explanation().contains("One-way wall"), qPrintable(row.explanation()));
        QCOMPARE(cutOffTexts(*test.window), QStringList());
        // And it is shown, beside the file.
        QCOMPARE(test.window->files().path(), path);
        QVERIFY(test.level() == saved);
        QVERIFY(test.window->differences().isComparing());
        row.restore.click();
        QVERIFY(test.level() == drawn && test.window->isWindowModified());
        QCOMPARE(test.window->files().path(), path);
        QVERIFY(!test.window->messageBar().isVisible()); // it is open nowhere else
        test.trigger(Act::Undo);
        QVERIFY(test.level() == saved && !test.window->isWindowModified());
        test.trigger(Act::Redo);
        test.trigger(Act::Save);
        QVERIFY(readLevel(path.toStdString()).value().level == drawn);
    }

    void whileAFileIsWrittenTheJournalHoldsWhatGoesIntoItAndTheBackupsWhatWasThere() {
        TestWindow test;
        const QString path = openBall(test);
        const Level before = test.level();
        // Another name of the same file, so that it is written in place.
        std::filesystem::create_hard_link(path.toStdString(), test.file("other.json").toStdString());
        const std::array keys{before.objects[0].key};
        test.document().commit({"change"}, {std::make_shared<const Level>(moved(before, keys, {1, 0})), {}});
        const Level drawn = test.level();
        QVERIFY(test.window->recovery().isBehind()); // no time has passed
        bool saving = false;
        test.window->files().saving.connect([&] {
            saving = true;
            QVERIFY(!test.window->recovery().isBehind());
        });
        QVERIFY(test.window->files().save());
        QVERIFY(saving && readLevel(path.toStdString()).value().level == drawn);
        // As if it had ended in the middle of the writing.
        test.document().undo();
        test.document().redo();
        QFile file(path);
        test.window->files().saving.connect([&] {
            QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{\"schema\": 2, \"na") > 0);
            file.close();
            std::filesystem::remove_all(test.file("copy").toStdString());
            std::filesystem::copy(journalFolder(), test.file("copy").toStdString());
        });
        test.document().commit({"change"}, {std::make_shared<const Level>(before), {}});
        QVERIFY(test.window->files().overwrite());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{\"schema\": 2, \"na") > 0);
        file.close();
        const std::vector<Orphan> left = orphans(test.file("copy").toStdString());
        QCOMPARE(left.size(), std::size_t{1});
        QVERIFY(parseLevel(left[0].entry.text).level == before);
    }

    void aFileThatWasChangedSinceIsNotOverwrittenUnasked() {
        TestWindow test;
        const QString path = openBall(test);
        test.drawWalls();
        QVERIFY(test.window->recovery().flush());
        Level theirs;
        theirs.name = "theirs";
        QVERIFY(!writeLevel(path.toStdString(), theirs));
        killAndRestart(test);
        test.window->recoveryBar().rows().at(0)->restore.click();
        QVERIFY(test.window->isWindowModified());
        test.trigger(Act::Save);
        QVERIFY(test.window->diskBar().isVisible());
        QVERIFY(readLevel(path.toStdString()).value().level == theirs);
    }

    void discardedWorkIsOfferedNoMoreButCanBeBroughtBack() {
        TestWindow test;
        test.drawWalls();
        killAndRestart(test);
        RecoveryRow& row = *test.window->recoveryBar().rows().at(0);
        row.discard.click();
        QCOMPARE(entriesLeft(), std::size_t{0});
        QVERIFY(row.undo.isVisible() && !row.restore.isVisible());
        row.undo.click();
        QCOMPARE(entriesLeft(), std::size_t{1});
        row.discard.click();
        killAndRestart(test);
        QVERIFY(!test.window->recoveryBar().isVisible());
    }

    void aCleanCloseLeavesNothing() {
        TestWindow test;
        test.drawWalls();
        QVERIFY(test.window->recovery().flush());
        test.unsaved = Unsaved::Discard;
        QVERIFY(test.window->close());
        test.window.reset();
        QCOMPARE(entriesLeft(), std::size_t{0});
        QVERIFY(std::filesystem::is_empty(journalFolder()));
    }

    void whatIsSavedOrUndoneIsNotKept() {
        TestWindow test;
        openBall(test);
        const auto written = [] {
            for (const auto& entry : std::filesystem::directory_iterator(journalFolder())) {
                if (entry.path().extension() == ".journal") {
                    return true;
                }
            }
            return false;
        };
        test.drawWalls();
        QTRY_VERIFY(!test.window->recovery().isBehind());
        QVERIFY(written());
        test.trigger(Act::Undo);
        QTRY_VERIFY(!test.window->recovery().isBehind());
        QVERIFY(!written());
        test.trigger(Act::Redo);
        test.trigger(Act::Save);
        QTRY_VERIFY(!test.window->recovery().isBehind());
        QVERIFY(!written());
    }

    void theEndOfTheSessionAsksNothingAndLosesNothing() {
        TestWindow test;
        test.drawWalls();
        test.trigger(ToolId::Edge);
        test.click(-1, 1);
        test.click(1, 1); // half drawn
        MainWindow::keepForNextTime();
        QCOMPARE(test.asked, 0);
        const Level kept = test.level();
        QCOMPARE(kept.objects.size(), 2);
        test.reopen();
        test.window->offerRecovery();
        QTRY_VERIFY(test.window->recoveryBar().isVisible());
        test.window->recoveryBar().rows().at(0)->restore.click();
        QVERIFY(test.level() == kept);
    }

    void signalsBecomeEvents() {
        const QuitSignals ending;
        QSignalSpy spy(&ending, &QuitSignals::received);
        std::raise(SIGTERM);
        QTRY_COMPARE(spy.size(), 1);
        std::raise(SIGHUP);
        QTRY_COMPARE(spy.size(), 2);
    }

    void aJournalThatCannotBeWrittenIsToldOf() {
        TestWindow test;
        std::filesystem::remove_all(journalFolder());
        test.drawWalls();
        QVERIFY(!test.window->recovery().flush());
        QVERIFY(test.window->messageBar().isVisible());
        QVERIFY(test.window->messageBar().text().contains("lost"));
    }

    void aJournalIsWrittenAsSoonAsItCanBeAgain() {
        TestWindow test;
        test.drawWalls();
        QVERIFY(test.window->recovery().flush());
        QCOMPARE(entriesOfAll().size(), std::size_t{1});
        const std::filesystem::path journal = entriesOfAll().front();
        // Something is in the way, as a full disk is, and then no more.
        const std::filesystem::path obstacle = journal.string() + ".new";
        std::filesystem::create_directory(obstacle);
        test.drawWalls();
        QVERIFY(!test.window->recovery().flush());
        std::filesystem::remove(obstacle);
        QVERIFY(test.window->recovery().isBehind());
        QVERIFY(test.window->recovery().flush());
        QVERIFY(!test.window->recovery().isBehind());
        std::ifstream file(journal, std::ios::binary);
        const std::string text(std::istreambuf_iterator<char>(file), {});
        QVERIFY(*parseLevel(parsedJournal(text)->text).level == test.level());
    }

    void askingWhenThereIsNothingSaysSo() {
        TestWindow test;
        test.trigger(Act::Recover);
        QTRY_VERIFY(test.window->messageBar().isVisible());
        QVERIFY(!test.window->recoveryBar().isVisible());
    }

    void aSecondWindowOfAFileIsTold() {
        TestWindow test;
        const QString path = openBall(test);
        QVERIFY(!test.window->messageBar().isVisible());
        MainWindow second;
        QVERIFY(second.open(path));
        QVERIFY(second.messageBar().text().contains("open in another window"));
        second.recovery().close();
    }

    void workIsRestoredBesideWorkThatIsNotSaved() {
        test::TestApplication test;
        test.start();
        Level mine;
        mine.name = "mine";
        test.window(0).startNew();
        test.window(0).document().commit({"change-level", 1}, {std::make_shared<const Level>(mine), {}});
        {
            const Result<JournalSlot> slot = JournalSlot::made(journalFolder());
            QVERIFY(!slot.value().write({"", "found", {}, 1, levelText(TestWindow::twoBallsAtOneSpot())}));
        }
        test.window(0).offerRecovery();
        QTRY_COMPARE(test.window(0).recoveryBar().rows().size(), std::size_t{1});
        test.window(0).recoveryBar().rows().front()->restore.click();
        QCOMPARE(test.count(), std::size_t{2});
        QVERIFY(test.window(0).document().level() == mine);
        QVERIFY(test.window(1).document().level() == TestWindow::twoBallsAtOneSpot());
        QVERIFY(test.window(1).isWindowModified());
    }

    void aFormerVersionIsOpenedAsOneEdit() {
        TestWindow test;
        openBall(test);
        const Level first = test.level();
        test.drawWalls();
        test.trigger(Act::Save);
        const Level second = test.level();
        test.key(Qt::Key_Escape);
        QMenu* backups = nullptr;
        for (QMenu* menu : test.window->findChildren<QMenu*>()) {
            backups = menu->title() == "&Backups" ? menu : backups;
        }
        QVERIFY(backups != nullptr);
        Q_EMIT backups->aboutToShow();
        QCOMPARE(backups->actions().size(), 1);
        backups->actions().front()->trigger();
        QVERIFY(test.level() == first && test.window->isWindowModified());
        test.trigger(Act::Undo);
        QVERIFY(test.level() == second && !test.window->isWindowModified());
    }

    void whereNoBackupCanBeMadeItIsSavedAndSaysSoOnce() {
        TestWindow test;
        const QString path = openBall(test);
        std::filesystem::create_directories(stateFolder());
        std::filesystem::remove_all(backupFolder());
        QFile inTheWay(QString::fromStdString(backupFolder().string()));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        inTheWay.close();
        const MessageBar& bar = test.window->messageBar();
        const auto saveAnother = [&test] {
            test.drawWalls();
            test.trigger(Act::Save);
        };
        saveAnother();
        QVERIFY(!test.document().isModified());
        QVERIFY2(bar.isVisible() && bar.text().contains("backup"), qPrintable(bar.text()));
        QVERIFY(bar.tone() == MessageBar::Tone::Warning);
        saveAnother();
        QVERIFY(!bar.isVisible());
        QVERIFY(inTheWay.remove());
        saveAnother();
        QVERIFY(!bar.isVisible());
        QCOMPARE(backupsOf(backupFolder(), path.toStdString()).size(), std::size_t{1});
        QVERIFY(QFile::rename(QString::fromStdString(backupFolder().string()), test.file("elsewhere")));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        inTheWay.close();
        saveAnother();
        QVERIFY(bar.isVisible());
    }

    void aFileThatIsBrokenOffersItsNewestBackup() {
        TestWindow test;
        const QString path = openBall(test);
        const Level first = test.level();
        test.drawWalls();
        test.trigger(Act::Save);
        test.trigger(Act::New);
        QFile out(path);
        QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
        out.write("{ nonsense");
        out.close();
        QVERIFY(!test.window->open(path));
        QCOMPARE(test.window->messageBar().buttons().size(), std::size_t{1});
        { // one that is broken itself is passed over
            const std::filesystem::path newest = backupsOf(backupFolder(), path.toStdString()).front().file;
            const std::string later = std::to_string(std::stoll(newest.stem().string()) + 1) + ".json";
            std::ofstream(newest.parent_path() / later) << "{";
        }
        test.window->messageBar().buttons().front()->click();
        QVERIFY(test.level() == first && test.window->isWindowModified());
        QCOMPARE(test.window->files().path(), path);
        test.trigger(Act::Save);
        QVERIFY(readLevel(path.toStdString()).value().level == first);
    }

    void nothingOfTheBarIsCutOffInASmallWindow() {
        TestWindow test;
        openBall(test);
        test.drawWalls();
        killAndRestart(test);
        test.window->recoveryBar().rows().at(0)->compare.click();
        for (const QSize size : {QSize(1024, 640), QSize(800, 600)}) {
            test.window->resize(size);
            QApplication::processEvents();
            QCOMPARE(cutOffTexts(test.window->recoveryBar()), QStringList());
        }
    }
};

SPACETOW_TEST(RecoveryTest)
#include "recovery_test.moc"
