#include "core/base/whole_file.h"

#include "tests/support/disk_scene.h"
#include "tests/support/test_main.h"

#include <sys/xattr.h>

using namespace spacetow;
using namespace spacetow::test;

namespace {

namespace fs = std::filesystem;

/// An access list that lets another user read, as the kernel takes it.
QByteArray accessList() {
    QByteArray list;
    const auto put = [&list](auto number) { list.append(reinterpret_cast<const char*>(&number), sizeof number); };
    put(std::uint32_t{2});
    struct Entry {
        std::uint16_t tag, permissions;
        std::uint32_t id;
    };
    constexpr std::uint32_t none = 0xffffffff;
    for (const Entry& entry :
         {Entry{1, 6, none}, Entry{2, 4, 1234}, Entry{4, 4, none}, Entry{16, 4, none}, Entry{32, 0, none}}) {
        put(entry.tag);
        put(entry.permissions);
        put(entry.id);
    }
    return list;
}

QByteArray attributeOf(const fs::path& path, const char* name) {
    QByteArray value(1000, '\0');
    const ssize_t size = ::getxattr(path.c_str(), name, value.data(), 1000);
    return size < 0 ? QByteArray("(none)") : value.left(size);
}

} // namespace

class KeptAttributesTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { m_folder.emplace(); }

    void attributesAndAccessListsStay() {
        put("file", "old");
        const QByteArray list = accessList();
        if (::setxattr(path("file").c_str(), "user.origin", "a hand", 6, 0) != 0 ||
            ::setxattr(path("file").c_str(), "system.posix_acl_access", list.data(), std::size_t(list.size()), 0) !=
                0) {
            QSKIP("this file system has no attributes or access lists");
        }
        const mode_t mode = info("file").st_mode;
        const ino_t number = info("file").st_ino;
        QCOMPARE(codeOf(writeFile(path("file"), "new")), std::string("written"));
        QVERIFY(info("file").st_ino != number); // it was replaced
        QCOMPARE(attributeOf(path("file"), "user.origin"), QByteArray("a hand"));
        QCOMPARE(attributeOf(path("file"), "system.posix_acl_access"), list);
        QCOMPARE(info("file").st_mode, mode);
    }

    void whatCannotBeGivenToANewFileStaysWithTheOldOne_data() {
        QTest::addColumn<QString>("call");
        QTest::newRow("mode") << "chmod";
        QTest::newRow("attribute") << "setxattr";
        QTest::newRow("place") << "rename";
    }
    void whatCannotBeGivenToANewFileStaysWithTheOldOne() {
        QFETCH(QString, call);
        put("file", "old");
        if (::setxattr(path("file").c_str(), "user.origin", "a hand", 6, 0) != 0 && call == "setxattr") {
            QSKIP("this file system has no attributes");
        }
        const ino_t number = info("file").st_ino;
        const std::string name = call.toStdString();
        const WithFault fault(0, EPERM, name);
        QCOMPARE(codeOf(writeFile(path("file"), "new")), std::string("written"));
        QVERIFY(disk_scene::plan.met);
        QCOMPARE(info("file").st_ino, number);
        QCOMPARE(get("file"), QByteArray("new"));
        QCOMPARE(entries(), QStringList{"file"});
    }

    void ownerGroupAndModeStay() {
        if (::geteuid() != 0) {
            QSKIP("only root can make files that belong to others");
        }
        put("file", "old");
        QCOMPARE(::chown(path("file").c_str(), 1234, 1235), 0);
        QCOMPARE(::chmod(path("file").c_str(), 04666), 0);
        QCOMPARE(codeOf(writeFile(path("file"), "new")), std::string("written"));
        QCOMPARE(info("file").st_uid, uid_t{1234});
        QCOMPARE(info("file").st_gid, gid_t{1235});
        QCOMPARE(info("file").st_mode & 07777u, mode_t{04666});
        // Somebody who may write it, but not give it away.
        QCOMPARE(::chmod(qPrintable(m_folder->path()), 0777), 0);
        QCOMPARE(asSomebody([this] { return bool(writeFile(path("file"), "theirs")); }), 0);
        QCOMPARE(get("file"), QByteArray("theirs"));
        QCOMPARE(info("file").st_uid, uid_t{1234});
        QCOMPARE(info("file").st_gid, gid_t{1235});
    }

    void whereTheFolderTakesNothingTheFileItselfIsWritten_data() {
        QTest::addColumn<int>("mode");
        QTest::newRow("a folder that may not be written") << 0555;
        QTest::newRow("a folder that may be entered only") << 0111;
        QTest::newRow("a folder that all share") << 01777;
    }
    void whereTheFolderTakesNothingTheFileItselfIsWritten() {
        QFETCH(int, mode);
        put("file", "old");
        put("protected", "old");
        QCOMPARE(::chmod(path("file").c_str(), 0666), 0);
        QCOMPARE(::chmod(path("protected").c_str(), 0444), 0);
        QCOMPARE(::chmod(qPrintable(m_folder->path()), mode_t(mode)), 0);
        const auto told = [this](const char* file) { return codeOf(writeFile(path(file), "new")); };
        const bool shared = mode == 01777;
        const int written = asSomebody([&] { return told("file") == "written"; });
        const int refused = asSomebody([&] { return told("protected") == "file-protected"; });
        const int made = asSomebody([&] { return told("other") == (shared ? "written" : "folder-protected"); });
        QCOMPARE(::chmod(qPrintable(m_folder->path()), 0755), 0);
        QCOMPARE(written, 0);
        QCOMPARE(refused, 0);
        QCOMPARE(made, 0);
        QCOMPARE(get("file"), QByteArray("new"));
        QCOMPARE(get("protected"), QByteArray("old"));
        QCOMPARE(entries(), shared ? (QStringList{"file", "other", "protected"}) : (QStringList{"file", "protected"}));
    }

  private:
    void put(const QString& file, const QByteArray& text) const { m_folder->put(file, text); }
    QByteArray get(const QString& file) const { return m_folder->get(file); }
    struct stat info(const std::string& file) const {
        return m_folder->info(file);
    }
    fs::path path(const std::string& file) const { return m_folder->path(file); }
    QStringList entries() const { return m_folder->entries(); }

    std::optional<FolderOfFiles> m_folder;
};

SPACETOW_TEST(KeptAttributesTest)
#include "kept_attributes_test.moc"
