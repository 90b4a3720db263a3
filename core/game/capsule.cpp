#include "core/game/capsule.h"

#include "core/game/crowd.h"

namespace spacetow {

bool Capsule::operator==(const Capsule& other) const {
    return program == other.program && platform == other.platform && *level == *other.level && run == other.run &&
           hash == other.hash;
}

Session sessionOf(const Capsule& capsule, const std::stop_token& stop) {
    Session session(*capsule.level, capsule.run.seed);
    for (InputReader inputs(inputsOf(capsule.run, *capsule.level));
         !inputs.isAtEnd() && !stop.stop_requested() && !isCrowdedAt(session.updates(), session.world());) {
        session.step(inputs.next());
    }
    return session;
}

} // namespace spacetow
