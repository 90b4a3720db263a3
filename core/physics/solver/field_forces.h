#pragma once
// The forces of fields, applied as impulses before each sub-step.

#include "core/physics/solver/force_stage.h"

namespace spacetow {

/// Whether the field acts on the body.
bool actsOn(const Bodies& bodies, const FieldRecord& field, Slot slot);

/// The body moves in sub-steps.
void noteSubstepped(Bodies& bodies, Forces& forces, Slot slot);

/// Marks the bodies that feel any field as moving in sub-steps, and lists them.
void refreshFields(Bodies& bodies, Forces& forces);
/// Likewise a body that is new.
void refreshFieldsOf(Bodies& bodies, Forces& forces, Slot slot);

/// The impulses of all fields during `seconds` at the trial poses; changes velocities only. Each body feels the sum of
/// its fields at once, so that their order does not matter; values that are not finite are left out and reported.
void applyFields(const ForceStage& stage, double seconds, int iteration);

/// Removes the fields that act on this body alone.
void removeFieldsOf(const Bodies& bodies, Forces& forces, Slot slot);

} // namespace spacetow
