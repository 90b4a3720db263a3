#pragma once
// A game of SpaceTow in one level, or, in a level without a ship, a sandbox. A session is a value: a copy of it goes on
// exactly like the original. It knows no clock and no thread; each step is one update of the world.
//
// An attempt begins with the level as it was drawn and the ship frozen. It ends when the payload is towed through the
// finish, where ship and payload then stay, or costs one life when ship or payload is lost. The level may be edited
// meanwhile: the session then takes over the difference, object by object.

#include "core/base/random.h"
#include "core/game/camera.h"
#include "core/game/controls.h"
#include "core/game/debris.h"
#include "core/game/flight_end.h"
#include "core/game/payload.h"
#include "core/game/snapshot.h"
#include "core/game/start_bodies.h"
#include "core/game/step_input.h"
#include "core/game/tag_touches.h"
#include "core/physics/world/world.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace spacetow {

class Session {
  public:
    explicit Session(const Level& level, std::uint64_t seed = 1);
    explicit Session(std::shared_ptr<const Level> level, std::uint64_t seed = 1);

    /// One update. A press counts when the key was not held in the update before; after a crash all keys have to be let
    /// go first, so that whoever is still steering sees that it is over.
    void step(const Controls& controls) { step(StepInput{controls, {}, {}}); }
    /// The same. A level that is given holds from this update on. What was added stands where it starts; what was
    /// moved, turned or given another start velocity goes on by so much from where it is now, as fast as it is and
    /// more; everything else changes in place. An object that could not be built now goes on as it was. Before the
    /// first update the session becomes that of the new level; a later attempt begins with it.
    void step(const StepInput& input);
    /// Likewise, and tells how long the stages of the world's update take.
    void stepTimed(const StepInput& input, StageTimes& times);
    /// To be looked at in the middle of an update: the first `iterations` of it, in their share of its time. All of
    /// them are a step.
    void stepPartly(const StepInput& input, int iterations);
    /// What is seen while the next update, with this level, is waited for: removed objects are gone from the pictures,
    /// but still in the world.
    void adopt(const std::shared_ptr<const Level>& level);

    Phase phase() const { return m_phase; }
    /// How it would have ended if this were its end.
    FlightResult flight() const;
    Hud hud() const;
    /// What ended this attempt; none unless it was lost.
    const std::optional<Loss>& loss() const { return m_loss; }
    /// s since the first press of this attempt; stands still when it is over.
    double time() const { return static_cast<double>(m_flown) * updateSeconds(); }
    /// s of thrust in this attempt; stands still when it is over.
    double fuel() const { return static_cast<double>(m_thrusted) * updateSeconds(); }
    int lives() const { return m_lives; } // attempts left, this one included
    std::int64_t updates() const { return m_update; }
    /// Simulated by one step, s.
    double updateSeconds() const { return m_world.parameters().seconds; }
    const Level& level() const { return *m_level; }
    const std::shared_ptr<const Level>& sharedLevel() const { return m_level; }
    const World& world() const { return m_world; }
    const Camera& camera() const { return m_camera; }
    PayloadState payloadState() const { return m_payloadState; }
    /// None while there is no such body in the world.
    std::optional<BodyState> ship() const;
    std::optional<BodyState> payload() const;
    bool payloadInRange() const;
    /// Of an object of the level, ship, payload and finish included; none while it is not in the world.
    std::optional<BodyId> bodyOf(Key object) const;
    std::optional<ConnectorId> connectorOf(Key object) const;
    /// 0 for what is of no object: debris, the rope.
    Key keyOf(BodyId body) const;
    Key keyOf(ConnectorId connector) const;
    std::optional<BodyId> shipBody() const { return m_ship ? std::optional(m_ship) : std::nullopt; }
    std::optional<BodyId> payloadBody() const { return m_payload ? std::optional(m_payload) : std::nullopt; }
    std::optional<ConnectorId> rope() const;
    /// Of the last update.
    const std::optional<GrabForce>& grabForce() const { return m_grabForce; }

    /// A picture of the state now, with the sounds of the last step.
    std::shared_ptr<const Snapshot> snapshot() const;
    /// Of the state: with one level, equal hashes mean equal futures. `levelHash` tells whether levels' rules differ.
    std::uint64_t hash() const;
    /// Memory that a copy takes, about.
    std::size_t copyBytes() const;
    /// Whether worlds note what contacts give (World::setRecordsImpulses), and meetings of what masks keep apart are
    /// looked for, from the next step on. Decides nothing.
    void setExplains(bool explains) { m_explains = explains; }
    /// Since the first step; meetings while that was wanted.
    const TagTouches& tagTouches() const { return m_touches; }

  private:
    struct Actor {
        BodyId body;
        std::shared_ptr<const BodyLook> look;
    };
    struct FlyingDebris {
        DebrisPiece piece;
        BodyId body;
    };
    struct Verdict;
    struct Adoption; // of an edited level
    template <class Id>
    using Table = std::shared_ptr<const std::vector<std::pair<Key, Id>>>; // sorted by key

    void begin();
    void buildStart();
    void indexBodies();
    void beginAttempt();
    void beginLevel();
    void obey(const Controls& fresh);
    void attachRope();
    void letGoOfRope();
    struct StepManner {
        std::optional<int> iterations; // the first of the update only
        StageTimes* times = nullptr;
    };
    void stepWith(const StepInput& input, const StepManner& manner);
    void updateWorld(const StepManner& manner);
    Verdict verdict() const;
    Loss lossOf(const Verdict& verdict) const;
    void judge();
    void loseAttempt();
    void win();
    void destroyShip();
    void destroyPayload();
    void breakRope();
    void scatter(const BodyState& source, int least);
    void addDebris(FlyingDebris& debris);
    void ageDebris();
    void moveCamera();
    void noteFlight();
    void appendPictures(BodyKind kind, BodyPictures& pictures) const;
    void listStatics();

    BodyId addActor(const BodyDef& def, BodyRole role, Key key);
    BodyId addActor(const std::optional<StartBody>& start, BodyRole role);
    void removeActor(BodyId& body);
    bool isPlaying() const { return m_phase == Phase::Flying || m_phase == Phase::Towing; }
    void hear(Sound sound) { m_sounds |= static_cast<std::uint32_t>(sound); }

    std::shared_ptr<const Level> m_level;
    // The level's own bodies and the finish, before the first update; null once the level has been edited, until it is
    // needed.
    std::shared_ptr<const World> m_start;
    Table<ConnectorId> m_startConnectors; // of m_start
    World m_world;
    std::vector<Actor> m_actors; // in order of creation; the first m_startActors are those of m_start
    std::size_t m_startActors = 0;
    std::shared_ptr<const BodyPictures> m_statics; // of the actors
    Table<BodyId> m_bodies;                        // of objects; some may no longer be in the world
    Table<ConnectorId> m_connectors;
    std::vector<FlyingDebris> m_debris;
    std::uint64_t m_lastLook = 0;
    Random m_random;

    Phase m_phase = Phase::Sandbox;
    PayloadState m_payloadState = PayloadState::Absent;
    BodyId m_ship, m_payload;
    ConnectorId m_rope;
    Controls m_controls;
    int m_lives = 0;
    bool m_rested = false;       // no key was held since this phase began
    std::int64_t m_flown = 0;    // updates of this attempt
    std::int64_t m_thrusted = 0; // updates of this attempt
    double m_flippedFor = -1;    // s
    std::optional<Loss> m_loss;  // of this attempt
    std::int64_t m_update = 0;
    struct FlightNote {
        bool won = false, lost = false; // ever
        std::optional<Vec2> place{};
        std::int64_t update = 0;
    };
    FlightNote m_note;
    std::uint32_t m_sounds = 0;
    bool m_explains = false;
    TagTouches m_touches;
    std::optional<GrabForce> m_grabForce;
    Camera m_camera;
    Vec2 m_shipSeen{0, 0}, m_payloadSeen{0, 0}; // where they are or were last
};

} // namespace spacetow
