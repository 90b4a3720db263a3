#pragma once
// What the stages of the update tell each other. Whoever sets a flag, and who clears it, is written here and nowhere
// else.
namespace spacetow {

struct StepFlags {
    // Something is out of date. Between updates these are part of the state of a world.

    // Static bodies have been added, removed, moved or switched: set by whoever does so, cleared by refreshStatics.
    bool staticsChanged = true;
    // Connectors have come or gone: set likewise, cleared by refreshConnections, which sets `pairsStale`.
    bool connectionsStale = false;
    // All pairs are to be found anew, as their bodies, filters or statics have changed: cleared by changePairs.
    bool pairsStale = true;
    // There are more pairs than are kept: set by collectPairs, cleared by refreshBodyLists, which sets `pairsStale`.
    bool crowded = false;
    // The pairs, or who moves, have changed: set by changePairs and listSensors, cleared by findComponents.
    bool contactGraphStale = true;
    // Every lane belongs to the contact of a pair in the table. Set by resetConstraints; cleared by releaseConstraints,
    // for changes that lanes cannot follow. Only then are `anyScalarUpdate` and `anySingular` true of the constraints.
    bool constraintsValid = false;
    bool anyScalarUpdate = false;
    bool anySingular = false;
    // Pairs behind merged contacts have begun or ceased to touch: set by solveVelocities; the next findContacts
    // rebuilds the constraints.
    bool mergeStale = false;

    // Noticed in the iteration; each is written before it is read.

    // By measureMotion: a motion is not finite; a body has left its fat AABB, or all pairs are stale (until findPairs;
    // measureCorrections writes this one again); a motion exceeds the speculative margin (solveVelocities may add one).
    bool anyFault = false;
    bool anyMovedProxy = false;
    bool anyFast = false;
    // By findContacts: a pair will bounce, and is to be swept; a contact bounces; the constraints have been rebuilt.
    bool anySweep = false;
    bool anyBounce = false;
    bool constraintsRebuilt = false;
    // By solveVelocities: contacts have sent a body elsewhere than it was going.
    bool anyDeflected = false;
};

} // namespace spacetow
