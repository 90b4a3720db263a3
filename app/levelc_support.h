#pragma once
// What the commands of levelc share: reading arguments and levels, and saying what is wrong. Results go to standard
// output, complaints to standard error.

#include "core/level/file.h"
#include "core/level/json_text.h"
#include "core/physics/world/world.h"

#include <QCommandLineParser>

#include <optional>

namespace spacetow {

/// A parser with the command's description and a --help option.
class CommandLine {
  public:
    CommandLine(const QString& command, const QString& description);

    QCommandLineParser parser;

    /// False after complaining; otherwise there are at least `least` and at most `most` file names (no limit if < 0).
    bool read(const QStringList& arguments, int least, int most);
    bool helpWanted() const { return parser.isSet(QStringLiteral("help")); }
    QString helpText() const;

  private:
    QString m_command;
};

/// The arguments of the program, whatever bytes they are made of; toPath() gives those bytes back.
QStringList argumentsOf(int argc, char** argv);
std::filesystem::path toPath(const QString& file);
/// With control characters, and bytes that are not UTF-8, spelled by their codes: a text out of a file must not steer
/// the terminal.
QString harmless(const QString& text);

/// One line, made harmless.
void printLine(const QString& line);
/// Texts of our own, of any number of lines, and JSON, as they are.
void printText(const QString& text);
/// One line, made harmless, and what may follow it as it is.
void complain(const QString& line, const QString& more = {});
/// Of a file that cannot be read or written.
void complain(const QString& file, const Error& error);

/// "FILE:LINE: error: code: message (/pointer)"
QString problemLine(const QString& file, const Problem& problem);
/// The same for programs, with the place in the world and whether there is a fix.
JsonText problemJson(const QString& file, const Problem& problem);

/// The level of a file; none after complaining about what keeps it from being one.
std::optional<Level> loadedLevel(const QString& file);

/// "0123456789abcdef"
QString hashText(std::uint64_t hash);
/// Prints a result, on standard error when standard output is where `dump` goes.
void printBeside(const QString& dump, const QString& line);
/// Writes to a file, or on a pipe or device. False after complaining.
bool writeOut(const QString& file, std::string_view text);
/// Writes every body's key, name, position, angle, velocity and angular velocity as JSON. False after complaining.
bool writeDump(const QString& file, const Level& level, const World& world, std::int64_t updates);

} // namespace spacetow
