// The overlays of the window: which are on, in which colors, and the legend that explains them.
#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"
#include "editor/window/main_window.h"
#include "editor/window/overlay_colors_dialog.h"

#include <QColorDialog>
#include <QCoreApplication>

#include <utility>

namespace spacetow {

void MainWindow::setOverlays(const OverlayFlags& overlays) {
    m_overlays = overlays;
    m_canvas.setOverlays(overlays);
    m_live.setOverlays(overlays);
    m_files.preferences.setOverlays(overlays);
    m_collisions.setOn(overlays.collides);
    updateLegend();
}

void MainWindow::setOverlayPalette(const OverlayPalette& palette) {
    m_overlayPalette = palette;
    m_canvas.setOverlayPalette(palette);
    m_files.preferences.setOverlayPalette(palette);
    updateLegend();
}

void MainWindow::setLegendShown(bool shown) {
    m_legendShown = shown;
    m_files.preferences.setLegendShown(shown);
    updateLegend();
}

void MainWindow::updateLegend() {
    constexpr OverlayFlags none{.ways = false};
    OverlayFlags told = m_legendShown ? m_overlays : none;
    told.ways = told.ways && m_hasWays;
    m_legend.showOverlays({told, m_overlayPalette, m_document.level().tags, overlayGround(),
                           isInGame() ? 3 * fontMetrics().height() : 0, m_leftOut});
    if (m_overlayColors != nullptr) {
        m_overlayColors->showPalette(m_overlayPalette, overlayGround());
    }
    m_actions.refresh();
}

void MainWindow::chooseOverlayColors() {
    if (m_overlayColors == nullptr) {
        m_overlayColors = new OverlayColorsDialog(this); // goes when it is closed
        m_overlayColors->setAttribute(Qt::WA_DeleteOnClose);
        connect(m_overlayColors, &OverlayColorsDialog::chosen, this, &MainWindow::setOverlayPalette);
        connect(m_overlayColors, &OverlayColorsDialog::colorWanted, this, &MainWindow::chooseOverlayColor);
        m_overlayColors->showPalette(m_overlayPalette, overlayGround());
    }
    m_overlayColors->show();
    m_overlayColors->raise();
    m_overlayColors->activateWindow();
}

/// Space is dark, whatever the panels are.
Shade MainWindow::overlayGround() const {
    return isInGame() ? Shade::Dark : shadeOf(palette());
}

/// At once where something is left out, and for a while afterwards: in a run it changes from frame to frame.
void MainWindow::updateLeftOut() {
    constexpr int linger = 1000; // ms
    const LeftOut& now = m_canvas.leftOut();
    const LeftOut either{now.dots || m_leftOut.dots, now.names || m_leftOut.names};
    const bool lingers = isPlaying() && either != now;
    if (!lingers) {
        m_leftOutEnds.stop();
    } else if (!m_leftOutEnds.isActive()) {
        m_leftOutEnds.start(linger);
    }
    const LeftOut& told = lingers ? either : now;
    if (std::exchange(m_leftOut, told) != told) {
        updateLegend();
    }
}

void MainWindow::updateWays() {
    const bool hasWays = m_live.hasWays();
    if (std::exchange(m_hasWays, hasWays) != hasWays) {
        updateLegend();
    }
}

void MainWindow::listenToLegend() {
    connect(&m_canvas, &Canvas::leftOutChanged, this, &MainWindow::updateLeftOut);
    m_leftOutEnds.setSingleShot(true);
    connect(&m_leftOutEnds, &QTimer::timeout, this, [this] {
        m_leftOut = m_canvas.leftOut();
        updateLegend();
    });
    connect(&m_legend, &Legend::switchedOff, this, [this](int row) {
        OverlayFlags flags = m_overlays;
        flags.*overlayRows()[static_cast<std::size_t>(row)].flag = false;
        setOverlays(flags);
    });
    connect(&m_legend, &Legend::colorWanted, this, &MainWindow::chooseOverlayColor);
    connect(&m_legend, &Legend::closed, this, [this] { setLegendShown(false); });
}

/// Asks for a color of one's own, and goes on meanwhile.
void MainWindow::chooseOverlayColor(int ink) {
    const OverlayInk& chosen = overlayInks()[static_cast<std::size_t>(ink)];
    const DebugColors colors = overlayColors(m_overlayPalette, overlayGround());
    QWidget* const asker = m_overlayColors != nullptr ? m_overlayColors.data() : static_cast<QWidget*>(this);
    auto* dialog = new QColorDialog(toQColor(colors.*chosen.color), asker);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QCoreApplication::translate("Legend", chosen.meaning));
    connect(dialog, &QColorDialog::colorSelected, this, [this, name = std::string(chosen.name)](const QColor& color) {
        OverlayPalette changed = m_overlayPalette;
        changed.own[name] = toColor(color);
        setOverlayPalette(changed);
    });
    dialog->open();
}

} // namespace spacetow
