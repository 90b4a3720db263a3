#pragma once
// What can be plotted of a session: quantities of a body, of a connector and of everything together. SI units; angles
// in degrees, as people read them.

#include "core/game/session.h"

#include <optional>
#include <span>

namespace spacetow {

enum class PlotSubject : std::uint8_t { World, Body, Connector };

enum class PlotQuantity : std::uint8_t {
    // Of a body.
    X,
    Y,
    Angle,
    VelocityX,
    VelocityY,
    Speed,
    AngularVelocity,
    ForceX, // of all that acts on it
    ForceY,
    ContactForce,
    BodyKinetic,
    BodyPotential,
    BodyEnergy,
    BodyMomentumX,
    BodyMomentumY,
    Spin,
    // Of a connector.
    Distance,
    Tension,
    ConnectorEnergy,
    // Of all.
    Energy,
    Kinetic,
    Potential,
    Elastic,
    EnergyDrift,
    MomentumX,
    MomentumY,
    MomentumDrift,
    AngularMomentum,
};
constexpr int plotQuantityCount = 28;

PlotSubject subjectOf(PlotQuantity quantity);
/// "m/s"; the same for what can share an axis.
const char* unitOf(PlotQuantity quantity);
/// In the order of the list above.
std::span<const PlotQuantity> quantitiesOf(PlotSubject subject);
/// What the object is in the session; World for key 0, nothing for what is not there.
std::optional<PlotSubject> subjectOf(const Session& session, Key object);

struct PlotSource {
    Key object = 0; // 0: of all
    PlotQuantity quantity = PlotQuantity::Energy;

    auto operator<=>(const PlotSource&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

/// Nothing while the object is not in the world. Drifts are of one moment against another, see PlotHistory.
std::optional<double> plotted(const Session& session, const PlotSource& source);

} // namespace spacetow
