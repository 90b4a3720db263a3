#pragma once
// One piece of work that was found in the journal, as a row of the recovery bar: its picture, name, place and time.

#include "core/level/level.h"
#include "editor/editing/journal.h"

#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include <memory>

namespace spacetow {

struct FoundWork {
    Orphan orphan;
    std::shared_ptr<const Level> level; // null when it cannot be read
    QImage picture;
};

class RecoveryRow : public QWidget {
    Q_OBJECT

  public:
    explicit RecoveryRow(FoundWork found);

    /// Of the picture, in device pixels.
    static QSize pictureSize(double pixelRatio);

    const FoundWork& found() const { return m_found; }
    /// What comparing has found.
    void explain(const QString& text);
    QString explanation() const { return m_explanation.text(); }
    QString details() const { return m_details.text(); }
    void setDiscarded(bool discarded);

    QToolButton restore, compare, discard, undo;

  private:
    FoundWork m_found;
    QHBoxLayout m_row;
    QVBoxLayout m_column;
    QHBoxLayout m_buttons;
    QLabel m_picture, m_name, m_details, m_explanation;
};

} // namespace spacetow
