#include "editor/play/ground_picture.h"

#include "editor/canvas/scene_painter.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

constexpr int ahead = 5; // of the shorter side of the view, the part that is painted beyond it on each side

int roomAround(const Frame2D& frame) {
    const QSize size = frame.deviceSize();
    return std::min(size.width(), size.height()) / ahead;
}

} // namespace

void GroundPicture::draw(QPainter& painter, const Frame2D& frame, const Snapshot& snapshot, const Theme& theme) {
    if (std::exchange(m_theme, &theme) != &theme) {
        ++m_epoch;
        m_standing.reset();
    }
    const bool sameList = std::exchange(m_seen, snapshot.statics) == snapshot.statics;
    if (!m_standing || !(sameList || standAlike(*m_standing->bodies, *snapshot.statics))) {
        m_standing = standing(snapshot);
        m_isOld = m_layer.isValid();
    }
    if (m_standing->isMuch) {
        paintBeside(frame, theme);
    } else if (!shows(frame)) {
        if (std::exchange(m_isOld, false)) {
            m_layer.discard();
        }
        paint(m_layer, frame.grown(roomAround(frame)), *m_standing, theme);
    }
    m_layer.draw(painter, frame);
}

void GroundPicture::forget(const PictureLayer& meanwhile) {
    ++m_epoch; // what is being painted will not be taken
    m_standing.reset();
    m_layer = meanwhile;
    m_isOld = m_layer.isValid();
}

bool GroundPicture::shows(const Frame2D& frame) const {
    return !m_isOld && m_layer.canShiftTo(frame) && m_layer.frame().all().contains(m_layer.frame().rectOf(frame));
}

void GroundPicture::paint(PictureLayer& layer, const Frame2D& frame, Standing& standing, const Theme& theme) {
    if (!standing.ground) {
        standing.ground = std::make_unique<const Ground>(groundOf(*standing.bodies));
    }
    const QRegion missing = layer.missingIn(frame);
    layer.shiftTo(frame);
    layer.paint(missing, theme, [&](const Stage& stage) { paintStatics(stage, *standing.bodies, *standing.ground); });
}

/// One picture at a time, and the next before the view has left this one.
void GroundPicture::paintBeside(const Frame2D& frame, const Theme& theme) {
    if (m_task.isRunning() || shows(frame.grown(roomAround(frame) / 2))) {
        return;
    }
    const PictureLayer before = m_isOld ? PictureLayer() : m_layer;
    const Frame2D wide = frame.grown(roomAround(frame));
    m_task.start([this, before, wide, standing = m_standing, epoch = m_epoch,
                  &theme](const std::stop_token&) -> BackgroundTask::Then {
        PictureLayer layer = before;
        paint(layer, wide, *standing, theme);
        return [this, layer, standing, epoch] {
            if (epoch == m_epoch) { // where something moves in each frame, all pictures are a little old
                m_layer = layer;
                m_isOld = standing != m_standing;
            }
            if (painted) {
                painted();
            }
        };
    });
}

std::shared_ptr<GroundPicture::Standing> GroundPicture::standing(const Snapshot& snapshot) {
    auto standing =
        std::make_shared<Standing>(Standing{.bodies = snapshot.statics, .ground = nullptr, .isMuch = false});
    std::size_t shapes = 0;
    for (auto body = snapshot.statics->begin(); body != snapshot.statics->end() && shapes <= few; ++body) {
        shapes += body->look->shapes.size();
    }
    standing->isMuch = shapes > few;
    return standing;
}

} // namespace spacetow
