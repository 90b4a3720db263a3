#pragma once
// Contacts that walls and parts have in common.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// Makes one contact of those of a body that lie in one plane: a flat face on several walls, or several parts of the
/// body on one wall. The solver then finds its impulses at once, whatever the order of the walls and parts. Lists the
/// pairs for which merged contacts stand as `mergedPairs`.
void mergeContacts(const ContactStage& stage);

} // namespace spacetow
