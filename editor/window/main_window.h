#pragma once
// The window: lays out canvas, game, panels and bars, and connects them. What happens stands elsewhere: edits in
// editor/editing, files in files.h, what each action does in its row, actions_<topic>.cpp.

#include "editor/canvas/canvas.h"
#include "editor/canvas/canvas_frame.h"
#include "editor/panels/array_bar.h"
#include "editor/panels/guide_bar.h"
#include "editor/panels/history_panel.h"
#include "editor/panels/inspector.h"
#include "editor/panels/nodes_panel.h"
#include "editor/panels/outliner_panel.h"
#include "editor/panels/problems_panel.h"
#include "editor/panels/tag_matrix_panel.h"
#include "editor/panels/transform_bar.h"
#include "editor/play/play_view.h"
#include "editor/window/actions.h"
#include "editor/window/appearance.h"
#include "editor/window/collision_view.h"
#include "editor/window/difference_panel.h"
#include "editor/window/files.h"
#include "editor/window/menus.h"
#include "editor/window/message_bar.h"
#include "editor/window/panels.h"
#include "editor/window/status_line.h"

#include <QMainWindow>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <map>
#include <optional>
#include <span>

namespace spacetow {

class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    explicit MainWindow(QWidget* parent = nullptr);
    ~MainWindow() override;

    bool open(const QString& path);
    /// The first level that comes with the program, as a copy without a file.
    void openExample();

    void play();
    void stopPlaying();
    bool isPlaying() const { return m_stack.currentWidget() == &m_play; }

    /// Enters what is still being typed in a panel, so that no save, question or game misses it.
    void enterTyping();
    /// Ends a half-drawn shape as Enter does, before something that would drop it; what cannot be ended is dropped.
    void finishDrawing();
    void takeTool(ToolId tool);
    /// The one of these that was in the hand last or, where one is, the next.
    void takeNextOf(std::span<const ToolId> tools);
    /// Each of these switches is remembered until the program runs again.
    void setGridVisible(bool visible);
    void setRulersVisible(bool visible);
    void setGuidesVisible(bool visible);
    /// Shows the bar in which place, angle and name of this guide are typed.
    void openGuide(std::size_t index);
    void setSnap(const SnapSettings& snap);
    /// By the user; while a game is running they are away in any case.
    void setPanelsHidden(bool hidden);
    bool arePanelsHidden() const { return m_panelsHidden; }
    Appearance appearance() const { return m_wardrobe.appearance(); }
    void setAppearance(Appearance appearance);
    const OverlayFlags& overlays() const { return m_overlays; }
    void setOverlays(const OverlayFlags& overlays);

    Document& document() { return m_document; }
    const Document& document() const { return m_document; }
    Toolbox& toolbox() { return m_toolbox; }
    const Toolbox& toolbox() const { return m_toolbox; }
    Canvas& canvas() { return m_canvas; }
    const Canvas& canvas() const { return m_canvas; }
    CanvasFrame& canvasFrame() { return m_frame; }
    const CanvasFrame& canvasFrame() const { return m_frame; }
    PlayView& playView() { return m_play; }
    const PlayView& playView() const { return m_play; }
    Inspector& inspector() { return m_inspector; }
    TagMatrixPanel& tagMatrix() { return m_tagMatrix; }
    CollisionView& collisions() { return m_collisions; }
    const CollisionView& collisions() const { return m_collisions; }
    ProblemsPanel& problems() { return m_problems; }
    NodesPanel& nodes() { return m_nodes; }
    OutlinerPanel& outliner() { return m_outliner; }
    HistoryPanel& history() { return m_history; }
    LevelPanel& levelPanel() { return m_levelPanel; }
    DifferencePanel& differences() { return m_differences; }
    ArrayBar& arrayBar() { return m_arrays; }
    TransformBar& transformBar() { return m_transform; }
    Actions& actions() { return m_actions; }
    Panels& panels() { return *m_panels; }
    Files& files() { return m_files; }
    MessageBar& messageBar() { return m_message; }
    GuideBar& guideBar() { return m_guideBar; }
    StatusLine& statusLine() { return m_status; }

    /// Of a window that has no remembered size, frame excluded, on a screen with so much room; logical pixels.
    static QSize firstSize(const QSize& available);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void layOut();
    void makeMenus();
    void makeToolBars();
    void fillRecent();
    QMenu* makeMenu(const MenuRow& row);
    void openMenuAt(const QPoint& global);
    void openOutlinerMenuAt(const QPoint& global);

    void listen();
    void listenToPanels();
    void restore();
    void showObject(Key key);
    /// A stroke that is nobody's key may be one by its place.
    bool actByPlace(const QKeyEvent& stroke);

    void updateTitle();
    void updateOrigin();
    void updateTool();
    QString snapHint() const;
    void updateSelection();
    void updateMode();

    Wardrobe m_wardrobe; // before anything that has colours
    Document m_document;
    Toolbox m_toolbox;
    Actions m_actions;

    // What holds other widgets comes before them, for it would delete those that are still in it.
    QWidget m_center;
    QVBoxLayout m_column;
    QStackedWidget m_stack;
    std::map<MenuId, QMenu*> m_menus; // owned by the menu bar

    CanvasFrame m_frame;
    Canvas& m_canvas;
    PlayView m_play;
    Inspector m_inspector;
    TagMatrixPanel m_tagMatrix;
    CollisionView m_collisions;
    ProblemsPanel m_problems;
    NodesPanel m_nodes;
    OutlinerPanel m_outliner;
    HistoryPanel m_history;
    LevelPanel m_levelPanel;
    DifferencePanel m_differences;
    MessageBar m_message;
    ArrayBar m_arrays;
    TransformBar m_transform;
    GuideBar m_guideBar;
    StatusLine m_status;
    Files m_files;
    std::optional<Panels> m_panels; // once there is a window to add them to
    OverlayFlags m_overlays;
    bool m_panelsHidden = false;
    ToolId m_shownTool = ToolId::Select;
    bool m_shownBusy = false; // a shape was half drawn
};

} // namespace spacetow
