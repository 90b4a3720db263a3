#pragma once
// Offers what former runs have left in the journal: to restore, to compare with the file, to discard. A bar above the
// canvas; who closes it is offered the same next time.

#include "editor/canvas/background_task.h"
#include "editor/editing/journal.h"
#include "editor/window/recovery_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include <functional>
#include <vector>

namespace spacetow {

class RecoveryBar : public QWidget {
    Q_OBJECT

  public:
    /// Opens what was found, not saved, and has it in a journal of its own already; false when the user would rather
    /// keep what is open.
    using Restore = std::function<bool(const JournalEntry&)>;

    /// Shows on a canvas what differs between the file of the entry and the level that was found.
    using Show = std::function<void(const JournalEntry&, const std::shared_ptr<const Level>& found)>;

    RecoveryBar(std::filesystem::path folder, Restore restore);
    void setShow(Show show) { m_show = std::move(show); }

    /// Looks for what there is, by a thread beside, and comes up when there is something; the keyboard goes there if
    /// it was called for.
    void look(bool calledFor = false);
    bool isLooking() const { return m_task.isRunning(); }
    /// Those that are offered, newest first.
    std::vector<RecoveryRow*> rows() const;

    void restore(RecoveryRow& row);
    void compare(RecoveryRow& row);
    void discard(RecoveryRow& row);
    void bringBack(RecoveryRow& row);

  Q_SIGNALS:
    void closed();
    void nothingFound();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void layOut();
    void dress();
    void fill(std::vector<FoundWork> found);
    void remove(RecoveryRow& row);
    void fitHeight();

    bool m_calledFor = false;
    std::filesystem::path m_folder;
    Restore m_restore;
    Show m_show;
    QVBoxLayout m_column;
    QHBoxLayout m_header;
    QLabel m_icon;
    QLabel m_title;
    QToolButton m_close;
    QScrollArea m_scroll;
    QWidget* m_list; // in the scroll area, which owns it
    QVBoxLayout* m_rows;
    BackgroundTask m_task; // last, so that it has ended before the rest goes
};

} // namespace spacetow
