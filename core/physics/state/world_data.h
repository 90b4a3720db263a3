#pragma once
// The arrays behind a world, as the stages of the update see them. Body slots are used again after a removal; slot
// order is the same for equal histories, so it may decide the order of work. SI units, radians.

#include "core/geometry/moving_quadtree.h"
#include "core/math/aabb.h"
#include "core/physics/def/events.h"
#include "core/physics/def/parameters.h"
#include "core/physics/state/body_data.h"
#include "core/physics/state/broad_phase_data.h"
#include "core/physics/state/contact_data.h"
#include "core/physics/state/force_data.h"
#include "core/physics/state/island_data.h"
#include "core/physics/state/iteration_step.h"
#include "core/physics/state/sleep_data.h"
#include "core/physics/state/static_geometry.h"

#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace spacetow {

using SlotPair = std::pair<Slot, Slot>; // lower first

/// A pair that may have to be stopped where it meets; see time_of_impact.h.
struct ToiCandidate {
    std::uint32_t pair = 0;
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t visitedAt = 0; // 0: not yet
    bool touches = false;        // then only its turns are limited
    bool stopsA = false, stopsB = false;
};

struct WorldData {
    UpdateParameters parameters;

    // Bodies, by slot.
    std::vector<BodyMotion> motions;
    std::vector<BodyStep> steps;
    std::vector<BodyRecord> records;
    std::vector<Slot> freeSlots;
    std::uint64_t nextSerial = 0;

    std::vector<ConnectorRecord> connectors;
    std::vector<std::uint32_t> freeConnectors;
    std::vector<SlotPair> notColliding; // sorted

    std::vector<FieldRecord> fields;
    std::vector<std::uint32_t> freeFields;
    std::vector<Slot> fieldBodies; // that feel any of them

    std::vector<PendingChange> pending;
    std::shared_ptr<const StaticGeometry> statics;
    bool staticsChanged = true;
    bool bodiesChanged = true; // so that lists and pairs are to be made anew
    bool pairsStale = true;    // so that nothing that is known of the pairs' distances holds

    PairTable table;
    std::vector<Contact> contacts; // of the pairs that have come near each other
    std::vector<std::uint32_t> freeContacts;
    std::vector<KeptManifold> manifolds; // of the general ones
    std::vector<std::uint32_t> freeManifolds;
    std::vector<CircleContact> circleContacts; // that the solver has, see constraint_list.h
    std::vector<GeneralContact> generalContacts;
    ContactBatches batches;
    bool constraintsValid = false;                     // so that the above are those of the pairs
    bool anyScalarUpdate = false, anySingular = false; // of these contacts
    bool anyBounce = false;
    std::vector<std::uint16_t> mergeableContacts; // by slot: general contacts with what others may share a plane with
    std::vector<std::pair<std::uint32_t, std::uint32_t>> mergeCandidates; // contacts that may come to lie in one plane
    std::vector<std::uint32_t> mergedPairs;                               // pairs that merged contacts stand for
    bool mergeStale = false;                                              // whether these may have changed
    bool constraintsRebuilt = false;                                      // all contacts, in this iteration
    std::size_t constraintChanges = 0;                                    // since all were rebuilt
    std::vector<TagMask> touchedTags;                                     // by slot, of the last iteration
    Events events;

    Sleep sleep;

    MovingQuadtree tree;
    std::vector<Slot> moving;                  // active and awake, kinematic bodies first
    std::vector<Slot> reporters;               // of touched tags
    std::vector<MovingProxy> proxies;          // of `moving` and the sleepers
    std::vector<double> motionBounds;          // m, at most, at the end of the iteration: 0, then by slot
    std::vector<PlannedMotion> plannedMotions; // nothing, then by slot
    std::vector<BodyExtent> extents;           // nothing, then by slot
    std::vector<std::uint8_t> mayNeedToi;      // whether the body may need a time of impact: 0, then by slot

    // Working memory, kept so that a steady update allocates nothing.
    PairTable newTable;
    std::vector<Pair> newPairs;
    std::vector<std::uint32_t> pairEnds; // by slot, of the sorted pairs
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> sensors;               // indices of the pairs of sensors
    std::vector<std::uint32_t> candidates;            // indices of pairs to be updated
    std::vector<Constraint> constraints;              // general contacts that have no lane yet
    std::vector<std::array<double, 3>> wholeImpulses; // by contact, while an iteration is made in parts
    Islands islands;
    std::vector<std::uint64_t> droppedTouches; // body pairs whose boxes parted while they touched
    std::vector<Transform> trial;              // poses during sub-steps, by slot
    bool anyFault = false;                     // something is not finite
    bool anyMovedProxy = false;
    bool anyFast = false; // something moves further than anticipation covers
    bool anySweep = false;
    bool anyDeflected = false;
    bool islandsStale = true;                     // the pairs or who moves have changed
    std::vector<std::uint8_t> movable;            // 0, then by slot: whether anything can move or turn it
    std::vector<Aabb> boxes;                      // that colliders cannot leave unnoticed
    std::vector<std::uint32_t> firstProxies;      // by slot
    std::vector<std::uint32_t> staleProxies;      // colliders that are not where the tree has them
    std::vector<Slot> movedBodies;                // whose pairs are found anew
    std::vector<MovingQuadtree::Two> overlapping; // colliders whose boxes do
    std::vector<FoundPair> foundPairs, sortedPairs;
    std::vector<std::uint8_t> isMovedProxy; // 0, then by slot: while the table is compared
    std::vector<std::uint32_t> movedPairs;  // pairs of those who have
    std::vector<std::uint32_t> dropped;     // of those, which were not found again
    std::vector<std::uint32_t> newPlaces;   // of new pairs: the index before which they belong
    std::vector<Run> runs;                  // of the table that remain
    std::vector<ToiCandidate> toiCandidates;
    std::vector<std::uint32_t> shortenedAt; // by slot: the visit of a pair that shortened the motion
    std::uint32_t visits = 0;               // of candidates

    /// Whether the parts of the pair may meet in this iteration.
    bool mayTouchNow(std::uint32_t pair) const {
        const PairBound& bound = table.bounds[pair];
        return motionBounds[bound.moverA] + motionBounds[bound.moverB] + linearSlop >= bound.separationBound;
    }
    /// The motion bounds of both bodies before the iteration, m.
    double motionOf(const PairBound& bound) const {
        return extents[bound.moverA].motionBound + extents[bound.moverB].motionBound;
    }
    /// To be called when the motion of the body has been planned, or it no longer moves.
    void notePlannedMotion(Slot slot) {
        plannedMotions[slot + 1] = {motions[slot], steps[slot]};
        extents[slot + 1] = {steps[slot].motionBound, steps[slot].outerRadius};
    }
    BodyId idOf(Slot slot) const { return {slot, records[slot].generation}; }
    Transform pose(Slot slot) const { return {motions[slot].center, motions[slot].rotation}; }
};

} // namespace spacetow
