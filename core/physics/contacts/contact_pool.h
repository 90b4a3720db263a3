#pragma once
// What is known of contacts, for the pairs that have come near each other.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// The pair's contact; a new one without points if it has none.
Contact& contactOf(const Bodies& bodies, Contacts& contacts, Pair& pair);

void freeContact(Contacts& contacts, NarrowPhase& narrow, Pair& pair);

/// Of the pairs that are `dropped` from the table.
void freeContactsOfDropped(const ContactStage& stage);

/// All manifolds are to be made anew.
void resetManifolds(Contacts& contacts);

/// An iteration that is made in parts has the impulses of each part, this share of it, added up for the next iteration;
/// until then the last iteration's stand for the parts to come.
void beginPart(const ContactStage& stage, double share);
void endPart(const ContactStage& stage, double share);

} // namespace spacetow
