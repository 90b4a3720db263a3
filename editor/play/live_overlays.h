#pragma once
// The debug overlays of a run. Those of a few bodies are painted within the frame. Those of a crowd take longer than a
// frame may, so they are painted beside the window; what is shown of the run meanwhile is the moment that they are of,
// so that overlays and bodies belong together.

#include "core/game/session.h"
#include "editor/canvas/background_task.h"
#include "editor/canvas/left_out.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/picture_layer.h"
#include "editor/play/trail_keeper.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace spacetow {

class LiveOverlays {
  public:
    /// Bodies and walls whose overlays are painted within the frame.
    static constexpr std::size_t few = 300;

    struct Wanted {
        std::shared_ptr<const Session> session;
        std::shared_ptr<const Snapshot> picture; // of the same moment
        OverlayFlags flags;
        OverlayPalette palette;
        std::vector<Key> selected;    // ascending
        Key pointed = 0;              // by the mouse, where it is to be named
        const Theme* theme = nullptr; // lives on
        Frame2D frame;

        bool operator==(const Wanted&) const = default;
    };

    /// Whether the overlays of this session are painted beside the window.
    static bool areMany(const Session& session);

    /// There is a new moment to be shown, or another view of it. Of a crowd it is painted beside the window, unless
    /// another picture is being painted; then whoever is told of that asks again.
    void see(const Wanted& wanted);
    /// Bodies at the moment of the run that the overlays are of; null as long as there are none.
    const std::shared_ptr<const Snapshot>& picture() const { return m_shown.picture; }
    /// What has been seen last. Of a crowd, the last picture that is there, where it belongs in the frame. What has
    /// been left out.
    LeftOut draw(const Stage& stage, const Frame2D& frame);
    void forget();

    /// Once what was painted beside the window is there.
    std::function<void()> painted;
    bool isPainting() const { return m_task.isRunning(); }
    /// Waits for what is being painted.
    void finish() { m_task.finish(); }

  private:
    /// Upper and lower part of the view: each is painted by a thread of its own.
    using Bands = std::array<PictureLayer, 2>;

    static OverlayGaps paint(Bands& bands, const Wanted& wanted, const OverlayRequest& request);
    LeftOut leftOut() const { return {.dots = !m_gaps.dots.empty(), .names = m_gaps.names}; }
    void paintBeside(const Wanted& wanted);

    Wanted m_shown;
    Bands m_bands; // of a crowd
    Bands m_spare; // painted into next
    OverlayGaps m_gaps;
    TrailKeeper m_trails;
    bool m_failed = false;     // until a picture that was begun is there
    std::uint64_t m_epoch = 0; // how often all was forgotten
    BackgroundTask m_task;
};

} // namespace spacetow
