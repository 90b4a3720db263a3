#pragma once
// Plots of a running session: any quantity of the selected body or connector, and of everything together. Several
// curves in one plot, one against another, and a file of them.

#include "core/game/course.h"
#include "core/game/plot_history.h"
#include "editor/editing/document.h"
#include "editor/panels/plot_view.h"
#include "editor/panels/wrapping_row.h"

#include <QComboBox>
#include <QLabel>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include <memory>
#include <vector>

namespace spacetow {

class PlotPanel : public QWidget {
    Q_OBJECT

  public:
    /// The document must outlive the panel.
    explicit PlotPanel(Document& document, QWidget* parent = nullptr);
    ~PlotPanel() override;

    /// What goes on; a run that begins after a pause without one starts with an empty plot. `runs`: it is not merely
    /// the session that the level would start with.
    void showSession(std::shared_ptr<const Session> session, bool runs);
    /// Comes before the sessions that are on it.
    void showTimeline(const TimelineSummary& timeline);

    void add(const PlotSource& source);
    void remove(std::size_t curve);
    const PlotHistory& history() const { return m_history; }
    PlotView& view() { return m_view; }
    QComboBox& quantities() { return m_quantities; }
    QToolButton& addButton() { return m_add; }
    QToolButton& phaseButton() { return m_phase; }
    QToolButton& exportButton() { return m_export; }
    QLabel& totals() { return m_totals; }
    /// Buttons of the curves, which remove them.
    std::vector<QToolButton*> curveButtons() const;

    QSize sizeHint() const override { return {360, 260}; }
    /// The curves keep their room, however many lines their names take: what is more than the panel is high scrolls.
    QSize minimumSizeHint() const override { return {240, 120}; }

  Q_SIGNALS:
    /// The user wants the table as a file.
    void exportWanted(const QByteArray& csv);

  protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void layOut();
    void offerQuantities();
    void showCurves();
    void showTotals();
    QStringList names() const;
    Key selected() const;

    Document& m_document;
    PlotHistory m_history;
    std::shared_ptr<const Session> m_session;
    bool m_runs = false;
    int m_futures = 0;       // that are known to have begun
    bool m_inUpdate = false; // what is shown is in the middle of one
    QVBoxLayout m_all;
    QScrollArea m_scroll;
    QWidget m_page;
    QVBoxLayout m_column;
    WrappingRow* m_row;    // owned by the column
    WrappingRow* m_curves; // likewise
    QComboBox m_quantities;
    QToolButton m_add, m_phase, m_export, m_clear;
    PlotView m_view;
    QLabel m_totals;
    std::vector<std::unique_ptr<QToolButton>> m_buttons;
    std::vector<PlotSource> m_offered;
    int m_listener = 0;
};

} // namespace spacetow
