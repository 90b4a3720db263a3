#include "editor/play/ground_picture.h"

#include "editor/canvas/scene_painter.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr int ahead = 5; // of the shorter side of the view, the part that is painted beyond it on each side

bool isStatic(const BodyPicture& body) {
    return body.look->kind == BodyKind::Static;
}

} // namespace

void GroundPicture::draw(QPainter& painter, const Frame2D& frame, const Snapshot& snapshot, const Theme& theme) {
    if (!stillStands(snapshot)) {
        take(snapshot);
        m_layer.discard();
    }
    const bool painted = m_layer.canShiftTo(frame) && m_layer.frame().all().contains(m_layer.frame().rectOf(frame));
    if (!painted) {
        const QSize size = frame.deviceSize();
        const Frame2D wide = frame.grown(std::min(size.width(), size.height()) / ahead);
        const QRegion missing = m_layer.missingIn(wide);
        m_layer.shiftTo(wide);
        m_layer.paint(missing, theme, [&](const Stage& stage) { paintStatics(stage, snapshot, m_ground); });
    }
    m_layer.draw(painter, frame);
}

bool GroundPicture::stillStands(const Snapshot& snapshot) const {
    std::size_t count = 0;
    for (const BodyPicture& body : snapshot.bodies) {
        if (!isStatic(body)) {
            break; // they come first
        }
        if (count == m_standing.size() ||
            !(m_standing[count] == Standing{body.look, body.pose.position, body.pose.rotation})) {
            return false;
        }
        ++count;
    }
    return count == m_standing.size();
}

void GroundPicture::take(const Snapshot& snapshot) {
    m_standing.clear();
    for (const BodyPicture& body : snapshot.bodies) {
        if (!isStatic(body)) {
            break;
        }
        m_standing.push_back({body.look, body.pose.position, body.pose.rotation});
    }
    m_ground = groundOf(snapshot);
}

} // namespace spacetow
