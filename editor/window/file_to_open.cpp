#include "editor/window/file_to_open.h"

#include "core/level/level_index.h"
#include "editor/exchange/capsule_text.h"
#include "editor/exchange/file_mark.h"
#include "editor/window/exchange.h"

#include <QFile>
#include <QFileInfo>

#include <optional>
#include <string_view>

namespace spacetow {

namespace {

/// What is neither JSON nor XML is nothing that is known, however much there is of it.
bool mayBeMarked(const QByteArray& text) {
    const QByteArray begin = text.trimmed().left(1);
    return begin.isEmpty() || QByteArrayLiteral("{<\xef\xff\xfe").contains(begin);
}

std::string_view viewOf(const QByteArray& text) {
    return {text.constData(), static_cast<std::size_t>(text.size())};
}

/// Nothing where the content does not say. Our own files say at once what they are, so only of others all is read.
std::optional<FileKind> kindByContent(const QString& path) {
    constexpr qint64 looked = 4096; // bytes
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QByteArray text = file.read(looked);
    if (holdsCapsule(viewOf(text)) && !mayBeMarked(text)) {
        return FileKind::Capsule;
    }
    FileMark mark = markOf(viewOf(text));
    if (mark == FileMark::None && mayBeMarked(text) && !file.atEnd() &&
        file.size() <= static_cast<qint64>(maxLevelBytes)) {
        text += file.readAll();
        mark = markOf(viewOf(text));
    }
    switch (mark) {
    case FileMark::Level:
        return FileKind::Level;
    case FileMark::Replay:
        return FileKind::Replay;
    case FileMark::Foreign:
        return FileKind::Foreign;
    case FileMark::None:
        break;
    }
    return {};
}

} // namespace

FileKind kindOfFile(const FileToOpen& file) {
    if (file.read) {
        return file.read->kind;
    }
    if (const std::optional<FileKind> kind = kindByContent(file.path)) {
        return *kind;
    }
    return Exchange::isForeign(file.path)                                            ? FileKind::Foreign
           : file.path.endsWith(QStringLiteral(".replay.json"), Qt::CaseInsensitive) ? FileKind::Replay
                                                                                     : FileKind::Level;
}

Result<LevelFile> levelOfFile(const FileToOpen& file, FileState& disk) {
    const std::filesystem::path path = file.path.toStdString();
    if (file.read && file.read->kind == FileKind::Level && stampOf(path) == file.read->disk.stamp) {
        disk = file.read->disk;
        return file.read->level;
    }
    // First, so that what is written meanwhile counts as another's change.
    disk = fileState(path);
    return readLevel(path, Checks::FileOnly);
}

FileToOpen readWhole(const QString& path) {
    const FileKind kind = kindOfFile(path);
    FileState disk;
    Result<LevelFile> level = LevelFile();
    if (kind == FileKind::Level) {
        level = levelOfFile(path, disk);
    }
    if (level && level.value().level) {
        levelIndex(*level.value().level); // the window would make it, and wait for it
    }
    return {path, std::make_shared<const FileRead>(FileRead{kind, disk, std::move(level)})};
}

} // namespace spacetow
