#include "editor/window/dropped_files.h"

#include "core/game/replay.h"
#include "core/level/file.h"
#include "editor/exchange/file_mark.h"
#include "editor/window/application.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace spacetow {

namespace {

struct DropWords {
    Q_DECLARE_TR_FUNCTIONS(DroppedFiles)
};

enum class Match { None, Name, Exact };

Match matchOf(const MainWindow& window, const Replay& replay) {
    const OpenLevel& open = *window.openLevel();
    if (replay.levelHash && levelHash(*open.document.current().level) == *replay.levelHash) {
        return Match::Exact;
    }
    return open.files.name() == QString::fromStdString(replay.level) ? Match::Name : Match::None;
}

std::vector<MainWindow*> windowsFrom(MainWindow& first) {
    std::vector<MainWindow*> all{&first};
    if (first.application() != nullptr) {
        for (MainWindow* window : first.application()->windows()) {
            if (window != &first) {
                all.push_back(window);
            }
        }
    }
    return all;
}

/// A file of the level's name near the recording, or the level of that name that comes with the program.
QString levelFileFor(const Replay& replay, const QString& replayPath) {
    const QString name = QFileInfo(QString::fromStdString(replay.level)).fileName(); // wherever it lay elsewhere
    if (name.isEmpty()) {
        return {};
    }
    const QDir folder = QFileInfo(replayPath).absoluteDir();
    for (const QString& place : {QStringLiteral("."), QStringLiteral("../levels"), QStringLiteral("../../levels")}) {
        const QString path = QDir::cleanPath(folder.filePath(place + QLatin1Char('/') + name));
        if (QFileInfo(path).isFile()) {
            return path;
        }
    }
    for (const QString& place : {QStringLiteral(":/levels/"), QStringLiteral(":/levels/sandbox/")}) {
        if (QFileInfo::exists(place + name)) {
            return place + name;
        }
    }
    return {};
}

/// The window with the level that was flown: one that is open, else one that is opened; null when there is none.
MainWindow* windowFor(const Replay& replay, const QString& replayPath, MainWindow& window) {
    const std::vector<MainWindow*> open = windowsFrom(window);
    for (const Match wanted : {Match::Exact, Match::Name}) {
        for (MainWindow* one : open) {
            if (matchOf(*one, replay) >= wanted) {
                return one;
            }
        }
    }
    const QString path = levelFileFor(replay, replayPath);
    if (path.isEmpty()) {
        window.messageBar().say(MessageBar::Tone::Error,
                                DropWords::tr("%1 is a flight in the level “%2”, which is neither open nor beside it. "
                                              "Open the level and drop the flight on it.")
                                    .arg(QFileInfo(replayPath).fileName(), QString::fromStdString(replay.level)));
        return nullptr;
    }
    return window.openAside(path);
}

void flyDropped(const QString& path, MainWindow& window) {
    const Result<Replay> replay = readReplay(path.toStdU16String());
    if (!replay) {
        window.messageBar().say(MessageBar::Tone::Error, sentence(replay.error()));
        return;
    }
    MainWindow* const place = windowFor(replay.value(), path, window);
    if (place == nullptr) {
        return;
    }
    const bool changed = replay.value().levelHash && matchOf(*place, replay.value()) != Match::Exact;
    place->comeForward();
    place->messageBar().dismiss();
    place->playReplay(replay.value());
    if (changed) {
        place->messageBar().say(
            MessageBar::Tone::Warning,
            DropWords::tr(
                "The level has been changed since the flight was recorded, which may therefore end otherwise."));
    }
}

/// Our own files say at once what they are, so only of others all is read.
FileMark markOfFile(const QString& path) {
    constexpr qint64 looked = 4096; // bytes
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) {
        return FileMark::None;
    }
    QByteArray text = file.read(looked);
    FileMark mark = markOf({text.constData(), static_cast<std::size_t>(text.size())});
    if (mark == FileMark::None && !file.atEnd() && file.size() <= static_cast<qint64>(maxLevelBytes)) {
        text += file.readAll();
        mark = markOf({text.constData(), static_cast<std::size_t>(text.size())});
    }
    return mark;
}

} // namespace

FileKind kindOfFile(const QString& path) {
    switch (markOfFile(path)) {
    case FileMark::Level:
        return FileKind::Level;
    case FileMark::Replay:
        return FileKind::Replay;
    case FileMark::Foreign:
        return FileKind::Foreign;
    case FileMark::None:
        break;
    }
    return Exchange::isForeign(path)                                            ? FileKind::Foreign
           : path.endsWith(QStringLiteral(".replay.json"), Qt::CaseInsensitive) ? FileKind::Replay
                                                                                : FileKind::Level;
}

void openDropped(const QStringList& paths, MainWindow& window) {
    QStringList levels;
    QStringList flights;
    QStringList foreign;
    for (const QString& path : paths) {
        const FileKind kind = kindOfFile(path);
        (kind == FileKind::Replay ? flights : kind == FileKind::Foreign ? foreign : levels) << path;
    }
    if (!levels.isEmpty()) {
        window.openFiles(levels);
    }
    if (!foreign.isEmpty()) {
        window.open(foreign.front());
    }
    if (foreign.size() > 1) {
        window.messageBar().say(MessageBar::Tone::Info,
                                DropWords::tr("Files of other programs are imported one at a time, as each is looked "
                                              "at first: of these it is %1.")
                                    .arg(QFileInfo(foreign.front()).fileName()));
    }
    for (const QString& flight : flights) {
        flyDropped(flight, window);
    }
}

} // namespace spacetow
