#include "editor/editing/selection.h"

#include <algorithm>

namespace spacetow {

Selection::Selection(std::vector<Key> keys) : m_keys(std::move(keys)) {
    std::sort(m_keys.begin(), m_keys.end());
    m_keys.erase(std::unique(m_keys.begin(), m_keys.end()), m_keys.end());
}

bool Selection::contains(Key key) const {
    return std::binary_search(m_keys.begin(), m_keys.end(), key);
}

Selection Selection::with(Key key) const {
    Selection result = *this;
    const auto place = std::lower_bound(result.m_keys.begin(), result.m_keys.end(), key);
    if (place == result.m_keys.end() || *place != key) {
        result.m_keys.insert(place, key);
    }
    return result;
}

Selection Selection::without(Key key) const {
    Selection result = *this;
    std::erase(result.m_keys, key);
    return result;
}

Selection Selection::toggled(Key key) const {
    return contains(key) ? without(key) : with(key);
}

Selection Selection::within(const Level& level) const {
    std::vector<Key> kept;
    if (!empty()) {
        for (const Object& object : level.objects) {
            if (contains(object.key)) {
                kept.push_back(object.key);
            }
        }
    }
    return Selection(std::move(kept));
}

} // namespace spacetow
