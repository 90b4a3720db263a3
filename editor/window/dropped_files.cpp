#include "editor/window/dropped_files.h"

#include "core/base/whole_file.h"
#include "editor/exchange/capsule_text.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace spacetow {

namespace {

struct DropWords {
    Q_DECLARE_TR_FUNCTIONS(DroppedFiles)
};

/// One at a time, as each becomes a run.
void openCapsule(const QString& path, MainWindow& window) {
    Result<ReadText> read = readFile(path.toStdU16String(), maxCapsuleText);
    if (read) {
        window.bugCapsule().open(std::move(read).value().text);
    } else {
        window.messageBar().say(MessageBar::Tone::Error, sentence(read.error()));
    }
}

void openEach(const std::vector<FileToOpen>& files, MainWindow& window) {
    std::vector<FileToOpen> levels;
    QStringList flights;
    QStringList capsules;
    QStringList foreign;
    for (const FileToOpen& file : files) {
        const FileKind kind = kindOfFile(file);
        if (kind == FileKind::Level) {
            levels.push_back(file);
        } else {
            (kind == FileKind::Replay ? flights : kind == FileKind::Capsule ? capsules : foreign) << file.path;
        }
    }
    if (!levels.empty()) {
        window.openAll(levels);
    }
    if (!foreign.isEmpty()) {
        window.importFile(foreign.front());
    }
    if (foreign.size() > 1) {
        window.messageBar().say(MessageBar::Tone::Info,
                                DropWords::tr("Files of other programs are imported one at a time, as each is looked "
                                              "at first: of these it is %1.")
                                    .arg(QFileInfo(foreign.front()).fileName()));
    }
    if (!capsules.isEmpty()) {
        openCapsule(capsules.front(), window);
    }
    if (!flights.isEmpty()) {
        window.flightReader().open(flights);
    }
}

} // namespace

void openDropped(const QStringList& paths, MainWindow& window) {
    window.fileReader().read(paths, [&window](const std::vector<FileToOpen>& files) { openEach(files, window); });
}

} // namespace spacetow
