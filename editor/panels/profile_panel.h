#pragma once
// Where the time of an update goes, by stage: now, on average and at most, with a strip chart; and how much there is to
// do.

#include "core/game/session.h"
#include "core/game/step_profile.h"

#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWidget>

#include <memory>

namespace spacetow {

/// The last updates as bars, each of its stages on top of one another.
class ProfileChart : public QWidget {
    Q_OBJECT

  public:
    explicit ProfileChart(QWidget* parent = nullptr);

    /// `period`: s between two updates, beyond which the game falls behind.
    void setProfile(std::shared_ptr<const StepProfile> profile, double period);
    /// That stands at the top of the chart, s.
    double top() const { return m_top; }

    static QColor stageColor(StepStage stage, const QPalette& palette);

    QSize sizeHint() const override { return {300, 110}; }
    QSize minimumSizeHint() const override { return {120, 60}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::shared_ptr<const StepProfile> m_profile;
    double m_period = 0.02;
    double m_top = 0.001;
};

class ProfilePanel : public QWidget {
    Q_OBJECT

  public:
    explicit ProfilePanel(QWidget* parent = nullptr);

    /// Null for what there is not.
    void showSession(std::shared_ptr<const Session> session, std::shared_ptr<const StepProfile> profile);
    void refresh();

    QTreeWidget& rows() { return m_rows; }
    ProfileChart& chart() { return m_chart; }

    QSize sizeHint() const override { return {320, 300}; }
    QSize minimumSizeHint() const override { return {200, 140}; }

  protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void fill();
    void tint();
    void showTimes();
    void showCounters();

    QVBoxLayout m_column;
    ProfileChart m_chart;
    QTreeWidget m_rows;
    QTreeWidgetItem* m_total = nullptr; // owned by the tree
    QTimer m_pause;
    bool m_stale = false;
    std::shared_ptr<const Session> m_session;
    std::shared_ptr<const StepProfile> m_profile;
};

} // namespace spacetow
