#include "core/game/blend.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spacetow {
namespace {

Vec2 between(const Vec2& a, const Vec2& b, double share) {
    return a + share * (b - a);
}

Rot between(const Rot& a, const Rot& b, double share) {
    // Normalised linear interpolation: between two updates a body turns far less than half a turn.
    const double c = a.c + share * (b.c - a.c);
    const double s = a.s + share * (b.s - a.s);
    const double length = std::hypot(c, s);
    return length > 1e-6 ? Rot{c / length, s / length} : b;
}

bool isOver(Phase phase) {
    return phase == Phase::Crashed || phase == Phase::GameOver || phase == Phase::Won;
}

} // namespace

Snapshot blended(const Snapshot& before, const Snapshot& now, double share) {
    Snapshot picture = now;
    const double t = std::clamp(share, 0.0, 1.0);
    // Both lists are in order of creation within each kind, so that equal bodies come in equal order.
    std::size_t next = 0;
    for (BodyPicture& body : picture.moving) {
        const std::pair place(body.look->kind, body.look->id);
        const auto at = [&](std::size_t i) {
            return std::pair(before.moving[i].look->kind, before.moving[i].look->id);
        };
        while (next < before.moving.size() && at(next) < place) {
            ++next;
        }
        if (next < before.moving.size() && at(next) == place) {
            const BodyPicture& old = before.moving[next];
            body.pose.position = between(old.pose.position, body.pose.position, t);
            body.pose.rotation = between(old.pose.rotation, body.pose.rotation, t);
        }
    }
    if (before.connectors.size() == now.connectors.size()) {
        for (std::size_t i = 0; i < picture.connectors.size(); ++i) {
            picture.connectors[i].a = between(before.connectors[i].a, picture.connectors[i].a, t);
            picture.connectors[i].b = between(before.connectors[i].b, picture.connectors[i].b, t);
        }
    }
    if (!isOver(before.phase) || isOver(now.phase)) {
        picture.camera = between(before.camera, now.camera, t);
    }
    return picture;
}

} // namespace spacetow
