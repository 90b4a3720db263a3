#include "core/level/guides.h"

#include "core/level/unknown_fields.h"
#include "core/math/transform.h"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace spacetow {

Vec2 directionOf(const Guide& guide) {
    // Exact along the axes, so that what snaps to a level guide lies on it to the last bit.
    constexpr double quarter = std::numbers::pi / 2;
    const double turns = guide.angle / quarter;
    const double whole = std::round(turns);
    if (std::abs(turns - whole) < 1e-12) {
        return std::fmod(whole, 2) == 0 ? Vec2(1, 0) : Vec2(0, 1);
    }
    return Rot::fromAngle(guide.angle).right();
}

double distanceTo(const Guide& guide, const Vec2& point) {
    return std::abs(cross(directionOf(guide), point - guide.point));
}

Vec2 footOn(const Guide& guide, const Vec2& point) {
    const Vec2 along = directionOf(guide);
    if (along.y() == 0) { // exact, which the sum below is not
        return {point.x(), guide.point.y()};
    }
    if (along.x() == 0) {
        return {guide.point.x(), point.y()};
    }
    return guide.point + along.dot(point - guide.point) * along;
}

Level guideAdded(Level level, const Guide& guide) {
    level.guides.push_back(guide);
    return level;
}

Level guideReplaced(Level level, std::size_t index, const Guide& guide) {
    if (index < level.guides.size()) {
        level.guides[index] = guide;
    }
    return level;
}

Level guideRemoved(Level level, std::size_t index) {
    if (index < level.guides.size()) {
        level.guides.erase(level.guides.begin() + static_cast<std::ptrdiff_t>(index));
        level.unknownFields = withoutEntries(level.unknownFields, "/guides", std::array{static_cast<int>(index)});
    }
    return level;
}

Level guidesCleared(Level level) {
    std::vector<int> all(level.guides.size());
    std::iota(all.begin(), all.end(), 0);
    level.unknownFields = withoutEntries(level.unknownFields, "/guides", all);
    level.guides.clear();
    return level;
}

} // namespace spacetow
