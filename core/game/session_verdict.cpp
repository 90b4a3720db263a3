// What an update means for the game: who is lost by it, and whether the payload is home.

#include "core/game/rules.h"
#include "core/game/session.h"

#include <algorithm>
#include <limits>

namespace spacetow {

/// In which iteration of the update each thing happened first; `never` when it did not.
struct Session::Verdict {
    static constexpr int never = std::numeric_limits<int>::max();

    int shipHit = never;     // something fatal to the ship
    int payloadHit = never;  // a wall
    int payloadHome = never; // the finish
    bool payloadTouchedByShip = false;
};

Session::Verdict Session::verdict() const {
    Verdict verdict;
    const auto earlier = [](int& first, int iteration) { first = std::min(first, iteration); };
    for (const TagsTouchedEvent& touched : m_world.events().tagsTouched) {
        if (touched.body == m_ship && touched.tags.intersects(rules::fatalToShip)) {
            earlier(verdict.shipHit, touched.iteration);
        }
        if (touched.body == m_payload) {
            if (touched.tags.intersects(rules::finish)) {
                earlier(verdict.payloadHome, touched.iteration);
            }
            if (touched.tags.intersects(rules::fatalToPayload)) {
                earlier(verdict.payloadHit, touched.iteration);
            }
            verdict.payloadTouchedByShip |= touched.tags.intersects(rules::ship);
        }
    }
    // What was switched off because it left the finite numbers is as lost as what hit a wall.
    for (const FaultEvent& fault : m_world.events().faults) {
        if (fault.body == m_ship) {
            earlier(verdict.shipHit, fault.iteration);
        }
        if (fault.body == m_payload) {
            earlier(verdict.payloadHit, fault.iteration);
        }
    }
    return verdict;
}

/// Before they are taken out of the world.
Loss Session::lossOf(const Verdict& verdict) const {
    Loss loss{.ship = verdict.shipHit != Verdict::never, .payload = verdict.payloadHit != Verdict::never};
    loss.who = verdict.payloadHit < verdict.shipHit ? BodyRole::Payload : BodyRole::Ship;
    const bool isShip = loss.who == BodyRole::Ship;
    const BodyId body = isShip ? m_ship : m_payload;
    const int iteration = std::min(verdict.shipHit, verdict.payloadHit);
    const TagMask fatal = isShip ? rules::fatalToShip : rules::fatalToPayload;
    for (const TagsTouchedEvent& touched : m_world.events().tagsTouched) {
        loss.tags |= touched.body == body && touched.iteration == iteration ? touched.tags.bits & fatal.bits : 0;
    }
    for (const TouchEvent& touch : m_world.events().began) {
        const BodyId other = touch.a == body ? touch.b : touch.a;
        const bool isOfIt = touch.iteration <= iteration && (touch.a == body || touch.b == body);
        if (isOfIt && m_world.contains(other) && m_world.body(other).filter.tags.intersects(fatal)) {
            loss.what = keyOf(other);
            loss.whom = other == m_payload ? BodyRole::Payload : other == m_ship ? BodyRole::Ship : BodyRole::Object;
        }
    }
    return loss;
}

void Session::judge() {
    if (m_phase == Phase::Sandbox || m_phase == Phase::AwaitingInput || m_phase == Phase::Won) {
        return;
    }
    Verdict now = verdict();
    if (m_payloadState == PayloadState::Waiting && now.payloadTouchedByShip) {
        m_world.setFrozen(m_payload, false);
        m_payloadState = PayloadState::Dropped;
        now.payloadHit = Verdict::never; // it may have rested on a wall until now
    }
    if (m_payloadState == PayloadState::Waiting) {
        now.payloadHit = Verdict::never;
    }
    // The finish comes before a wall in the same iteration, the loss of the ship before either.
    const bool home = m_phase == Phase::Towing && now.payloadHome != Verdict::never &&
                      now.payloadHome <= now.payloadHit && now.payloadHome < now.shipHit;
    if (home) {
        win();
        return;
    }
    if (now.shipHit == Verdict::never && now.payloadHit == Verdict::never) {
        return;
    }
    const bool wasPlaying = isPlaying();
    const Loss loss = lossOf(now);
    if (now.shipHit != Verdict::never) {
        destroyShip();
    }
    if (now.payloadHit != Verdict::never) {
        destroyPayload();
    }
    if (wasPlaying) {
        loseAttempt();
        m_loss = loss;
    }
}

} // namespace spacetow
