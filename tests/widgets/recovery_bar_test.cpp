#include "editor/window/recovery_bar.h"

#include "core/level/file.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

using namespace spacetow;

class RecoveryBarTest : public QObject {
    Q_OBJECT

  private slots:
    void whoOnlyLooksTakesNothingFromTheBar() {
        const QTemporaryDir home;
        const std::filesystem::path folder = home.path().toStdString();
        std::string id;
        {
            const Result<JournalSlot> left = JournalSlot::made(folder);
            id = left.value().id();
            QVERIFY(!left.value().write({"", "work", {}, 1, levelText(Level())}));
        }
        int restored = 0;
        RecoveryBar bar(folder, [&restored](const JournalEntry&) { return ++restored > 0; });
        const auto settle = [&bar] {
            QTRY_VERIFY(!bar.isLooking());
            QApplication::processEvents();
        };
        bar.look(false);
        settle();
        QCOMPARE(bar.rows().size(), std::size_t{1});
        const int looking = ::open((folder / (id + ".lock")).c_str(), O_RDONLY | O_CLOEXEC);
        QVERIFY(looking >= 0 && ::flock(looking, LOCK_SH) == 0); // as another program does when it starts
        for (const auto button : {&RecoveryRow::restore, &RecoveryRow::discard}) {
            (bar.rows().front()->*button).click();
            settle();
            QCOMPARE(bar.rows().size(), std::size_t{1});
            QCOMPARE(restored, 0);
        }
        ::close(looking);
        bar.rows().front()->restore.click();
        QCOMPARE(restored, 1);
        QVERIFY(orphans(folder).empty());
    }
};

SPACETOW_TEST(RecoveryBarTest)
#include "recovery_bar_test.moc"
