#include "editor/window/dropped_files.h"

#include "core/level/file.h"
#include "editor/exchange/file_mark.h"
#include "editor/window/main_window.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

namespace spacetow {

namespace {

struct DropWords {
    Q_DECLARE_TR_FUNCTIONS(DroppedFiles)
};

/// What is neither JSON nor XML is nothing that is known, however much there is of it.
bool mayBeMarked(const QByteArray& text) {
    const QByteArray begin = text.trimmed().left(1);
    return begin.isEmpty() || QByteArrayLiteral("{<\xef\xff\xfe").contains(begin);
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
    if (mark == FileMark::None && mayBeMarked(text) && !file.atEnd() &&
        file.size() <= static_cast<qint64>(maxLevelBytes)) {
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
    if (!flights.isEmpty()) {
        window.flightReader().open(flights);
    }
}

} // namespace spacetow
