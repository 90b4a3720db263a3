#pragma once
// The contact pool: manifolds and impulses that pairs keep from one iteration to the next, for the warm start.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// The contact of the pair. A pair without a contact gets a new one without points, with the mixed friction and
/// restitution of the two bodies. A later call that creates a contact may invalidate the reference.
Contact& contactOf(const Bodies& bodies, Contacts& contacts, Pair& pair);

/// Returns the contact of the pair to the pool, if the pair has one. The contact must not have a lane.
void freeContact(Contacts& contacts, NarrowPhase& narrow, Pair& pair);

/// Frees the contacts of all pairs in `PairChanges::dropped` and closes their lanes.
void freeContactsOfDropped(const ContactStage& stage);

/// Marks all manifolds as out of date. Impulses stay for the warm start.
void resetManifolds(Contacts& contacts);

/// The body has another mass, friction or restitution: its contacts, also those in the table of sleepers, keep their
/// manifolds and impulses but get its material. Releases all constraints if the body has contact points;
/// returns whether it has.
bool refreshMaterials(const ContactStage& stage, const PairTable& sleepers, Slot slot);

/// Scale impulses for an iteration that is divided into shorter parts. `share` is the length of the part divided by the
/// length of the iteration, 0 … 1. beginPart() multiplies all impulses with `share`, as the warm start of a shorter
/// step needs. endPart() adds 1 − share of the impulses before the part. The sum approximates a whole iteration:
/// impulses of the parts so far, and earlier impulses in place of the parts to come. Both functions release all
/// constraints.
void beginPart(const ContactStage& stage, double share);
void endPart(const ContactStage& stage, double share);

} // namespace spacetow
