#pragma once
// The constraints of the solver. A contact gets a lane of a SIMD batch when its surfaces come within the speculative
// margin, and keeps the lane until the surfaces part or all constraints are rebuilt. While a contact has a lane, its
// impulses are stored in the lane. saveImpulses() copies impulses to the contact pool: always before all lanes are
// released, and at the end of an update.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// The geometry of a circle contact in one iteration. World coordinates.
struct CircleManifold {
    Vec2 normal;             // unit, from a to b
    double separation;       // m, negative when the surfaces overlap
    double radiusA, radiusB; // m, from the centre of mass to the surface along the normal; 0 for static bodies
    std::uint32_t feature;   // identifies the corner or face that touches, for the warm start
};

/// The normal velocity that the solver aims at; positive when the surfaces separate. See contact_rules.h.
struct CircleTarget {
    double velocity = 0;  // m/s: the least normal velocity
    double closing = 0;   // m/s: with a normal velocity below this limit the contact has not converged
    bool bounces = false; // restitution acts in this iteration
};

/// Opens a lane for a circle contact, or updates the lane if the contact already has one.
void addCircleConstraint(const ContactStage& stage, std::uint32_t pair, const CircleManifold& touch,
                         const CircleTarget& target);

/// Opens a lane for a general contact. `perSecond` is iterations per second, here and below.
void addManifoldConstraint(const ContactStage& stage, const Constraint& constraint, double perSecond);

/// Overwrites the lane of a general contact with `constraint`. The contact has to have a lane.
void rewriteConstraint(const ContactStage& stage, const Constraint& constraint, double perSecond);

/// Chooses the acting point of each singular contact anew: after an update the other point may be the deeper one.
void updateSingular(Constraints& constraints);

/// Closes the lane of the pair's contact. Impulses in the lane are lost, unless saveImpulses() was called before. The
/// pair no longer counts as touching, and is updated in every iteration until the narrow phase sets a separation bound.
void removeConstraint(Contacts& contacts, Constraints& constraints, std::uint32_t pair);

/// Copies impulses from the lanes to the contact pool: of one contact, or of all if the constraints are valid.
void saveImpulses(Contacts& contacts, const Constraints& constraints, const CircleContact& contact);
void saveImpulses(Contacts& contacts, const Constraints& constraints, const GeneralContact& contact);
void saveAllImpulses(Contacts& contacts, const Constraints& constraints, const StepFlags& flags);

/// Prepares the warm start of a contact of one point. If `feature` differs from that of the last iteration, the contact
/// begins without impulses, and the function returns true.
bool matchFeature(Contact& contact, std::uint32_t feature);

/// Lists the merge candidates: two mergeable general contacts of the same body a, against one body b or two static
/// bodies. The first function searches all contacts, which have to be grouped by body a, as after a rebuild. The second
/// one adds the candidates that contain the last contact.
void findMergeCandidates(const Bodies& bodies, Constraints& constraints);
void findMergeCandidatesOfLast(const Bodies& bodies, Constraints& constraints);
/// Whether the two contacts of any merge candidate have parallel normals, so that both may lie in one plane.
bool anyInOnePlane(const Contacts& contacts, const Constraints& constraints);

/// Updates the pair indices of all contacts with a lane after `PairChanges::runs` have moved in the pair table. Lanes
/// stay as they are.
void remapPairs(const ContactStage& stage);

/// Saves all impulses and closes all lanes; the next findContacts() rebuilds the constraints. To be called before any
/// change that remapPairs() and removeConstraint() cannot follow: when all pairs are found anew, for example.
void releaseConstraints(Contacts& contacts, Constraints& constraints, StepFlags& flags);

/// Empties all lists and batches. From then on the constraints count as valid. To be called after releaseConstraints().
void resetConstraints(const Bodies& bodies, Constraints& constraints, StepFlags& flags, NarrowPhase& narrow);

} // namespace spacetow
