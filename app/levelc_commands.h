#pragma once
// The commands of levelc, one a file. Each takes the program's arguments without the command's name (the program's own
// name stays first) and returns the exit status.

#include <QStringList>

namespace spacetow {

namespace exit_status {
constexpr int good = 0;
constexpr int bad = 1;      // the level has errors, or the flight was not won
constexpr int unusable = 2; // bad usage, or a file that cannot be read or written
} // namespace exit_status

int checkCommand(const QStringList& arguments);
/// Carries out the safe fixes.
int fixCommand(const QStringList& arguments);
int infoCommand(const QStringList& arguments);
/// Makes a level of an SVG drawing, a map of Tiled or a scene of R.U.B.E.
int importCommand(const QStringList& arguments);
int renderCommand(const QStringList& arguments);
int simulateCommand(const QStringList& arguments);
int replayCommand(const QStringList& arguments);
/// All flights that are stored beside levels.
int flightsCommand(const QStringList& arguments);
/// What is different between two levels, in words.
int diffCommand(const QStringList& arguments);
/// The three-way merge of levels.
int mergeCommand(const QStringList& arguments);
/// The JSON schema of level files.
int schemaCommand(const QStringList& arguments);
/// The fields of a part of them as a Markdown table.
int fieldsCommand(const QStringList& arguments);

} // namespace spacetow
