#pragma once
// Keeps the fan of where the ship can be on the canvas, for as long as it is switched on: from its start while editing,
// from where it is while a run is paused. It is worked out beside the window.

#include "editor/canvas/background_task.h"
#include "editor/canvas/canvas.h"
#include "editor/editing/document.h"
#include "editor/play/live_run.h"

#include <memory>

namespace spacetow {

class ReachView : public QObject {
    Q_OBJECT

  public:
    static constexpr int shortest = 1, longest = 5; // s

    /// All of them must outlive it.
    ReachView(Document& document, Canvas& canvas, LiveRun& run);
    ~ReachView() override;

    void setOn(bool on);
    bool isOn() const { return m_on; }
    /// How far it looks ahead; kept within `shortest` … `longest`.
    void setSeconds(int seconds);
    int seconds() const { return m_seconds; }
    /// Waits for what is being worked out.
    void finish();

  private:
    struct Subject {
        std::shared_ptr<const Level> level;     // while nothing runs
        std::shared_ptr<const Session> session; // while a run is paused
        Controls held;
        int seconds = 0;

        bool operator==(const Subject&) const = default;
    };

    Subject wanted();
    void refresh();
    void begin();

    Document& m_document;
    Canvas& m_canvas;
    LiveRun& m_run;
    bool m_on = false;
    int m_seconds = 2;
    Subject m_subject; // that is shown, or worked out
    bool m_isStale = false;
    int m_listener = 0;
    BackgroundTask m_task; // last, so that nothing is shown by who is gone
};

} // namespace spacetow
