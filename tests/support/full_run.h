#pragma once
// How far the searches of a test go: ./dev test --full makes them denser and longer, never different in kind;
// under sanitizers, which take ten times as long, there are the quick ones then, and thinner ones otherwise.

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

/// In a quick run under sanitizers. They look for faults of memory, for which fewer scenes of the same kinds will do;
/// whether the bars hold everywhere is for the dev build to say.
inline bool isThinRun() {
    return isSanitized && std::getenv("SPACETOW_FULL") == nullptr;
}

/// The first figure, or the second in a thin run.
template <class Number>
Number usualOrThin(Number usual, Number thin) {
    return isThinRun() ? thin : usual;
}

} // namespace spacetow::test
