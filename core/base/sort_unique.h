#pragma once
// Sorts a list and removes repeated elements.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace spacetow {

/// Sorts the elements from index `first` on, and removes repeated ones among them.
template <class T>
void sortUnique(std::vector<T>& list, std::size_t first = 0) {
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, list.end());
    list.erase(std::unique(begin, list.end()), list.end());
}

} // namespace spacetow
