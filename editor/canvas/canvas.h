#pragma once
// The drawing board: shows the document, hands mouse and keys to the toolbox, and moves the view. Positions of the
// mouse are logical pixels; the world is in metres.

#include "core/level/problem_place.h"
#include "core/physics/query/overlay_flags.h"
#include "editor/canvas/board.h"
#include "editor/canvas/difference_painter.h"
#include "editor/canvas/edge_scroll.h"
#include "editor/canvas/entry_box.h"
#include "editor/canvas/force_painter.h"
#include "editor/canvas/live_scene.h"
#include "editor/canvas/overlay_palette.h"
#include "editor/canvas/reach_painter.h"
#include "editor/editing/document.h"
#include "editor/editing/toolbox.h"
#include "editor/editing/viewport.h"

#include <QPixmap>
#include <QPointF>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QNativeGestureEvent;

namespace spacetow {

class Canvas : public QWidget {
    Q_OBJECT

  public:
    /// Document and toolbox must outlive the canvas.
    Canvas(Document& document, Toolbox& toolbox, QWidget* parent = nullptr);
    ~Canvas() override;

    const Viewport& view() const { return m_view; }
    /// As it is painted.
    Frame2D frame() const;
    void setView(const Viewport& view);
    bool isGridVisible() const { return m_grid; }
    void setGridVisible(bool visible);
    void setOverlays(const OverlayFlags& overlays);
    const OverlayPalette& overlayPalette() const { return m_overlayPalette; }
    void setOverlayPalette(const OverlayPalette& palette);
    /// Objects that are marked without being selected; the keys are ascending.
    void setHighlighted(std::vector<Key> keys);
    const std::vector<Key>& highlighted() const { return *m_highlighted; }
    /// What to say in the middle of a level in which there is nothing yet.
    void setBeginning(const QString& words) { m_beginning = words; }
    /// Over the level, until null is given.
    void setDifference(std::shared_ptr<const ShownDifference> difference);
    /// Over the level, and over what runs in place of it, until null is given.
    void setReach(std::shared_ptr<const ShownReach> reach);
    const ShownReach* reach() const { return m_reach.get(); }
    /// Places of problems, drawn while the overlay is on, and which problem somebody looks at (−1: none).
    void setProblems(std::shared_ptr<const std::vector<ProblemMark>> marks, int current);
    /// Of the body that is explained; none to show none.
    void setForces(std::vector<ForceArrow> arrows);
    const std::vector<ForceArrow>& forces() const { return m_forces; }
    bool areGuidesVisible() const { return m_toolbox.guidesVisible; }
    void setGuidesVisible(bool visible);

    /// Shows the scene in place of the board, which comes back with null, and with it the view that it had. The scene
    /// must outlive its being shown.
    void showLive(LiveScene* scene);
    bool isLive() const { return m_live != nullptr; }
    /// Whether the view shows all of the level, in a window of any size, since nobody has moved it.
    bool isFitted() const { return m_live == nullptr ? m_fitted : m_kept.fitted; }
    /// See Board.
    PictureLayer groundPicture(bool onRock) const { return m_board.groundPicture(onRock); }
    /// What overlays have left out here and now.
    const LeftOut& leftOut() const { return m_leftOut; }

    /// A drag that began on a ruler and goes on here. Positions are global; a guide of this angle comes out of it.
    void beginGuide(double angle, const QPointF& global, Qt::KeyboardModifiers modifiers);
    void dragGuide(const QPointF& global, Qt::KeyboardModifiers modifiers);
    void endGuide(const QPointF& global, Qt::KeyboardModifiers modifiers);
    /// What to call a thing that a point has snapped to; it stands beside the marker.
    void setSnapNames(std::function<QString(const SnapAnswer&)> name) { m_snapName = std::move(name); }

    /// About the middle of the view; out no further than until the level is only just seen.
    void zoom(double factor);
    void zoomTo(double scale); // pixels a metre
    /// The whole level in view, and again whenever the canvas changes its size, until the view is moved.
    void fitLevel();
    /// Another level has been opened: all of it in view, and nothing of the one before, not even for a moment.
    void showAnew();
    /// Waits for what is being painted beside, and paints it.
    void finishPainting();
    void centerSelection();
    void frameSelection();
    /// Moves the view so that all of the place can be seen, and not only as a dot.
    void showPlace(std::span<const Vec2> place);

    /// A button is down that moves something or the view. Nothing else acts until it is up, or the mouse is lost.
    bool isDragging() const { return m_drag != Drag::None; }
    /// The view is what a drag moves now, or would move.
    bool isPanning() const { return m_drag == Drag::Pan || m_spaceHeld; }
    /// Ends a drag without its release: what it moved is back where it was.
    void loseMouse();
    EdgeScroll& edgeScroll() { return m_edgeScroll; }
    /// As if the key had been pressed on the canvas.
    void toolKey(ToolKey key);

    /// Where the pointer is or was last, in world coordinates; the middle of the view before it ever came.
    Vec2 pointerPosition() const;
    /// As if the pointer were there, in pixels, until it moves again.
    void pointAt(const QPointF& position) { m_position = position; }
    Pointer pointerAt(const QPointF& position, Qt::KeyboardModifiers modifiers) const;
    /// As what the mouse would do now has it.
    void updateCursor();

    QSize sizeHint() const override { return {880, 660}; }

  signals:
    void pointerMoved(double x, double y); // m
    /// The place that a click would take or a release reach: where the pointer snaps, else the pointer.
    void pointed(double x, double y, int decimals);
    void pointerLeft();
    void viewChanged();
    void leftOutChanged();
    void menuWanted(const QPoint& global);
    void menuKeyPressed(); // at what is selected
    /// Somebody wants to type where this guide is.
    void guideOpened(std::size_t index);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

  private:
    enum class Drag { None, Tool, Guide, Pan, PanOrMenu };
    struct Still {
        Frame2D frame;
        const Theme* theme = nullptr;
        double gridStep = 0; // m; 0 for no grid
        int revision = 0;    // of the board

        bool operator==(const Still&) const = default;
    };

    void tellPlace();
    void scrollAtEdge(const QPointF& push);
    void moveTo(const QPointF& position, Qt::KeyboardModifiers modifiers);
    void modifiersChanged(Qt::KeyboardModifiers modifiers);
    void zoomAt(const Vec2& screen, double factor);
    bool nativeGesture(const QNativeGestureEvent& event);
    bool pressToolKey(int key);
    bool opensEntry(const QKeyEvent& event) const;
    bool nudge(int key, Qt::KeyboardModifiers modifiers);
    void panBy(const QPointF& pixels);
    void paintLive(QPainter& painter, const Frame2D& frame);
    void paintFocus(QPainter& painter) const;
    void composeStill(const Still& wanted);
    void tellLeftOut(const LeftOut& leftOut);
    void drawProblems(QPainter& painter, const Frame2D& frame, const Theme& theme);

    Document& m_document;
    Toolbox& m_toolbox;
    Viewport m_view;
    Board m_board;
    QPixmap m_still;
    Still m_composed;
    Overlay m_overlay; // shown
    OverlayFlags m_overlays;
    OverlayPalette m_overlayPalette;
    LeftOut m_leftOut;
    std::shared_ptr<const ShownDifference> m_difference;
    std::shared_ptr<const ShownReach> m_reach;
    std::shared_ptr<const std::vector<Key>> m_highlighted = std::make_shared<const std::vector<Key>>();
    std::shared_ptr<const std::vector<ProblemMark>> m_problems;
    int m_problem = -1;
    std::vector<ForceArrow> m_forces;
    struct ShownMarks {
        Frame2D frame;
        const Theme* theme = nullptr;
        std::shared_ptr<const std::vector<ProblemMark>> marks;
        int current = -1;

        bool operator==(const ShownMarks&) const = default;
    };
    QPixmap m_marks;
    ShownMarks m_shownMarks;
    std::function<QString(const SnapAnswer&)> m_snapName;
    QString m_beginning; // words for an empty level
    bool m_grid = true;
    int m_top = 0;         // px, in the window
    bool m_fitted = false; // since the last fitLevel() nobody has moved the view

    LiveScene* m_live = nullptr;
    struct KeptView {
        Viewport view;
        bool fitted = false;
    };
    KeptView m_kept; // of the board, while there is a scene in place of it

    Drag m_drag = Drag::None;
    Qt::MouseButton m_dragButton = Qt::NoButton;
    bool m_spaceHeld = false;
    bool m_belowHeld = false; // serves as Alt, which many window managers keep for themselves
    QPointF m_pressedAt;
    std::optional<QPointF> m_position; // of the pointer, which may have left since
    Qt::KeyboardModifiers m_held;      // as the tool was last told
    bool m_inside = false;             // the pointer is here
    EntryBox m_entry;
    EdgeScroll m_edgeScroll;
    int m_documentListener = 0;
    int m_toolboxListener = 0;
};

} // namespace spacetow
