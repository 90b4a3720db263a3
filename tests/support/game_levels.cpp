#include "tests/support/game_levels.h"

namespace spacetow::test {

Level openSpaceWithPayloadAt(const Vec2& position) {
    Level level;
    level.name = "open space";
    level.gravity = Vec2(0, 0);
    level.iterations = 10;
    level.objects.append({shipKey, "ship", ShipObject{}, {}});
    level.objects.append({payloadKey, "payload", PayloadObject{position}, {}});
    level.objects.append({finishKey, "finish", FinishObject{Vec2(-10, 2), Vec2(10, 2)}, {}});
    return level;
}

Level openSpace() {
    return openSpaceWithPayloadAt(Vec2(0, -1));
}

void addWall(Level& level, const Vec2& a, const Vec2& b) {
    BodyObject wall;
    const Vec2 span = b - a;
    wall.position = a;
    wall.shapes = {EdgeChain{{Vec2(0, 0), span}, false, 1}};
    level.objects.append({freshKey(level, 7), "wall", wall, {}});
}

void addBall(Level& level, const Vec2& position, double radius, const Vec2& velocity) {
    BodyObject ball;
    ball.kind = BodyKind::Dynamic;
    ball.position = position;
    ball.velocity = velocity;
    ball.shapes = {Circle{Vec2(0, 0), radius}};
    level.objects.append({freshKey(level, 7), "ball", ball, {}});
}

void hold(Session& session, const Controls& controls, int updates) {
    for (int i = 0; i < updates; ++i) {
        session.step(controls);
    }
}

void press(Session& session, const Controls& controls) {
    session.step(idle);
    session.step(controls);
}

bool holdUntil(Session& session, const Controls& controls, Phase phase, int updates) {
    for (int i = 0; i < updates && session.phase() != phase; ++i) {
        session.step(controls);
    }
    return session.phase() == phase;
}

Session towing(const Level& level) {
    Session session(level);
    press(session, right);
    press(session, tow);
    EXPECTS(session.phase() == Phase::Towing);
    return session;
}

Level spaceWithCeiling() {
    Level level = openSpace();
    addWall(level, Vec2(3, 1), Vec2(-3, 1));
    return level;
}

std::vector<BodyPicture> allBodies(const Snapshot& picture) {
    std::vector<BodyPicture> all = *picture.statics;
    all.insert(all.end(), picture.moving.begin(), picture.moving.end());
    return all;
}

std::size_t count(const Session& session, BodyRole role) {
    const std::shared_ptr<const Snapshot> picture = session.snapshot();
    std::size_t found = 0;
    for (const BodyPicture& body : allBodies(*picture)) {
        found += body.look->role == role ? 1u : 0u;
    }
    return found;
}

bool heard(const Session& session, Sound sound) {
    return (session.snapshot()->sounds & static_cast<std::uint32_t>(sound)) != 0;
}

} // namespace spacetow::test
