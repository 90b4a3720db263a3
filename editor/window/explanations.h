#pragma once
// The panels that explain what runs, and what feeds them: the session of the run or, while nothing runs, the one that
// the level would start with. They ask for what they need only while they can be seen.

#include "core/game/runner.h"
#include "editor/canvas/canvas.h"
#include "editor/canvas/start_session.h"
#include "editor/panels/explain_panel.h"
#include "editor/panels/plot_panel.h"
#include "editor/panels/profile_panel.h"
#include "editor/panels/tag_matrix_panel.h"

#include <QObject>

#include <functional>
#include <memory>

namespace spacetow {

class Explanations : public QObject {
  public:
    /// All must outlive it.
    Explanations(Document& document, Canvas& canvas, TagMatrixPanel& matrix);
    ~Explanations() override;

    ExplainPanel& panel() { return m_panel; }
    PlotPanel& plots() { return m_plots; }
    ProfilePanel& profile() { return m_profile; }

    /// Asks for the place of a table, suggesting one; empty: nowhere after all. To be set before plots are exported.
    std::function<QString(const QString&)> whereToWrite;

    /// Whether any of them can be seen.
    bool wantsSession() const;
    bool wantsProfile() const { return m_profile.isVisible(); }

    /// Of the run, with its session; the level may be edited meanwhile.
    void showRun(const std::shared_ptr<const Frame>& frame);
    /// Whether anything runs; comes before what runs is shown.
    void setRuns(bool runs);

    /// As the level would start, while nothing runs and somebody looks.
    StartSession& start() { return m_start; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Who can be seen, or whether anything runs, has changed.
    void look();
    void showStart();
    void showForces();

    Canvas& m_canvas;
    TagMatrixPanel& m_matrix;
    ExplainPanel m_panel;
    PlotPanel m_plots;
    ProfilePanel m_profile;
    std::shared_ptr<const Session> m_session;
    std::shared_ptr<const Frame> m_frame; // of the run, shown last
    bool m_runs = false;
    bool m_wantsStart = false;
    StartSession m_start;
};

} // namespace spacetow
