#pragma once
// How far the searches of a test go: ./dev test --full makes them denser and longer, never different in kind.

#include <cstdlib>

namespace spacetow::test {

/// Sanitizers make what takes minutes take hours, so they always see the quick searches.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif
#else
constexpr bool isSanitized = false;
#endif

inline bool isFullRun() {
    return !isSanitized && std::getenv("SPACETOW_FULL") != nullptr;
}

/// The first figure in a full run, the second in a quick one.
template <class Number>
Number fullOrQuick(Number full, Number quick) {
    return isFullRun() ? full : quick;
}

} // namespace spacetow::test
