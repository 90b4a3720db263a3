#include "core/level/level.h"

#include "core/base/random.h"

#include <algorithm>

namespace spacetow {

std::array<Vec2, 4> shipOutline() {
    return {Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)};
}

Key freshKey(const Level& level, std::uint64_t seed) {
    Random random(seed);
    for (;;) {
        const Key key = random.next();
        if (key != 0 && level.objects.find(key) == nullptr) {
            return key;
        }
    }
}

} // namespace spacetow
