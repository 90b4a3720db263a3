// World: adding, reading and removing connectors.

#include "core/base/contract.h"
#include "core/physics/sleep/sleep.h"
#include "core/physics/state/world_data.h"
#include "core/physics/world/world.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

std::optional<Error> check(const ConnectorDef& d) {
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
            return Error{"not-finite", {name}};
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
            return Error{"out-of-range", {name}};
        }
    }
    return {};
}

/// Nothing changes for others near a static body to which something is connected.
void requestWakeOfEnds(Bodies& bodies, Sleep& sleep, const ConnectorRecord& c) {
    for (const Slot slot : {c.a, c.b}) {
        if (bodies.records[slot].kind != BodyKind::Static) {
            requestWake(bodies, sleep, slot);
        }
    }
}

} // namespace

Result<ConnectorId> World::addConnector(const ConnectorDef& def) {
    if (!contains(def.a) || !contains(def.b)) {
        return Error{"no-such-body", {contains(def.a) ? "b" : "a"}};
    }
    if (def.a == def.b) {
        return Error{"same-body", {}};
    }
    if (std::optional<Error> error = check(def)) {
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
    const BodyState a = body(def.a);
    const BodyState b = body(def.b);
    c.used = true;
    c.serial = data.bodies.nextSerial++;
    c.a = def.a.index;
    c.b = def.b.index;
    c.anchorA = def.anchorA - data.bodies.records[c.a].localCenter;
    c.anchorB = def.anchorB - data.bodies.records[c.b].localCenter;
    c.length = def.length.value_or((b.pose.toWorld(def.anchorB) - a.pose.toWorld(def.anchorA)).norm());
    c.stiffness = def.stiffness;
    c.damping = def.damping;
    c.slack = def.slack;
    c.bodiesCollide = def.bodiesCollide;
    c.truncation = def.truncation;
    c.tension = 0;
    data.flags.connectionsStale = true;
    requestWakeOfEnds(data.bodies, data.sleep, c);
    return ConnectorId{index, c.generation};
}

bool World::contains(ConnectorId connector) const {
    return connector.index < m_data->forces.connectors.size() && m_data->forces.connectors[connector.index].used &&
           m_data->forces.connectors[connector.index].generation == connector.generation;
}

void World::removeConnector(ConnectorId connector) {
    EXPECTS(contains(connector));
    ConnectorRecord& c = m_data->forces.connectors[connector.index];
    requestWakeOfEnds(m_data->bodies, m_data->sleep, c);
    c.used = false;
    ++c.generation;
    m_data->forces.freeConnectors.push_back(connector.index);
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
