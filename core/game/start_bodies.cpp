#include "core/game/start_bodies.h"

#include "core/game/payload.h"
#include "core/game/ship.h"

namespace spacetow {

std::optional<StartBody> startOfShip(const Level& level) {
    const Object* object = firstOf<ShipObject>(level);
    if (object == nullptr) {
        return {};
    }
    const auto& data = std::get<ShipObject>(object->data);
    BodyDef def = shipBody(data.position, data.angle, level.rules);
    def.positionFrozen = def.rotationFrozen = true;
    return StartBody{object->key, std::move(def)};
}

std::optional<StartBody> startOfPayload(const Level& level) {
    const Object* object = firstOf<PayloadObject>(level);
    return object == nullptr
               ? std::nullopt
               : std::optional(StartBody{object->key, payloadBody(std::get<PayloadObject>(object->data))});
}

std::optional<StartBody> startOfFinish(const Level& level) {
    const Object* object = firstOf<FinishObject>(level);
    return object == nullptr ? std::nullopt
                             : std::optional(StartBody{object->key, finishBody(std::get<FinishObject>(object->data))});
}

} // namespace spacetow
