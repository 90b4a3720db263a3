// What the actions of the window do, and what it listens to.
#include "editor/editing/clipboard.h"
#include "editor/editing/verbs.h"
#include "editor/window/keys_dialog.h"
#include "editor/window/main_window.h"

#include <QApplication>
#include <QClipboard>

#include <array>
#include <numbers>

namespace spacetow {

namespace {

constexpr double turn = std::numbers::pi / 12; // 15°
constexpr double quarter = std::numbers::pi / 2;
constexpr double zoomStep = 1.25;

struct Switch {
    Act act;
    bool OverlayFlags::*flag;
};
constexpr std::array switches{
    Switch{Act::OverlayAabb, &OverlayFlags::aabb},         Switch{Act::OverlayIncircle, &OverlayFlags::incircle},
    Switch{Act::OverlayVelocity, &OverlayFlags::velocity}, Switch{Act::OverlayOrientation, &OverlayFlags::orientation},
    Switch{Act::OverlayNormals, &OverlayFlags::normals},   Switch{Act::OverlayQuadtree, &OverlayFlags::quadtree},
};

} // namespace

void MainWindow::listen() {
    m_document.changed.connect([this](const Change& change) {
        updateSelection();
        updateTool();
        if (change.before.selection.empty() != change.after.selection.empty()) {
            m_actions.setSituation(isPlaying(), !m_document.selection().empty());
            updateHistory();
        }
    });
    m_document.historyChanged.connect([this] { updateHistory(); });
    m_toolbox.changed.connect([this] { updateTool(); });
    m_files.changed.connect([this] {
        updateTitle();
        updateHistory();
    });
    m_files.opened.connect([this] {
        m_toolbox.cancel();
        m_canvas.fitLevel();
    });
    connect(&m_canvas, &Canvas::pointerMoved, &m_status, &StatusLine::setPointer);
    connect(&m_canvas, &Canvas::pointerLeft, &m_status, &StatusLine::clearPointer);
    connect(&m_canvas, &Canvas::viewChanged, this,
            [this] { m_status.setZoom(m_canvas.view().scale, Viewport().scale); });
    connect(&m_canvas, &Canvas::menuWanted, this, &MainWindow::openMenuAt);
    connect(&m_problems, &ProblemsPanel::objectWanted, this, &MainWindow::showObject);
    connect(&m_problems, &ProblemsPanel::problemsChanged, this,
            [this] { m_status.setProblems(m_problems.errors(), m_problems.warnings()); });
    m_status.setProblems(m_problems.errors(), m_problems.warnings());
}

void MainWindow::connectFiles() {
    m_actions.on(Act::New, [this] {
        enterTyping();
        m_message.dismiss();
        m_files.startNew();
    });
    m_actions.on(Act::Open, [this] {
        enterTyping();
        m_message.dismiss();
        m_files.chooseAndOpen();
    });
    const auto saved = [this](bool (Files::*save)()) {
        enterTyping();
        if ((m_files.*save)()) {
            m_message.dismiss();
            m_status.showMessage(tr("Saved %1").arg(m_files.path()), 4000);
        }
    };
    m_actions.on(Act::Save, [saved] { saved(&Files::save); });
    m_actions.on(Act::SaveAs, [saved] { saved(&Files::saveAs); });
    m_actions.on(Act::Quit, [this] { close(); });
}

void MainWindow::connectEdits() {
    m_actions.on(Act::Undo, [this] {
        m_toolbox.cancel();
        m_document.undo();
    });
    m_actions.on(Act::Redo, [this] {
        m_toolbox.cancel();
        m_document.redo();
    });
    m_actions.on(Act::Cut, [this] {
        copyToClipboard();
        finish(cut(m_toolbox.context()));
    });
    m_actions.on(Act::Copy, [this] { copyToClipboard(); });
    m_actions.on(Act::Paste, [this] { pasteFromClipboard(false); });
    m_actions.on(Act::PasteInPlace, [this] { pasteFromClipboard(true); });
    m_actions.on(Act::Duplicate, [this] { finish(duplicateSelected(m_toolbox.context())); });
    m_actions.on(Act::Delete, [this] { finish(removeSelected(m_toolbox.context())); });
    m_actions.on(Act::SelectAll, [this] { m_document.select(selectAll(m_document.level())); });
    m_actions.on(Act::SelectNone, [this] { m_document.select(Selection()); });
    m_actions.on(Act::InvertSelection, [this] { m_document.select(invertedSelection(m_document.shown())); });
    m_actions.on(Act::RotateLeft, [this] { finish(rotateSelected(m_toolbox.context(), turn)); });
    m_actions.on(Act::RotateRight, [this] { finish(rotateSelected(m_toolbox.context(), -turn)); });
    m_actions.on(Act::QuarterLeft, [this] { finish(rotateSelected(m_toolbox.context(), quarter)); });
    m_actions.on(Act::QuarterRight, [this] { finish(rotateSelected(m_toolbox.context(), -quarter)); });
    m_actions.on(Act::Reverse, [this] { finish(reverseSelected(m_toolbox.context())); });
    m_actions.on(Act::NextProblem, [this] { m_problems.go(1); });
    m_actions.on(Act::PreviousProblem, [this] { m_problems.go(-1); });
    connect(&m_status, &StatusLine::problemsClicked, &m_actions[Act::NextProblem], &QAction::trigger);
}

void MainWindow::connectTools() {
    const auto choose = [this](Act act, ToolId tool) {
        m_actions.on(act, [this, tool] {
            m_toolbox.choose(tool);
            m_canvas.setFocus();
        });
    };
    choose(Act::ToolSelect, ToolId::Select);
    choose(Act::ToolEdge, ToolId::Edge);
    choose(Act::ToolLine, ToolId::Line);
    choose(Act::ToolPolygon, ToolId::Polygon);
    choose(Act::ToolCircle, ToolId::Circle);
    choose(Act::PlaceNext, ToolId::Place);
    const auto place = [this](Act act, PlaceKind kind) {
        m_actions.on(act, [this, kind] {
            m_toolbox.choose(ToolId::Place);
            m_toolbox.setPlaceKind(kind);
            updateTool();
            m_canvas.setFocus();
        });
    };
    place(Act::PlaceShip, PlaceKind::Ship);
    place(Act::PlacePayload, PlaceKind::Payload);
    place(Act::PlaceFinish, PlaceKind::Finish);
}

void MainWindow::connectView() {
    m_actions.on(Act::ZoomIn, [this] { m_canvas.zoom(zoomStep); });
    m_actions.on(Act::ZoomOut, [this] { m_canvas.zoom(1 / zoomStep); });
    m_actions.on(Act::ZoomReset, [this] { m_canvas.zoomTo(Viewport().scale); });
    m_actions.on(Act::FitLevel, [this] { m_canvas.fitLevel(); });
    m_actions.on(Act::Center, [this] { m_canvas.centerSelection(); });
    m_actions.on(Act::Frame, [this] { m_canvas.frameSelection(); });
    connect(&m_status, &StatusLine::zoomClicked, &m_actions[Act::ZoomReset], &QAction::trigger);
    connect(&m_status, &StatusLine::stepChosen, this, [this](double step) {
        m_toolbox.snap.step = step;
        m_files.preferences.setSnap(m_toolbox.snap);
        m_status.setSnap(m_toolbox.snap);
        m_canvas.update();
    });
    m_actions.onToggled(Act::Grid, [this](bool on) {
        m_canvas.setGridVisible(on);
        m_files.preferences.setGrid(on);
    });
    m_actions.onToggled(Act::Snap, [this](bool on) {
        m_toolbox.snap.grid = on;
        m_files.preferences.setSnap(m_toolbox.snap);
        m_status.setSnap(m_toolbox.snap);
    });
    m_actions.onToggled(Act::FullScreen, [this](bool on) {
        setWindowState(on ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
    });
    for (const Switch& each : switches) {
        m_actions[each.act].setChecked(m_files.preferences.overlays().*each.flag);
        m_actions.onToggled(each.act, [this](bool) { setOverlays(); });
    }
    m_actions.on(Act::OverlaysOff, [this] {
        for (const Switch& each : switches) {
            m_actions[each.act].setChecked(false);
        }
    });
    m_actions[Act::Grid].setChecked(m_files.preferences.grid());
    m_canvas.setGridVisible(m_files.preferences.grid());
    m_toolbox.snap = m_files.preferences.snap();
    m_actions[Act::Snap].setChecked(m_toolbox.snap.grid);
    m_status.setSnap(m_toolbox.snap);
    setOverlays();
}

OverlayFlags MainWindow::overlays() const {
    OverlayFlags flags;
    for (const Switch& each : switches) {
        flags.*each.flag = m_actions[each.act].isChecked();
    }
    return flags;
}

void MainWindow::setOverlays() {
    m_canvas.setOverlays(overlays());
    m_play.setOverlays(overlays());
    m_files.preferences.setOverlays(overlays());
}

void MainWindow::connectPlay() {
    m_actions.on(Act::Play, [this] { play(); });
    m_actions.on(Act::Stop, [this] { stopPlaying(); });
    m_actions.on(Act::Step, [this] { m_play.stepOnce(); });
    m_actions.on(Act::Restart, [this] { m_play.restart(); });
    m_actions.onToggled(Act::Pause, [this](bool on) { m_play.setPaused(on); });
    connect(&m_play, &PlayView::pausedChanged, &m_actions[Act::Pause], &QAction::setChecked);
    connect(&m_play, &PlayView::finished, this, &MainWindow::stopPlaying);
    m_actions.on(Act::Keys, [this] { KeysDialog(this).exec(); });
    m_actions.on(Act::About, [this] { showAbout(); });
}

void MainWindow::copyToClipboard() {
    if (!m_document.selection().empty()) {
        QApplication::clipboard()->setText(QString::fromStdString(copied(m_document.current())));
    }
}

void MainWindow::pasteFromClipboard(bool inPlace) {
    const std::string text = QApplication::clipboard()->text().toStdString();
    const std::optional<Vec2> at = inPlace ? std::nullopt : std::optional(m_canvas.pointerPosition());
    const std::optional<FinishedEdit> edit = pasted(m_toolbox.context(), text, at);
    if (!edit) {
        m_status.showMessage(tr("There is nothing on the clipboard that can be pasted here."), 4000);
    }
    finish(edit);
}

} // namespace spacetow
