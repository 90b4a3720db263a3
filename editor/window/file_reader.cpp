#include "editor/window/file_reader.h"

#include "editor/panels/number_text.h"
#include "editor/window/message_bar.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <numeric>
#include <utility>

namespace spacetow {

namespace {

struct ReaderWords {
    Q_DECLARE_TR_FUNCTIONS(FileReader)
};

constexpr int readerTick = 200; // ms
constexpr int patience = 500;   // ms, before the window offers to leave what it reads

/// Of what is going to be read; what is no file, or too large for one, is refused at once.
qint64 bytesToRead(const QStringList& paths) {
    return std::accumulate(paths.begin(), paths.end(), qint64{0}, [](qint64 sum, const QString& path) {
        const QFileInfo file(path);
        const bool isRead = file.isFile() && file.size() <= static_cast<qint64>(maxLevelBytes);
        return sum + (isRead ? file.size() : 0);
    });
}

} // namespace

FileReader::FileReader(MessageBar& bar) : m_bar(bar) {
    QObject::connect(&m_ticks, &QTimer::timeout, &m_ticks, [this] { tick(); });
}

void FileReader::read(const QStringList& paths, Then then) {
    if (bytesToRead(paths) <= small) {
        then(std::vector<FileToOpen>(paths.begin(), paths.end()));
        return;
    }
    m_waiting.push_back({paths, std::move(then)});
    if (m_waiting.size() == 1) {
        next();
    }
}

void FileReader::next() {
    m_time.start();
    m_ticks.start(readerTick);
    tell();
    if (m_task.isRunning()) {
        return; // on what was left; it begins when that has ended
    }
    m_task.start([this, paths = m_waiting.front().paths,
                  generation = m_generation](const std::stop_token& stop) -> BackgroundTask::Then {
        std::vector<FileToOpen> files;
        for (const QString& path : paths) {
            if (!stop.stop_requested()) {
                files.push_back(readWhole(path));
            }
        }
        return [this, files = std::move(files), generation] {
            if (generation == m_generation) {
                arrived(files);
            } else if (isReading()) {
                next();
            }
        };
    });
}

void FileReader::arrived(const std::vector<FileToOpen>& files) {
    const Wish wish = std::move(m_waiting.front());
    m_waiting.pop_front();
    dismiss();
    if (isReading()) {
        next();
    }
    tell();
    wish.then(files);
}

/// Where there was not enough memory, nothing arrives.
void FileReader::tick() {
    if (!m_task.isRunning()) {
        leave();
        m_bar.say(MessageBar::Tone::Error, ReaderWords::tr("There is not enough memory to open the file."));
        return;
    }
    if (m_said.isEmpty() && m_time.elapsed() >= patience) {
        m_said = ReaderWords::tr("%1 is being read…").arg(subject());
        m_bar.say(MessageBar::Tone::Info, m_said, {{ReaderWords::tr("Cancel"), [this] { leave(); }}});
    }
    tell();
}

void FileReader::leave() {
    if (!isReading()) {
        return;
    }
    const std::deque<Wish> left = std::exchange(m_waiting, {});
    ++m_generation;
    m_task.requestStop();
    dismiss();
    tell();
    for (const Wish& wish : left) {
        wish.then({});
    }
}

void FileReader::dismiss() {
    m_ticks.stop();
    if (!m_said.isEmpty() && m_bar.text() == std::exchange(m_said, {})) {
        m_bar.dismiss();
    }
}

void FileReader::tell() {
    if (changed) {
        changed();
    }
}

QString FileReader::subject() const {
    if (!isReading()) {
        return {};
    }
    const QStringList& paths = m_waiting.front().paths;
    const auto largest =
        std::ranges::max_element(paths, {}, [](const QString& path) { return QFileInfo(path).size(); });
    const QFileInfo file(*largest);
    return QStringLiteral("%1 (%2)").arg(file.fileName(), sizeText(file.size()));
}

void FileReader::finish() {
    while (m_task.isRunning()) {
        m_task.finish();
    }
}

} // namespace spacetow
