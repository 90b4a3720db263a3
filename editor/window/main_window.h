#pragma once
// The window: lays out canvas, game, panels and bars, and connects them. What happens stands elsewhere: edits in
// editor/editing, files in files.h, what each action does in its row, actions_<topic>.cpp.

#include "editor/canvas/canvas.h"
#include "editor/canvas/canvas_frame.h"
#include "editor/canvas/legend.h"
#include "editor/panels/array_bar.h"
#include "editor/panels/flights_panel.h"
#include "editor/panels/guide_bar.h"
#include "editor/panels/history_panel.h"
#include "editor/panels/inspector.h"
#include "editor/panels/minimap.h"
#include "editor/panels/nodes_panel.h"
#include "editor/panels/outliner_panel.h"
#include "editor/panels/problems_panel.h"
#include "editor/panels/tag_matrix_panel.h"
#include "editor/panels/transform_bar.h"
#include "editor/play/live_view.h"
#include "editor/play/timeline_bar.h"
#include "editor/window/actions.h"
#include "editor/window/appearance.h"
#include "editor/window/bug_capsule.h"
#include "editor/window/collision_view.h"
#include "editor/window/difference_panel.h"
#include "editor/window/exchange.h"
#include "editor/window/explanations.h"
#include "editor/window/file_reader.h"
#include "editor/window/finder.h"
#include "editor/window/flight_file.h"
#include "editor/window/flight_reader.h"
#include "editor/window/menus.h"
#include "editor/window/message_bar.h"
#include "editor/window/open_level.h"
#include "editor/window/panels.h"
#include "editor/window/reach_view.h"
#include "editor/window/recovery_bar.h"
#include "editor/window/run_changes_panel.h"
#include "editor/window/status_line.h"

#include <QElapsedTimer>
#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <functional>
#include <map>
#include <memory>
#include <optional>

namespace spacetow {

class Application;
class OverlayColorsDialog;
class WelcomePage;

class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    /// Shows a level that is open, or an empty one. Without an application it is the only window.
    explicit MainWindow(std::shared_ptr<OpenLevel> level = nullptr, Application* application = nullptr);
    ~MainWindow() override;

    /// In place of the level that it shows; a file of another program is imported into it.
    bool open(const FileToOpen& file);
    /// The levels that were chosen, each in a window of its own, once they have been read.
    void openFiles(const QStringList& paths);
    /// The same when they have been.
    void openAll(const std::vector<FileToOpen>& files);
    /// A file of another program becomes part of the level, if the user likes it.
    void importFile(const QString& path);
    /// The same with one file or resource; the window that shows it, or null after saying why there is none.
    MainWindow* openAside(const QString& path);
    /// An empty level, here where nothing is lost by it, else in a window of its own.
    void startNew();
    /// The first level that comes with the program, as a copy without a file.
    void openExample();
    /// A level that comes with the program, likewise; a sandbox says what to try in it.
    bool openShipped(const QString& resource);
    /// Shows what former runs have left in the journal, if there is anything; `asked`: says so if there is not.
    void offerRecovery(bool asked = false);
    /// Marks what is different from this level, and lists it; with null nothing any more.
    void compareWith(std::shared_ptr<const Level> other, const QString& name);
    /// The session ends, and there is no time for questions: the journals of all windows hold everything.
    static void keepForNextTime();

    /// In place of an empty level, until there is one.
    void showWelcome();
    void leaveWelcome();
    bool isWelcoming() const;
    WelcomePage& welcome();

    /// A game where the level has a ship, else a simulation. A large level is built beside the window first, and one
    /// edits on until it runs.
    void play();
    /// The level runs in place, and the editor goes on.
    void simulate();
    /// A game in which the ship starts at the pointer.
    void playFromPointer();
    /// The run as it was recorded, as the game or the simulation that it was.
    void playReplay(const Replay& recorded) { enterReplay({recorded, nullptr}); }
    /// A run that was edited, and the level as it was at its end, which is edited on.
    void reopenRun(const Replay& run, const std::shared_ptr<const Level>& edited) { enterReplay({run, edited}); }
    void stopPlaying();
    /// What has been flown, into a file that the user chooses.
    void saveFlight() { m_flightFile.save(); }
    FlightFile& flightFile() { return m_flightFile; }
    FlightReader& flightReader() { return m_flightReader; }
    FileReader& fileReader() { return m_fileReader; }
    /// What is to run is being built, or the flight or the level that is to be shown read.
    bool isGettingReady() const { return m_run.isStarting() || m_flightReader.isReading() || m_fileReader.isReading(); }
    /// Where to, after a suggestion; empty: nowhere. Asks with a dialog, unless a test answers.
    std::function<QString(const QString& suggestion)> whereToSaveFlight;
    /// The level as it is edited, but for what was said about this run.
    std::shared_ptr<const Level> levelToRun() const;
    /// A game or a simulation runs in place of the drawing board.
    bool isPlaying() const { return m_live.isShown(); }
    /// What runs is a game: it has the keyboard, and the panels are out of the way until they are called.
    bool isInGame() const { return isPlaying() && m_inGame; }

    /// Enters and ends whatever is half done in this window.
    void finishWork();
    /// Offers to save what is modified and shown nowhere else; false when the user would rather stay.
    bool mayClose();
    void closeUnasked();
    /// That of the level, with a number where several windows show it.
    QString name() const;
    /// Before all other windows, and into use.
    void comeForward();

    /// Enters what is still being typed in a panel, so that no save, question or game misses it.
    void enterTyping();
    /// Ends a half-drawn shape as Enter does, before something that would drop it; what cannot be ended is dropped.
    void finishDrawing();
    /// Selects the object and brings it into the middle of the view, and to a size at which it is seen; selects nothing
    /// where there is none.
    void showObject(Key key);
    void takeTool(ToolId tool);
    void takePlaceTool();
    /// Each of these switches is remembered until the program runs again.
    void setGridVisible(bool visible);
    void setRulersVisible(bool visible);
    void setGuidesVisible(bool visible);
    /// Shows the bar in which place, angle and name of this guide are typed.
    void openGuide(std::size_t index);
    void setSnap(const SnapSettings& snap);
    /// By the user; at the beginning of a game they are away in any case.
    void setPanelsHidden(bool hidden);
    bool arePanelsHidden() const { return isInGame() ? !m_panelsInGame : m_panelsHidden; }
    Appearance appearance() const { return m_wardrobe->appearance(); }
    void setAppearance(Appearance appearance);
    /// The keys that the preferences remember, on all actions and panels.
    void updateKeys();
    const OverlayFlags& overlays() const { return m_overlays; }
    void setOverlays(const OverlayFlags& overlays);
    const OverlayPalette& overlayPalette() const { return m_overlayPalette; }
    void setOverlayPalette(const OverlayPalette& palette);
    bool isLegendShown() const { return m_legendShown; }
    /// Beside the window, which goes on.
    void chooseOverlayColors();
    void setLegendShown(bool shown);
    Legend& legend() { return m_legend; }

    Application* application() const { return m_application; }
    /// What other windows show too, when they are views of the same level.
    const std::shared_ptr<OpenLevel>& openLevel() const { return m_open; }
    Document& document() { return m_document; }
    const Document& document() const { return m_document; }
    Toolbox& toolbox() { return m_toolbox; }
    const Toolbox& toolbox() const { return m_toolbox; }
    Canvas& canvas() { return m_canvas; }
    const Canvas& canvas() const { return m_canvas; }
    CanvasFrame& canvasFrame() { return m_frame; }
    const CanvasFrame& canvasFrame() const { return m_frame; }
    LiveRun& liveRun() { return m_run; }
    const LiveRun& liveRun() const { return m_run; }
    TimelineBar& timelineBar() { return m_timeline; }
    LiveView& liveView() { return m_live; }
    const LiveView& liveView() const { return m_live; }
    Inspector& inspector() { return m_inspector; }
    TagMatrixPanel& tagMatrix() { return m_tagMatrix; }
    ReachView& reach() { return m_reach; }
    const ReachView& reach() const { return m_reach; }
    CollisionView& collisions() { return m_collisions; }
    const CollisionView& collisions() const { return m_collisions; }
    ProblemsPanel& problems() { return m_problems; }
    const ProblemsPanel& problems() const { return m_problems; }
    NodesPanel& nodes() { return m_nodes; }
    OutlinerPanel& outliner() { return m_outliner; }
    HistoryPanel& history() { return m_history; }
    Minimap& minimap() { return m_minimap; }
    LevelPanel& levelPanel() { return m_levelPanel; }
    FlightsPanel& flights() { return m_flights; }
    DifferencePanel& differences() { return m_differences; }
    RunChangesPanel& runChangesPanel() { return m_runChanges; }
    Explanations& explanations() { return m_explanations; }
    ArrayBar& arrayBar() { return m_arrays; }
    TransformBar& transformBar() { return m_transform; }
    Actions& actions() { return m_actions; }
    Panels& panels() { return *m_panels; }
    const Panels& panels() const { return *m_panels; }
    Files& files() { return m_files; }
    const Files& files() const { return m_files; }
    Exchange& exchange() { return m_exchange; }
    BugCapsule& bugCapsule() { return m_bugCapsule; }
    MessageBar& messageBar() { return m_message; }
    Recovery& recovery() { return m_open->recovery; }
    RecoveryBar& recoveryBar() { return m_recoveryBar; }
    DiskChanges& diskChanges() { return m_open->disk; }
    MessageBar& diskBar() { return m_diskBar; }
    GuideBar& guideBar() { return m_guideBar; }
    Finder& finder() { return *m_finder; }
    /// The entries of a menu that are possible and neither actions of the table nor panels.
    QList<QAction*> listedIn(MenuId menu);
    QMenu& menu(MenuId id) { return *m_menus.at(id); }
    /// Its middle, or that of the view without one, on the screen; the pointer counts as being there.
    QPoint placeOfSelection();
    StatusLine& statusLine() { return m_status; }

    /// Of a window that has no remembered size, frame excluded, on a screen with so much room; logical pixels.
    static QSize firstSize(const QSize& available);

  Q_SIGNALS:
    /// It has been agreed to; all of the window is still there.
    void closing();
    void fileChanged();

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
    void fillWindows();
    void fillBackups();
    void fillLanguages();
    QMenu* makeMenu(const MenuRow& row);
    void openMenuAt(const QPoint& global);
    void openMenuAtSelection();
    void openOutlinerMenuAt(const QPoint& global);

    void listen();
    void listenToPanels();
    void listenToDisk();
    void showNotice();
    void listenToRunChanges();
    void tellRun();
    bool restoreWork(const JournalEntry& entry);
    void showRecovered(const JournalEntry& entry, const std::shared_ptr<const Level>& found);
    void restore();
    /// A stroke that is nobody's key may be one by its place.
    bool actByPlace(const QKeyEvent& stroke);

    struct Recorded {
        const Replay& replay;
        std::shared_ptr<const Level> then; // see Course::open
    };
    void enterReplay(const Recorded& recorded);
    void putDown();
    void enterRun(LiveRun::Kind wanted, const Recorded* recorded);
    void showRun();
    void takeOverEdits();
    bool isStarting(LiveRun::Kind kind) const;
    void listenToRun();
    void placePanels();
    QString runHint() const;
    QString heldHint() const;
    QString solidHint() const;
    void updateMotion();
    void showTension(const Object* object);
    void updateTimeline();
    void updatePace();
    void updateExplanations();
    void writePlots(const QByteArray& csv);
    void tellErrors();
    void showBoard();
    QString playedPhase() const;
    void updateTitle();
    void updateOrigin();
    void updateTool();
    QString snapHint() const;
    QString lockedHint() const;
    QString firstSteps() const;
    Aabb boundsOfSelection();
    void updateSelection();
    void updateMode();
    void updateProblems();
    void showCured(Key key);
    void updateLegend();
    void updateLeftOut();
    void updateWays();
    Shade overlayGround() const;
    void listenToLegend();
    void chooseOverlayColor(int ink);

    std::shared_ptr<Wardrobe> m_wardrobe; // before anything that has colours
    Application* m_application;
    std::shared_ptr<OpenLevel> m_open;
    Document& m_document;
    Files& m_files;
    Toolbox m_toolbox;
    Actions m_actions;

    // What holds other widgets comes before them, for it would delete those that are still in it.
    QWidget m_center;
    QVBoxLayout m_column;
    QStackedWidget m_stack;
    std::map<MenuId, QMenu*> m_menus;       // owned by the menu bar
    std::unique_ptr<WelcomePage> m_welcome; // once it has been wanted

    CanvasFrame m_frame;
    Canvas& m_canvas;
    LiveRun m_run;
    LiveView m_live;
    TimelineBar m_timeline;
    Inspector m_inspector;
    TagMatrixPanel m_tagMatrix;
    CollisionView m_collisions;
    ReachView m_reach;
    ProblemsPanel m_problems;
    NodesPanel m_nodes;
    OutlinerPanel m_outliner;
    HistoryPanel m_history;
    LevelPanel m_levelPanel;
    FlightsPanel m_flights;
    DifferencePanel m_differences;
    RunChangesPanel m_runChanges;
    Explanations m_explanations;
    Minimap m_minimap;
    RecoveryBar m_recoveryBar;
    MessageBar m_diskBar; // what others do to the file
    MessageBar m_message;
    ArrayBar m_arrays;
    TransformBar m_transform;
    GuideBar m_guideBar;
    StatusLine m_status;
    Exchange m_exchange;
    BugCapsule m_bugCapsule;
    FlightFile m_flightFile;
    FlightReader m_flightReader;
    FileReader m_fileReader;
    std::optional<Panels> m_panels; // once there is a window to add them to
    std::optional<Finder> m_finder; // above all the rest
    OverlayFlags m_overlays;
    OverlayPalette m_overlayPalette;
    Legend m_legend; // on the canvas
    bool m_legendShown = true;
    LeftOut m_leftOut;      // as the legend says
    bool m_hasWays = false; // likewise
    QTimer m_leftOutEnds;
    QPointer<OverlayColorsDialog> m_overlayColors; // null while nobody chooses
    bool m_panelsHidden = false;
    bool m_panelsInGame = false;  // called back
    bool m_inGame = false;        // what runs, or ran last, is a game
    bool m_smartBefore = false;   // snapping to what is in the level, before the run
    std::optional<Vec2> m_shipAt; // where it starts in the run, if not where the level has it
    QElapsedTimer m_sinceMotion;  // was shown
    double m_framesPerSecond = 0;
    ToolId m_shownTool = ToolId::Select;
    bool m_shownBusy = false;                // a shape was half drawn
    std::shared_ptr<const Level> m_reopened; // what the level is to become, once the run is there; null for none
    bool m_enteredAnew = false;              // from the welcome page, without a view of its own
    bool m_recorded = false;                 // what is played
    bool m_errorsUntold = false;             // of what is played
    QString m_errorsTold;                    // in the message bar
    int m_view = 0;                          // its number among the views of the level
    bool m_mayClose = false;                 // without another question
    std::shared_ptr<const Level> m_told;     // that the run has heard of
    int m_documentListener = 0;
    int m_runListener = 0;
    int m_historyListener = 0;
    int m_fileListener = 0;
    int m_openedListener = 0;
    int m_noticeListener = 0;
};

} // namespace spacetow
