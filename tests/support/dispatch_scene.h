#pragma once
// A world whose bodies have handlers, and a record of what these heard.

#include "core/physics/query/dispatcher.h"
#include "tests/support/contact_scenes.h"

#include <algorithm>
#include <vector>

namespace spacetow::test {

inline constexpr TagMask wallMask = TagMask::bit(0);
inline constexpr TagMask ballTag = TagMask::bit(3);

/// One call of a handler.
struct Call {
    enum class What { Touched, Tags, Removed } what;
    BodyId body;
    BodyId other;      // Touched
    int iteration = 0; // not of Removed
    TagMask tags;      // Tags

    bool operator==(const Call&) const = default;
};

/// A world in which balls move straight on, and what its handlers heard.
struct DispatchScene {
    World world{withIterations(10, {0, 0})};
    Dispatcher dispatcher;
    std::vector<Call> calls;

    BodyId addBall(const Vec2& at, const Vec2& velocity, bool reports = false) {
        BodyDef def = ball(at, 0.25);
        def.velocity = velocity;
        def.restitution = 1;
        def.friction = 0;
        def.filter.tags = ballTag;
        def.reportsTouches = reports;
        return add(world, def);
    }
    BodyId addWall(double x) {
        BodyDef def = lineBody({x, -5}, {x, 5});
        def.filter.tags = wallMask;
        def.restitution = 1;
        return add(world, def);
    }
    BodyHandler recording(BodyId body) {
        return {[this, body](BodyId other, const TouchEvent& touch) {
                    calls.push_back({Call::What::Touched, body, other, touch.iteration, {}});
                },
                [this, body](TagMask tags, int iteration) {
                    calls.push_back({Call::What::Tags, body, {}, iteration, tags});
                },
                [this, body] {
                    calls.push_back({Call::What::Removed, body, {}, 0, {}});
                }};
    }
    void record(BodyId body) { dispatcher.set(body, recording(body)); }
    void onTouch(BodyId body, std::function<void(BodyId, const TouchEvent&)> what) {
        dispatcher.set(body, {.touched = std::move(what)});
    }
    void step(int updates = 1) {
        for (int i = 0; i < updates; ++i) {
            world.update();
            dispatcher.dispatch(world);
        }
    }
    qsizetype count(Call::What what, BodyId body) const {
        return std::count_if(calls.begin(), calls.end(),
                             [&](const Call& call) { return call.what == what && call.body == body; });
    }
};

/// A ball that hits a wall after a few updates, and comes back.
struct Hit : DispatchScene {
    BodyId wall = addWall(1);
    BodyId ball = addBall({0, 0}, {5, 0});
};

} // namespace spacetow::test
