#include "editor/window/level_pictures.h"

#include "core/level/file.h"

#include <QFile>
#include <QFileInfo>

namespace spacetow {

namespace {

std::optional<Level> levelIn(const QString& path) {
    if (!path.startsWith(QLatin1Char(':'))) {
        Result<LevelFile> file = readLevel(path.toStdU16String(), Checks::FileOnly);
        return file ? std::move(file).value().level : std::nullopt;
    }
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? parseLevel(file.readAll().toStdString(), Checks::FileOnly).level
                                          : std::nullopt;
}

} // namespace

QPixmap LevelPictures::picture(const QString& path, const PictureSize& size, Shade shade) {
    const Wanted wanted{path, QFileInfo(path).lastModified(), size, shade};
    const auto [place, isNew] = m_pictures.try_emplace(wanted.id());
    if (isNew) {
        m_queue.push_back(wanted);
        paintNext();
    }
    return place->second;
}

bool LevelPictures::isUnreadable(const QString& path) const {
    const auto found = m_unreadable.find(path);
    return found != m_unreadable.end() && found->second;
}

void LevelPictures::paintNext() {
    if (m_task.isRunning() || m_queue.empty()) {
        return;
    }
    const Wanted wanted = m_queue.front();
    m_queue.pop_front();
    m_task.start([this, wanted](const std::stop_token&) -> BackgroundTask::Then {
        const std::optional<Level> level = levelIn(wanted.path);
        const QImage image = level ? levelPicture(*level, wanted.size, wanted.shade) : QImage();
        return [this, wanted, image] {
            m_pictures[wanted.id()] = QPixmap::fromImage(image);
            m_unreadable[wanted.path] = image.isNull();
            paintNext();
            Q_EMIT painted(wanted.path);
        };
    });
}

void LevelPictures::finish() {
    while (m_task.isRunning()) {
        m_task.finish();
    }
}

} // namespace spacetow
