#include "core/base/whole_file.h"

#include "core/base/codes.h"
#include "core/base/random.h"
#include "core/base/replace_file.h"
#include "tests/support/disk_scene.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

using namespace spacetow;
using namespace spacetow::test;

namespace {

namespace fs = std::filesystem;

} // namespace

class WholeFileTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_folder.emplace(); }

    void aTextComesBackWithTheStampOfItsFile() {
        std::string text("a\0b\n", 4);
        text.append(200'000, 'x');
        const Result<FileStamp> written = writeFile(path("file"), text);
        QCOMPARE(codeOf(written), std::string("written"));
        const Result<ReadText> read = readFile(path("file"), text.size());
        QVERIFY(bool(read));
        QVERIFY(read.value().text == text);
        QVERIFY(read.value().stamp == written.value() && stampOf(path("file")) == written.value());
        QVERIFY(!stampOf(path("other")).exists);
        QCOMPARE(readFile(path("file"), text.size() - 1).error().code.text(), std::string("file-too-large"));
        QCOMPARE(entries(), QStringList{"file"});
    }

    void whereverACallFailsTheFileIsWhole_data() {
        QTest::addColumn<int>("code");
        QTest::addColumn<bool>("linked");
        QTest::addColumn<bool>("isNew");
        for (const int code : {EIO, ENOSPC, EACCES}) {
            QTest::addRow("%d replaced", code) << code << false << false;
            QTest::addRow("%d in place", code) << code << true << false;
            QTest::addRow("%d new", code) << code << false << true;
        }
    }
    void whereverACallFailsTheFileIsWhole() {
        QFETCH(int, code);
        QFETCH(bool, linked);
        QFETCH(bool, isNew);
        int failures = 0;
        for (int n = 0;; ++n) {
            QFile::remove(name("file"));
            QFile::remove(name("link"));
            if (!isNew) {
                put("file", "the old content, which is longer");
            }
            if (linked) {
                QCOMPARE(::link(path("file").c_str(), path("link").c_str()), 0);
            }
            std::optional<Result<FileStamp>> written;
            {
                const WithFault fault(n, code);
                written = writeFile(path("file"), "new content");
            }
            const QByteArray now = QFile::exists(name("file")) ? get("file") : QByteArray("(none)");
            const QByteArray before = isNew ? "(none)" : "the old content, which is longer";
            QVERIFY2(now == (*written ? "new content" : before), qPrintable(QString::number(n)));
            QCOMPARE(entries().size(), (linked ? 1 : 0) + (now == "(none)" ? 0 : 1));
            failures += *written ? 0 : 1;
            if (!disk_scene::plan.met) {
                break;
            }
        }
        QVERIFY(failures >= 2);
    }

    void whatKeepsItFromBeingWrittenIsTold_data() {
        QTest::addColumn<QString>("call");
        QTest::addColumn<int>("code");
        QTest::addColumn<QString>("told");
        QTest::newRow("full disk") << "write" << ENOSPC << "disk-full";
        QTest::newRow("full when flushed") << "fsync" << ENOSPC << "disk-full";
        QTest::newRow("no room for a new file") << "create" << ENOSPC << "disk-full";
        QTest::newRow("quota") << "write" << EDQUOT << "quota-full";
        QTest::newRow("broken disk") << "fsync" << EIO << "cannot-write";
        QTest::newRow("removed from under it") << "rename" << ENOENT << "cannot-write";
    }
    void whatKeepsItFromBeingWrittenIsTold() {
        QFETCH(QString, call);
        QFETCH(int, code);
        QFETCH(QString, told);
        put("file", "old");
        const std::string name = call.toStdString();
        const WithFault fault(0, code, name);
        const Result<FileStamp> written = writeFile(path("file"), "new");
        QVERIFY(!written);
        QCOMPARE(QString::fromUtf8(written.error().code.text()), told);
        QCOMPARE(QString::fromStdString(written.error().arguments.at(0)), this->name("file"));
        QCOMPARE(get("file"), QByteArray("old"));
        QCOMPARE(entries(), QStringList{"file"});
    }

    void aFolderThatIsGoneIsTold() {
        const Result<FileStamp> written = writeFile(path("gone/file"), "new");
        QVERIFY(!written);
        QVERIFY((written.error() ==
                 Error{BaseCode("folder-missing"), {path("gone/file").string(), path("gone").string()}}));
    }

    void onADiskThatCanOnlyBeReadNothingIsWritten() {
        {
            const WithFault fault(0, EROFS, "create");
            QCOMPARE(codeOf(writeFile(path("file"), "new")), std::string("disk-read-only"));
        }
        QCOMPARE(entries(), QStringList());
    }

    void whatWasBrokenOffInPlaceIsPutBack() {
        put("file", "old");
        QCOMPARE(::link(path("file").c_str(), path("link").c_str()), 0);
        {
            const WithFault fault(1, EIO, "write"); // the first goes to the file beside
            QCOMPARE(codeOf(writeFile(path("file"), "new")), std::string("cannot-write"));
        }
        QCOMPARE(get("link"), QByteArray("old"));
    }

    void namesAsLongAsNamesCanBeAreSaved() {
        const std::string longest(255, 'n');
        QCOMPARE(codeOf(writeFile(path(longest), "old")), std::string("written"));
        QCOMPARE(codeOf(writeFile(path(longest), "new")), std::string("written"));
        QCOMPARE(get(QString::fromStdString(longest)), QByteArray("new"));
        QCOMPARE(codeOf(writeFile(path(longest + 'n'), "new")), std::string("cannot-write"));
        QCOMPARE(entries(), QStringList{QString::fromStdString(longest)});
    }

    void linksOfAllKindsStay() {
        put("file", "old");
        QVERIFY(QFile::link("file", name("soft")));
        QCOMPARE(::link(path("file").c_str(), path("hard").c_str()), 0);
        QCOMPARE(codeOf(writeFile(path("soft"), "new")), std::string("written"));
        QCOMPARE(get("file"), QByteArray("new"));
        QCOMPARE(get("hard"), QByteArray("new"));
        QVERIFY(QFileInfo(name("soft")).isSymLink());
        QCOMPARE(codeOf(writeFile(path("hard"), "newer")), std::string("written"));
        QCOMPARE(get("file"), QByteArray("newer"));
        QCOMPARE(entries(), (QStringList{"file", "hard", "soft"}));
    }

    void aNameThatIsTakenIsLeftAlone() {
        const WithFault fault(0, EEXIST, "create");
        QCOMPARE(codeOf(writeFile(path("file"), "new")), std::string("written"));
        QVERIFY(disk_scene::plan.met);
    }

    void whatKilledWritersLeftIsRemoved() {
        put("file", "old");
        const QString beside = QString::fromStdString(disk::namesBeside(path("file")));
        const QString dead = beside + "999999999-1.tmp";
        const QString living = beside + "999999999-2.tmp";
        const QString others = beside + "999999999-3.tmp";
        const QString unlike = beside + "notes.txt";
        const QString another = QString::fromStdString(disk::namesBeside(path("file2"))) + "999999999-4.tmp";
        for (const QString& left : {dead, living, others, unlike, another}) {
            put(left, "half");
        }
        const disk::Descriptor lock(::open(qPrintable(name(living)), O_RDONLY));
        QCOMPARE(::flock(lock.number(), LOCK_EX), 0);
        const bool foreign = ::chown(qPrintable(name(others)), somebody, somebody) == 0;
        QCOMPARE(codeOf(writeFile(path("file"), "new")), std::string("written"));
        QVERIFY(!QFile::exists(name(dead)));
        QVERIFY(QFile::exists(name(living)) && QFile::exists(name(unlike)) && QFile::exists(name(another)));
        QCOMPARE(QFile::exists(name(others)), foreign);
    }

    void onlyTheFileThatWasSeenIsReplaced() {
        const Result<FileStamp> first = writeFile(path("file"), "old");
        QVERIFY(bool(first));
        const Result<FileStamp> second = writeFile(path("file"), "newer", first.value());
        QCOMPARE(codeOf(second), std::string("written"));
        put("file", "somebody else's");
        QCOMPARE(codeOf(writeFile(path("file"), "mine", second.value())), std::string("changed-on-disk"));
        QCOMPARE(get("file"), QByteArray("somebody else's"));
        QFile::remove(name("file"));
        QCOMPARE(codeOf(writeFile(path("file"), "mine", second.value())), std::string("changed-on-disk"));
        QCOMPARE(codeOf(writeFile(path("file"), "mine", FileStamp())), std::string("written"));
        QCOMPARE(codeOf(writeFile(path("file"), "mine", FileStamp())), std::string("changed-on-disk"));
        QCOMPARE(entries(), QStringList{"file"});
    }

    void pipesAreReadAndWritten() {
        QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
        const std::string text(300'000, 'p');
        std::thread writer([&] { QVERIFY(!writeFileOrStream(path("pipe"), text)); });
        const Result<ReadText> read = readFile(path("pipe"), text.size(), Sources::Any);
        writer.join();
        QVERIFY(read && read.value().text == text);
        QCOMPARE(readFile(path("pipe"), 10).error().code.text(), std::string("cannot-read"));
        QCOMPARE(readFile("/dev/zero", 1000, Sources::Any).error().code.text(), std::string("file-too-large"));
    }

    void aDeviceIsWrittenOnWhenThatIsAskedFor() {
        QCOMPARE(codeOf(writeFile("/dev/null", "new")), std::string("cannot-write"));
        QVERIFY(!writeFileOrStream("/dev/null", "new"));
        const std::optional<Error> full = writeFileOrStream("/dev/full", "new");
        QVERIFY(full && full->code.text() == "disk-full");
        QVERIFY(!writeFileOrStream(path("file"), "new"));
        QCOMPARE(get("file"), QByteArray("new"));
    }

    void killedAtAnyMomentTheFileIsWhole() {
        const int kills = isFullRun() ? 500 : 50;
        const std::string first(30'000, '0');
        QVERIFY(bool(writeFile(path("file"), first)));
        Random random(7);
        for (int i = 0; i < kills; ++i) {
            int acknowledged[2] = {-1, -1};
            QCOMPARE(::pipe(acknowledged), 0);
            const pid_t child = ::fork();
            if (child == 0) {
                for (char c = 'a';; c = c == 'z' ? 'a' : static_cast<char>(c + 1)) {
                    const bool good = bool(writeFile(path("file"), std::string(30'000, c)));
                    if (!good || ::write(acknowledged[1], &c, 1) != 1) {
                        ::_exit(1);
                    }
                }
            }
            ::close(acknowledged[1]);
            ::usleep(500 + random.below(4000));
            ::kill(child, SIGKILL);
            ::waitpid(child, nullptr, 0);
            char last = '\0';
            for (char c = '\0'; ::read(acknowledged[0], &c, 1) == 1;) {
                last = c;
            }
            ::close(acknowledged[0]);
            const QByteArray now = get("file");
            QVERIFY2(now == QByteArray(30'000, now.at(0)), qPrintable(QString::number(i)));
            // The one that was told last, or the one that was on its way.
            QVERIFY(last == '\0' || now.at(0) == last || now.at(0) == (last == 'z' ? 'a' : last + 1));
        }
        QVERIFY(bool(writeFile(path("file"), "end")));
        QCOMPARE(entries(), QStringList{"file"});
    }

  private:
    void put(const QString& file, const QByteArray& text) const { m_folder->put(file, text); }
    QByteArray get(const QString& file) const { return m_folder->get(file); }
    QString name(const QString& file) const { return m_folder->name(file); }
    fs::path path(const std::string& file) const { return m_folder->path(file); }
    QStringList entries() const { return m_folder->entries(); }

    std::optional<FolderOfFiles> m_folder;
};

SPACETOW_TEST(WholeFileTest)
#include "whole_file_test.moc"
