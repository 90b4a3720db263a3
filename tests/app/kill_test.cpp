// The editor is killed at random moments of editing and saving, and nothing is lost.
#include "core/level/file.h"
#include "editor/editing/journal.h"
#include "tests/support/edit_script.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

#include <QProcess>
#include <QTemporaryDir>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Until when a process has come that was killed.
struct Killed {
    std::uint64_t seed = 0;
    int begun = 0, done = 0; // steps
};

Level levelAtStart(std::uint64_t seed) {
    Level level;
    level.name = beginsWithFile(seed) ? "from the file" : "";
    return level;
}

/// What the script of the seed has made by then.
struct Expected {
    explicit Expected(const Killed& killed) {
        Document document(levelAtStart(killed.seed));
        EditScript script(killed.seed);
        states.push_back(document.level());
        for (int step = 1; step <= killed.begun; ++step) {
            if (script.next(document) == Deed::Save) {
                document.markSaved();
                (step <= killed.done ? savedAt : savingAt) = step;
            }
            states.push_back(document.level());
        }
    }
    std::vector<Level> states;   // after each step; the first is that at the start
    std::optional<int> savedAt;  // the last save that was told as done
    std::optional<int> savingAt; // one that had begun
};

std::optional<Level> readBack(const std::filesystem::path& path) {
    const Result<LevelFile> file = readLevel(path, Checks::FileOnly);
    return file ? file.value().level : std::nullopt;
}

} // namespace

class KillTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsSavedStaysAndAtMostTheLastStepIsMissing() {
        const QTemporaryDir folder;
        const int count = usualOrThin(fullOrQuick(500, 50), 10);
        for (int seed = 1; seed <= count; ++seed) {
            const std::filesystem::path own = place(folder, static_cast<std::uint64_t>(seed));
            std::filesystem::create_directories(own);
            if (beginsWithFile(static_cast<std::uint64_t>(seed))) {
                QVERIFY(!writeLevel(scriptFile(own), levelAtStart(static_cast<std::uint64_t>(seed))));
            }
        }
        QProcess process;
        process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process.start(binaryFolder() + "/bin/kill_child", {folder.path(), "1", QString::number(count)});
        QVERIFY(process.waitForFinished(-1));
        QCOMPARE(process.exitCode(), 0);
        int runs = 0;
        int early = 0;
        for (const QByteArray& line : process.readAllStandardOutput().split('\n')) {
            const QList<QByteArray> words = line.split(' ');
            if (words.size() == 3) {
                const Killed killed{words[0].toULongLong(), words[1].toInt(), words[2].toInt()};
                check(killed, place(folder, killed.seed));
                early += killed.done < 60 ? 1 : 0;
                ++runs;
            }
        }
        QCOMPARE(runs, count);
        QVERIFY2(early > count * 3 / 4, "hardly any process was killed before its end");
    }

  private:
    static std::filesystem::path place(const QTemporaryDir& folder, std::uint64_t seed) {
        return std::filesystem::path(folder.path().toStdString()) / std::to_string(seed);
    }

    static void check(const Killed& killed, const std::filesystem::path& folder) {
        const QByteArray where = "seed " + QByteArray::number(static_cast<qulonglong>(killed.seed)) + ", begun " +
                                 QByteArray::number(killed.begun) + ", done " + QByteArray::number(killed.done);
        const Expected expected(killed);
        const auto stateAt = [&expected](int step) { return expected.states.at(static_cast<std::size_t>(step)); };
        // The file: the last acknowledged save, or one that was just being made.
        const std::filesystem::path path = scriptFile(folder);
        const bool mustExist = expected.savedAt || beginsWithFile(killed.seed);
        std::optional<Level> file;
        if (std::filesystem::exists(path)) {
            file = readBack(path);
            QVERIFY2(file.has_value(), where + ": the file cannot be read");
            const bool current = (mustExist && *file == stateAt(expected.savedAt.value_or(0))) ||
                                 (expected.savingAt && *file == stateAt(*expected.savingAt));
            QVERIFY2(current, where + ": the file is older than its last save");
        } else {
            QVERIFY2(!mustExist, where + ": the file is gone");
        }
        // What the next start has: the journal or, where that has nothing to add, the file.
        const std::vector<Orphan> found = orphans(folder / "state/spacetow-studio/recovery");
        QVERIFY2(found.size() <= 1, where + ": one document was kept twice");
        const Level recovered = !found.empty() ? parseLevel(found.front().entry.text).level.value_or(Level())
                                : file         ? *file
                                               : levelAtStart(killed.seed);
        const int oldest = killed.begun > killed.done ? killed.done : std::max(killed.done - 1, 0);
        bool recent = false;
        for (int step = oldest; step <= killed.begun; ++step) {
            recent = recent || recovered == stateAt(step);
        }
        QVERIFY2(recent, where + ": more than the last step is missing");
        for (const Orphan& orphan : found) {
            QVERIFY2(orphan.entry.path.empty() || orphan.entry.path == path, where + ": it belongs to another file");
        }
    }
};

SPACETOW_TEST(KillTest)
#include "kill_test.moc"
