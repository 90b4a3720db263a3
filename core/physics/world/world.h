#pragma once
// The world: bodies and connectors, and the update that moves them. A world is a value: a copy is a saved state. No
// two threads may use one world at a time. SI units, radians, y up.

#include "core/base/result.h"
#include "core/math/aabb.h"
#include "core/physics/def/body.h"
#include "core/physics/def/connector.h"
#include "core/physics/def/events.h"
#include "core/physics/def/parameters.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace spacetow {

struct StageTimes;
struct WorldData;

class World {
  public:
    explicit World(const UpdateParameters& parameters = {});
    World(const World&);
    World(World&&) noexcept;
    World& operator=(const World&);
    World& operator=(World&&) noexcept;
    ~World();

    /// At once; the body collides from the next update on. Errors: "not-finite", "bad-mass", "bad-shape", "no-shape",
    /// "out-of-range"; argument 1 names the field.
    Result<BodyId> addBody(const BodyDef& def);
    /// Errors: "not-finite", "out-of-range", "no-such-body", "same-body"; argument 1 names the field.
    Result<ConnectorId> addConnector(const ConnectorDef& def);

    /// Every id that is passed to a member function has to be in the world; EXPECTS checks that, except for contains()
    /// and the ids in a ConnectorDef.
    ///
    /// Deferred to the start of the next update. The connectors of the body are removed with the body.
    void removeBody(BodyId body);
    /// At once.
    void removeConnector(ConnectorId connector);
    /// Flags; deferred to the start of the next update. See BodyDef for their meaning.
    void setActive(BodyId body, bool active);
    void setTangible(BodyId body, bool tangible);
    void setFrozen(BodyId body, bool frozen) { setFrozen(body, frozen, frozen); }
    void setFrozen(BodyId body, bool position, bool rotation);

    /// Replaces the definition of a connector at once; its bodies may change too. Without a length the connector gets
    /// the present distance of its anchors. Returns whether anything has changed; if not, no body wakes. Errors as in
    /// addConnector.
    Result<bool> setConnector(ConnectorId connector, const ConnectorDef& def);

    /// At once: position of the local origin in m, angle in rad, both finite. For a static body the next update also
    /// patches the static tree.
    void setPose(BodyId body, const Vec2& position, double angle);
    /// At once: velocity of the centre of mass in m/s, angular velocity in rad/s, both finite. Ignored by static bodies
    /// and frozen axes.
    void setVelocity(BodyId body, const Vec2& velocity, double angularVelocity);
    /// At once; pairs are found again in the next update.
    void setFilter(BodyId body, const Filter& filter);
    /// At once. Contacts keep their manifolds and impulses, and the centre of mass keeps its place. A static body has
    /// restitution and friction only. Returns whether anything has changed; if not, no body wakes. Errors:
    /// "not-finite", "out-of-range", "bad-mass", as in addBody; the body then keeps its material.
    Result<bool> setMaterial(BodyId body, const BodyMaterial& material);

    /// Forces (N) and torques (N m) act during the next update and are then cleared. A body that does not accept the
    /// force (see ForceSource) or is inactive ignores it. With a value that is not finite the call returns false and
    /// changes nothing; else it returns true.
    bool applyForce(BodyId body, const Vec2& force, ForceSource source = ForceSource::Manual);
    bool applyForceAt(BodyId body, const Vec2& force, const Vec2& worldPoint, ForceSource source = ForceSource::Manual);
    bool applyTorque(BodyId body, double torque, ForceSource source = ForceSource::Manual);
    /// Impulses (N s) and angular impulses (N m s) act at once; errors as above.
    bool applyImpulseAt(BodyId body, const Vec2& impulse, const Vec2& worldPoint,
                        ForceSource source = ForceSource::Manual);
    bool applyAngularImpulse(BodyId body, double impulse, ForceSource source = ForceSource::Manual);

    /// Whether bodies may fall asleep, from the next update on; off by default. An island of touching or connected
    /// bodies sleeps once no point of its bodies has moved faster than 0.01 m/s for half a second. It wakes when an
    /// awake body touches it, or when a call changes one of its bodies or a body that they rest on. Each call also
    /// restarts the half second for all bodies.
    void setSleeping(bool allowed);

    /// Whether updates record the impulse of each contact, for core/physics/query/explain.h; off by default. Recording
    /// changes no result.
    void setRecordsImpulses(bool records);
    bool recordsImpulses() const;

    /// One update, with the parameters of the world or with `parameters` for this call only.
    void update();
    void update(const UpdateParameters& parameters);
    /// The same. Adds the time that each stage takes to `times`, which needs a clock.
    void update(const UpdateParameters& parameters, StageTimes& times);

    const UpdateParameters& parameters() const;
    /// EXPECTS the ranges of UpdateParameters, as update() does.
    void setParameters(const UpdateParameters& parameters);
    /// Of the last update.
    const Events& events() const;

    bool contains(BodyId body) const;
    bool contains(ConnectorId connector) const;
    BodyState body(BodyId body) const;
    const std::vector<Shape>& shapes(BodyId body) const;
    ConnectorState connector(ConnectorId connector) const;
    /// An AABB that contains all shapes of the body at its present pose: the fat AABB of the last broad phase, or the
    /// exact AABB when the body has been added or moved by a call since.
    Aabb bounds(BodyId body) const;
    /// In the order in which they were added to the world.
    std::vector<BodyId> bodies() const;
    std::vector<ConnectorId> connectors() const;
    int bodyCount() const;

    /// A hash of the state; shapes and the functions of connectors are not in it. Worlds that were made from
    /// the same definitions and have equal hashes have equal futures.
    std::uint64_t hash() const;

    /// The arrays behind the world, for query/ and tests.
    const WorldData& data() const { return *m_data; }

  private:
    std::unique_ptr<WorldData> m_data;
};

} // namespace spacetow
