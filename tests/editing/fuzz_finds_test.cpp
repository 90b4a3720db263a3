#include "tests/support/folders.h"
#include "tests/support/fuzz_targets.h"
#include "tests/support/test_main.h"

#include <QDirIterator>
#include <QFile>

using namespace spacetow;
using namespace spacetow::test;

class FuzzFindsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatMustHoldHoldsForAllThatWasFoundAndForWhatIsSound_data() {
        QTest::addColumn<QString>("path");
        for (const char* place : {"tests/fuzz/found", "tests/golden", "tests/replays", "levels"}) {
            QDirIterator files(sourceFolder() + '/' + place, {"*.json", "*.txt"}, QDir::Files,
                               QDirIterator::Subdirectories);
            while (files.hasNext()) {
                const QString path = files.next();
                QTest::newRow(qPrintable(path.mid(sourceFolder().size() + 1))) << path;
            }
        }
    }
    void whatMustHoldHoldsForAllThatWasFoundAndForWhatIsSound() {
        QFETCH(QString, path);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const std::string bytes = file.readAll().toStdString();
        // What does not hold ends the program.
        tryLevel(bytes);
        tryReplay(bytes);
        tryClipboard(bytes);
    }
};

SPACETOW_TEST(FuzzFindsTest)
#include "fuzz_finds_test.moc"
