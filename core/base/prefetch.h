#pragma once
// Tells the processor what will be read soon.

#include <cstddef>

// Forced: GCC takes a function that only fetches for one without effect, and leaves out the calls of it.
#define SPACETOW_PREFETCHES inline __attribute__((always_inline))

namespace spacetow {

template <class T>
SPACETOW_PREFETCHES void prefetch(const T& what) {
    const auto* address = reinterpret_cast<const char*>(&what);
    for (std::size_t line = 0; line < sizeof(T); line += 64) {
        __builtin_prefetch(address + line);
    }
}

} // namespace spacetow
