#include "core/physics/contacts/order_constraints.h"

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

bool isAtStatic(const Bodies& bodies, const Constraint& c) {
    return !c.unmergeable && bodies.records[c.b].kind == BodyKind::Static;
}

double leastSeparation(const Constraint& c) {
    return c.count == 2 ? std::min(c.points[0].separation, c.points[1].separation) : c.points[0].separation;
}

/// One step of an insertion sort: moves the contact `last` to its place among the contacts with static bodies from
/// `first` on.
void insertLast(const Bodies& bodies, NarrowPhase& narrow, std::size_t first, std::size_t last) {
    std::vector<Constraint>& all = narrow.constraints;
    for (std::size_t i = last; i-- > first;) {
        if (!isAtStatic(bodies, all[i])) {
            continue;
        }
        if (leastSeparation(all[i]) >= leastSeparation(all[last])) {
            return;
        }
        std::swap(all[i], all[last]);
        last = i;
    }
}

} // namespace

void orderConstraints(const Bodies& bodies, NarrowPhase& narrow) {
    const std::vector<Constraint>& all = narrow.constraints;
    std::size_t first = 0; // of the same body
    for (std::size_t i = 1; i < all.size(); ++i) {
        if (all[i].a != all[first].a) {
            first = i;
        } else if (isAtStatic(bodies, all[i])) {
            insertLast(bodies, narrow, first, i);
        }
    }
}

} // namespace spacetow
