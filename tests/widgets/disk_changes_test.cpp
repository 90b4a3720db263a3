#include "core/base/disk_calls.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "tests/support/disk_scene.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <atomic>
#include <cerrno>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

Level ballAt(double x) {
    Level level = TestWindow::twoBallsAtOneSpot();
    level.objects.erase(1);
    return moved(std::move(level), std::vector<Key>{1}, Vec2(x, 0));
}

/// The file is opened, and then another program writes to it.
struct OpenFile {
    OpenFile() : path(test.file("level.json")) {
        write(0);
        test.window->open(path);
        test.window->resize(1280, 800);
    }
    void write(double x) const { writeLevel(path.toStdString(), ballAt(x)); }
    std::optional<Level> onDisk() const { return readLevel(path.toStdString()).value().level; }
    MessageBar& bar() { return test.window->diskBar(); }
    void press(int button) { bar().buttons().at(static_cast<std::size_t>(button))->click(); }

    TestWindow test;
    QString path;
};

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class DiskChangesTest : public QObject {
    Q_OBJECT

  private slots:
    void aCleanLevelFollowsItsFileAndUndoTakesThatBack() {
        OpenFile file;
        file.test.trigger(Act::ZoomIn);
        const double scale = file.test.canvas().view().scale;
        file.write(3);
        QTRY_VERIFY(file.test.level() == ballAt(3));
        QVERIFY(!file.test.window->isWindowModified());
        QCOMPARE(file.test.canvas().view().scale, scale);
        QVERIFY(file.bar().isVisible() && file.bar().buttons().empty());
        file.test.trigger(Act::Undo);
        QVERIFY(file.test.level() == ballAt(0));
        QVERIFY(file.test.window->isWindowModified());
        file.test.trigger(Act::Redo);
        QVERIFY(!file.test.window->isWindowModified());
    }

    void aFileThatIsWrittenInPlaceIsFollowedToo() {
        OpenFile file;
        QFile out(file.path);
        QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
        out.write(levelText(ballAt(4)).c_str());
        out.close();
        QTRY_VERIFY(file.test.level() == ballAt(4));
    }

    void savingHereIsNoChangeOfOthers() {
        OpenFile file;
        file.test.drawWalls();
        file.test.trigger(Act::Save);
        const int position = file.test.document().position();
        file.test.window->diskChanges().look();
        QTRY_VERIFY(!file.test.window->diskChanges().isLooking());
        QVERIFY(!file.bar().isVisible());
        QCOMPARE(file.test.document().position(), position);
    }

    void changesOnBothSidesAreAskedAbout_data() {
        QTest::addColumn<int>("button");
        QTest::newRow("reload") << 0;
        QTest::newRow("keep mine") << 1;
        QTest::newRow("compare, then reload") << 2;
    }
    void changesOnBothSidesAreAskedAbout() {
        QFETCH(int, button);
        OpenFile file;
        file.test.drawWalls();
        const Level mine = file.test.level();
        file.write(3);
        QTRY_VERIFY(file.bar().isVisible());
        QVERIFY(file.test.level() == mine);
        file.press(button);
        if (button == 1) {
            QVERIFY(!file.bar().isVisible() && file.test.window->isWindowModified());
            file.test.trigger(Act::Save);
            QVERIFY(file.onDisk() == mine);
            return;
        }
        if (button == 2) {
            DifferencePanel& panel = file.test.window->differences();
            panel.finish();
            QCOMPARE(panel.lines().size(), std::size_t{2}); // the ball has moved, the wall is new
            QVERIFY(file.bar().isVisible());
            file.press(0);
        }
        QVERIFY(file.test.level() == ballAt(3) && !file.test.window->isWindowModified());
        QVERIFY(!file.bar().isVisible() && !file.test.window->differences().isComparing());
        file.test.trigger(Act::Undo);
        QVERIFY(file.test.level() == mine);
    }

    void savingAsksBeforeItOverwritesAnothersChange() {
        OpenFile file;
        file.test.drawWalls();
        const Level mine = file.test.level();
        file.write(3);
        file.test.trigger(Act::Save); // before the watcher has said anything
        QVERIFY(file.onDisk() == ballAt(3));
        QVERIFY(file.bar().isVisible() && file.bar().text().contains("Not saved"));
        QVERIFY(file.test.window->isWindowModified());
        file.press(0);
        QVERIFY(file.onDisk() == mine);
        QVERIFY(!file.bar().isVisible() && !file.test.window->isWindowModified());
    }

    void whatCannotBeReadIsNotOverwrittenUnasked() {
        OpenFile file;
        file.test.drawWalls();
        const auto size = static_cast<qint64>(maxLevelBytes) + 1;
        QVERIFY(QFile::resize(file.path, size));
        file.test.trigger(Act::Save);
        QCOMPARE(QFileInfo(file.path).size(), size);
        QVERIFY(file.bar().isVisible() && file.bar().text().contains("Not saved"));
    }

    void whatCannotBeReadIsNotTakenForMissing() {
        OpenFile file;
        QVERIFY(QFile::resize(file.path, static_cast<qint64>(maxLevelBytes) + 1));
        file.test.window->openLevel()->disk.look();
        QTRY_VERIFY(file.bar().isVisible());
        QVERIFY2(file.bar().text().contains("cannot be read any more"), qPrintable(file.bar().text()));
    }

    void whatAnotherWritesWhileItIsBeingSavedIsNotOverwrittenLater() {
        OpenFile file;
        file.test.drawWalls();
        static QString path;
        path = file.path;
        spacetow::disk::setFault([](std::string_view call) {
            static int flushed = 0;
            if (call == "fsync" && ++flushed == 2) { // the folder: the file is in its place
                QFile other(path);
                if (other.open(QIODevice::WriteOnly | QIODevice::Truncate)) {
                    other.write(levelText(ballAt(7)).c_str());
                }
            }
            return 0;
        });
        file.test.trigger(Act::Save);
        spacetow::disk::setFault(nullptr);
        QVERIFY(file.onDisk() == ballAt(7));
        file.test.drawWalls();
        file.test.trigger(Act::Save);
        QVERIFY(file.onDisk() == ballAt(7));
        QVERIFY(file.bar().isVisible() && file.bar().text().contains("Not saved"));
    }

    void closingWithSaveStaysWhenThatWouldOverwriteAnothersChange() {
        OpenFile file;
        file.test.drawWalls();
        file.write(3);
        file.test.unsaved = Unsaved::Save;
        QVERIFY(!file.test.window->close());
        QVERIFY(file.onDisk() == ballAt(3) && file.bar().isVisible());
    }

    void aFileThatIsTouchedButTheSameIsNoChange() {
        OpenFile file;
        file.test.drawWalls();
        const Level mine = file.test.level();
        file.write(0);
        file.test.trigger(Act::Save);
        QVERIFY(file.onDisk() == mine && !file.bar().isVisible());
    }

    void aDeletedFileMakesTheLevelCountAsModified() {
        OpenFile file;
        QFile::remove(file.path);
        QTRY_VERIFY(file.bar().isVisible());
        QVERIFY(file.bar().text().contains("no longer there"));
        QVERIFY(file.test.window->isWindowModified());
        QTRY_VERIFY(!file.test.window->recovery().isBehind());
        file.press(0);
        QVERIFY(file.onDisk() == ballAt(0));
        QVERIFY(!file.bar().isVisible() && !file.test.window->isWindowModified());
    }

    void aFileThatComesBackIsFollowedAgain() {
        OpenFile file;
        QFile::rename(file.path, file.path + ".moved");
        QTRY_VERIFY(file.bar().isVisible());
        QFile::rename(file.path + ".moved", file.path);
        QTRY_VERIFY(!file.bar().isVisible());
        QVERIFY(!file.test.window->isWindowModified());
        QFile::remove(file.path);
        QTRY_VERIFY(file.bar().isVisible());
        file.write(5);
        QTRY_VERIFY(file.test.level() == ballAt(5));
        QVERIFY(!file.test.window->isWindowModified());
    }

    void aFileThatCannotBeReadAnyMoreLeavesTheLevelAlone() {
        OpenFile file;
        QFile out(file.path);
        QVERIFY(out.open(QIODevice::WriteOnly | QIODevice::Truncate));
        out.write("{ nonsense");
        out.close();
        QTRY_VERIFY(file.bar().isVisible());
        QVERIFY(file.test.level() == ballAt(0) && file.test.window->isWindowModified());
        file.press(0);
        file.test.trigger(Act::Save);
        QVERIFY(file.onDisk() == ballAt(0));
    }

    void nothingIsSwappedDuringADrag() {
        OpenFile file;
        const QPoint from = file.test.at(0.5, 0);
        QTest::mousePress(&file.test.canvas(), Qt::LeftButton, {}, from);
        QTest::mouseMove(&file.test.canvas(), from + QPoint(40, 0));
        QVERIFY(file.test.document().hasPreview());
        file.write(3);
        file.test.window->diskChanges().look();
        QTRY_VERIFY(!file.test.window->diskChanges().isLooking());
        QVERIFY(file.test.document().hasPreview());
        QTest::keyClick(&file.test.canvas(), Qt::Key_Escape);
        QTest::mouseRelease(&file.test.canvas(), Qt::LeftButton, {}, from);
        QTRY_VERIFY(file.test.level() == ballAt(3));
    }

    void ctrlRReadsTheFileAgain() {
        OpenFile file;
        file.test.drawWalls();
        const Level mine = file.test.level();
        QCOMPARE(file.test.window->actions()[Act::Reload].shortcut(), QKeySequence(QStringLiteral("Ctrl+R")));
        file.test.trigger(Act::Reload);
        QVERIFY(file.test.level() == ballAt(0) && !file.test.window->isWindowModified());
        file.test.trigger(Act::Undo);
        QVERIFY(file.test.level() == mine);
    }

    void aFileThatIsBrokenOffAndCannotBePutBackIsToldWithWhereItsTextIs_data() {
        QTest::addColumn<bool>("hasCopy");
        QTest::newRow("with a copy beside") << true;
        QTest::newRow("in a folder of others") << false;
    }
    void aFileThatIsBrokenOffAndCannotBePutBackIsToldWithWhereItsTextIs() {
        QFETCH(bool, hasCopy);
        OpenFile file;
        // Another name of the file lets it be written in place only, as does a folder in which none can be made.
        QVERIFY(!hasCopy || ::link(qPrintable(file.path), qPrintable(file.path + ".link")) == 0);
        file.test.drawWalls();
        static std::atomic<bool> failsToMake;
        static std::atomic<int> soundWrites; // before they fail: what is written first are the journal and a backup
        QString words;
        for (int sound = 0; sound < 30 && !words.contains("written in part only"); ++sound) {
            failsToMake = !hasCopy;
            soundWrites = sound;
            disk::setFault([](std::string_view call) {
                return call == "create" && failsToMake ? EACCES : call == "write" && --soundWrites < 0 ? EIO : 0;
            });
            file.test.window->files().overwrite();
            disk::setFault(nullptr);
            words = file.test.window->messageBar().text();
        }
        QVERIFY2(words.startsWith("The file “" + file.path + "” was written in part only: "), qPrintable(words));
        QVERIFY2(words.contains(hasCopy ? "All that it was to hold is in the file “" : "What was there before is lost"),
                 qPrintable(words));
        QVERIFY(file.test.window->isWindowModified());
    }

    void whatKeepsAFileFromBeingSavedIsToldWithAWayOut_data() {
        QTest::addColumn<int>("fault"); // 0: the folder is gone
        QTest::addColumn<QByteArray>("call");
        QTest::newRow("folder gone") << 0 << QByteArray();
        QTest::newRow("folder protected") << EACCES << QByteArray("create");
        QTest::newRow("disk read-only") << EROFS << QByteArray("create");
        QTest::newRow("disk full") << ENOSPC << QByteArray("write");
    }
    void whatKeepsAFileFromBeingSavedIsToldWithAWayOut() {
        QFETCH(int, fault);
        QFETCH(QByteArray, call);
        OpenFile file;
        const QString folder = file.test.file("folder");
        QDir().mkpath(folder);
        file.test.toSave = folder + "/level.json";
        file.test.trigger(Act::SaveAs);
        file.test.drawWalls();
        const Level mine = file.test.level();
        if (call == "create") {
            QVERIFY(QFile::remove(file.test.toSave)); // one that is there would be written in place
        }
        const QByteArray before = bytesOf(file.test.toSave);
        if (fault == 0) {
            QVERIFY(QDir(folder).removeRecursively());
            file.test.trigger(Act::Save);
        } else {
            const spacetow::test::WithFault failing(0, fault, std::string_view(call.data(), call.size()));
            file.test.trigger(Act::Save);
        }
        MessageBar& bar = file.test.window->messageBar();
        QVERIFY(bar.isVisible() && bar.text().contains("Nothing is lost"));
        QVERIFY(fault == 0 || bytesOf(file.test.toSave) == before);
        QVERIFY(file.test.level() == mine && file.test.window->isWindowModified());
        QVERIFY(file.test.window->recovery().flush()); // the journal goes on
        file.test.toSave = file.test.file("elsewhere.json");
        bar.buttons().at(0)->click();
        QCOMPARE(file.test.window->files().path(), file.test.toSave);
        QVERIFY(!file.test.window->isWindowModified() && !bar.isVisible());
    }

    void buttonsOfABarAreNotCutOffInANarrowWindow() {
        OpenFile file;
        file.test.drawWalls();
        file.write(3);
        QTRY_VERIFY(file.bar().isVisible());
        file.press(2);
        for (const QSize size : {QSize(1024, 640), QSize(800, 600)}) {
            file.test.window->resize(size);
            QApplication::processEvents();
            QCOMPARE(spacetow::test::cutOffTexts(file.bar()), QStringList());
        }
    }
};

SPACETOW_TEST(DiskChangesTest)
#include "disk_changes_test.moc"
