#pragma once
// The payload and the rope that tows it.

#include "core/level/level.h"
#include "core/physics/def/connector.h"

namespace spacetow {

enum class PayloadState : std::uint8_t {
    Absent,  // the level has none
    Waiting, // frozen at its place
    Towed,
    Dropped,   // free, no longer to be won
    Lost,      // destroyed
    Delivered, // has crossed the finish; nothing hurts it any more
};

/// At rest and frozen, as it waits.
BodyDef payloadBody(const PayloadObject& object);
/// From the ship's notch to the centre of the payload, as long as their distance now.
ConnectorDef towRope(BodyId ship, BodyId payload, const RopeRules& rope);
/// An intangible line that only the payload notices.
BodyDef finishBody(const FinishObject& object);

} // namespace spacetow
