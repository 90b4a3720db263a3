#include "core/level/key_index.h"

#include <algorithm>

namespace spacetow {

namespace {

constexpr auto keyOf = [](const auto& entry) { return entry.first; };

} // namespace

KeyIndex::KeyIndex(const ObjectList& objects) {
    m_entries.reserve(static_cast<std::size_t>(objects.size()));
    for (const Object& object : objects) {
        m_entries.emplace_back(object.key, &object);
    }
    std::ranges::stable_sort(m_entries, {}, keyOf);
}

const Object* KeyIndex::find(Key key) const {
    const auto found = std::ranges::lower_bound(m_entries, key, {}, keyOf);
    return found != m_entries.end() && found->first == key ? found->second : nullptr;
}

} // namespace spacetow
