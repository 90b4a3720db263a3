#include "editor/editing/journal.h"

#include "core/level/file_state.h"
#include "editor/editing/backups.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>

#include <filesystem>
#include <fstream>

using namespace spacetow;

namespace {

namespace fs = std::filesystem;

JournalEntry anEntry(const std::string& text = "{}\n", std::int64_t time = 1000) {
    return {"/home/a b/100%\nlevel.json", "100%\nlevel.json", 0xfedcba9876543210u, time, text};
}

void putBytes(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string bytesIn(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

class JournalTest : public QObject {
    Q_OBJECT

  private slots:
    void init() {
        m_folder.emplace();
        QVERIFY(m_folder->isValid());
    }

    void anEntryIsReadBackTheSame() {
        for (const JournalEntry& entry : {anEntry(), anEntry(""), JournalEntry{"", "Untitled", {}, 5, "a\nb\0c"}}) {
            QCOMPARE(parsedJournal(journalText(entry)), std::optional(entry));
        }
    }

    void aTornOrForeignTextIsNoEntry() {
        const std::string whole = journalText(anEntry("some text of a level\n"));
        for (std::size_t size = 0; size < whole.size(); ++size) {
            QVERIFY(!parsedJournal(whole.substr(0, size)));
        }
        QVERIFY(!parsedJournal(whole + "x"));
        std::string other = whole;
        other.back() = 'x';
        QVERIFY(!parsedJournal(other));
    }

    void whatALivingProcessHasWrittenIsNotOffered() {
        Result<JournalSlot> made = JournalSlot::made(folder());
        QVERIFY(bool(made));
        std::optional<JournalSlot> slot = std::move(made).value();
        QVERIFY(!slot->write(anEntry()));
        QVERIFY(orphans(folder()).empty());
        QVERIFY(!JournalSlot::takenOver(folder(), slot->id()));
        const std::string id = slot->id();
        slot.reset(); // as when the process ends
        const std::vector<Orphan> found = orphans(folder());
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found.front().id, id);
        QCOMPARE(found.front().entry, anEntry());
    }

    void onlyOneTakesOver() {
        const std::string id = leave(anEntry());
        const std::optional<JournalSlot> first = JournalSlot::takenOver(folder(), id);
        QVERIFY(first.has_value());
        QCOMPARE(first->read(), std::optional(anEntry()));
        QVERIFY(!JournalSlot::takenOver(folder(), id));
        QVERIFY(orphans(folder()).empty());
    }

    void theNewestComesFirst() {
        leave(anEntry("old", 10));
        leave(anEntry("new", 30));
        leave(anEntry("middle", 20));
        std::string order;
        for (const Orphan& orphan : orphans(folder())) {
            order += orphan.entry.text + ' ';
        }
        QCOMPARE(order, std::string("new middle old "));
    }

    void aPlaceWithoutAnythingWrittenLeavesNothing() {
        { const Result<JournalSlot> slot = JournalSlot::made(folder()); }
        {
            const Result<JournalSlot> slot = JournalSlot::made(folder());
            QVERIFY(!slot.value().write(anEntry()));
            slot.value().erase();
        }
        QVERIFY(fs::is_empty(folder()));
    }

    void whatTheFileHoldsAlreadyIsNoNews() {
        JournalEntry entry = anEntry("saved text\n");
        entry.path = (fs::path(path()) / "level.json").string();
        putBytes(entry.path, entry.text);
        leave(entry);
        QVERIFY(orphans(folder()).empty());
        QVERIFY(fs::is_empty(folder()));
        leave(entry);
        putBytes(entry.path, "saved texd\n");
        QCOMPARE(orphans(folder()).size(), std::size_t{1});
    }

    void discardingCanBeTakenBack() {
        const std::string id = leave(anEntry());
        JournalSlot::takenOver(folder(), id)->discard();
        QVERIFY(orphans(folder()).empty());
        JournalSlot::takenOver(folder(), id)->bringBack();
        QCOMPARE(orphans(folder()).size(), std::size_t{1});
    }

    void whatWasCutShortIsCleanedUp() {
        leave(anEntry());
        putBytes(folder() / "1-2-3.journal.new", "half");
        orphans(folder());
        QVERIFY(!fs::exists(folder() / "1-2-3.journal.new"));
        QCOMPARE(orphans(folder()).size(), std::size_t{1});
    }

    void aFolderThatCannotBeMadeIsToldOf() {
        putBytes(fs::path(path()) / "file", "");
        const Result<JournalSlot> slot = JournalSlot::made(fs::path(path()) / "file" / "recovery");
        QVERIFY(!slot);
        QCOMPARE(slot.error().code.text(), std::string("cannot-write"));
        QVERIFY(orphans(fs::path(path()) / "nowhere").empty());
    }

    void othersSeeWhichFileIsOpen() {
        const Result<JournalSlot> mine = JournalSlot::made(folder());
        std::optional<JournalSlot> other = std::move(JournalSlot::made(folder())).value();
        mine.value().setFile("/a/level.json");
        other->setFile("/a/much longer/level.json");
        QVERIFY(!isOpenElsewhere(folder(), "/a/level.json", mine.value().id()));
        other->setFile("/a/level.json");
        QVERIFY(isOpenElsewhere(folder(), "/a/level.json", mine.value().id()));
        QVERIFY(!isOpenElsewhere(folder(), "/a/other.json", mine.value().id()));
        other.reset();
        QVERIFY(!isOpenElsewhere(folder(), "/a/level.json", mine.value().id()));
    }

    void whoTakesOverDoesNotHaveTheFileOpen() {
        std::string id;
        {
            const Result<JournalSlot> slot = JournalSlot::made(folder());
            slot.value().setFile("/a/level.json");
            QVERIFY(!slot.value().write(anEntry()));
            QVERIFY(isOpenElsewhere(folder(), "/a/level.json", ""));
            id = slot.value().id();
        }
        const std::optional<JournalSlot> taken = JournalSlot::takenOver(folder(), id);
        QVERIFY(taken && !isOpenElsewhere(folder(), "/a/level.json", ""));
    }

    void eachSavePutsTheFormerVersionAside() {
        const fs::path file = fs::path(path()) / "level.json";
        QVERIFY(!backUp(backups(), file)); // there is nothing yet
        QVERIFY(backupsOf(backups(), file).empty());
        for (const char* text : {"one", "two", "two", "three"}) {
            putBytes(file, text);
            QVERIFY(!backUp(backups(), file));
        }
        std::string order;
        for (const Backup& backup : backupsOf(backups(), file)) {
            order += bytesIn(backup.file) + ' ';
        }
        QCOMPARE(order, std::string("three two one "));
        QVERIFY(backupsOf(backups(), fs::path(path()) / "other" / "level.json").empty());
    }

    void theOldestBackupsGo() {
        const fs::path file = fs::path(path()) / "level.json";
        for (int i = 0; i < 25; ++i) {
            putBytes(file, std::to_string(i));
            QVERIFY(!backUp(backups(), file));
        }
        const std::vector<Backup> kept = backupsOf(backups(), file);
        QCOMPARE(kept.size(), maxBackups);
        QCOMPARE(bytesIn(kept.front().file), std::string("24"));
        QCOMPARE(bytesIn(kept.back().file), std::string("5"));
    }

    void aFileIsKnownByItsContent() {
        const fs::path file = fs::path(path()) / "level.json";
        QVERIFY(!fileState(file).exists());
        QVERIFY(!fileState(path()).exists()); // a folder
        putBytes(file, "0123456789");
        const FileState first = fileState(file);
        QVERIFY(first.exists() && fileState(file).stamp == first.stamp);
        QCOMPARE(first.hash, contentHash("0123456789"));
        fs::remove(file);
        putBytes(file, "0123456789");
        QVERIFY(fileState(file, first).sameContent(first));
        putBytes(file, "0123456788");
        QVERIFY(!fileState(file, first).sameContent(first));
        QVERIFY(contentHash("a") != contentHash(std::string_view("\0a", 2)));
        QVERIFY(contentHash("12345678") != contentHash("123456780"));
    }

  private:
    std::string path() const { return m_folder->path().toStdString(); }
    fs::path folder() const { return fs::path(path()) / "recovery"; }
    fs::path backups() const { return fs::path(path()) / "backups"; }
    /// As a process that was killed does.
    std::string leave(const JournalEntry& entry) {
        const Result<JournalSlot> slot = JournalSlot::made(folder());
        slot.value().write(entry);
        return slot.value().id();
    }

    std::optional<QTemporaryDir> m_folder;
};

SPACETOW_TEST(JournalTest)
#include "journal_test.moc"
