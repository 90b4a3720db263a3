#pragma once
// Wall-clock time of a piece of work, in milliseconds.

#include <chrono>

namespace spacetow::bench {

template <class Work>
double milliseconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

} // namespace spacetow::bench
