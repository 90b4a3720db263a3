#pragma once
// The constraints of the solver: each contact has a lane of a batch, from the iteration in which its surfaces come near
// each other to that in which they part. Meanwhile its impulses are in the lane; the contact gets a copy when the lane
// is closed, or at the end of an update.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// The surfaces of a circle contact.
struct CircleTouch {
    Vec2 normal; // from a to b
    double separation;
    double radiusA, radiusB; // from the centres of mass to the surfaces along the normal; of static bodies 0
    std::uint32_t feature;
};

/// What the normal velocity is to be, see contact_rules.h.
struct CircleTarget {
    double velocity = 0; // m/s
    double closing = 0;  // m/s: faster than they may come nearer to each other
    bool bounces = false;
};

/// Gives a circle contact a lane, or updates the lane that it has.
void addCircleConstraint(const ContactStage& stage, std::uint32_t pair, const CircleTouch& touch,
                         const CircleTarget& target);

/// Gives a general contact a lane.
void addManifoldConstraint(const ContactStage& stage, const Constraint& constraint, double perSecond);

/// Writes the lane of a general contact anew; its pair is that of the constraint.
void rewriteConstraint(const ContactStage& stage, const Constraint& constraint, double perSecond);

/// Where the point that acts for both points of singular contacts may have changed.
void updateSingular(Constraints& constraints);

/// Closes the lane of the pair's contact, impulses included. The pair has no separation bound until it gets another
/// one.
void removeConstraint(Contacts& contacts, Constraints& constraints, std::uint32_t pair);

/// Copies impulses from the lanes to where they are kept.
void saveImpulses(Contacts& contacts, const Constraints& constraints, const CircleContact& contact);
void saveImpulses(Contacts& contacts, const Constraints& constraints, const GeneralContact& contact);
void saveAllImpulses(Contacts& contacts, const Constraints& constraints, const StepFlags& flags);

/// A contact of other features than before begins without impulses. True when it does.
bool matchFeature(Contact& contact, std::uint32_t feature);

/// Notes which general contacts may come to lie in one plane: of all, in the order of their pairs, or of the last one.
void findMergeCandidates(const Bodies& bodies, Constraints& constraints);
void findMergeCandidatesOfLast(const Bodies& bodies, Constraints& constraints);
/// Whether any of them do.
bool anyInOnePlane(const Contacts& contacts, const Constraints& constraints);

/// Contacts keep their lanes when `runs` of pairs have moved in the table.
void remapPairs(const ContactStage& stage);

/// Saves all impulses and gives up all lanes; the next iteration rebuilds the constraints. To be called before pairs
/// change in another way than by removal.
void releaseConstraints(Contacts& contacts, Constraints& constraints, StepFlags& flags);

/// Begins anew without constraints.
void resetConstraints(const Bodies& bodies, Constraints& constraints, StepFlags& flags, NarrowPhase& narrow);

} // namespace spacetow
