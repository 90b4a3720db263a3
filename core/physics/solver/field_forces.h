#pragma once
// Forces of force fields, applied as impulses (kicks) around each sub-step.

#include "core/physics/solver/force_stage.h"

namespace spacetow {

/// Whether the field acts on the body: the field targets this body or one of its tags, and the body accepts the force.
bool actsOn(const Bodies& bodies, const FieldRecord& field, Slot slot);

/// Marks the body as integrated in sub-steps, and adds the body to `Forces::substepped`.
void noteSubstepped(Bodies& bodies, Forces& forces, Slot slot);

/// Lists all bodies on which any field acts in `Forces::fieldBodies`, by slot, and marks each as integrated in
/// sub-steps.
void refreshFields(Bodies& bodies, Forces& forces);
/// The same for one body that has just been added.
void refreshFieldsOf(Bodies& bodies, Forces& forces, Slot slot);

/// Applies the impulses of all fields over `seconds` at the trial poses; changes velocities only. All fields of a body
/// are evaluated at the same velocity and summed, so no field sees the effect of another. A force that is not finite is
/// left out and reported, once an update for each field. Sleeping bodies are skipped.
void applyFields(const ForceStage& stage, double seconds, int iteration);

/// Removes the fields that are attached to this body (ForceFieldDef::body).
void removeFieldsOf(const Bodies& bodies, Forces& forces, Slot slot);

} // namespace spacetow
