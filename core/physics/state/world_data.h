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

/// A pair that may have to be stopped where it meets; see continuous.h.
struct OnWay {
    std::uint32_t pair = 0;
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t lookedAt = 0; // 0: not yet
    bool touches = false;       // then only its turns are limited
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
    std::vector<RoundContact> roundContacts; // that the solver has, see contact_lanes.h
    std::vector<GeneralContact> generalContacts;
    ContactBatches batches;
    bool contactsListed = false;                 // so that the above are those of the pairs
    bool anySingle = false, anySingular = false; // of these contacts
    bool anyBounce = false;
    std::vector<std::uint16_t> wallContacts; // by slot: general contacts with what others may share a plane with
    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours; // contacts that may come to lie in one plane
    std::vector<std::uint32_t> absorbed;                             // pairs that merged contacts stand for
    bool mergeDoubt = false;                                         // whether these may have changed
    bool justListed = false;                                         // all contacts, in this iteration
    std::size_t listChanges = 0;                                     // since all were listed
    std::vector<TagMask> touchedTags;                                // by slot, of the last iteration
    Events events;

    Sleep sleep;

    MovingQuadtree tree;
    std::vector<Slot> moving;              // active and awake, kinematic bodies first
    std::vector<Slot> reporters;           // of touched tags
    std::vector<MovingCollider> colliders; // of `moving` and the sleepers
    std::vector<double> travelled;         // m, at most, at the end of the iteration: 0, then by slot
    std::vector<BodyWay> ways;             // nothing, then by slot
    std::vector<BodyReach> reaches;        // nothing, then by slot
    std::vector<std::uint8_t> alert;       // whether a body's way is to be looked at: 0, then by slot

    // Working memory, kept so that a steady update allocates nothing.
    PairTable newTable;
    std::vector<Pair> newPairs;
    std::vector<std::uint32_t> pairEnds; // by slot, of the sorted pairs
    std::vector<std::uint32_t> found;
    std::vector<std::uint32_t> felt;                  // indices of felt pairs
    std::vector<std::uint32_t> open;                  // indices of pairs to be looked at
    std::vector<Constraint> constraints;              // general contacts that are not yet listed
    std::vector<std::array<double, 3>> wholeImpulses; // by contact, while an iteration is made in parts
    Islands islands;
    std::vector<std::uint64_t> droppedTouches; // body pairs whose boxes parted while they touched
    std::vector<Transform> trial;              // poses during sub-steps, by slot
    bool anyFault = false;                     // something is not finite
    bool anyEscaped = false;
    bool anyFast = false; // something moves further than anticipation covers
    bool anySweep = false;
    bool anyDiverted = false;
    bool islandsStale = true;                     // the pairs or who moves have changed
    std::vector<std::uint8_t> yields;             // 0, then by slot: whether anything can move or turn it
    std::vector<Aabb> boxes;                      // that colliders cannot leave unnoticed
    std::vector<std::uint32_t> firstColliders;    // by slot
    std::vector<std::uint32_t> astray;            // colliders that are not where the tree has them
    std::vector<Slot> escaped;                    // whose pairs are found anew
    std::vector<MovingQuadtree::Two> overlapping; // colliders whose boxes do
    std::vector<FoundPair> foundPairs, sortedPairs;
    std::vector<std::uint8_t> leaves;     // 0, then by slot: whether a body has escaped, while pairs are merged
    std::vector<std::uint32_t> leaving;   // pairs of those who have
    std::vector<std::uint32_t> dropped;   // of those, which were not found again
    std::vector<std::uint32_t> newPlaces; // of new pairs: the index before which they belong
    std::vector<Stretch> stretches;       // of the table that remain
    std::vector<OnWay> onWays;
    std::vector<std::uint32_t> shortenedAt; // by slot: the look at a pair that did so
    std::uint32_t looks = 0;                // at pairs on their ways

    /// Whether the parts of the pair may meet in this iteration.
    bool isGateOpen(std::uint32_t pair) const {
        const PairGate& gate = table.gates[pair];
        return travelled[gate.moverA] + travelled[gate.moverB] + linearSlop >= gate.apartUntil;
    }
    /// What the bodies of the pair have travelled together before the iteration, m.
    double milesOf(const PairGate& gate) const {
        return reaches[gate.moverA].travelled + reaches[gate.moverB].travelled;
    }
    /// To be called when the motion of the body has been planned, or it no longer moves.
    void noteWay(Slot slot) {
        ways[slot + 1] = {motions[slot], steps[slot]};
        reaches[slot + 1] = {steps[slot].travelled, steps[slot].outerRadius};
    }
    BodyId idOf(Slot slot) const { return {slot, records[slot].generation}; }
    Transform pose(Slot slot) const { return {motions[slot].center, motions[slot].rotation}; }
};

} // namespace spacetow
