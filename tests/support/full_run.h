#pragma once
// How far the searches of a test go: ./dev test --full makes them denser and longer, never different in kind.

#include <cstdlib>

namespace spacetow::test {

inline bool isFullRun() {
    return std::getenv("SPACETOW_FULL") != nullptr;
}

/// The first figure in a full run, the second in a quick one.
template <class Number>
Number fullOrQuick(Number full, Number quick) {
    return isFullRun() ? full : quick;
}

} // namespace spacetow::test
