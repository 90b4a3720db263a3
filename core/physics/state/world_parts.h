#pragma once
// The state of a world in parts. Each stage of the update takes the parts that it touches. A body slot is used again
// after a removal. Worlds with equal histories have equal slots, so the order of slots may decide the order of work. SI
// units, radians.

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
    std::vector<Slot> moving;           // bodies that are active, awake and not static; kinematic ones first
    std::vector<Slot> reporters;        // bodies with BodyDef::reportsTouches
    std::vector<Slot> taggedAtRest;     // bodies with touched tags that are static or asleep
    std::vector<PendingChange> pending; // deferred changes, in the order of the calls
    std::vector<Slot> changedBodies;    // bodies for which lists and pairs have to be rebuilt
    std::vector<Slot> slotsToReset;     // slots that resetSlots() has to reset
    std::vector<Slot> nonStatic;        // sorted; without bodies in changedBodies
    std::vector<Slot> addedNonStatic;   // bodies in changedBodies that are not static, until the next update

    // What loops over pairs read of a body.
    // m, motion bounds at the end of the iteration
    MoverArray<double> motionBounds;
    MoverArray<PlannedMotion> plannedMotions;
    MoverArray<BodyExtent> extents;
    MoverArray<std::uint8_t> mayNeedToi; // 1: the body is fast, will bounce, or was deflected
    MoverArray<std::uint8_t> movable;    // 1: contacts can move or turn the body, see BodyMotion::isMovable

    bool contains(BodyId body) const {
        return body.index < records.size() && records[body.index].used &&
               records[body.index].generation == body.generation;
    }
    BodyId idOf(Slot slot) const { return {slot, records[slot].generation}; }
    Transform pose(Slot slot) const { return {motions[slot].center, motions[slot].rotation}; }
    /// The pose of the second part of a pair: the identity for static parts, which are in world coordinates.
    Transform poseOfB(const Pair& pair) const { return pair.staticB ? Transform{} : pose(pair.bodyB); }
    /// The sum of the motion bounds of both bodies at the beginning of the iteration, m.
    double motionOf(const PairBound& bound) const {
        return extents[bound.moverA].motionBound + extents[bound.moverB].motionBound;
    }
    /// To be called when the planned motion of the body has changed.
    void notePlannedMotion(Slot slot) {
        plannedMotions[slot] = {motions[slot], steps[slot]};
        extents[slot] = {steps[slot].motionBound, steps[slot].outerRadius};
    }
};

struct Forces {
    std::vector<ConnectorRecord> connectors;
    std::vector<std::uint32_t> freeConnectors;
    std::vector<SlotPair> notColliding; // bodies that do not collide because a connector joins them; sorted
    std::vector<Slot> substepped;       // bodies with BodyRecord::substepped

    /// Frees the record of a removed connector; its id becomes invalid.
    void release(std::uint32_t index) {
        connectors[index].used = false;
        ++connectors[index].generation;
        freeConnectors.push_back(index);
    }
};

struct BroadPhase {
    std::shared_ptr<const StaticGeometry> statics;      // all static bodies when it was built
    std::shared_ptr<const StaticChanges> staticChanges; // the changes since; null if there are none
    std::vector<Slot> changedStatics;                   // bodies that refreshStatics() has yet to enter
    MovingQuadtree tree;
    std::vector<MovingProxy> proxies;        // the parts of moving and of sleeping bodies
    std::vector<Aabb> boxes;                 // by proxy: its fat AABB
    std::vector<std::uint32_t> firstProxies; // by slot: index of the first proxy of the body
    std::vector<std::uint32_t> staleProxies; // indices of proxies whose fat AABB in `tree` is out of date

    /// The collider of an index: first come those of `statics`, then those of `staticChanges`.
    const StaticGeometry::Collider& staticCollider(std::uint32_t index) const {
        const std::size_t first = statics->colliders.size();
        return index < first ? statics->colliders[index] : staticChanges->geometry.colliders[index - first];
    }
};

/// The pair table and the contact pool.
struct Contacts {
    PairTable table;
    std::vector<std::uint32_t> sensors; // indices of sensor pairs
    std::vector<Contact> pool;          // persistent contacts of pairs that have come near each other
    std::vector<std::uint32_t> freeInPool;

    /// Whether the parts of the pair may touch in this iteration.
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
    std::vector<std::uint16_t> mergeableContacts; // by slot: count of mergeable general contacts as body a
    std::vector<std::pair<std::uint32_t, std::uint32_t>> mergeCandidates; // in the pool, see findMergeCandidates()
    std::vector<std::uint32_t> mergedPairs;                               // pairs whose contacts have been merged
    std::size_t constraintChanges = 0;                                    // lanes opened and closed since the rebuild
};

} // namespace spacetow
