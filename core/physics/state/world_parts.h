#pragma once
// The state of a world, by whose it is; a stage of the update takes those that it touches. Body slots are used again
// after a removal; slot order is the same for equal histories, so it may decide the order of work. SI units, radians.

#include "core/geometry/moving_quadtree.h"
#include "core/math/aabb.h"
#include "core/physics/state/body_data.h"
#include "core/physics/state/broad_phase_data.h"
#include "core/physics/state/contact_data.h"
#include "core/physics/state/force_data.h"
#include "core/physics/state/mover.h"
#include "core/physics/state/static_geometry.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace spacetow {

using SlotPair = std::pair<Slot, Slot>; // lower first

struct Bodies {
    // By slot.
    std::vector<BodyMotion> motions;
    std::vector<BodyStep> steps;
    std::vector<BodyRecord> records;
    std::vector<TagMask> touchedTags; // of the last iteration

    std::vector<Slot> freeSlots;
    std::uint64_t nextSerial = 0;
    std::vector<Slot> moving;           // active and awake, kinematic bodies first
    std::vector<Slot> reporters;        // of touched tags
    std::vector<Slot> taggedAtRest;     // who has any touched tags and does not move
    std::vector<PendingChange> pending; // deferred changes
    std::vector<Slot> changedBodies;    // so that lists and pairs are to be made anew
    std::vector<Slot> slotsToReset;     // whose entries in what is kept by slot are to begin anew
    std::vector<Slot> nonStatic;        // by slot, but for changed bodies
    std::vector<Slot> addedNonStatic;   // of changed bodies; between updates all others are in the list

    // What is asked for pairs. The motion bounds are those at the end of the iteration, m.
    MoverArray<double> motionBounds;
    MoverArray<PlannedMotion> plannedMotions;
    MoverArray<BodyExtent> extents;
    MoverArray<std::uint8_t> mayNeedToi; // whether the body may need a time of impact
    MoverArray<std::uint8_t> movable;    // whether anything can move or turn it

    bool contains(BodyId body) const {
        return body.index < records.size() && records[body.index].used &&
               records[body.index].generation == body.generation;
    }
    BodyId idOf(Slot slot) const { return {slot, records[slot].generation}; }
    Transform pose(Slot slot) const { return {motions[slot].center, motions[slot].rotation}; }
    /// Of the second part of a pair; static parts are in world coordinates.
    Transform poseOfB(const Pair& pair) const { return pair.staticB ? Transform{} : pose(pair.bodyB); }
    /// The motion bounds of both bodies before the iteration, m.
    double motionOf(const PairBound& bound) const {
        return extents[bound.moverA].motionBound + extents[bound.moverB].motionBound;
    }
    /// To be called when the motion of the body has been planned, or it no longer moves.
    void notePlannedMotion(Slot slot) {
        plannedMotions[slot] = {motions[slot], steps[slot]};
        extents[slot] = {steps[slot].motionBound, steps[slot].outerRadius};
    }
};

struct Forces {
    std::vector<ConnectorRecord> connectors;
    std::vector<std::uint32_t> freeConnectors;
    std::vector<SlotPair> notColliding; // sorted
    std::vector<Slot> substepped;       // see BodyRecord
};

struct BroadPhase {
    std::shared_ptr<const StaticGeometry> statics;      // of all static bodies
    std::shared_ptr<const StaticChanges> staticChanges; // since that was made, if any
    std::vector<Slot> changedStatics;                   // in neither as they are now
    MovingQuadtree tree;
    std::vector<MovingProxy> proxies;        // of the bodies that move and the sleepers
    std::vector<Aabb> boxes;                 // of proxies, which they cannot leave unnoticed
    std::vector<std::uint32_t> firstProxies; // by slot
    std::vector<std::uint32_t> staleProxies; // that are not where the tree has them

    /// By its index in `statics`, or after those in `staticChanges`.
    const StaticGeometry::Collider& staticCollider(std::uint32_t index) const {
        const std::size_t first = statics->colliders.size();
        return index < first ? statics->colliders[index] : staticChanges->geometry.colliders[index - first];
    }
};

/// Pairs, and what is kept of their contacts.
struct Contacts {
    PairTable table;
    std::vector<std::uint32_t> sensors; // indices of the pairs of sensors
    std::vector<Contact> pool;          // of the pairs that have come near each other
    std::vector<std::uint32_t> freeInPool;

    /// Whether the parts of the pair may meet in this iteration.
    bool mayTouchNow(const Bodies& bodies, std::uint32_t pair) const {
        const PairBound& bound = table.bounds[pair];
        return bodies.motionBounds[bound.moverA] + bodies.motionBounds[bound.moverB] + linearSlop >=
               bound.separationBound;
    }
};

/// The constraints of the solver; see constraint_list.h.
struct Constraints {
    std::vector<CircleContact> circleContacts;
    std::vector<GeneralContact> generalContacts;
    ContactBatches batches;
    std::vector<std::uint16_t> mergeableContacts; // by slot: general contacts with what others may share a plane with
    std::vector<std::pair<std::uint32_t, std::uint32_t>> mergeCandidates; // contacts that may come to lie in one plane
    std::vector<std::uint32_t> mergedPairs;                               // pairs that merged contacts stand for
    std::size_t constraintChanges = 0;                                    // since all were rebuilt
};

} // namespace spacetow
