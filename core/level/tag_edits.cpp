#include "core/level/tag_edits.h"

#include "core/level/tag_spelling.h"

namespace spacetow {

namespace {

TagMask with(TagMask mask, int tag, bool on) {
    const std::uint32_t bit = TagMask::bit(tag).bits;
    return {on ? mask.bits | bit : mask.bits & ~bit};
}

} // namespace

Level withTagsMeeting(Level level, int a, int b, bool meet) {
    for (int i = 0; i < level.objects.size(); ++i) {
        const auto* body = std::get_if<BodyObject>(&level.objects[i].data);
        if (body == nullptr) {
            continue;
        }
        TagMask touches = body->filter.touches;
        touches = body->filter.tags.contains(a) ? with(touches, b, meet) : touches;
        touches = body->filter.tags.contains(b) ? with(touches, a, meet) : touches;
        if (!(touches == body->filter.touches)) {
            Object object = level.objects[i];
            std::get<BodyObject>(object.data).filter.touches = touches;
            level.objects.replace(i, std::move(object));
        }
    }
    return level;
}

TagMask tagsInUse(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    if (body == nullptr) {
        return {};
    }
    const TagMask touches = body->filter.touches;
    return body->filter.tags | (isSpelledByExceptions(touches) ? TagMask{~touches.bits} : touches);
}

TagMask tagsInUse(const Level& level) {
    TagMask used;
    for (const Object& object : level.objects) {
        used = used | tagsInUse(object);
    }
    return used;
}

} // namespace spacetow
