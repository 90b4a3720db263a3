#pragma once
// What an update needs while it runs. It is kept, so that a steady update allocates nothing, but means nothing between
// updates: a copy of a world does without it.

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

/// Of find_pairs.
struct PairSearch {
    std::vector<Slot> movedBodies;                    // whose pairs are found anew
    std::vector<std::uint32_t> found;                 // by one query
    std::vector<MovingQuadtree::BoxPair> overlapping; // proxies whose boxes do
    std::vector<FoundPair> foundPairs, sortedPairs;
    std::vector<std::uint32_t> pairEnds; // by slot, of the sorted pairs
    std::size_t mostFound = 0;           // pairs at a time
};

/// Of pair_changes: from the table of pairs to the next one.
struct PairChanges {
    PairTable newTable;                    // when all have been found anew
    MoverArray<std::uint8_t> isMovedProxy; // all 0 but while the table is compared
    std::vector<std::uint32_t> movedPairs; // pairs of moved proxies
    std::vector<std::uint32_t> dropped;    // of those, which were not found again
    std::vector<Pair> newPairs;
    std::vector<std::uint32_t> newPlaces;      // of new pairs: the index before which they belong
    std::vector<Run> runs;                     // of the table that remain
    std::vector<std::uint64_t> droppedTouches; // body pairs whose boxes parted while they touched; until reported
};

/// Of the narrow phase.
struct NarrowPhase {
    std::vector<std::uint32_t> candidates;            // indices of pairs to be updated
    std::vector<Constraint> constraints;              // general contacts that have no lane yet
    std::vector<std::array<double, 3>> wholeImpulses; // by contact, while an iteration is made in parts
};

/// What the impulses of an iteration do to the energy of bodies, J: three sums over their motions to the sides, up and
/// around; see energy_limit.cpp.
struct EnergyChange {
    Wide a{}, b{}, c{};
};

/// The change with a share x of the impulses: a·x²/2 + b·x + c. `corrections` is the work of position corrections.
struct EnergyBalance {
    double a = 0, b = 0, c = 0, corrections = 0;

    double gain() const { return 0.5 * a + b + c; }
};

/// Of the solver, for an iteration; by slot, and one entry more for lanes without a contact.
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

/// A pair that may have to be stopped where it meets; see time_of_impact.h.
struct ToiCandidate {
    std::uint32_t pair = 0;
    Slot bodyA = 0, bodyB = 0;
    std::uint32_t visitedAt = 0; // 0: not yet
    bool touches = false;        // then only its turns are limited
    bool deepens = false;        // and maybe where it has no contact point yet
    bool stopsA = false, stopsB = false;
};

/// Of time_of_impact.
struct ToiSearch {
    std::vector<ToiCandidate> candidates;
    std::vector<std::uint32_t> shortenedAt; // by slot: the visit of a pair that shortened the motion
    std::uint32_t visits = 0;               // of candidates
};

/// Of sub-steps.
struct Substeps {
    std::vector<Transform> trial;       // poses, by slot
    std::vector<std::uint8_t> implicit; // by slot: whether a connector is too stiff for the sub-steps
};

/// Of sleep.
struct SleepSearch {
    PairTable newTable;
    std::vector<Slot> parents;        // by slot: islands as trees
    std::vector<std::uint8_t> marked; // by slot
};

struct Scratch {
    PairSearch search;
    PairChanges changes;
    NarrowPhase narrow;
    SolverScratch solver;
    ToiSearch toi;
    Substeps substeps;
    SleepSearch sleep;
    StageTimes* times = nullptr; // of the running update, if anybody wants them

    Scratch() = default;
    ~Scratch() = default;
    /// A copy begins without, and so does what a copy is assigned to.
    Scratch(const Scratch&) {}           // NOLINT(bugprone-copy-constructor-init)
    Scratch& operator=(const Scratch&) { // NOLINT(bugprone-unhandled-self-assignment): nothing is lost but room
        *this = Scratch{};
        return *this;
    }
    Scratch(Scratch&&) noexcept = default;
    Scratch& operator=(Scratch&&) noexcept = default;
};

} // namespace spacetow
