#include "core/game/capsule.h"

#include <algorithm>

namespace spacetow {

namespace {

bool isSameLevel(const std::shared_ptr<const Level>& a, const std::shared_ptr<const Level>& b) {
    return a == b || (a && b && *a == *b);
}

} // namespace

bool Capsule::operator==(const Capsule& other) const {
    const auto same = [](const StepInput& a, const StepInput& b) {
        return a.controls == b.controls && a.grab == b.grab && isSameLevel(a.level, b.level);
    };
    return program == other.program && platform == other.platform && name == other.name && seed == other.seed &&
           hash == other.hash && isSameLevel(level, other.level) && std::ranges::equal(inputs, other.inputs, same);
}

Session sessionOf(const Capsule& capsule, const std::stop_token& stop) {
    Session session(*capsule.level, capsule.seed);
    for (const StepInput& input : capsule.inputs) {
        if (stop.stop_requested()) {
            break;
        }
        session.step(input);
    }
    return session;
}

} // namespace spacetow
