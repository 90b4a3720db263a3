#include "tests/support/reach_runs.h"

#include "core/game/reach.h"
#include "tests/support/game_levels.h"

namespace spacetow::test {

namespace {

Controls someKeys(Random& random) {
    return controlsFromBits(static_cast<std::uint8_t>(random.below(8)));
}

/// Waiting, flying or towing.
Session someFlight(Random& random) {
    switch (random.below(3)) {
    case 0:
        return Session(reachSpace());
    case 1: {
        Session session(reachSpace());
        session.step(thrust);
        steerAtRandom(session, random, static_cast<int>(random.below(150)));
        return session;
    }
    default: {
        Session session = onTheRope();
        steerAtRandom(session, random, static_cast<int>(random.below(150)));
        return session;
    }
    }
}

} // namespace

Level reachSpace(const Vec2& payload) {
    Level level = openSpaceWithPayloadAt(payload);
    level.gravity = Vec2(0, -0.95);
    level.objects.replace(2, {finishKey, "finish", FinishObject{Vec2(-1, 9000), Vec2(1, 9000)}, {}});
    return level;
}

Session onTheRope() {
    return towing(reachSpace(Vec2(0, -1)));
}

void steerAtRandom(Session& session, Random& random, int updates) {
    Controls keys;
    for (int i = 0, held = 0; i < updates; ++i, --held) {
        if (held <= 0) {
            keys = someKeys(random);
            held = 1 + static_cast<int>(random.below(30));
        }
        session.step(keys);
    }
}

bool isWithin(const std::vector<Vec2>& outline, const Vec2& point) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2& a = outline[i];
        const Vec2& b = outline[(i + 1) % outline.size()];
        if (cross(b - a, point - a) < -1e-9) {
            return false;
        }
    }
    return outline.size() > 2;
}

bool endsWithinItsReach(std::uint64_t seed) {
    Random random(seed);
    Session session = someFlight(random);
    const int updates = 10 + static_cast<int>(random.below(241));
    const ReachOutline outline = reachOutlines(session, {updates * session.updateSeconds()}).front();
    const bool onRope = session.phase() == Phase::Towing;
    steerAtRandom(session, random, updates);
    return outline.payload.empty() == !onRope && isWithin(outline.ship, session.ship()->massCenter) &&
           (!onRope || isWithin(outline.payload, session.payload()->massCenter));
}

} // namespace spacetow::test
