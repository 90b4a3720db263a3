#include "editor/play/live_overlays.h"

#include "core/level/build.h"
#include "editor/canvas/overlay_painter.h"

#include <future>
#include <system_error>
#include <utility>

namespace spacetow {

namespace {

OverlayRequest requestOf(const LiveOverlays::Wanted& wanted, std::span<const DebugTrail> trails,
                         std::span<const std::uint64_t> named) {
    return {.flags = wanted.flags,
            .palette = wanted.palette,
            .level = &wanted.session->level(),
            .selected = wanted.selected,
            .pointed = wanted.pointed,
            .named = named,
            .trails = trails};
}

void noteTrails(TrailKeeper& trails, const LiveOverlays::Wanted& wanted) {
    if (wanted.flags.trails) {
        trails.note(*wanted.session);
    }
}

} // namespace

bool LiveOverlays::areMany(const Session& session) {
    return partsToBuild(session.level(), few) > few;
}

void LiveOverlays::see(const Wanted& wanted) {
    if (areMany(*wanted.session)) {
        if (!isPainting() && !(wanted == m_shown)) {
            paintBeside(wanted);
        }
        return;
    }
    if (isPainting() || m_bands.front().isValid()) { // there were many before
        forget();
        finish();
    }
    noteTrails(m_trails, wanted);
    m_shown = wanted;
}

LeftOut LiveOverlays::draw(const Stage& stage, const Frame2D& frame) {
    if (m_shown.session && !areMany(*m_shown.session)) {
        m_gaps =
            paintWorldOverlays(stage, m_shown.session->world(), requestOf(m_shown, m_trails.trails(), m_gaps.named));
        return leftOut();
    }
    for (const PictureLayer& band : m_bands) {
        band.draw(stage.painter, frame);
    }
    return leftOut();
}

void LiveOverlays::forget() {
    ++m_epoch; // what is being painted will not be taken
    m_shown = {};
    m_bands = {};
    m_gaps = {};
    m_trails.forget();
}

OverlayGaps LiveOverlays::paint(Bands& bands, const Wanted& wanted, const OverlayRequest& request) {
    const Frame2D& whole = wanted.frame;
    const PainterDraw marks = worldOverlays(whole.view, wanted.theme->shade, wanted.session->world(), request);
    const QRect all = whole.all();
    const auto paintBand = [&](std::size_t i) {
        const auto count = static_cast<int>(bands.size());
        const int top = all.height() * static_cast<int>(i) / count;
        const int bottom = all.height() * (static_cast<int>(i) + 1) / count;
        bands[i].wipe();
        bands[i].shiftTo(whole.part({0, top, all.width(), bottom - top}));
        bands[i].paint(bands[i].frame().all(), *wanted.theme, [&](const Stage& stage) {
            const SavedPainter saved(stage.painter);
            stage.painter.translate(0, -top / whole.pixelRatio);
            marks.paint(stage);
        });
    };
    std::future<void> second;
    try {
        second = std::async(std::launch::async, [&] { paintBand(1); });
    } catch (const std::system_error&) { // there are no more threads
        paintBand(1);
    }
    paintBand(0);
    if (second.valid()) {
        second.get();
    }
    return gapsOf(marks, whole.view);
}

void LiveOverlays::paintBeside(const Wanted& wanted) {
    if (std::exchange(m_failed, true)) { // for want of memory: the run goes on without
        forget();
    }
    m_task.start([this, wanted, trails = m_trails, named = m_gaps.named, epoch = m_epoch,
                  bands = std::exchange(m_spare, {})](const std::stop_token&) mutable -> BackgroundTask::Then {
        noteTrails(trails, wanted);
        OverlayGaps gaps = paint(bands, wanted, requestOf(wanted, trails.trails(), named));
        return [this, wanted, epoch, gaps = std::move(gaps), trails = std::move(trails),
                bands = std::move(bands)]() mutable {
            m_failed = false;
            if (epoch == m_epoch) {
                m_trails = std::move(trails);
                m_spare = std::exchange(m_bands, std::move(bands));
                m_gaps = std::move(gaps);
                m_shown = wanted;
            }
            if (painted) {
                painted();
            }
        };
    });
}

} // namespace spacetow
