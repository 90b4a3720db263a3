#include "editor/editing/snap_align.h"

#include "core/level/level_index.h"

#include <array>
#include <cmath>
#include <span>

namespace spacetow {

namespace {

constexpr double aroundPixels = 600; // as far as objects align where the view is not known
constexpr double oneLine = 1e-9;     // m, between lines that are one
constexpr double evenPixels = 4;     // from a line of the grid, within which nothing draws but that
constexpr double coarsePixels = 8;   // between grid lines; closer ones would go before everything

std::array<double, 3> linesOf(const Aabb& box, int axis) {
    return {box.min[axis], box.center()[axis], box.max[axis]};
}

/// The one that is nearest and, of objects in one line, whose bounds are.
class Nearest {
  public:
    Nearest(const SnapSettings& settings, const SnapQuery& query, int axis, double reach)
        : m_settings(settings), m_query(query), m_axis(axis), m_reach(reach) {}

    void offer(double mine, Key key, const Aabb& box) {
        const double far = box.center()[1 - m_axis];
        const double gap = std::abs(far - m_query.at[1 - m_axis]);
        for (const double value : linesOf(box, m_axis)) {
            const double away = std::abs(value - mine);
            const bool nearer = !found || away < m_away - oneLine || (away < m_away + oneLine && gap < m_gap);
            if (away <= m_reach && nearer && !losesToGrid(value - mine)) {
                found = Alignment{value, mine, key, far};
                m_away = away;
                m_gap = gap;
            }
        }
    }

    std::optional<Alignment> found;

  private:
    /// Whether the grid has the point rather than a line that is so far from it.
    bool losesToGrid(double way) const {
        if (!m_settings.grid || m_settings.fineStep() < coarsePixels * m_query.pixel) {
            return false;
        }
        const auto offGrid = [&](double value) { return std::abs(onGrid(m_settings, value) - value); };
        const double place = m_query.at[m_axis];
        const double beside = offGrid(place + way);
        return beside > oneLine && (beside <= evenPixels * m_query.pixel || offGrid(place) < std::abs(way));
    }

    const SnapSettings& m_settings;
    const SnapQuery& m_query;
    int m_axis;
    double m_reach;
    double m_away = 0, m_gap = 0;
};

} // namespace

Aabb alignedBox(const Object& object, const Aabb& bounds) {
    if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        return {ship->position, ship->position};
    }
    const auto* payload = std::get_if<PayloadObject>(&object.data);
    return payload == nullptr ? bounds : Aabb{payload->position, payload->position};
}

std::optional<Alignment> alignmentOf(const Level& level, const SnapSettings& settings, const SnapSubject& subject,
                                     const SnapQuery& query, int axis) {
    const double reach = calm * settings.reach * query.pixel;
    std::array<double, 3> mine{query.at[axis], query.at[axis], query.at[axis]};
    std::size_t lines = 1;
    if (!subject.box.isEmpty()) {
        mine = linesOf({subject.box.min + query.at, subject.box.max + query.at}, axis);
        lines = mine.size();
    }
    const LevelIndex& index = levelIndex(level);
    const Aabb seen = query.view.isEmpty() ? Aabb{query.at, query.at}.grown(aroundPixels * query.pixel) : query.view;
    Nearest nearest(settings, query, axis, reach);
    for (const double line : std::span(mine).first(lines)) {
        Aabb band = seen;
        band.min[axis] = line - reach;
        band.max[axis] = line + reach;
        index.visitObjects(band, [&](int object) {
            const Object& other = level.objects[object];
            if (!std::holds_alternative<ConnectorObject>(other.data) && staysInView(level, subject, object)) {
                nearest.offer(line, other.key, alignedBox(other, index.boundsOf(object)));
            }
        });
    }
    return nearest.found;
}

} // namespace spacetow
