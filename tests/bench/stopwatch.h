#pragma once
// The time of a piece of work, in milliseconds, and the quantiles of many such times.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <vector>

namespace spacetow::bench {

/// By the clock on the wall.
template <class Work>
double milliseconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Of the processor, by this thread: what other programs do in between does not count.
template <class Work>
double processorMilliseconds(Work&& work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

/// The time that the given share (0 … 1) of all does not exceed; there must be one.
inline double quantile(std::vector<double> times, double share) {
    std::sort(times.begin(), times.end());
    return times[static_cast<std::size_t>(std::lround(share * static_cast<double>(times.size() - 1)))];
}

} // namespace spacetow::bench
