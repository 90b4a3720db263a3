#pragma once
// What a point snaps to in a level: the nearest thing within reach, the better kinds before the others. What tools call
// stands in snap_point.h. World coordinates, m.

#include "editor/editing/snap.h"
#include "editor/editing/snap_near.h"

#include <optional>

namespace spacetow {

struct SnapQuery {
    Vec2 at{0, 0};                    // where the point would be
    double pixel = 0.01;              // size of one, m
    Aabb view;                        // objects outside align nothing; empty: some way around the point
    std::optional<Vec2> from = {};    // the point before, for perpendiculars and angles
    std::optional<Vec2> along = {};   // unit vector: it may go no other way
    std::optional<Vec2> through = {}; // a point of that line with rounder numbers than `at`

    bool operator==(const SnapQuery&) const = default;
};

/// With settings as they hold now, see withHeld. Takes time with what is near, and with what is in line with it.
SnapAnswer snapAnswer(const Level& level, const SnapSettings& settings, const SnapSubject& subject,
                      const SnapQuery& query);

/// How much nearer, in reaches, a thing of the first kind has to be to be taken before a vertex.
double snapHandicap(SnapKind kind);

} // namespace spacetow
