#pragma once
// A game or sandbox running in the window, on a copy of the level. The view owns the runner, turns keys into controls
// and paints the newest two snapshots blended at the display's rate. Circles stay round in any window; at least the
// classic view, 13.33 × 10 m, can be seen.

#include "core/game/runner.h"
#include "editor/canvas/background_task.h"
#include "editor/canvas/overlay_flags.h"
#include "editor/editing/viewport.h"
#include "editor/play/ground_picture.h"
#include "editor/play/key_map.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <memory>
#include <optional>
#include <vector>

namespace spacetow {

class PauseMenu;

class PlayView : public QWidget {
    Q_OBJECT

  public:
    /// With a manual runner nothing moves but by Runner::advance, for tests and screenshots.
    explicit PlayView(QWidget* parent = nullptr, Runner::Mode mode = Runner::Mode::Threaded);
    ~PlayView() override;

    /// Plays the level from its beginning; what was playing before is stopped.
    void start(const Level& level);
    /// The same as it was flown once; what is held down counts when the recording has ended.
    void start(const Level& level, const Replay& recorded);
    /// Ends the game, if there is one. `finished` is not emitted. Of a level that is too much an update takes seconds;
    /// nobody waits for the one that is running.
    void stop();
    /// Games whose last update has not ended yet.
    int ending() const;
    bool isRunning() const { return m_runner != nullptr; }

    /// Without the menu, so that the scene stays in sight.
    void setPaused(bool paused);
    bool isPaused() const { return m_paused; }
    /// The game waits while something else in the window has the keyboard, and then is as it was before.
    void setWaiting(bool waiting);
    /// Pauses and makes one update.
    void stepOnce();
    void restart();
    void setOverlays(const OverlayFlags& overlays);
    void setKeys(const PlayKeys& keys);

    /// Sandbox while nothing is played.
    Phase phase() const;
    /// How many have been made that can be seen; 0 while nothing is played.
    std::int64_t updates() const { return m_runner ? m_runner->frame()->now->update : 0; }
    /// By how many seconds the game is behind real time, while it falls back further; 0 while it keeps up.
    double behind() const { return m_behind; }
    /// Null while nothing is played.
    Runner* runner() { return m_runner.get(); }
    /// What the view would show of the world now.
    Viewport viewport() const;

    QSize minimumSizeHint() const override { return {160, 120}; }
    QSize sizeHint() const override { return {880, 660}; }

  signals:
    /// The player wants to go back to the editor; the game has been stopped.
    void finished();
    void pausedChanged(bool paused);
    /// Seen at the display's rate.
    void phaseChanged();
    /// Seen once a second.
    void paceChanged();
    /// The game could not go on, and has been stopped.
    void failed(spacetow::RunnerFault fault);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

  private:
    void begin(const Level& level, std::uint64_t seed);
    Snapshot picture() const;
    void showFrame();
    void watchPace();
    void fail(RunnerFault fault);
    void paintScene(QPainter& painter, const Snapshot& snapshot);
    void tapIfOver();
    void openMenu();
    void closeMenu();
    void letGo();
    void goOn();
    void follow();
    double fittingScale() const;
    Viewport viewport(const Snapshot& snapshot) const;
    Vec2 framed(const Snapshot& snapshot, double scale) const;

    const Runner::Mode m_mode;
    std::unique_ptr<Runner> m_runner;
    std::vector<std::unique_ptr<BackgroundTask>> m_ending;
    PauseMenu* m_menu; // owned by Qt as a child
    QTimer m_frames;
    OverlayFlags m_overlays;
    GroundPicture m_ground;
    PlayKeys m_keys;
    HeldKeys m_held;
    QString m_background;
    double m_towRange = 0;        // m
    Vec2 m_extent{13.333333, 10}; // m, seen at least
    Phase m_shownPhase = Phase::Sandbox;
    QElapsedTimer m_paceTime; // since it was looked at
    double m_lost = 0;        // s, at that time
    double m_behind = 0;      // s
    bool m_paused = false;
    bool m_waiting = false; // though not paused
    Aabb m_bounds;          // of the level; empty where nothing is to be followed
    double m_zoom = 1;
    std::optional<Vec2> m_lookedAt; // world point in the middle, when the player has moved the view
    QPointF m_dragged;
    bool m_dragging = false;
};

} // namespace spacetow
