#include "core/level/level.h"

#include "core/base/random.h"

#include <algorithm>

namespace spacetow {

std::array<Vec2, 4> shipOutline() {
    return {Vec2(0, 0.7 / 3), Vec2(-0.2, -0.5 / 3), Vec2(0, -0.2 / 3), Vec2(0.2, -0.5 / 3)};
}

int ObjectList::indexOf(Key key) const {
    const auto found = std::ranges::find_if(m_items, [key](const auto& item) { return item->key == key; });
    return found == m_items.end() ? -1 : static_cast<int>(found - m_items.begin());
}

const Object* ObjectList::find(Key key) const {
    const int index = indexOf(key);
    return index < 0 ? nullptr : m_items[static_cast<std::size_t>(index)].get();
}

void ObjectList::insert(int index, Object object) {
    EXPECTS(index >= 0 && index <= size());
    m_items.insert(m_items.begin() + index, std::make_shared<const Object>(std::move(object)));
}

void ObjectList::replace(int index, Object object) {
    EXPECTS(index >= 0 && index < size());
    m_items[static_cast<std::size_t>(index)] = std::make_shared<const Object>(std::move(object));
}

void ObjectList::erase(int index) {
    EXPECTS(index >= 0 && index < size());
    m_items.erase(m_items.begin() + index);
}

void ObjectList::move(int from, int to) {
    EXPECTS(from >= 0 && from < size() && to >= 0 && to < size());
    const auto first = m_items.begin();
    if (from < to) {
        std::rotate(first + from, first + from + 1, first + to + 1);
    } else {
        std::rotate(first + to, first + from, first + from + 1);
    }
}

bool ObjectList::operator==(const ObjectList& other) const {
    return std::ranges::equal(m_items, other.m_items, [](const auto& a, const auto& b) { return a == b || *a == *b; });
}

Key freshKey(const Level& level, std::uint64_t seed) {
    Random random(seed);
    for (;;) {
        const Key key = random.next();
        if (key != 0 && level.objects.find(key) == nullptr) {
            return key;
        }
    }
}

} // namespace spacetow
