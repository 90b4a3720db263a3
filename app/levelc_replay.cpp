#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/game/flights.h"
#include "core/game/replay.h"
#include "core/game/session.h"
#include "core/level/json_text.h"

namespace spacetow {

namespace {

bool dumpEnd(const QString& file, const Level& level, const Replay& replay) {
    Session session(level, replay.seed);
    for (InputReader inputs(inputsOf(replay, level)); !inputs.isAtEnd();) {
        session.step(inputs.next());
    }
    return writeDump(file, level, session.world(), session.updates());
}

const char* nameOf(FlightEnd end) {
    return end == FlightEnd::Won       ? "won"
           : end == FlightEnd::Lost    ? "lost"
           : end == FlightEnd::Crowded ? "crowded"
                                       : "running";
}

QString nameOf(FlightNews news) {
    switch (news) {
    case FlightNews::New:
        return QStringLiteral("new");
    case FlightNews::Same:
        return QStringLiteral("same");
    case FlightNews::Elsewhere:
        return QStringLiteral("elsewhere");
    case FlightNews::Better:
        return QStringLiteral("better");
    case FlightNews::Worse:
        return QStringLiteral("worse");
    case FlightNews::Other:
        break;
    }
    return QStringLiteral("other");
}

/// Instead of who won.
void tellOfSimulation(const QString& file) {
    complain(file + QStringLiteral(" is a simulation: nobody flies, and nothing is won or lost"));
}

/// One line a flight, and a sentence where nobody flew. Whether it ends as it did; of one of which that is not known,
/// whether it is won.
bool printFlight(const Level& level, const StoredFlight& flight) {
    const QString name = harmless(QString::fromStdString(flight.path.string()));
    if (!flight.replay) {
        complain(name, flight.unread);
        printLine(name + ": outcome=unreadable");
        return false;
    }
    const FlightResult result = flightResult(level, *flight.replay);
    const std::optional<FlightResult>& before = flight.replay->ended;
    const auto number = [](double value) { return QString::fromStdString(spelledNumber(value)); };
    if (flight.replay->kind == RunKind::Simulation && result.end != FlightEnd::Crowded) {
        tellOfSimulation(name);
        printLine(QStringLiteral("%1: outcome=simulation update=%2 seconds=%3")
                      .arg(name)
                      .arg(result.update)
                      .arg(number(result.seconds)));
        return true;
    }
    QString line = QStringLiteral("%1: outcome=%2 before=%3 news=%4 time=%5 fuel=%6 update=%7 seconds=%8")
                       .arg(name, QLatin1String(nameOf(result.end)),
                            before ? QLatin1String(nameOf(before->end)) : QLatin1String("unknown"),
                            nameOf(newsOf(before, result)), number(result.time), number(result.fuel))
                       .arg(result.update)
                       .arg(number(result.seconds));
    if (result.place) {
        line += QStringLiteral(" place=(%1, %2)").arg(number(result.place->x()), number(result.place->y()));
    }
    printLine(line);
    return result.end == (before ? before->end : FlightEnd::Won);
}

} // namespace

int replayCommand(const QStringList& arguments) {
    CommandLine line(QStringLiteral("replay"),
                     QStringLiteral("Flies a recorded flight. Exit status: 0 when it is won or is a simulation, 1 when "
                                    "it is not won, 2 when a file cannot be read."));
    line.parser.addOption(
        {QStringLiteral("dump"), QStringLiteral("Writes where every body is at the end."), QStringLiteral("OUT.json")});
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level file."), QStringLiteral("FILE"));
    line.parser.addPositionalArgument(QStringLiteral("replay"), QStringLiteral("Recorded flight."),
                                      QStringLiteral("REPLAY"));
    if (!line.read(arguments, 2, 2)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const QStringList files = line.parser.positionalArguments();
    const std::optional<Level> level = loadedLevel(files[0]);
    if (!level) {
        return exit_status::unusable;
    }
    const Result<Replay> replay = readReplay(toPath(files[1]), Sources::Any);
    if (!replay) {
        complain(files[1], replay.error());
        return exit_status::unusable;
    }
    const Outcome outcome = replayed(*level, replay.value());
    if (outcome.levelChanged) {
        complain(QStringLiteral("the level has been changed since the flight was recorded"));
    }
    const bool isSimulation = replay.value().kind == RunKind::Simulation;
    if (isSimulation) {
        tellOfSimulation(files[1]);
    }
    const char* result = isSimulation ? "simulation" : outcome.won() ? "won" : outcome.lost() ? "lost" : "running";
    const QString dump = line.parser.value(QStringLiteral("dump"));
    printBeside(dump, QStringLiteral("outcome=%1 time=%2 fuel=%3 lives=%4 hash=%5")
                          .arg(QLatin1String(result), QString::fromStdString(spelledNumber(outcome.time)),
                               QString::fromStdString(spelledNumber(outcome.fuel)))
                          .arg(outcome.lives)
                          .arg(hashText(outcome.hash)));
    if (!dump.isEmpty() && !dumpEnd(dump, *level, replay.value())) {
        return exit_status::unusable;
    }
    return isSimulation || outcome.won() ? exit_status::good : exit_status::bad;
}

int flightsCommand(const QStringList& arguments) {
    CommandLine line(
        QStringLiteral("flights"),
        QStringLiteral("Flies all flights that are stored beside levels: of cave.json cave.replay.json and "
                       "cave.NAME.replay.json, and tells how each ended when it was recorded. Exit status: 0 when all "
                       "end as they did (those of which that is not known: when they are won), 1 when not, 2 when a "
                       "level cannot be read."));
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level files."), QStringLiteral("FILE…"));
    if (!line.read(arguments, 1, -1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    int status = exit_status::good;
    for (const QString& file : line.parser.positionalArguments()) {
        const std::optional<Level> level = loadedLevel(file);
        if (!level) {
            return exit_status::unusable;
        }
        for (const StoredFlight& flight : flightsBeside(toPath(file))) {
            status = printFlight(*level, flight) ? status : exit_status::bad;
        }
    }
    return status;
}

} // namespace spacetow
