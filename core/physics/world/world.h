#pragma once
// The world: bodies and connectors, and the update that moves them. A world is a value: a copy of it is a saved game.
// It has one owner; other threads read snapshots.

#include "core/base/result.h"
#include "core/math/aabb.h"
#include "core/physics/def/body.h"
#include "core/physics/def/connector.h"
#include "core/physics/def/events.h"
#include "core/physics/def/force_field.h"
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

    /// Codes: "not-finite", "bad-mass", "bad-shape", "no-shape", "out-of-range"; the first argument names the field.
    Result<BodyId> addBody(const BodyDef& def);
    /// Codes: "not-finite", "out-of-range", "no-such-body", "same-body".
    Result<ConnectorId> addConnector(const ConnectorDef& def);

    /// Codes: "no-force", "no-such-body". Acts from the next update on.
    Result<FieldId> addField(ForceFieldDef def);

    /// Removal, together with the body's connectors, is carried out at the start of the next update or the end of
    /// the running iteration; the same goes for the setters of flags below.
    void removeBody(BodyId body);
    void removeConnector(ConnectorId connector);
    void removeField(FieldId field); // at once, like a connector
    void setActive(BodyId body, bool active);
    void setTangible(BodyId body, bool tangible);
    void setFrozen(BodyId body, bool frozen) { setFrozen(body, frozen, frozen); }
    void setFrozen(BodyId body, bool position, bool rotation);

    /// At once; for a static body the static tree is rebuilt with the next update.
    void setPose(BodyId body, const Vec2& position, double angle);
    void setVelocity(BodyId body, const Vec2& velocity, double angularVelocity);
    void setFilter(BodyId body, const Filter& filter);
    /// Whether the tags that it touches in each iteration are among the events.
    void setReportsTouches(BodyId body, bool reports);

    /// Forces act during the whole of the next update and are then forgotten; N and N m. A value that is not finite
    /// is refused: the call returns false and changes nothing.
    bool applyForce(BodyId body, const Vec2& force, ForceSource source = ForceSource::Manual);
    bool applyForceAt(BodyId body, const Vec2& force, const Vec2& worldPoint, ForceSource source = ForceSource::Manual);
    bool applyTorque(BodyId body, double torque, ForceSource source = ForceSource::Manual);
    /// At once; N s and N m s.
    bool applyImpulseAt(BodyId body, const Vec2& impulse, const Vec2& worldPoint,
                        ForceSource source = ForceSource::Manual);
    bool applyAngularImpulse(BodyId body, double impulse, ForceSource source = ForceSource::Manual);

    /// Whether bodies fall asleep, from the next update on; at first they do not. Bodies that touch or are connected
    /// and no point of which has been faster than 0.01 m/s for half a second then rest, at no cost, until one of them
    /// is touched by an awake body, or anything is done to one of them or to what they rest on.
    void setSleeping(bool allowed);
    bool sleeping() const;

    /// Whether updates note what each contact gives, for the explanations (core/physics/query/explain.h); at first they
    /// do not. It changes nothing else.
    void setRecordsImpulses(bool records);
    bool recordsImpulses() const;

    /// One update with the world's own parameters, or with others for this call only.
    void update();
    void update(const UpdateParameters& parameters);
    /// Likewise, and tells how long its stages take.
    void update(const UpdateParameters& parameters, StageTimes& times);

    const UpdateParameters& parameters() const;
    void setParameters(const UpdateParameters& parameters);
    const Events& events() const;

    bool contains(BodyId body) const;
    bool contains(ConnectorId connector) const;
    bool contains(FieldId field) const;
    /// The id must be in the world.
    BodyState body(BodyId body) const;
    const std::vector<Shape>& shapes(BodyId body) const;
    ConnectorState connector(ConnectorId connector) const;
    /// Always contains the body's shapes where they are now. It is the box of the last broad phase, with room for the
    /// whole way of the body in that update, or the exact one when the body has been added or put elsewhere since.
    Aabb bounds(BodyId body) const;
    /// In the order in which they were added.
    std::vector<BodyId> bodies() const;
    std::vector<ConnectorId> connectors() const;
    int bodyCount() const;

    /// Kinetic energy plus potential energy in the gravity of `parameters()` plus what connectors hold, J.
    double energy() const;
    /// Over everything that decides the future but the shapes and the functions of connectors and fields: worlds made
    /// of the same definitions and with equal hashes have equal futures.
    std::uint64_t hash() const;

    /// The arrays themselves, for the stages of the update and the queries.
    const WorldData& data() const { return *m_data; }

  private:
    std::unique_ptr<WorldData> m_data;
};

} // namespace spacetow
