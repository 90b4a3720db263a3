#include "core/physics/query/masked_meetings.h"

#include "core/geometry/bounds.h"
#include "core/geometry/collide.h"
#include "core/geometry/overlaps.h"
#include "core/physics/broad_phase/collision_rules.h"
#include "core/physics/broad_phase/statics.h"
#include "core/physics/state/world_data.h"

#include <algorithm>

namespace spacetow {

namespace {

using Meetings = std::vector<std::pair<BodyId, BodyId>>;

/// All filters of active bodies, each once.
std::vector<Filter> filtersOf(const Bodies& bodies) {
    std::vector<Filter> filters;
    for (const BodyRecord& record : bodies.records) {
        const bool known =
            std::any_of(filters.begin(), filters.end(), [&](const Filter& filter) { return filter == record.filter; });
        if (record.used && record.active && !known) {
            filters.push_back(record.filter);
        }
    }
    return filters;
}

/// Whether the filter rejects any of the others.
bool isPicky(const std::vector<Filter>& filters, const Filter& own) {
    return std::any_of(filters.begin(), filters.end(), [&](const Filter& other) { return !mayTouch(own, other); });
}

/// Whether the bodies would collide but for their filters.
bool isMaskedOnly(const Bodies& bodies, const Forces& forces, Slot a, Slot b) {
    return !mayTouch(bodies.records[a].filter, bodies.records[b].filter) &&
           mayCollideButForFilters(bodies, forces, a, b);
}

/// A part and its pose.
struct Placed {
    const Part& part;
    Transform pose;
};

bool meets(const Placed& a, const Placed& b, bool solid) {
    return solid ? collide(a.part, a.pose, b.part, b.pose, linearSlop).count > 0
                 : overlaps(a.part, a.pose, b.part, b.pose);
}

bool bodiesMeet(const Bodies& bodies, Slot a, Slot b) {
    const bool solid = areTangible(bodies, a, b);
    for (const Part& partA : *bodies.records[a].parts) {
        const Placed one{partA, bodies.pose(a)};
        const Aabb box = boundsOf(partA, one.pose).grown(linearSlop);
        for (const Part& partB : *bodies.records[b].parts) {
            const Placed other{partB, bodies.pose(b)};
            if (boundsOf(partB, other.pose).overlaps(box) && meets(one, other, solid)) {
                return true;
            }
        }
    }
    return false;
}

void note(const Bodies& bodies, Slot a, Slot b, Meetings& out) {
    const bool ordered = bodies.records[a].serial < bodies.records[b].serial;
    out.emplace_back(bodies.idOf(ordered ? a : b), bodies.idOf(ordered ? b : a));
}

/// A body that is not static, its AABB, and whether its filter rejects any other.
struct Standing {
    Slot slot;
    Aabb box;
    bool picky;
};

std::vector<Standing> movingBodies(const Bodies& bodies, const std::vector<Filter>& filters) {
    std::vector<Standing> all;
    for (Slot slot = 0; slot < bodies.records.size(); ++slot) {
        const BodyRecord& record = bodies.records[slot];
        if (record.used && record.active && record.kind != BodyKind::Static) {
            const Aabb box = boundsOf(*record.parts, bodies.pose(slot)).grown(linearSlop);
            all.push_back({slot, box, isPicky(filters, record.filter)});
        }
    }
    std::sort(all.begin(), all.end(),
              [](const Standing& a, const Standing& b) { return a.box.min.x() < b.box.min.x(); });
    return all;
}

/// Sweep and prune along x.
void findMoving(const Bodies& bodies, const Forces& forces, const std::vector<Standing>& all, Meetings& out) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = i + 1; k < all.size() && all[k].box.min.x() <= all[i].box.max.x(); ++k) {
            const Slot a = all[i].slot;
            const Slot b = all[k].slot;
            if (all[i].picky && all[k].picky && all[i].box.overlaps(all[k].box) && isMaskedOnly(bodies, forces, a, b) &&
                bodiesMeet(bodies, a, b)) {
                note(bodies, a, b, out);
            }
        }
    }
}

void findStaticsOf(const WorldData& data, const Standing& body, Meetings& out) {
    std::vector<std::uint32_t> found;
    findStatics(data.broadPhase, body.box, found);
    std::vector<Slot> met;
    for (const std::uint32_t i : found) {
        const StaticGeometry::Collider& wall = data.broadPhase.staticCollider(i);
        if (!isMaskedOnly(data.bodies, data.forces, body.slot, wall.body) ||
            std::find(met.begin(), met.end(), wall.body) != met.end()) {
            continue;
        }
        const bool solid = areTangible(data.bodies, body.slot, wall.body);
        for (const Part& part : *data.bodies.records[body.slot].parts) {
            if (meets({part, data.bodies.pose(body.slot)}, {wall.shape, {}}, solid)) {
                met.push_back(wall.body);
                note(data.bodies, body.slot, wall.body, out);
                break;
            }
        }
    }
}

} // namespace

std::vector<std::pair<BodyId, BodyId>> maskedMeetings(const World& world) {
    const WorldData& data = world.data();
    const std::vector<Filter> filters = filtersOf(data.bodies);
    Meetings meetings;
    if (std::none_of(filters.begin(), filters.end(), [&](const Filter& own) { return isPicky(filters, own); })) {
        return meetings;
    }
    const std::vector<Standing> all = movingBodies(data.bodies, filters);
    findMoving(data.bodies, data.forces, all, meetings);
    if (data.broadPhase.statics != nullptr && !data.flags.staticsChanged) {
        for (const Standing& body : all) {
            if (body.picky) {
                findStaticsOf(data, body, meetings);
            }
        }
    }
    std::sort(meetings.begin(), meetings.end());
    return meetings;
}

} // namespace spacetow
