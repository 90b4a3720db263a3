#include "core/game/mark_list.h"

#include <algorithm>

namespace spacetow {

std::span<const TimelineMark> MarkList::all() const {
    return m_storage ? std::span<const TimelineMark>(m_storage->places).subspan(m_first, m_count)
                     : std::span<const TimelineMark>();
}

/// With as much room again.
void MarkList::storeAnew() {
    constexpr std::size_t least = 16;
    const std::span<const TimelineMark> now = all();
    auto storage = std::make_shared<Storage>();
    storage->places.resize(std::max(least, 2 * m_count));
    std::ranges::copy(now, storage->places.begin());
    storage->used = m_count;
    m_storage = std::move(storage);
    m_first = 0;
}

void MarkList::append(const TimelineMark& mark) {
    std::size_t end = m_first + m_count;
    // The place behind is taken where a copy has gone another way.
    if (!m_storage || end == m_storage->places.size() || !m_storage->used.compare_exchange_strong(end, end + 1)) {
        storeAnew();
        m_storage->used = m_count + 1;
    }
    m_storage->places[m_first + m_count] = mark;
    ++m_count;
}

void MarkList::dropBefore(std::int64_t update) {
    const auto kept = std::ranges::lower_bound(all(), update, {}, &TimelineMark::update);
    const auto gone = static_cast<std::size_t>(kept - all().begin());
    m_first += gone;
    m_count -= gone;
}

void MarkList::dropAfter(std::int64_t update) {
    const auto end = std::ranges::upper_bound(all(), update, {}, &TimelineMark::update);
    m_count = static_cast<std::size_t>(end - all().begin());
}

void MarkList::eraseIf(const std::function<bool(const TimelineMark&)>& goes) {
    if (std::ranges::none_of(all(), goes)) {
        return;
    }
    storeAnew(); // others read what there was
    const auto begin = m_storage->places.begin();
    m_count =
        static_cast<std::size_t>(std::remove_if(begin, begin + static_cast<std::ptrdiff_t>(m_count), goes) - begin);
    m_storage->used = m_count;
}

bool MarkList::operator==(const MarkList& other) const {
    const bool isSame = m_storage == other.m_storage && m_first == other.m_first && m_count == other.m_count;
    return isSame || std::ranges::equal(all(), other.all());
}

} // namespace spacetow
