#pragma once
// Contacts of one or two points between parts of any shape. A manifold is kept while its parts move little against each
// other: its points stay with their bodies, and what changes is how far apart they are.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// Adds the contact of a pair to `constraints`, from its kept manifold or from a new one.
void updateManifold(const ContactStage& stage, std::uint32_t index, double perSecond);

/// Makes the manifold of a contact that has a lane anew.
void remakeManifold(const ContactStage& stage, std::uint32_t index, double perSecond);

/// How much nearer the parts of a pair may come before their kept manifold is out of date, m.
double toleranceLeftOf(const Bodies& bodies, const Contacts& contacts, const Pair& pair);

/// How much nearer the parts of a pair without a contact may come before they can have one, m; 0 when that is unknown.
double separationBoundOf(const Bodies& bodies, const Contacts& contacts, const Pair& pair);

} // namespace spacetow
