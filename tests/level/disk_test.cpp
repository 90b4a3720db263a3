#include "core/level/file.h"

#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

using namespace spacetow;
using namespace spacetow::test;

namespace {

namespace fs = std::filesystem;

QByteArray contentsOnDisk(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(unreadable)");
}

fs::path native(const QString& path) {
    return path.toStdString();
}

mode_t modeOf(const QString& path) {
    struct stat info {};
    return ::stat(qPrintable(path), &info) == 0 ? info.st_mode & 07777u : 0;
}

/// Lets no file of this process grow beyond `bytes`: writing then fails as on a full disk.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        m_handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_handler);
    }

  private:
    rlimit m_before{};
    void (*m_handler)(int) = SIG_DFL;
};

} // namespace

class DiskTest : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        m_folder.emplace();
        QVERIFY(m_folder->isValid());
    }

    void aLevelComesBackFromDisk() {
        const QString path = m_folder->filePath("a level.json");
        const Level level = populatedLevel();
        QCOMPARE(writeLevel(native(path), level), std::nullopt);
        const Result<LevelFile> read = readLevel(native(path));
        QVERIFY(bool(read));
        QVERIFY(*read.value().level == level);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"a level.json"});
    }

    void whatCannotBeReadSaysWhy_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("code");
        QTest::newRow("no such file") << "missing.json"
                                      << "cannot-read";
        QTest::newRow("a folder") << "."
                                  << "cannot-read";
        QTest::newRow("below a file") << "file/level.json"
                                      << "cannot-read";
        QTest::newRow("a pipe without a writer") << "pipe"
                                                 << "cannot-read";
        QTest::newRow("a file that is too large") << "large"
                                                  << "file-too-large";
    }
    void whatCannotBeReadSaysWhy() {
        QFETCH(QString, name);
        QFETCH(QString, code);
        QFile file(m_folder->filePath("file"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(::mkfifo(qPrintable(m_folder->filePath("pipe")), 0600), 0);
        QFile large(m_folder->filePath("large"));
        QVERIFY(large.open(QIODevice::WriteOnly) && large.resize(static_cast<qint64>(maxLevelBytes) + 1));
        const fs::path path = native(m_folder->filePath(name));
        const Result<LevelFile> read = readLevel(path);
        QVERIFY(!read);
        QCOMPARE(QString::fromUtf8(read.error().code.text()), code);
        QCOMPARE(read.error().arguments.at(0), path.string());
    }

    void anEmptyFileIsNoLevel() {
        const QString path = m_folder->filePath("empty.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        const Result<LevelFile> read = readLevel(native(path));
        QVERIFY(bool(read) && !read.value().level);
        QCOMPARE(read.value().problems.at(0).code.text(), std::string("empty-file"));
    }

    void whatCouldNotBeReadAgainIsNotSaved_data() {
        QTest::addColumn<QString>("code");
        for (const char* code :
             {"text-too-large", "too-many-vertices", "bad-tag-name", "duplicate-tag", "not-finite"}) {
            QTest::newRow(code) << code;
        }
    }
    void whatCouldNotBeReadAgainIsNotSaved() {
        QFETCH(QString, code);
        Level level;
        if (code == "text-too-large") {
            level.description.assign(maxLevelBytes, 'x');
        } else if (code == "too-many-vertices") {
            BodyObject body;
            body.shapes = {EdgeChain{std::vector<Vec2>(500'000, Vec2(0, 0))},
                           LineChain{std::vector<Vec2>(500'001, Vec2(0, 0))}};
            level.objects.append({1, {}, body, {}});
        } else if (code == "bad-tag-name") {
            level.tags.set(7, {"#3", 0});
        } else if (code == "duplicate-tag") {
            level.tags.set(7, level.tags[wallTag]);
        } else {
            level.gravity.x() = NAN;
        }
        const QString path = m_folder->filePath("level.json");
        const std::optional<Error> error = writeLevel(native(path), level);
        QVERIFY(error);
        QCOMPARE(QString::fromUtf8(error->code.text()), code);
        QVERIFY(!QFile::exists(path));
    }

    void savingKeepsTheModeOfTheFile() {
        const QString path = m_folder->filePath("level.json");
        QCOMPARE(writeLevel(native(path), Level()), std::nullopt);
        QCOMPARE(::chmod(qPrintable(path), 0640), 0);
        QCOMPARE(writeLevel(native(path), populatedLevel()), std::nullopt);
        QCOMPARE(modeOf(path), mode_t{0640});
    }

    void savingFollowsLinks() {
        const QString path = m_folder->filePath("level.json");
        const QString first = m_folder->filePath("first");
        const QString second = m_folder->filePath("second");
        QVERIFY(QFile::link("level.json", first) && QFile::link(first, second));
        // The file at the end of the links need not exist.
        QCOMPARE(writeLevel(native(second), Level()), std::nullopt);
        QCOMPARE(writeLevel(native(second), populatedLevel()), std::nullopt);
        QVERIFY(QFileInfo(first).isSymLink() && QFileInfo(second).isSymLink() && !QFileInfo(path).isSymLink());
        QCOMPARE(contentsOnDisk(path), QByteArray::fromStdString(levelText(populatedLevel())));
    }

    void whatCannotBeWrittenLeavesEverythingAsItWas_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("code");
        QTest::newRow("no such folder") << "nowhere/level.json"
                                        << "folder-missing";
        QTest::newRow("a folder") << "folder"
                                  << "cannot-write";
        QTest::newRow("a pipe") << "pipe"
                                << "cannot-write";
        QTest::newRow("a circle of links") << "circle"
                                           << "cannot-write";
    }
    void whatCannotBeWrittenLeavesEverythingAsItWas() {
        QFETCH(QString, name);
        QFETCH(QString, code);
        QVERIFY(QDir(m_folder->path()).mkdir("folder"));
        QCOMPARE(::mkfifo(qPrintable(m_folder->filePath("pipe")), 0600), 0);
        QVERIFY(QFile::link("circle", m_folder->filePath("circle")));
        const auto entries = [this] {
            return QDir(m_folder->path())
                .entryList(QDir::AllEntries | QDir::System | QDir::Hidden | QDir::NoDotAndDotDot);
        };
        const QStringList before = entries();
        const auto error = writeLevel(native(m_folder->filePath(name)), Level());
        QVERIFY(error.has_value());
        QCOMPARE(QString::fromUtf8(error->code.text()), code);
        QCOMPARE(entries(), before);
    }

    void aSavedLevelIsToldWhatItsFileIsThen() {
        const fs::path path = native(m_folder->filePath("level.json"));
        const Result<FileStamp> saved = savedLevel(path, Level());
        QVERIFY(saved && readLevel(path).value().stamp == saved.value());
        QVERIFY(bool(savedLevel(path, populatedLevel(), saved.value())));
        const Result<FileStamp> late = savedLevel(path, Level(), saved.value());
        QVERIFY(!late && late.error().code.text() == "changed-on-disk");
        QVERIFY(*readLevel(path).value().level == populatedLevel());
    }

    void aDeviceIsNotReplacedByALevel() {
        QVERIFY(writeLevel("/dev/full", Level()).has_value());
        struct stat info {};
        QCOMPARE(::stat("/dev/full", &info), 0);
        QVERIFY(S_ISCHR(info.st_mode));
    }

    void aFullDiskLeavesTheOldFileWhole() {
        const QString path = m_folder->filePath("level.json");
        QCOMPARE(writeLevel(native(path), Level()), std::nullopt);
        const QByteArray before = contentsOnDisk(path);
        std::optional<Error> error;
        {
            const FileSizeLimit limit(1000);
            error = writeLevel(native(path), randomLevel(5, 100));
        }
        QVERIFY(error.has_value());
        QCOMPARE(error->code.text(), std::string("cannot-write"));
        QCOMPARE(contentsOnDisk(path), before);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"level.json"});
    }

    void aProtectedFolderOrFileIsRespected() {
        const QString path = m_folder->filePath("level.json");
        QCOMPARE(writeLevel(native(path), Level()), std::nullopt);
        const QByteArray before = contentsOnDisk(path);
        // Permissions do not bind root, so the attempt is made by a child that is somebody else.
        const auto asNobody = [&](const QString& target, const char* code) {
            const pid_t child = ::fork();
            if (child == 0) {
                const bool plain = ::geteuid() != 0 || (::setgid(65534) == 0 && ::setuid(65534) == 0);
                const auto error = writeLevel(native(target), populatedLevel());
                ::_exit(plain && error && error->code.text() == code ? 0 : 1);
            }
            int status = -1;
            ::waitpid(child, &status, 0);
            return status;
        };
        QCOMPARE(::chmod(qPrintable(path), 0444), 0);
        QCOMPARE(::chmod(qPrintable(m_folder->path()), 0777), 0);
        QCOMPARE(asNobody(path, "file-protected"), 0);
        QCOMPARE(::chmod(qPrintable(m_folder->path()), 0555), 0);
        QCOMPARE(asNobody(m_folder->filePath("new.json"), "folder-protected"), 0);
        QCOMPARE(::chmod(qPrintable(m_folder->path()), 0755), 0);
        QCOMPARE(contentsOnDisk(path), before);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
                 QStringList{"level.json"});
    }

    void aLevelThatJsonCannotHoldIsNotWritten() {
        const QString path = m_folder->filePath("level.json");
        Level level;
        level.gravity.x() = std::nan("");
        const auto error = writeLevel(native(path), level);
        QVERIFY(error.has_value());
        QCOMPARE(error->code.text(), std::string("not-finite"));
        QVERIFY(!QFile::exists(path));
    }

  private:
    std::optional<QTemporaryDir> m_folder;
};

SPACETOW_TEST(DiskTest)
#include "disk_test.moc"
