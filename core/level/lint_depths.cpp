// How deep walls are: too deep for what lies behind, or too thin for what comes fast.
#include "core/geometry/intersect.h"
#include "core/level/json_text.h"
#include "core/level/lint_walls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

/// The first wall behind a place, as it is met on the way from the face into the depth.
struct BehindHit {
    double distance = 0; // m
    bool leaves = false; // seen from its own back: on its other side all is free
};

class DepthProbe {
  public:
    explicit DepthProbe(const Walls& walls) : m_walls(walls) {
        for (const Aabb& box : walls.still.tree.boxes()) {
            m_bounds.include(box);
        }
        m_stride = std::max(m_bounds.size().norm() / strides, 0.01);
    }

    /// In a heap of walls that lie across each other there is no telling what is behind what; one gives up.
    bool isTired() const { return m_work > mostWork; }
    /// Looks from a point of the chain's segment as far as `depth`.
    std::optional<BehindHit> behind(int chain, int segment, double fraction, double depth) {
        constexpr double skin = 1e-6; // m: what is nearer is the wall itself
        const WallChain& own = m_walls.chains[static_cast<std::size_t>(chain)];
        const Vec2 along = own.end(segment) - own.start(segment);
        const Vec2 way = -leftOf(along).normalized();
        const Vec2 from = own.start(segment) + fraction * along + skin * way;
        for (double near = 0; near < depth; near += m_stride) {
            const Vec2 a = from + near * way;
            if (!m_bounds.contains(a)) {
                break;
            }
            const Vec2 b = from + std::min(near + m_stride, depth) * way;
            if (const auto hit = firstHit(own, a, b, way)) {
                return BehindHit{near + hit->distance, hit->leaves};
            }
        }
        return {};
    }

  private:
    static constexpr double strides = 48;               // across the whole level
    static constexpr std::size_t mostWork = 10'000'000; // looks at single segments: a second
    static constexpr std::size_t queryWork = 10;        // as many of them as a query of the tree is worth

    std::optional<BehindHit> firstHit(const WallChain& own, const Vec2& a, const Vec2& b, const Vec2& way) {
        Aabb box;
        box.include(a);
        box.include(b);
        m_near.clear();
        m_walls.still.tree.query(box, m_near);
        m_work += m_near.size() + queryWork;
        std::optional<BehindHit> first;
        for (const std::uint32_t index : m_near) {
            const WallTree::Segment& at = m_walls.still.segments[index];
            const WallChain& chain = m_walls.chains[static_cast<std::size_t>(at.chain)];
            const Vec2& start = chain.start(at.segment);
            const Vec2& end = chain.end(at.segment);
            // Whatever other filters may let pass, bodies that feel this wall and not that one see no free side there.
            if (!chain.oneWay || !(chain.body->filter == own.body->filter)) {
                continue;
            }
            const auto fraction = segmentFraction(a, b, start, end);
            if (fraction && (!first || *fraction * (b - a).norm() < first->distance)) {
                first = BehindHit{*fraction * (b - a).norm(), leftOf(end - start).dot(way) > 0};
            }
        }
        return first;
    }

    const Walls& m_walls;
    Aabb m_bounds;
    double m_stride = 1;
    std::vector<std::uint32_t> m_near;
    std::size_t m_work = 0;
};

/// The thinnest place of what lies behind a chain.
struct Thinnest {
    double thickness = noBack;
    std::vector<Vec2> place;
};

Thinnest thinnestBehind(DepthProbe& probe, const Walls& walls, int index, bool thorough) {
    const WallChain& chain = walls.chains[static_cast<std::size_t>(index)];
    Thinnest thinnest;
    for (int s = 0; s < chain.segments() && !probe.isTired(); ++s) {
        for (const double fraction : {0.5, 0.25, 0.75}) {
            if (fraction != 0.5 && !thorough) {
                continue;
            }
            const auto hit = probe.behind(index, s, fraction, std::min(chain.depth, thinnest.thickness));
            if (hit && hit->leaves && hit->distance < thinnest.thickness) {
                const Vec2 along = chain.end(s) - chain.start(s);
                const Vec2 from = chain.start(s) + fraction * along;
                thinnest = {hit->distance, {from, from - hit->distance * leftOf(along).normalized()}};
            }
        }
    }
    return thinnest;
}

/// A straight wall in the open, under which there is room that another wall bounds.
bool isShelf(DepthProbe& probe, const Walls& walls, int index) {
    const WallChain& chain = walls.chains[static_cast<std::size_t>(index)];
    if (chain.closed || chain.segments() != 1) {
        return false;
    }
    constexpr double clear = 0.3; // m round the ends: nothing that it could belong to
    for (const Vec2& end : {chain.start(0), chain.end(0)}) {
        std::vector<std::uint32_t> near;
        const Aabb box = Aabb{end, end}.grown(clear);
        walls.still.tree.query(box, near);
        for (const std::uint32_t i : near) {
            const WallTree::Segment& at = walls.still.segments[i];
            const WallChain& other = walls.chains[static_cast<std::size_t>(at.chain)];
            if (at.chain != index && segmentMeets(other.start(at.segment), other.end(at.segment), box)) {
                return false;
            }
        }
    }
    const auto facesUs = [&](double fraction) {
        const auto hit = probe.behind(index, 0, fraction, noBack);
        return hit && !hit->leaves && hit->distance > clear;
    };
    return facesUs(0.05) && facesUs(0.5) && facesUs(0.95);
}

/// m: how far what is likely fastest moves between two looks at what it touches. Kinematic bodies are as fast as they
/// are told to be, others as they start; the ship, falling under full thrust against its damping, by what it can reach.
double longestStep(const Level& level) {
    double speed = 0;
    bool hasShip = false;
    for (const Object& object : level.objects) {
        hasShip = hasShip || std::holds_alternative<ShipObject>(object.data);
        if (const auto* body = std::get_if<BodyObject>(&object.data)) {
            speed = std::max(speed, body->kind == BodyKind::Static ? 0 : body->velocity.norm());
        }
    }
    if (hasShip) {
        const Rules& rules = level.rules;
        const double damping = std::max(rules.shipLinearDamping, Rules().shipLinearDamping); // no flight is endless
        speed = std::max(speed, (rules.thrust / rules.shipMass + level.gravity.norm()) / damping);
    }
    return speed * level.updateSeconds / std::max(1, level.iterations);
}

} // namespace

void checkDepths(const Level& level, const Walls& walls, Findings& findings) {
    constexpr std::size_t many = 20'000; // segments of which only the middles are looked at
    constexpr double slack = 0.01;       // m of a depth that may be too much
    constexpr double fast = 0.05;        // m: shorter steps are no danger, for what moves looks ahead
    DepthProbe probe(walls);
    const double step = longestStep(level);
    for (std::size_t i = 0; i < walls.chains.size() && !findings.isStopped() && !probe.isTired(); ++i) {
        const WallChain& chain = walls.chains[i];
        if (!chain.oneWay || !chain.isStill()) {
            continue;
        }
        if (std::isfinite(chain.depth) && step > fast && chain.depth < step) {
            FindingPlace place = chain.place();
            place.path += "/depth";
            findings.add(Severity::Warning, "wall-too-thin", {spelledNumber(chain.depth), metres(step)}, place);
        }
        const int index = static_cast<int>(i);
        const Thinnest thinnest = thinnestBehind(probe, walls, index, walls.still.segments.size() <= many);
        FindingPlace place = chain.place(thinnest.place);
        place.path += "/depth";
        if (chain.depth > thinnest.thickness + slack) {
            const bool endless = !std::isfinite(chain.depth);
            if (endless) {
                findings.add(Severity::Warning, "no-back-reaches-through", {metres(thinnest.thickness)}, place);
            } else {
                findings.add(Severity::Warning, "depth-reaches-through",
                             {spelledNumber(chain.depth), metres(thinnest.thickness)}, place);
            }
        } else if (!std::isfinite(chain.depth) && isShelf(probe, walls, index)) {
            findings.add(Severity::Warning, "shelf-without-back", {}, place);
        }
    }
}

} // namespace spacetow
