#include "editor/play/scene_marks.h"

#include "core/base/random.h"
#include "core/game/ship.h"

#include <QLinearGradient>
#include <QPainterPath>

#include <algorithm>

namespace spacetow {
namespace {

const BodyPicture* find(const Snapshot& snapshot, BodyRole role) {
    return snapshot.find([&](const BodyPicture& body) { return body.look->role == role; });
}

/// Part of a flame.
struct Tongue {
    double length, width; // m
    QColor hot, cold;     // at its root and its tip
};

void paintTongue(const Stage& stage, const Transform& pose, const Tongue& tongue) {
    const double width = tongue.width;
    const double length = tongue.length;
    const Vec2 root = shipNotch() + Vec2(0, 0.02);
    const Vec2 tip = root - Vec2(0, length);
    const auto at = [&](const Vec2& local) { return stage.at(pose.toWorld(local)); };
    QPainterPath path(at(root + Vec2(-width, 0)));
    path.quadTo(at(root + Vec2(-1.3 * width, -0.45 * length)), at(tip));
    path.quadTo(at(root + Vec2(1.3 * width, -0.45 * length)), at(root + Vec2(width, 0)));
    path.closeSubpath();
    QLinearGradient gradient(at(root), at(tip));
    gradient.setColorAt(0, tongue.hot);
    gradient.setColorAt(0.35, tongue.hot);
    gradient.setColorAt(1, tongue.cold);
    stage.painter.fillPath(path, gradient);
}

} // namespace

void paintFlame(const Stage& stage, const Snapshot& snapshot) {
    const bool flying = snapshot.phase == Phase::Flying || snapshot.phase == Phase::Towing;
    const BodyPicture* ship = find(snapshot, BodyRole::Ship);
    if (!flying || !snapshot.controls.thrust || ship == nullptr) {
        return;
    }
    Random random(static_cast<std::uint64_t>(snapshot.update));
    const double flicker = random.uniform(0.8, 1.15);
    stage.painter.save();
    stage.painter.setRenderHint(QPainter::Antialiasing);
    paintTongue(stage, ship->pose, {0.62 * flicker, 0.095, QColor(255, 176, 60), QColor(255, 70, 30, 0)});
    paintTongue(stage, ship->pose, {0.36 * flicker, 0.055, QColor(255, 255, 235), QColor(255, 200, 90, 0)});
    stage.painter.restore();
}

void paintTowRange(const Stage& stage, const Snapshot& snapshot, double range) {
    const BodyPicture* ship = find(snapshot, BodyRole::Ship);
    const BodyPicture* payload = find(snapshot, BodyRole::Payload);
    if (snapshot.phase != Phase::Flying || ship == nullptr || payload == nullptr || !(range > 0)) {
        return;
    }
    // Fades in over the last two metres of the approach.
    const double gap = (ship->pose.position - payload->pose.position).norm() - range;
    const double nearness = std::clamp(1 - gap / 2, 0.0, 1.0);
    if (nearness <= 0) {
        return;
    }
    stage.painter.save();
    stage.painter.setRenderHint(QPainter::Antialiasing);
    QColor color = snapshot.hud.towInRange ? QColor(255, 226, 150) : QColor(190, 214, 255);
    color.setAlphaF(static_cast<float>(nearness * (snapshot.hud.towInRange ? 0.9 : 0.45)));
    stage.painter.setPen(stroke(color, snapshot.hud.towInRange ? 2 : 1.5, Qt::DashLine));
    stage.painter.setBrush(Qt::NoBrush);
    const double radius = stage.pixels(range);
    stage.painter.drawEllipse(stage.at(payload->pose.position), radius, radius);
    stage.painter.restore();
}

} // namespace spacetow
