#include "core/game/reach.h"

#include "core/base/contract.h"
#include "core/game/crowd.h"
#include "core/game/ship.h"
#include "core/math/trig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace spacetow {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t directions = 64;
constexpr double sector = 2 * pi / static_cast<double>(directions); // rad

/// What a constant acceleration and a damping make of a motion in some time: v' = v·keep + a·gain, and
/// x' = x + v·gain + a·way.
struct Decay {
    double keep, gain, way;

    Decay(double damping, double time) {
        const double spent = damping * time;
        if (spent < 1e-6) { // series; what is left out is below rounding
            keep = 1 - spent;
            gain = time * (1 - spent / 2);
            way = time * time * (0.5 - spent / 6);
            return;
        }
        keep = expExact(-spent);
        gain = (1 - keep) / damping;
        way = (time - gain) / damping;
    }
};

struct AngleRange {
    double least, most; // rad

    /// The greatest cosine of the angle from anywhere in the range to the direction.
    double towards(double direction) const {
        const double half = (most - least) / 2;
        const double off = std::abs(std::remainder(direction - (least + half), 2 * pi));
        return off <= half ? 1 : sinCos(off - half).cos;
    }
};

/// The angles that an angle with a velocity can have come to after each update, driven either way.
class Turning {
  public:
    Turning(double angle, double velocity, double damping, double seconds)
        : m_step(damping, seconds), m_least{angle, velocity}, m_most{angle, velocity} {}

    AngleRange range() const { return {m_least.angle, m_most.angle}; }
    void advance(double acceleration) {
        advance(m_least, -acceleration);
        advance(m_most, acceleration);
    }

  private:
    struct One {
        double angle, velocity;
    };
    void advance(One& one, double acceleration) const {
        one.angle += one.velocity * m_step.gain + acceleration * m_step.way;
        one.velocity = one.velocity * m_step.keep + acceleration * m_step.gain;
    }

    Decay m_step;
    One m_least, m_most;
};

/// The ship, or ship and payload at their centre of mass.
struct Flyer {
    Vec2 position{0, 0}, velocity{0, 0};
    double mass = 1;
    double damping = 0;       // 1/s
    double slip = 0;          // m/s²: what the two dampings may add, whatever their direction
    Vec2 rope{0, 0};          // from ship to payload
    double ropeShare = 0;     // of it from the centre of mass to the ship; 0 without one
    double ropeSpin = 0;      // rad/s
    double ropeDrive = 0;     // rad/s²
    double ropeSlack = 0;     // m that it may be longer or elsewhere
    double extraSteering = 0; // rad/s² of the ship by the rope's pull
};

Flyer flyerOf(const Session& session, double longest) {
    const Rules& rules = session.level().rules;
    const BodyState ship = *session.ship();
    Flyer flyer{ship.massCenter, ship.velocity, ship.mass, rules.shipLinearDamping};
    const Object* const object = firstOf<PayloadObject>(session.level());
    const std::optional<BodyState> payload = session.payload();
    if (session.phase() != Phase::Towing || !payload || object == nullptr) {
        return flyer;
    }
    const double damping = std::get<PayloadObject>(object->data).linearDamping;
    const double mass = ship.mass + payload->mass;
    const double share = payload->mass / mass;
    const Vec2 relative = payload->velocity - ship.velocity;
    flyer.position = (1 - share) * ship.massCenter + share * payload->massCenter;
    flyer.velocity = (1 - share) * ship.velocity + share * payload->velocity;
    flyer.damping = (1 - share) * rules.shipLinearDamping + share * damping;
    flyer.mass = mass;
    flyer.rope = payload->massCenter - ship.massCenter;
    flyer.ropeShare = share;
    const double lever = shipNotch().norm();
    const double length = std::max(flyer.rope.norm() - lever, 1e-3); // m
    const double push = rules.thrust / ship.mass;
    const double fastest = relative.norm() + push * longest; // m/s, of the two against each other
    flyer.slip = std::abs(damping - rules.shipLinearDamping) * share * (1 - share) * fastest;
    const double pull = share * ship.mass * (push + fastest * fastest / length); // N
    flyer.extraSteering = pull * lever / ship.inertia;
    flyer.ropeSlack = 2 * lever + pull / std::max(rules.rope.stiffness, 1.0);
    flyer.ropeSpin = cross(flyer.rope, relative) / flyer.rope.squaredNorm();
    flyer.ropeDrive = (push + std::abs(damping - rules.shipLinearDamping) * fastest) / length;
    return flyer;
}

/// How far the flyer can come in each direction, update for update.
class Fan {
  public:
    Fan(const Session& session, double longest)
        : m_flyer(flyerOf(session, longest)), m_gravity(session.world().parameters().gravity),
          m_step(m_flyer.damping, session.updateSeconds()), m_push(session.level().rules.thrust / m_flyer.mass),
          m_steering(session.level().rules.steering),
          m_ship(session.ship()->angle + pi / 2, session.ship()->angularVelocity,
                 session.level().rules.shipAngularDamping, session.updateSeconds()),
          m_rope(arcTangent(m_flyer.rope.y(), m_flyer.rope.x()), m_flyer.ropeSpin, 0, session.updateSeconds()),
          m_waits(session.phase() == Phase::AwaitingInput) {
        for (std::size_t i = 0; i < directions; ++i) {
            m_angle[i] = sector * static_cast<double>(i);
            const SinCos turn = sinCos(m_angle[i]);
            m_normal[i] = Vec2(turn.cos, turn.sin);
        }
        m_speed.fill(0);
        m_way.fill(0);
        note();
    }

    void advance() {
        m_ship.advance(m_steering + m_flyer.extraSteering);
        m_rope.advance(m_flyer.ropeDrive);
        m_free += m_freeSpeed * m_step.gain + m_gravity * m_step.way;
        m_freeSpeed = m_freeSpeed * m_step.keep + m_gravity * m_step.gain;
        const AngleRange nose = m_ship.range();
        const AngleRange before = m_lastNose;
        const AngleRange both{std::min(nose.least, before.least), std::max(nose.most, before.most)};
        m_lastNose = nose;
        for (std::size_t i = 0; i < directions; ++i) {
            const double push = std::max(0.0, m_push * both.towards(m_angle[i])) + m_flyer.slip;
            m_way[i] += m_speed[i] * m_step.gain + push * m_step.way;
            m_speed[i] = m_speed[i] * m_step.keep + push * m_step.gain;
        }
        note();
    }

    ReachOutline outline(double seconds) const {
        return {seconds, hullOf(m_farShip), m_flyer.ropeShare > 0 ? hullOf(m_farPayload) : std::vector<Vec2>()};
    }

  private:
    using Figures = std::array<double, directions>;

    /// Who may still wait may begin the way at any time, and so be anywhere that was reached before.
    void note() {
        const AngleRange rope = m_rope.range();
        const double length = m_flyer.rope.norm();
        for (std::size_t i = 0; i < directions; ++i) {
            const double centre = m_normal[i].dot(m_free) + m_way[i];
            double ship = centre, payload = centre;
            if (m_flyer.ropeShare > 0) {
                const double along = rope.towards(m_angle[i]) * length + m_flyer.ropeSlack;
                const double against = rope.towards(m_angle[i] + pi) * length + m_flyer.ropeSlack;
                ship += m_flyer.ropeShare * against;
                payload += (1 - m_flyer.ropeShare) * along;
            }
            m_farShip[i] = m_waits && m_noted ? std::max(m_farShip[i], ship) : ship;
            m_farPayload[i] = payload;
        }
        m_noted = true;
    }

    /// Corners where the half planes of neighbouring directions meet.
    std::vector<Vec2> hullOf(const Figures& far) const {
        std::vector<Vec2> corners;
        const double sine = sinCos(sector).sin;
        for (std::size_t i = 0; i < directions; ++i) {
            const std::size_t next = (i + 1) % directions;
            const Vec2 a = m_normal[i], b = m_normal[next];
            const Vec2 corner((far[i] * b.y() - far[next] * a.y()) / sine, (far[next] * a.x() - far[i] * b.x()) / sine);
            corners.emplace_back(m_flyer.position + corner);
        }
        return corners;
    }

    Flyer m_flyer;
    Vec2 m_gravity;
    Decay m_step;
    double m_push, m_steering;
    Turning m_ship, m_rope;
    bool m_waits;
    bool m_noted = false;
    AngleRange m_lastNose = m_ship.range();
    Vec2 m_free{0, 0}, m_freeSpeed = m_flyer.velocity; // from now, without thrust
    Figures m_angle{}, m_speed{}, m_way{}, m_farShip{}, m_farPayload{};
    std::array<Vec2, directions> m_normal{};
};

bool isSteered(Phase phase) {
    return phase == Phase::AwaitingInput || phase == Phase::Flying || phase == Phase::Towing;
}

} // namespace

std::vector<ReachOutline> reachOutlines(const Session& session, const std::vector<double>& seconds) {
    std::vector<ReachOutline> outlines;
    if (!session.ship() || !isSteered(session.phase()) || seconds.empty()) {
        return outlines;
    }
    const double step = session.updateSeconds();
    Fan fan(session, seconds.back());
    double now = 0;
    for (const double time : seconds) {
        EXPECTS(time > 0);
        for (; now + step / 2 < time; now += step) {
            fan.advance();
        }
        outlines.push_back(fan.outline(time));
    }
    return outlines;
}

HeldPath heldPath(const Session& session, const Controls& held, double seconds, const std::stop_token& stop) {
    HeldPath path;
    if (!session.ship() || !isSteered(session.phase())) {
        return path;
    }
    Session copy = session;
    const double step = copy.updateSeconds();
    const auto note = [&] {
        path.ship.push_back(copy.ship()->massCenter);
        if (copy.phase() == Phase::Towing && copy.payload()) {
            path.payload.push_back(copy.payload()->massCenter);
        }
    };
    note();
    for (double now = 0; now + step / 2 < seconds && !stop.stop_requested(); now += step) {
        if (isCrowdedAt(copy.updates() - session.updates(), copy.world())) {
            path.ends = true;
            break;
        }
        copy.step(held);
        if (!copy.ship() || !isSteered(copy.phase())) {
            path.ends = true;
            break;
        }
        note();
    }
    return path;
}

} // namespace spacetow
