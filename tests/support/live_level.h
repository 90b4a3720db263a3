#pragma once
// Levels that are edited while they run, and how each object is edited.

#include "core/game/session.h"
#include "tests/support/game_levels.h"

namespace spacetow::test {

constexpr Key floorKey = 11, boxKey = 12, ballKey = 13, springKey = 14;

inline void addBodyObject(Level& level, Key key, BodyObject body) {
    level.objects.append({key, "", std::move(body), {}});
}

inline BodyObject ballAt(const Vec2& position) {
    return {.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, 0.25}}, .position = position};
}

/// A box on a floor, and a ball that hangs from it by a spring without a length of its own; no ship.
inline Level yard() {
    Level level;
    level.gravity = Vec2(0, -10);
    level.iterations = 4;
    addBodyObject(level, floorKey, {.shapes = {LineChain{{{-20, 0}, {20, 0}}, false}}});
    addBodyObject(level, boxKey,
                  {.kind = BodyKind::Dynamic,
                   .shapes = {Polygon{{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}}},
                   .position = Vec2(0, 2)});
    addBodyObject(level, ballKey, ballAt(Vec2(2, 2)));
    level.objects.append({springKey, "", ConnectorObject{.a = boxKey, .b = ballKey, .stiffness = 30}, {}});
    return level;
}

/// The level with the object changed by a function of its data.
template <class Data, class Change>
std::shared_ptr<const Level> edited(const Level& level, Key key, Change change) {
    Level after = level;
    const int index = after.objects.indexOf(key);
    Object object = after.objects[index];
    change(std::get<Data>(object.data));
    after.objects.replace(index, std::move(object));
    return std::make_shared<const Level>(std::move(after));
}

inline std::shared_ptr<const Level> without(const Level& level, Key key) {
    Level after = level;
    after.objects.eraseIf([key](const Object& object) { return object.key == key; });
    return std::make_shared<const Level>(std::move(after));
}

inline void stepOn(Session& session, int updates, const StepInput& input = {}) {
    for (int i = 0; i < updates; ++i) {
        session.step(input);
    }
}

inline StepInput withLevel(std::shared_ptr<const Level> level) {
    return {{}, {}, std::move(level)};
}

inline BodyState stateOf(const Session& session, Key key) {
    const std::optional<BodyId> body = session.bodyOf(key);
    EXPECTS(body);
    return session.world().body(*body);
}

} // namespace spacetow::test
