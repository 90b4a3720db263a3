#pragma once
// A file that is to be opened, with what it holds where that has been read already.

#include "core/level/file.h"
#include "core/level/file_state.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <utility>

namespace spacetow {

enum class FileKind : std::uint8_t { Level, Replay, Capsule, Foreign };

struct FileRead {
    FileKind kind = FileKind::Level;
    FileState disk;          // as it was before
    Result<LevelFile> level; // of a level alone
};

struct FileToOpen {
    FileToOpen(QString where) : path(std::move(where)) {}
    FileToOpen(QString where, std::shared_ptr<const FileRead> what) : path(std::move(where)), read(std::move(what)) {}

    QString path;
    std::shared_ptr<const FileRead> read; // null: not yet
};

/// By its name where its content says nothing, of which as much is read as it takes to know.
FileKind kindOfFile(const FileToOpen& file);
/// The level of the file: what has been read, as long as the file is still that one; `disk` says which.
Result<LevelFile> levelOfFile(const FileToOpen& file, FileState& disk);
/// Everything at once.
FileToOpen readWhole(const QString& path);

} // namespace spacetow
