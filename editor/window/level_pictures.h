#pragma once
// Pictures of level files, read and painted by a thread beside the window, one after the other, and kept for as long
// as the files stay as they are.

#include "editor/canvas/background_task.h"
#include "editor/canvas/level_picture.h"

#include <QDateTime>
#include <QObject>
#include <QPixmap>

#include <deque>
#include <map>
#include <tuple>

namespace spacetow {

class LevelPictures : public QObject {
    Q_OBJECT

  public:
    /// At once where it is known; else a null one, and `painted` follows. The path may be that of a resource.
    QPixmap picture(const QString& path, const PictureSize& size, Shade shade);
    /// The file holds no level that could be painted.
    bool isUnreadable(const QString& path) const;
    /// Waits for all that was asked for.
    void finish();

  Q_SIGNALS:
    void painted(const QString& path);

  private:
    using Id = std::tuple<QString, QDateTime, int, double, Shade>;
    struct Wanted {
        QString path;
        QDateTime changed; // when the file was
        PictureSize size;
        Shade shade;

        Id id() const { return {path, changed, size.logical.width(), size.ratio, shade}; }
    };

    void paintNext();

    std::map<Id, QPixmap> m_pictures; // null: not yet, or unreadable
    std::map<QString, bool> m_unreadable;
    std::deque<Wanted> m_queue;
    BackgroundTask m_task;
};

} // namespace spacetow
