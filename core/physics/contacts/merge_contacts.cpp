#include "core/physics/contacts/merge_contacts.h"

#include "core/geometry/near_points.h"
#include "core/math/vec.h"
#include "core/physics/contacts/contact_rules.h"
#include "core/physics/contacts/effective_mass.h"
#include "core/physics/contacts/update_manifold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

// Points of merged contacts that are no further apart than this are one point, m.
constexpr double coincident = 1e-9;

// Surfaces whose heights differ by less than this are in one plane, m: each may be off by jointTolerance.
constexpr double onePlane = 2 * jointTolerance;

bool samePlane(const Bodies& bodies, const Constraint& c, const Constraint& d) {
    if (!mayShareSurface(bodies, c.b, d.b) || c.friction != d.friction || c.restitution != d.restitution ||
        !areParallelNormals(c.normal, d.normal)) {
        return false;
    }
    // A point lies half way between the surfaces. The surface of b is half the separation further along the normal.
    const double planeC = c.points[0].armA.dot(c.normal) + 0.5 * c.points[0].separation;
    const double planeD = d.points[0].armA.dot(c.normal) + 0.5 * d.points[0].separation;
    return std::abs(planeC - planeD) < onePlane;
}

/// m, above the plane. Overlaps no deeper than position correction leaves count as in the plane.
double heightOf(const ConstraintPoint& p) {
    constexpr double leftOverlap = 4 * linearSlop;
    return std::max(p.separation, 0.0) + std::min(p.separation + leftOverlap, 0.0);
}

/// Whether the outermost two of all points can replace the others: no point between them is nearer to the plane than
/// the line through them, within `onePlane`. See heightOf() about overlaps.
bool isFlat(const Constraint& c, const Constraint& d) {
    const Vec2 tangent = leftOf(c.normal);
    std::array<Vec2, 4> points; // x: along the plane; y: above it
    std::size_t count = 0;
    for (const Constraint* from : {&c, &d}) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(from->count); ++i) {
            points[count++] = {from->points[i].armA.dot(tangent), heightOf(from->points[i])};
        }
    }
    const auto byPlace = [](const Vec2& p, const Vec2& q) { return p.x() < q.x(); };
    const auto ends = std::minmax_element(points.begin(), points.begin() + count, byPlace);
    const Vec2 first = *ends.first;
    const Vec2 along = *ends.second - first;
    return std::all_of(points.begin(), points.begin() + count, [&](const Vec2& p) {
        const double share = along.x() > 0 ? (p.x() - first.x()) / along.x() : 0;
        return p.y() >= first.y() + share * along.y() - onePlane;
    });
}

void refreshLevers(const Bodies& bodies, Constraint& c) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(c.count); ++i) {
        setLevers(bodies, c, c.points[i]);
    }
    setCouplingAndFriction(bodies, c);
}

ContactPoint& keptPoint(Contacts& contacts, const ConstraintPoint& p) {
    return contacts.pool[p.contact].points[p.index];
}

double toleranceOf(const Bodies& bodies, const Contacts& contacts, const Constraint& c) {
    return c.merged ? c.tolerance : toleranceLeftOf(bodies, contacts, contacts.table.pairs[c.points[0].pair]);
}

/// Excludes the pair from updates while the merged contact has a lane.
void excludePair(Contacts& contacts, Constraints& constraints, std::uint32_t pair) {
    constraints.mergedPairs.push_back(pair);
    contacts.table.bounds[pair].exclude();
}

/// Marks c as the merged contact of the pairs of c and d.
void noteMerge(const ContactStage& stage, Constraint& c, const Constraint& d) {
    c.tolerance = std::min(toleranceOf(stage.bodies, stage.contacts, c), toleranceOf(stage.bodies, stage.contacts, d));
    if (!c.merged) {
        excludePair(stage.contacts, stage.constraints, c.points[0].pair);
    }
    excludePair(stage.contacts, stage.constraints, d.points[0].pair);
    c.merged = true;
}

/// Replaces the points of c by the outermost two of the points of c and d. Of coincident points the one of the contact
/// with more points remains, as it persists when the body turns a little; it gets the impulses of both.
void mergeInto(const ContactStage& stage, Constraint& c, Constraint& d) {
    noteMerge(stage, c, d);
    const Vec2 tangent = leftOf(c.normal);
    std::array<ConstraintPoint, 4> all;
    std::array<double, 4> places;
    std::size_t count = 0;
    const bool cFirst = c.count >= d.count;
    for (const Constraint* from : {cFirst ? &c : &d, cFirst ? &d : &c}) {
        for (int i = 0; i < from->count; ++i) {
            all[count] = from->points[static_cast<std::size_t>(i)];
            places[count] = all[count].armA.dot(tangent);
            ++count;
        }
    }
    std::size_t least = 0;
    std::size_t most = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const ConstraintPoint& p = all[i];
        stage.contacts.table.flags[p.pair].touching |= p.separation <= linearSlop;
        keptPoint(stage.contacts, p).normalImpulse = 0;
        stage.contacts.pool[p.contact].tangentImpulse = 0;
        least = places[i] < places[least] - coincident ? i : least;
        most = places[i] > places[most] + coincident ? i : most;
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (i != least && places[i] <= places[least] + coincident) {
            all[least].normalImpulse += all[i].normalImpulse;
        } else if (i != most && places[i] >= places[most] - coincident) {
            all[most].normalImpulse += all[i].normalImpulse;
        }
    }
    c.points[0] = all[least];
    c.points[1] = all[most];
    c.count = 2;
    if (least == most) {
        c.count = 1;
        c.clearSecond();
    }
    c.tangentImpulse += d.tangentImpulse;
    d.count = 0;
}

} // namespace

void mergeContacts(const ContactStage& stage) {
    std::vector<Constraint>& all = stage.narrow.constraints;
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
        for (end = first + 1; end < all.size() && all[end].a == all[first].a; ++end) {
            for (std::size_t i = first; i < end && !all[end].unmergeable; ++i) {
                if (all[i].count > 0 && samePlane(stage.bodies, all[i], all[end]) && isFlat(all[i], all[end])) {
                    mergeInto(stage, all[i], all[end]);
                    refreshLevers(stage.bodies, all[i]);
                    break;
                }
            }
        }
    }
    if (!stage.constraints.mergedPairs.empty()) {
        std::erase_if(all, [](const Constraint& c) { return c.count == 0; });
    }
}

} // namespace spacetow
