// Edits and saves as the editor does, and is killed in the middle of it: kill_child FOLDER FIRST COUNT. For each seed
// from FIRST on it forks a process that follows the script of the seed in FOLDER/SEED, with document, files and journal
// of the editor, kills that at a random moment, and prints a line: the seed, the number of the last step that was begun
// and of the last that was done. A step that saves is done when the save has returned.

#include "core/level/file.h"
#include "editor/window/files.h"
#include "editor/window/recovery.h"
#include "editor/window/state_folder.h"
#include "tests/support/edit_script.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QSettings>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sys/wait.h>
#include <unistd.h>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr int steps = 60;
constexpr int patience = 5000; // ms, the longest time that the journal may be behind

struct Message {
    char kind = 0; // 'b'egun or 'd'one
    int step = 0;
};

void tell(int pipe, char kind, int step) {
    const Message message{kind, step};
    if (::write(pipe, &message, sizeof message) != sizeof message) {
        std::_Exit(2);
    }
}

/// A hand is slower than a disk: the next step comes when the last one is in the journal.
void letJournalFollow(const Recovery& recovery) {
    QElapsedTimer time;
    time.start();
    while (recovery.isBehind()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        if (time.elapsed() > patience) {
            std::fprintf(stderr, "the journal does not follow\n");
            std::_Exit(3);
        }
    }
}

/// The editor without its window. Never returns.
[[noreturn]] void edit(const std::filesystem::path& folder, std::uint64_t seed, int pipe) {
    ::setenv("XDG_STATE_HOME", (folder / "state").c_str(), 1);
    int count = 1;
    char name[] = "kill_child";
    char* arguments[] = {name, nullptr};
    const QCoreApplication application(count, arguments);
    QCoreApplication::setOrganizationName(QStringLiteral("spacetow-test"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, QString::fromStdString(folder / "settings"));

    const QString file = QString::fromStdString(scriptFile(folder));
    Document document;
    Files files(document,
                {.whichToOpen = {},
                 .whereToSave = [&file](const QString&) { return file; },
                 .whatAboutChanges = [](const QString&) { return Unsaved::Cancel; },
                 .whichToCompare = {}},
                [](MessageBar::Tone, const QString& text, const std::vector<MessageBar::Choice>&) {
                    std::fprintf(stderr, "%s\n", qPrintable(text));
                });
    Recovery recovery(document, files, journalFolder());
    if (beginsWithFile(seed) && !files.open(file)) {
        std::_Exit(4);
    }
    EditScript script(seed);
    for (int step = 1; step <= steps; ++step) {
        letJournalFollow(recovery);
        tell(pipe, 'b', step);
        if (script.next(document) == Deed::Save && !files.save()) {
            std::_Exit(5);
        }
        tell(pipe, 'd', step);
    }
    std::_Exit(0); // as sudden as being killed
}

void pause(long nanoseconds) {
    const timespec time{0, nanoseconds};
    ::nanosleep(&time, nullptr);
}

/// Kills the process a moment after it has told of so many things. False when something else has gone wrong.
bool killLater(pid_t process, int pipe, std::uint64_t seed) {
    Random random(seed + 1'000'000);
    const auto patient = static_cast<int>(random.below(50));
    int begun = 0;
    int done = 0;
    Message message;
    for (int told = 0; ::read(pipe, &message, sizeof message) == sizeof message; ++told) {
        (message.kind == 'b' ? begun : done) = message.step;
        if (told == patient) {
            pause(static_cast<long>(random.below(12'000'000)));
            ::kill(process, SIGKILL);
        }
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    std::printf("%llu %d %d\n", static_cast<unsigned long long>(seed), begun, done);
    return WIFSIGNALED(status) || WEXITSTATUS(status) == 0;
}

bool runAndKill(const std::filesystem::path& folder, std::uint64_t seed) {
    int pipe[2];
    if (::pipe(pipe) != 0) {
        return false;
    }
    std::fflush(stdout);
    const pid_t process = ::fork();
    if (process == 0) {
        ::close(pipe[0]);
        edit(folder / std::to_string(seed), seed, pipe[1]);
    }
    ::close(pipe[1]);
    const bool good = process > 0 && killLater(process, pipe[0], seed);
    ::close(pipe[0]);
    return good;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 4) {
        std::fprintf(stderr, "Usage: kill_child FOLDER FIRST COUNT\n");
        return 2;
    }
    const std::uint64_t first = std::strtoull(arguments[2], nullptr, 10);
    const std::uint64_t number = std::strtoull(arguments[3], nullptr, 10);
    for (std::uint64_t seed = first; seed < first + number; ++seed) {
        if (!runAndKill(arguments[1], seed)) {
            return 1;
        }
    }
    return 0;
}
