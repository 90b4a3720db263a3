#include "core/game/plot_quantity.h"

#include "core/physics/query/explain.h"

#include <array>
#include <numbers>

namespace spacetow {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

struct QuantityRow {
    PlotSubject subject;
    const char* unit;
};

constexpr std::array<QuantityRow, plotQuantityCount> quantityRows{{
    {PlotSubject::Body, "m"},        {PlotSubject::Body, "m"},       {PlotSubject::Body, "°"},
    {PlotSubject::Body, "m/s"},      {PlotSubject::Body, "m/s"},     {PlotSubject::Body, "m/s"},
    {PlotSubject::Body, "°/s"},      {PlotSubject::Body, "N"},       {PlotSubject::Body, "N"},
    {PlotSubject::Body, "N"},        {PlotSubject::Body, "J"},       {PlotSubject::Body, "J"},
    {PlotSubject::Body, "J"},        {PlotSubject::Body, "kg m/s"},  {PlotSubject::Body, "kg m/s"},
    {PlotSubject::Body, "kg m²/s"},  {PlotSubject::Connector, "m"},  {PlotSubject::Connector, "N"},
    {PlotSubject::Connector, "J"},   {PlotSubject::World, "J"},      {PlotSubject::World, "J"},
    {PlotSubject::World, "J"},       {PlotSubject::World, "J"},      {PlotSubject::World, "%"},
    {PlotSubject::World, "kg m/s"},  {PlotSubject::World, "kg m/s"}, {PlotSubject::World, "%"},
    {PlotSubject::World, "kg m²/s"},
}};

const QuantityRow& rowOf(PlotQuantity quantity) {
    return quantityRows[static_cast<std::size_t>(quantity)];
}

constexpr std::array<PlotQuantity, plotQuantityCount> inOrder() {
    std::array<PlotQuantity, plotQuantityCount> all{};
    for (int i = 0; i < plotQuantityCount; ++i) {
        all[static_cast<std::size_t>(i)] = static_cast<PlotQuantity>(i);
    }
    return all;
}
constexpr std::array<PlotQuantity, plotQuantityCount> allQuantities = inOrder();

double ofState(const BodyState& state, PlotQuantity quantity) {
    switch (quantity) {
    case PlotQuantity::X:
        return state.pose.position.x();
    case PlotQuantity::Y:
        return state.pose.position.y();
    case PlotQuantity::Angle:
        return state.angle * degrees;
    case PlotQuantity::VelocityX:
        return state.velocity.x();
    case PlotQuantity::VelocityY:
        return state.velocity.y();
    case PlotQuantity::Speed:
        return state.velocity.norm();
    default:
        return state.angularVelocity * degrees;
    }
}

double ofReading(const BodyReading& reading, PlotQuantity quantity) {
    switch (quantity) {
    case PlotQuantity::ForceX:
        return reading.forces.sum().force.x();
    case PlotQuantity::ForceY:
        return reading.forces.sum().force.y();
    case PlotQuantity::ContactForce:
        return reading.forces.contacts.force.norm();
    case PlotQuantity::BodyKinetic:
        return reading.energy.kinetic;
    case PlotQuantity::BodyPotential:
        return reading.energy.potential;
    case PlotQuantity::BodyEnergy:
        return reading.energy.kinetic + reading.energy.potential;
    case PlotQuantity::BodyMomentumX:
        return reading.momentum.x();
    case PlotQuantity::BodyMomentumY:
        return reading.momentum.y();
    default:
        return reading.spin;
    }
}

double ofConnector(const ConnectorReading& reading, PlotQuantity quantity) {
    return quantity == PlotQuantity::Distance  ? reading.distance
           : quantity == PlotQuantity::Tension ? reading.tension
                                               : reading.energy;
}

std::optional<double> ofWorld(const WorldReading& reading, PlotQuantity quantity) {
    switch (quantity) {
    case PlotQuantity::Energy:
        return reading.energy();
    case PlotQuantity::Kinetic:
        return reading.kinetic;
    case PlotQuantity::Potential:
        return reading.potential;
    case PlotQuantity::Elastic:
        return reading.elastic;
    case PlotQuantity::MomentumX:
        return reading.momentum.x();
    case PlotQuantity::MomentumY:
        return reading.momentum.y();
    case PlotQuantity::AngularMomentum:
        return reading.angularMomentum;
    default:
        return std::nullopt;
    }
}

} // namespace

PlotSubject subjectOf(PlotQuantity quantity) {
    return rowOf(quantity).subject;
}

const char* unitOf(PlotQuantity quantity) {
    return rowOf(quantity).unit;
}

std::span<const PlotQuantity> quantitiesOf(PlotSubject subject) {
    std::size_t first = 0;
    while (quantityRows[first].subject != subject) {
        ++first;
    }
    std::size_t end = first;
    while (end < quantityRows.size() && quantityRows[end].subject == subject) {
        ++end;
    }
    return std::span(allQuantities).subspan(first, end - first);
}

std::optional<PlotSubject> subjectOf(const Session& session, Key object) {
    return object == 0                   ? std::optional(PlotSubject::World)
           : session.bodyOf(object)      ? std::optional(PlotSubject::Body)
           : session.connectorOf(object) ? std::optional(PlotSubject::Connector)
                                         : std::nullopt;
}

std::optional<double> plotted(const Session& session, const PlotSource& source) {
    const World& world = session.world();
    switch (subjectOf(source.quantity)) {
    case PlotSubject::World:
        return ofWorld(totals(world), source.quantity);
    case PlotSubject::Body:
        if (const std::optional<BodyId> body = session.bodyOf(source.object)) {
            return source.quantity <= PlotQuantity::AngularVelocity
                       ? ofState(world.body(*body), source.quantity)
                       : ofReading(explained(world, *body), source.quantity);
        }
        break;
    case PlotSubject::Connector:
        if (const std::optional<ConnectorId> connector = session.connectorOf(source.object)) {
            return ofConnector(explained(world, *connector), source.quantity);
        }
        break;
    }
    return std::nullopt;
}

} // namespace spacetow
