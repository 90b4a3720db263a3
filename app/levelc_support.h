#pragma once
// What the commands of levelc share: reading arguments and levels, and saying what is wrong. Results go to standard
// output, complaints to standard error.

#include "core/level/file.h"
#include "core/physics/world.h"

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

void printLine(const QString& line);
void complain(const QString& line);
void complain(const Error& error);

/// "FILE:LINE: error: code: message (/pointer)"
QString problemLine(const QString& file, const Problem& problem);

/// The level of a file; none after complaining about what keeps it from being one.
std::optional<Level> loadedLevel(const QString& file);

/// "0123456789abcdef"
QString hashText(std::uint64_t hash);
/// Writes every body's key, name, position, angle, velocity and angular velocity as JSON. False after complaining.
bool writeDump(const QString& file, const Level& level, const World& world, std::int64_t updates);

} // namespace spacetow
