#include "editor/window/flight_reader.h"

#include "editor/window/application.h"
#include "editor/window/main_window.h"
#include "editor/window/messages.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

struct FlownWords {
    Q_DECLARE_TR_FUNCTIONS(DroppedFiles)
};

constexpr int tick = 200; // ms

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

} // namespace

FlightReader::FlightReader(MainWindow& window) : m_window(window) {
    QObject::connect(&m_ticks, &QTimer::timeout, &m_ticks, [this] {
        const bool failed = m_reading && !m_task.isRunning(); // for want of memory
        setReading(m_reading && !failed);
        if (failed) {
            m_window.messageBar().say(MessageBar::Tone::Error,
                                      FlownWords::tr("There is not enough memory to read the flight."));
            next();
        }
    });
}

void FlightReader::open(const QStringList& paths) {
    m_waiting = paths;
    next();
}

void FlightReader::leave() {
    m_waiting.clear();
    m_task.requestStop();
    setReading(false);
}

void FlightReader::finish() {
    while (m_task.isRunning()) {
        m_task.finish();
    }
}

void FlightReader::setReading(bool reading) {
    if (reading && !m_reading) {
        m_time.start();
        m_ticks.start(tick);
    } else if (!reading) {
        m_ticks.stop();
    }
    if (m_reading || reading) {
        m_reading = reading;
        changed();
    }
}

void FlightReader::next() {
    if (m_waiting.isEmpty()) {
        return;
    }
    setReading(true);
    m_again = m_task.isRunning();
    if (m_again) {
        m_task.requestStop();
        return;
    }
    std::vector<std::shared_ptr<const Level>> open;
    for (MainWindow* window : windowsFrom(m_window)) {
        open.push_back(window->document().current().level);
    }
    m_task.start([this, path = m_waiting.takeFirst(), open](const std::stop_token& stop) -> BackgroundTask::Then {
        Read read{path, readReplay(path.toStdU16String()), {}};
        for (const auto& level : open) {
            const bool isHashed = !stop.stop_requested() && read.replay && read.replay.value().levelHash;
            if (isHashed && levelHash(*level) == *read.replay.value().levelHash) {
                read.levels.push_back(level);
            }
        }
        return [this, read = std::move(read)] {
            if (m_again) {
                next();
            } else if (m_reading) {
                fly(read);
            }
        };
    });
}

MainWindow* FlightReader::windowFor(const Read& read) {
    const std::vector<MainWindow*> open = windowsFrom(m_window);
    const auto exact = std::ranges::find_if(open, [&read](MainWindow* one) {
        return std::ranges::find(read.levels, one->document().current().level) != read.levels.end();
    });
    const QString name = QString::fromStdString(read.replay.value().level);
    const auto named =
        std::ranges::find_if(open, [&name](MainWindow* one) { return one->files().nameInFlights() == name; });
    if (exact != open.end() || named != open.end()) {
        return exact != open.end() ? *exact : *named;
    }
    const QString path = levelFileFor(read.replay.value(), read.path);
    if (path.isEmpty()) {
        const QString words =
            read.replay.value().kind == RunKind::Simulation
                ? FlownWords::tr("%1 is a simulation of the level “%2”, which is neither open nor beside it. Open the "
                                 "level and drop the simulation on it.")
                : FlownWords::tr("%1 is a flight in the level “%2”, which is neither open nor beside it. Open the "
                                 "level and drop the flight on it.");
        m_window.messageBar().say(MessageBar::Tone::Error, words.arg(QFileInfo(read.path).fileName(), name));
        return nullptr;
    }
    return m_window.openAside(path);
}

/// The others come afterwards: what is flown here or there leaves what is being read.
void FlightReader::fly(const Read& read) {
    const QStringList rest = std::exchange(m_waiting, {});
    setReading(false);
    MainWindow* const place = read.replay ? windowFor(read) : nullptr;
    if (!read.replay) {
        m_window.messageBar().say(MessageBar::Tone::Error,
                                  sentence(QFileInfo(read.path).fileName(), read.replay.error()));
    }
    if (place != nullptr) {
        const Replay& replay = read.replay.value();
        const std::shared_ptr<const Level> level = place->document().current().level;
        const bool changed = replay.levelHash && std::ranges::find(read.levels, level) == read.levels.end() &&
                             levelHash(*level) != *replay.levelHash;
        place->comeForward();
        place->messageBar().dismiss();
        place->playReplay(replay);
        if (changed) {
            place->messageBar().say(MessageBar::Tone::Warning,
                                    replay.kind == RunKind::Simulation
                                        ? FlownWords::tr("The level has been changed since the simulation was "
                                                         "recorded, which may therefore go otherwise.")
                                        : FlownWords::tr("The level has been changed since the flight was recorded, "
                                                         "which may therefore end otherwise."));
        }
    }
    open(rest);
}

} // namespace spacetow
