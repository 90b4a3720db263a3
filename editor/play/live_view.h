#pragma once
// A run as the canvas shows it in place of its board: bodies, the range of the rope, the head-up display of a game, the
// menu over one that is held. It lets the canvas's view follow the ship, and hands keys and mouse on.

#include "editor/canvas/canvas.h"
#include "editor/canvas/disc_stamps.h"
#include "editor/canvas/label_painter.h"
#include "editor/canvas/live_scene.h"
#include "editor/play/ground_picture.h"
#include "editor/play/live_hand.h"
#include "editor/play/live_overlays.h"
#include "editor/play/live_run.h"

#include <QElapsedTimer>

namespace spacetow {

class PauseMenu;

class LiveView : public QObject, public LiveScene {
    Q_OBJECT

  public:
    /// All of them must outlive the view.
    LiveView(Document& document, Toolbox& toolbox, Canvas& canvas, LiveRun& run);
    ~LiveView() override;

    /// What runs, in place of the board. `anew`: nobody has looked at the level yet, so the classic view is taken; so
    /// it is where the ship could not be seen.
    void show(const Level& level, bool anew);
    /// What is not a body: background and ranges. The level may be edited while it runs.
    void knowLevel(const Level& level);
    /// The board again, with the view that it had.
    void hide();
    bool isShown() const { return m_shown; }

    /// Whether the view goes with the ship: until somebody moves it.
    bool isFollowing() const { return m_following; }
    /// Goes with the ship again, at the zoom that the run began with.
    void follow();
    /// Without letting go of the ship, as when the canvas has come to lie elsewhere on the screen; pixels.
    void shiftView(const Vec2& pixels);
    void setOverlays(const OverlayFlags& overlays);
    /// Whether there are ways to be shown: of a run that is held, or in futures given up.
    bool hasWays() const;
    void setKeys(const PlayKeys& keys);
    /// Shows what the run has come to; it does so by itself at the display's rate.
    void refresh();
    /// Whether overlays of a crowd are being painted beside the window.
    bool isPaintingOverlays() const { return m_marks.isPainting(); }
    /// What is shown of the run.
    const Snapshot& picture() const { return m_picture; }
    /// These objects where they are in it; what is being dragged, as far from there as it has been dragged.
    Level posedShown(std::span<const Key> keys) const;
    LiveHand& hand() { return m_hand; }
    const LiveHand& hand() const { return m_hand; }

    void paint(QPainter& painter, const Frame2D& frame) override;
    void paintOver(QPainter& painter, const Frame2D& frame) override;
    bool showsTool() const override;
    bool isGame() const override { return m_run.isGame(); }
    LeftOut leftOut() const override { return m_leftOut; }
    CursorShape cursor() const override;
    bool take(QEvent& event) override;

  signals:
    /// The player wants to go back to the editor; the run has been stopped.
    void finished();
    void followingChanged();
    /// How often it was painted in the last second.
    void framesCounted(double perSecond);

  private:
    /// What the view shows in a window of any size, until somebody moves it: the classic part of the level, all of it,
    /// or nothing in particular.
    enum class Framing { Free, Classic, Whole };
    struct Paper {
        Frame2D frame;
        const Theme* theme = nullptr;
        double gridStep = 0; // m; 0 for no grid

        bool operator==(const Paper&) const = default;
    };

    bool takeKey(QKeyEvent& event);
    bool takeGameKey(QKeyEvent& event);
    bool takeSimulationKey(QKeyEvent& event);
    bool takeCommand(PlayKey meaning);
    bool takeTransport(PlayKey meaning, const QKeyEvent& event);
    bool takeMouse(QEvent& event);
    bool takePress(const Pointer& pointer);
    void focusLeft(Qt::FocusReason reason);
    void openMenu();
    void closeMenu();
    void moveView(const Viewport& view);
    void viewMoved();
    void setFollowing(bool following);
    void frame();
    bool isSteering() const;
    void countFrame();
    const Theme& theme() const;
    void seeOverlays(const Frame2D& frame);
    void takePicture();
    void paintWords(const Stage& stage) const;
    bool isTransportKey(const QKeyEvent& event) const;
    void drawPaper(QPainter& painter, const Paper& wanted);
    void paintHold(const Stage& stage, LabelPainter& labels) const;

    Document& m_document;
    Toolbox& m_toolbox;
    Canvas& m_canvas;
    LiveRun& m_run;
    LiveHand m_hand;
    PauseMenu* m_menu; // owned by the canvas
    OverlayFlags m_overlays;
    std::shared_ptr<const Frame> m_frame; // of the run, newest, while an overlay needs its session
    LiveOverlays m_marks;
    std::shared_ptr<const Snapshot> m_marked; // that the canvas was told of last
    GroundPicture m_ground;
    DiscStamps m_discs;
    LeftOut m_leftOut;
    Paper m_paperOf;
    QPixmap m_paper; // the board below a simulation
    Snapshot m_picture;
    QString m_background;
    QString m_goal;        // what the level says of itself
    double m_towRange = 0; // m
    Aabb m_bounds;         // of the level
    Viewport m_lastView;
    double m_firstScale = 1; // px a metre, with which the run began
    QElapsedTimer m_sinceLook;
    std::int64_t m_lastUpdate = 0;
    QElapsedTimer m_sinceCount;
    int m_frames = 0; // painted since
    bool m_shown = false;
    bool m_following = true;
    Framing m_framing = Framing::Free;
    bool m_moving = false;   // by this
    quint32 m_rewindKey = 0; // while it is held
};

} // namespace spacetow
