#include "editor/window/flight_file.h"

#include "core/game/codes.h"
#include "editor/panels/number_text.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

namespace spacetow {

namespace {

struct FlightWords {
    Q_DECLARE_TR_FUNCTIONS(FlightFile)
};

} // namespace

QString FlightFile::savedWords(const QString& file, const Recording& recording) {
    const QString words = recording.run.kind == RunKind::Simulation
                              ? FlightWords::tr("The simulation has been saved as %1. Drop the file on a window to see "
                                                "it again.")
                              : FlightWords::tr("The flight has been saved as %1. Drop the file on a window to see it "
                                                "again.");
    const QString saved = words.arg(file);
    if (recording.isWhole()) {
        return saved;
    }
    return saved + QLatin1Char(' ') +
           FlightWords::tr("It ends after %1 of %2 updates: a file holds no more.")
               .arg(countText(recording.run.updates()), countText(recording.updates));
}

void FlightFile::save() {
    if (m_task.isRunning()) {
        m_window.messageBar().say(MessageBar::Tone::Info, FlightWords::tr("Another recording is still being saved."));
        return;
    }
    const bool hasFile = !m_window.files().path().isEmpty();
    const QString levelPath = hasFile ? m_window.files().path() : m_window.files().name();
    const QString folder = hasFile ? QFileInfo(levelPath).path() : QDir::homePath();
    m_window.liveRun().setPaused(true); // while one looks for a name, the ship would fall
    const QString suggested = QFileInfo(levelPath).completeBaseName() + QStringLiteral(".replay.json");
    QString path = m_window.whereToSaveFlight(QDir(folder).filePath(suggested));
    Runner* const runner = m_window.liveRun().runner();
    if (path.isEmpty() || runner == nullptr) {
        return;
    }
    if (!path.endsWith(QStringLiteral(".json"), Qt::CaseInsensitive)) {
        path += QStringLiteral(".replay.json");
    }
    const std::string name = m_window.files().nameInFlights().toStdString();
    m_task.start([this, path, name, ask = runner->askRecording(), kind = m_window.liveRun().kind(),
                  now = m_window.document().current().level](const std::stop_token&) -> BackgroundTask::Then {
        Recording recording = ask();
        recording.run.kind = kind;
        Error error{GameCode("capsule-no-run"), {}};
        if (recording.start) { // the level may have been edited since: the flight then begins with becoming what it was
            Replay replay = basedOn(recording.run, *recording.start, *now);
            replay.level = name;
            replay.levelHash = levelHash(*now);
            const std::optional<Error> failed = writeReplay(path.toStdU16String(), replay);
            if (!failed) {
                return [this, path, recording] { say(path, recording); };
            }
            error = *failed;
        }
        return [this, error] { m_window.messageBar().say(MessageBar::Tone::Error, sentence(error)); };
    });
}

void FlightFile::say(const QString& path, const Recording& recording) {
    m_window.flights().setFile(m_window.files().path()); // it may stand beside the level
    m_window.messageBar().say(recording.isWhole() ? MessageBar::Tone::Info : MessageBar::Tone::Warning,
                              savedWords(QFileInfo(path).fileName(), recording));
}

} // namespace spacetow
