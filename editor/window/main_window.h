#pragma once
// The window: lays out canvas, game, panels and bars, and connects them. What happens stands elsewhere: edits in
// editor/editing, files in files.h, actions in actions.h.

#include "editor/canvas/canvas.h"
#include "editor/panels/inspector.h"
#include "editor/panels/problems_panel.h"
#include "editor/play/play_view.h"
#include "editor/window/actions.h"
#include "editor/window/files.h"
#include "editor/window/message_bar.h"
#include "editor/window/status_line.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QStackedWidget>
#include <QVBoxLayout>

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

    Document& document() { return m_document; }
    Toolbox& toolbox() { return m_toolbox; }
    Canvas& canvas() { return m_canvas; }
    PlayView& playView() { return m_play; }
    Inspector& inspector() { return m_inspector; }
    ProblemsPanel& problems() { return m_problems; }
    Actions& actions() { return m_actions; }
    Files& files() { return m_files; }
    MessageBar& messageBar() { return m_message; }
    StatusLine& statusLine() { return m_status; }

    QSize sizeHint() const override { return {1280, 800}; }

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
    void openMenuAt(const QPoint& global);

    void connectFiles();
    void connectEdits();
    void connectTools();
    void connectView();
    void connectPlay();
    void listen();

    void finish(const std::optional<FinishedEdit>& finished);
    /// Enters what is still being typed in a panel, so that no save, question or game misses it.
    void enterTyping();
    void copyToClipboard();
    void pasteFromClipboard(bool inPlace);
    void setOverlays();
    OverlayFlags overlays() const;
    void showObject(Key key);
    void showAbout();

    void updateHistory();
    void updateTitle();
    void updateTool();
    void updateSelection();
    void updateSituation();

    Document m_document;
    Toolbox m_toolbox;
    Actions m_actions;

    // What holds other widgets comes before them, for it would delete those that are still in it.
    QWidget m_center;
    QVBoxLayout m_column;
    QStackedWidget m_stack;
    QDockWidget m_inspectorDock;
    QDockWidget m_problemsDock;
    QMenu m_recent;

    Canvas m_canvas;
    PlayView m_play;
    Inspector m_inspector;
    ProblemsPanel m_problems;
    MessageBar m_message;
    StatusLine m_status;
    Files m_files;
};

} // namespace spacetow
