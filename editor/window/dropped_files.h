#pragma once
// What becomes of files that are dropped on a window, chosen in it or named on the command line: levels are opened,
// recorded flights are flown in their level, drawings are imported. What a file is, its content says, whatever it is
// called.

#include <QStringList>

#include <cstdint>

namespace spacetow {

class MainWindow;

enum class FileKind : std::uint8_t { Level, Replay, Foreign };

/// By its name where its content says nothing.
FileKind kindOfFile(const QString& path);

/// What cannot be done with them, the window says in its bar.
void openDropped(const QStringList& paths, MainWindow& window);

} // namespace spacetow
