#include "core/game/thinned_path.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace spacetow {
namespace {

double squaredDistance(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double length = along.squaredNorm();
    const double share = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
    return (p - a - share * along).squaredNorm();
}

} // namespace

std::vector<Vec2> thinned(std::span<const Vec2> points, double tolerance) {
    if (points.size() < 3) {
        return {points.begin(), points.end()};
    }
    std::vector<bool> kept(points.size());
    kept.front() = kept.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        std::size_t farthest = from;
        double most = tolerance * tolerance;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double distance = squaredDistance(points[i], points[from], points[to]);
            if (distance > most) {
                most = distance;
                farthest = i;
            }
        }
        if (farthest != from) {
            kept[farthest] = true;
            open.emplace_back(from, farthest);
            open.emplace_back(farthest, to);
        }
    }
    std::vector<Vec2> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) {
            result.push_back(points[i]);
        }
    }
    return result;
}

} // namespace spacetow
