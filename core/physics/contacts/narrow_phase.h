#pragma once
// The narrow phase over the pairs: contacts for solid pairs, overlaps for intangible ones.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// Makes the constraints of the solver from the poses at the beginning of the iteration. Surfaces that could
/// close their gap within the iteration count as in contact already; the solver lets them close it and no more. Those
/// that will bounce are marked to be swept instead.
void findContacts(const ContactStage& stage, const IterationStep& step);

/// Marks the pairs that touch without force at the end of the iteration: those of intangible bodies, and of
/// two bodies that nothing can move.
void findOverlaps(const Bodies& bodies, Contacts& contacts);

} // namespace spacetow
