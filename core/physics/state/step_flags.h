#pragma once
// Flags by which the stages of the update communicate. The comments say which function sets and which clears a flag.
namespace spacetow {

struct StepFlags {
    // Data that is out of date. Between updates these flags are part of the state of a world.

    // Static bodies have been added, removed, moved, activated or deactivated: set by noteStaticChange, cleared by
    // refreshStatics.
    bool staticsChanged = true;
    // Connectors have been added or removed, or join other bodies: set by World, cleared by refreshConnections, which
    // sets `pairsStale`.
    bool connectionsStale = false;
    // All pairs have to be found again, because bodies, filters, connectors or statics have changed: cleared by
    // changePairs.
    bool pairsStale = true;
    // There are more pairs than mostPairs allows: set by collectPairs, cleared by refreshBodyLists, which sets
    // `pairsStale`.
    bool crowded = false;
    // The pair table or the set of moving bodies has changed: set by changePairs, listSensors and resetSlots, cleared
    // by findComponents.
    bool contactGraphStale = true;
    // Every lane belongs to the contact of a pair in the table. Set by resetConstraints; cleared by releaseConstraints,
    // for changes that lanes cannot follow. While it is set, `anyScalarUpdate` and `anySingular` tell whether any
    // constraint has that property.
    bool constraintsValid = false;
    bool anyScalarUpdate = false;
    bool anySingular = false;
    // Pairs behind merged contacts have begun or ceased to touch: set by solveVelocities; the next findContacts
    // rebuilds the constraints.
    bool mergeStale = false;

    // Results within one iteration; each flag is written before it is read.

    // Set by measureMotion:
    // - anyFault: a motion is not finite.
    // - anyMovedProxy: a body has left its fat AABB, or all pairs are stale. Cleared by findPairs; findDisplaced
    //   sets it again.
    // - anyFast: a motion exceeds the speculative margin. solveVelocities may set it later.
    bool anyFault = false;
    bool anyMovedProxy = false;
    bool anyFast = false;
    // Set by findContacts:
    // - anySweep: a pair will bounce at its time of impact.
    // - anyBounce: restitution acts at a contact.
    // - constraintsRebuilt: the constraints have been rebuilt.
    bool anySweep = false;
    bool anyBounce = false;
    bool constraintsRebuilt = false;
    // Set by solveVelocities: contacts have changed the motion of a body by more than a small deflection.
    bool anyDeflected = false;
};

} // namespace spacetow
