#pragma once
// Scratch data of the stages of an update. Between updates only its capacity matters, so that a steady update allocates
// nothing; a copy of a world has none of it.

#include "core/geometry/moving_quadtree.h"
#include "core/math/transform.h"
#include "core/physics/lanes/contact_batches.h"
#include "core/physics/state/broad_phase_data.h"
#include "core/physics/state/contact_data.h"
#include "core/physics/state/mover.h"

#include <array>
#include <cstdint>
#include <vector>

namespace spacetow {

struct StageTimes;

/// Scratch of find_pairs.h.
struct PairSearch {
    std::vector<Slot> movedBodies;                    // bodies whose proxies are moved proxies
    std::vector<std::uint32_t> found;                 // the result of one query
    std::vector<MovingQuadtree::BoxPair> overlapping; // proxies whose fat AABBs overlap
    std::vector<PairKey> foundPairs, sortedPairs;
    std::vector<std::uint32_t> pairEnds; // by slot of `bodyA`: end of its range in sortedPairs
    std::size_t mostFound = 0;           // limit on foundPairs
};

/// Scratch of pair_changes.h: the difference between the pair table and the next one.
struct PairChanges {
    PairTable newTable;                    // the next table, if all pairs are stale
    MoverArray<std::uint8_t> isMovedProxy; // by body; all 0 but while the table is compared
    std::vector<std::uint32_t> movedPairs; // pairs of moved proxies
    std::vector<std::uint32_t> dropped;    // indices of pairs that the next table lacks
    std::vector<Pair> newPairs;
    std::vector<std::uint32_t> newPlaces;      // by new pair: the index before which it belongs
    std::vector<Run> runs;                     // runs of pairs that remain
    std::vector<std::uint64_t> droppedTouches; // Pair::bodies() of dropped pairs that touched; until reported
};

/// Scratch of narrow_phase.h.
struct NarrowPhase {
    std::vector<std::uint32_t> candidates;            // indices of pairs to update
    std::vector<Constraint> constraints;              // general contacts that have no lane yet
    std::vector<std::array<double, 3>> wholeImpulses; // by contact: tangent and normal impulses before beginPart()
};

/// The coefficients of EnergyBalance for one component, in the lanes x, y and rotation, J.
struct EnergyChange {
    Wide a{}, b{}, c{};
};

/// The energy that the impulses of an iteration add to a component, J, if they are scaled by x: a·x²/2 + b·x + c. See
/// energy_limit.cpp. `corrections` is the work of position correction, J.
struct EnergyBalance {
    double a = 0, b = 0, c = 0, corrections = 0;

    double gain() const { return 0.5 * a + b + c; }
};

/// Scratch of the solver in one iteration. Arrays by slot have one more entry where lanes without a contact refer to
/// it.
struct SolverScratch {
    /// Of a contact that is solved again.
    struct SameLane {
        Lane here, there; // in the batches of all contacts and of those
    };
    std::vector<BodyVelocity> velocities;
    std::vector<BodyVelocity> startVelocities;   // at the beginning of the iteration
    std::vector<BodyVelocity> plannedVelocities; // without the impulses of contacts
    std::vector<BodyVelocity> corrections;       // of positions, m and rad in the iteration
    std::vector<EnergyChange> changes;           // by slot, of roots of components
    std::vector<EnergyBalance> balances;         // likewise
    std::vector<std::uint8_t> unconverged;       // likewise: whether the component is solved again
    ContactBatches componentBatches;             // of these components
    std::vector<SameLane> lanes;                 // of their contacts
    std::vector<std::uint8_t> pushedByKinematic; // whether a moving kinematic body may push the component
    std::vector<std::uint8_t> limited;           // the round in which the motion was limited
    std::vector<double> fractions;               // of the motion that is left
};

/// A pair that the time of impact may stop; see time_of_impact.h.
struct ToiCandidate {
    std::uint32_t pair = 0;
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t visitedAt = 0;         // ToiSearch::visits at its last visit; 0: not visited
    bool touches = false;                // it has a contact: only its turn is limited
    bool deepens = false;                // it has a contact, and may penetrate where the manifold has no point
    bool stopsA = false, stopsB = false; // which of the bodies is stopped
};

/// Scratch of time_of_impact.h.
struct ToiSearch {
    std::vector<ToiCandidate> candidates;
    std::vector<std::uint32_t> shortenedAt; // by slot: `visits` when the motion was last shortened
    std::uint32_t visits = 0;               // of candidates so far
};

/// Scratch of the integration in sub-steps.
struct Substeps {
    std::vector<Transform> trial;       // by slot: the pose in the current sub-step
    std::vector<std::uint8_t> implicit; // by slot: a connector is too stiff for explicit sub-steps
};

/// Scratch of sleep.h.
struct SleepSearch {
    PairTable newTable;               // the next table of sleeping pairs
    std::vector<Slot> parents;        // by slot: disjoint sets, one for each island
    std::vector<std::uint8_t> marked; // by root of an island: it wakes, or stays awake
};

struct Scratch {
    PairSearch search;
    PairChanges changes;
    NarrowPhase narrow;
    SolverScratch solver;
    ToiSearch toi;
    Substeps substeps;
    SleepSearch sleep;
    StageTimes* times = nullptr; // of the running update; null if stages are not timed

    Scratch() = default;
    ~Scratch() = default;
    /// A copy is empty; assignment from another scratch clears this one.
    Scratch(const Scratch&) {}           // NOLINT(bugprone-copy-constructor-init)
    Scratch& operator=(const Scratch&) { // NOLINT(bugprone-unhandled-self-assignment): nothing is lost but room
        *this = Scratch{};
        return *this;
    }
    Scratch(Scratch&&) noexcept = default;
    Scratch& operator=(Scratch&&) noexcept = default;
};

} // namespace spacetow
