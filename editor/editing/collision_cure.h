#pragma once
// What would have to be changed in a level for two of its objects to collide that do not.

#include "core/level/level.h"
#include "core/physics/query/why_apart.h"

#include <optional>

namespace spacetow {

/// Two objects and why they do not collide.
struct ApartObjects {
    Key a = 0, b = 0;
    bool isAboutB = false; // the body of the answer is that of b
    Key connector = 0;     // the first that keeps them apart; 0 for one that is no object
    CollisionAnswer answer;
};

struct CollisionCure {
    enum class Kind : std::uint8_t {
        TickTag,    // `object` comes to touch `tag`
        GiveTag,    // `object` becomes `tag`
        MakeSolid,  // `object` becomes tangible
        LetCollide, // the bodies of the connector `object` may collide
    };
    Kind kind = Kind::TickTag;
    Key object = 0;
    int tag = 0;
};

/// The least change that helps; nothing where no edit of one field would, as with what the rules of the game decide.
std::optional<CollisionCure> cureOf(const Level& level, const ApartObjects& apart);
Level cured(Level level, const CollisionCure& cure);

} // namespace spacetow
