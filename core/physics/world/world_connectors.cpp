// World: adding, reading and removing connectors.

#include "core/base/contract.h"
#include "core/physics/def/codes.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/state/world_data.h"
#include "core/physics/world/world.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace spacetow {

namespace {

std::optional<Error> check(const World& world, const ConnectorDef& d) {
    if (!world.contains(d.a) || !world.contains(d.b)) {
        return Error{PhysicsCode("no-such-body"), {world.contains(d.a) ? "b" : "a"}};
    }
    if (d.a == d.b) {
        return Error{PhysicsCode("same-body"), {}};
    }
    const std::pair<const char*, bool> finite[] = {
        {"anchor", isFinite(d.anchorA) && isFinite(d.anchorB)},
        {"length", !d.length || std::isfinite(*d.length)},
        {"stiffness", std::isfinite(d.stiffness)},
        {"damping", std::isfinite(d.damping)},
        {"limit", std::isfinite(d.truncation.limit)},
        {"proportion", std::isfinite(d.truncation.proportion)},
    };
    for (const auto& [name, ok] : finite) {
        if (!ok) {
            return Error{PhysicsCode("not-finite"), {name}};
        }
    }
    const std::pair<const char*, bool> inRange[] = {
        {"length", !d.length || *d.length >= 0},
        {"stiffness", d.stiffness >= 0},
        {"damping", d.damping >= 0},
        {"limit", d.truncation.limit >= 0},
        {"proportion", d.truncation.proportion >= 0 && d.truncation.proportion <= 1},
    };
    for (const auto& [name, ok] : inRange) {
        if (!ok) {
            return Error{PhysicsCode("out-of-range"), {name}};
        }
    }
    return {};
}

/// Sets the members of the record that ConnectorDef defines.
void define(const Bodies& bodies, const ConnectorDef& def, ConnectorRecord& c) {
    c.a = def.a.index;
    c.b = def.b.index;
    c.anchorA = def.anchorA - bodies.records[c.a].localCenter;
    c.anchorB = def.anchorB - bodies.records[c.b].localCenter;
    const auto measured = [&] {
        return (bodies.pose(c.b).toWorld(c.anchorB) - bodies.pose(c.a).toWorld(c.anchorA)).norm();
    };
    c.length = def.length ? *def.length : measured();
    c.stiffness = def.stiffness;
    c.damping = def.damping;
    c.slack = def.slack;
    c.bodiesCollide = def.bodiesCollide;
    c.truncation = def.truncation;
}

/// Whether the records are equal. Connectors with a custom function never are: functions cannot be compared.
bool isSame(const ConnectorRecord& c, const ConnectorRecord& d) {
    const auto values = [](const ConnectorRecord& r) {
        return std::tuple(r.a, r.b, r.length, r.stiffness, r.damping, r.slack, r.bodiesCollide, r.truncation.rule,
                          r.truncation.limit, r.truncation.proportion);
    };
    return values(c) == values(d) && c.anchorA == d.anchorA && c.anchorB == d.anchorB &&
           c.truncation.rule != TruncationRule::Custom;
}

/// Requests the wake of the bodies of a connector. A static body would wake all bodies near it, which the connector
/// does not concern.
void requestWakeOfEnds(Bodies& bodies, Sleep& sleep, const ConnectorRecord& c) {
    for (const Slot slot : {c.a, c.b}) {
        if (bodies.records[slot].kind != BodyKind::Static) {
            requestWake(bodies, sleep, slot);
        }
    }
}

} // namespace

Result<ConnectorId> World::addConnector(const ConnectorDef& def) {
    if (std::optional<Error> error = check(*this, def)) {
        return *std::move(error);
    }
    WorldData& data = *m_data;
    auto index = static_cast<std::uint32_t>(data.forces.connectors.size());
    if (data.forces.freeConnectors.empty()) {
        data.forces.connectors.emplace_back();
    } else {
        index = data.forces.freeConnectors.back();
        data.forces.freeConnectors.pop_back();
    }
    ConnectorRecord& c = data.forces.connectors[index];
    c.used = true;
    c.serial = data.bodies.nextSerial++;
    c.tension = 0;
    define(data.bodies, def, c);
    data.flags.connectionsStale = true;
    requestWakeOfEnds(data.bodies, data.sleep, c);
    return ConnectorId{index, c.generation};
}

Result<bool> World::setConnector(ConnectorId connector, const ConnectorDef& def) {
    EXPECTS(contains(connector));
    if (std::optional<Error> error = check(*this, def)) {
        return *std::move(error);
    }
    WorldData& data = *m_data;
    ConnectorRecord& c = data.forces.connectors[connector.index];
    ConnectorRecord next = c;
    define(data.bodies, def, next);
    if (isSame(c, next)) {
        return false;
    }
    data.flags.connectionsStale |= c.a != next.a || c.b != next.b || c.bodiesCollide != next.bodiesCollide;
    requestWakeOfEnds(data.bodies, data.sleep, c);
    c = std::move(next);
    requestWakeOfEnds(data.bodies, data.sleep, c);
    return true;
}

bool World::contains(ConnectorId connector) const {
    return connector.index < m_data->forces.connectors.size() && m_data->forces.connectors[connector.index].used &&
           m_data->forces.connectors[connector.index].generation == connector.generation;
}

void World::removeConnector(ConnectorId connector) {
    EXPECTS(contains(connector));
    requestWakeOfEnds(m_data->bodies, m_data->sleep, m_data->forces.connectors[connector.index]);
    m_data->forces.release(connector.index);
    m_data->flags.connectionsStale = true;
}

ConnectorState World::connector(ConnectorId connector) const {
    EXPECTS(contains(connector));
    const ConnectorRecord& c = m_data->forces.connectors[connector.index];
    const Transform poseA = m_data->bodies.pose(c.a);
    const Transform poseB = m_data->bodies.pose(c.b);
    return {m_data->bodies.idOf(c.a),
            m_data->bodies.idOf(c.b),
            poseA.toWorld(c.anchorA),
            poseB.toWorld(c.anchorB),
            c.length,
            c.tension};
}

std::vector<ConnectorId> World::connectors() const {
    std::vector<ConnectorId> ids;
    for (std::uint32_t i = 0; i < m_data->forces.connectors.size(); ++i) {
        if (m_data->forces.connectors[i].used) {
            ids.push_back({i, m_data->forces.connectors[i].generation});
        }
    }
    std::sort(ids.begin(), ids.end(), [this](ConnectorId a, ConnectorId b) {
        return m_data->forces.connectors[a.index].serial < m_data->forces.connectors[b.index].serial;
    });
    return ids;
}

} // namespace spacetow
