#include "editor/editing/collision_cure.h"

#include "core/level/field_edits.h"
#include "editor/editing/collisions.h"

#include <array>
#include <bit>

namespace spacetow {

namespace {

bool isBodyObject(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    return object != nullptr && std::holds_alternative<BodyObject>(object->data);
}

Filter filterIn(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    return object == nullptr ? Filter{} : filterOf(*object).value_or(Filter{});
}

std::optional<int> firstTag(TagMask mask) {
    return mask.bits == 0 ? std::nullopt : std::optional(std::countr_zero(mask.bits));
}

/// `blind` touches nothing that the other is: it may come to, or the other may become what it touches.
std::optional<CollisionCure> cureOfMask(const Level& level, Key blind, Key other) {
    if (const std::optional<int> tag = firstTag(filterIn(level, other).tags); tag && isBodyObject(level, blind)) {
        return CollisionCure{CollisionCure::Kind::TickTag, blind, *tag};
    }
    if (const std::optional<int> tag = firstTag(filterIn(level, blind).touches); tag && isBodyObject(level, other)) {
        return CollisionCure{CollisionCure::Kind::GiveTag, other, *tag};
    }
    return std::nullopt;
}

Level withField(const Level& level, Key key, const char* field, const FieldValue& value) {
    const std::array keys{key};
    return withFieldEdited(level, {keys, {}}, {field, [&value](const FieldValue&) { return value; }}).level;
}

} // namespace

std::optional<CollisionCure> cureOf(const Level& level, const ApartObjects& apart) {
    const Key about = apart.isAboutB ? apart.b : apart.a;
    const Key other = apart.isAboutB ? apart.a : apart.b;
    switch (apart.answer.why) {
    case WhyApart::Mask:
        return cureOfMask(level, about, other);
    case WhyApart::Intangible:
        return isBodyObject(level, about) ? std::optional(CollisionCure{CollisionCure::Kind::MakeSolid, about, 0})
                                          : std::nullopt;
    case WhyApart::Connected:
        return level.objects.find(apart.connector) != nullptr
                   ? std::optional(CollisionCure{CollisionCure::Kind::LetCollide, apart.connector, 0})
                   : std::nullopt;
    default:
        return std::nullopt;
    }
}

Level cured(Level level, const CollisionCure& cure) {
    const Filter filter = filterIn(level, cure.object);
    switch (cure.kind) {
    case CollisionCure::Kind::TickTag:
        return withField(level, cure.object, "touches", filter.touches | TagMask::bit(cure.tag));
    case CollisionCure::Kind::GiveTag:
        return withField(level, cure.object, "tags", filter.tags | TagMask::bit(cure.tag));
    case CollisionCure::Kind::MakeSolid:
        return withField(level, cure.object, "tangible", true);
    case CollisionCure::Kind::LetCollide:
        return withField(level, cure.object, "bodiesCollide", true);
    }
    return level;
}

} // namespace spacetow
