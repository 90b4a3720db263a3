#include "core/level/leak_paths.h"

#include <algorithm>
#include <limits>
#include <queue>

namespace spacetow {

namespace {

/// An edge that the way goes over, as seen on the way.
struct Portal {
    Vec2 left{0, 0};
    Vec2 right{0, 0};
};

Portal portalOf(const LeakMesh& mesh, int edge, double margin) {
    const Vec2 right = mesh.at(mesh.net().origin(edge));
    const Vec2 left = mesh.at(mesh.net().target(edge));
    const Vec2 across = left - right;
    const double share = std::min(margin / across.norm(), 0.499);
    return {left - share * across, right + share * across};
}

/// The shortest way through the portals: a string is pulled tight between them.
std::vector<Vec2> pulledTight(const Vec2& from, const std::vector<Portal>& portals, const Vec2& to) {
    std::vector<Vec2> points{from};
    Vec2 left = from;
    Vec2 right = from;
    std::size_t leftAt = 0;
    std::size_t rightAt = 0;
    const auto portal = [&](std::size_t i) { return i < portals.size() ? portals[i] : Portal{to, to}; };
    // Begins anew at each corner of the way; `steps` is for rounding, which must not make it endless.
    std::size_t steps = 50 * (portals.size() + 10);
    for (std::size_t i = 0; i <= portals.size() && steps > 0; ++i, --steps) {
        const Vec2 apex = points.back();
        const Portal next = portal(i);
        const auto turn = [&apex](const Vec2& a, const Vec2& b) { return cross(a - apex, b - apex); };
        if (turn(right, next.right) >= 0) {
            if (apex == right || turn(left, next.right) < 0) {
                right = next.right;
                rightAt = i;
            } else {
                points.push_back(left);
                i = leftAt;
                rightAt = leftAt;
                right = left;
                continue;
            }
        }
        if (turn(left, next.left) <= 0) {
            if (apex == left || turn(right, next.left) > 0) {
                left = next.left;
                leftAt = i;
            } else {
                points.push_back(right);
                i = rightAt;
                leftAt = rightAt;
                left = right;
                continue;
            }
        }
    }
    points.push_back(to);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

struct Visit {
    double length; // m, so far
    int triangle;

    bool operator>(const Visit& other) const {
        return length != other.length ? length > other.length : triangle > other.triangle;
    }
};

/// How each triangle is entered on the shortest way to it, along the middles of the edges.
struct Entries {
    std::vector<double> length;
    std::vector<int> edge;
    int outside = -1;
};

Entries entriesFrom(const LeakMesh& mesh, const Vec2& ship, const std::stop_token& stop) {
    const auto count = static_cast<std::size_t>(mesh.net().edgeCount() / 3);
    Entries entries{std::vector<double>(count, std::numeric_limits<double>::infinity()), std::vector<int>(count, -1)};
    std::priority_queue<Visit, std::vector<Visit>, std::greater<>> queue;
    queue.push({0, mesh.start()});
    entries.length[static_cast<std::size_t>(mesh.start())] = 0;
    const auto middle = [&mesh](int edge) {
        return Vec2(0.5 * (mesh.at(mesh.net().origin(edge)) + mesh.at(mesh.net().target(edge))));
    };
    for (int steps = 1; !queue.empty() && !(steps % 1024 == 0 && stop.stop_requested()); ++steps) {
        const Visit visit = queue.top();
        queue.pop();
        const auto at = static_cast<std::size_t>(visit.triangle);
        if (visit.length > entries.length[at]) {
            continue;
        }
        if (mesh.isOutside(visit.triangle)) {
            entries.outside = visit.triangle;
            break;
        }
        const Vec2 from = entries.edge[at] < 0 ? ship : middle(entries.edge[at]);
        for (int edge = 3 * visit.triangle; edge < 3 * visit.triangle + 3; ++edge) {
            if (!mesh.lets(edge)) {
                continue;
            }
            const auto next = static_cast<std::size_t>(mesh.net().twin(edge) / 3);
            const double length = visit.length + (middle(edge) - from).norm();
            if (length < entries.length[next]) {
                entries.length[next] = length;
                entries.edge[next] = edge;
                queue.push({length, static_cast<int>(next)});
            }
        }
    }
    return entries;
}

} // namespace

Reach reachOf(const LeakMesh& mesh, const std::stop_token& stop) {
    Reach reach{false, std::vector<char>(static_cast<std::size_t>(mesh.net().edgeCount() / 3), 0)};
    std::vector<int> todo{mesh.start()};
    reach.triangles[static_cast<std::size_t>(mesh.start())] = 1;
    for (int steps = 1; !todo.empty() && !(steps % 1024 == 0 && stop.stop_requested()); ++steps) {
        const int triangle = todo.back();
        todo.pop_back();
        if (mesh.isOutside(triangle)) {
            reach.isOutside = true;
            break;
        }
        for (int edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
            if (mesh.lets(edge)) {
                const int next = mesh.net().twin(edge) / 3;
                if (reach.triangles[static_cast<std::size_t>(next)] == 0) {
                    reach.triangles[static_cast<std::size_t>(next)] = 1;
                    todo.push_back(next);
                }
            }
        }
    }
    return reach;
}

Escape shortestEscape(const LeakMesh& mesh, const Vec2& ship, double margin, const std::stop_token& stop) {
    const Entries entries = entriesFrom(mesh, ship, stop);
    Escape escape;
    if (entries.outside < 0) {
        return escape;
    }
    std::vector<Portal> portals;
    for (int triangle = entries.outside; triangle != mesh.start();) {
        const int edge = entries.edge[static_cast<std::size_t>(triangle)];
        escape.edges.push_back(edge);
        portals.push_back(portalOf(mesh, edge, margin));
        triangle = edge / 3;
    }
    std::ranges::reverse(escape.edges);
    std::ranges::reverse(portals);
    Vec2 end = ship;
    if (!portals.empty()) {
        // As far beyond the last edge as it is long, within reason.
        const Vec2 across = portals.back().left - portals.back().right;
        const double far = std::clamp(across.norm(), 4 * margin, 20 * margin);
        end = 0.5 * (portals.back().left + portals.back().right) - far * leftOf(across.normalized());
        end = isFinite(end) ? end : portals.back().left;
    }
    escape.points = pulledTight(ship, portals, end);
    return escape;
}

} // namespace spacetow
