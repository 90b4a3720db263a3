#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>

using namespace spacetow::test;

class SpacetowTest : public QObject {
    Q_OBJECT

  private slots:
    void helpAndVersionNeedNoDisplay_data() {
        QTest::addColumn<QString>("option");
        QTest::addColumn<QString>("words");
        QTest::newRow("--help") << "--help"
                                << "Usage: ";
        QTest::newRow("-h") << "-h"
                            << "[LEVEL";
        QTest::newRow("--version") << "--version"
                                   << "spacetow-studio ";
        QTest::newRow("-v") << "-v"
                            << "spacetow-studio ";
    }
    void helpAndVersionNeedNoDisplay() {
        QFETCH(QString, option);
        QFETCH(QString, words);
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
            environment.remove(name);
        }
        environment.insert("QT_QPA_PLATFORM", "xcb"); // which would end without a display
        environment.insert("LC_ALL", "C");
        process.setProcessEnvironment(environment);
        process.start(binaryFolder() + "/bin/spacetow", {option});
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 0);
        const QString out = QString::fromUtf8(process.readAllStandardOutput());
        QVERIFY2(out.contains(words), qPrintable(out));
    }

    void itEndsOrderlyWhenItIsTold() {
        const QTemporaryDir home;
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedChannels);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        for (const char* name : {"HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME"}) {
            environment.insert(name, home.path());
        }
        process.setProcessEnvironment(environment);
        process.start(binaryFolder() + "/bin/spacetow", QStringList());
        const QDir journal(home.filePath("spacetow-studio/recovery"));
        const auto isUp = [&journal] { return !journal.entryList({"*.lock"}, QDir::Files).isEmpty(); };
        QTRY_VERIFY_WITH_TIMEOUT(isUp(), 60000);
        process.terminate(); // SIGTERM
        QVERIFY(process.waitForFinished(60000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(!isUp());
    }
};

SPACETOW_TEST(SpacetowTest)
#include "spacetow_test.moc"
