#pragma once
// The narrow phase: contacts of solid pairs, and overlaps of sensor pairs.

#include "core/physics/contacts/contact_stage.h"

namespace spacetow {

/// Updates the constraints of the solver for the poses at the beginning of the iteration, or rebuilds all constraints,
/// for instance after many changes. Surfaces within the speculative margin get a speculative contact: the solver lets
/// the surfaces close their gap, and no more. Surfaces that will meet in this iteration and bounce get no contact at
/// the bouncing points. Their pairs are marked with `sweep` instead, and the time of impact stops the bodies.
void findContacts(const ContactStage& stage, const IterationStep& step);

/// Updates the sensor pairs at the end of the iteration. `touching`: the parts overlap at their final poses. `passed`:
/// the parts touch neither at the last report nor now, but overlapped on the way. A pair is a sensor pair if a body is
/// intangible, or if nothing can move either body.
void findOverlaps(const Bodies& bodies, Contacts& contacts);

} // namespace spacetow
