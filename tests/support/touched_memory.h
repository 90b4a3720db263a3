#pragma once
// How much memory a piece of work reads or writes: a count of what it touches that no other load changes.

#include <cstddef>
#include <fstream>
#include <optional>
#include <string>
#include <sys/prctl.h>

namespace spacetow::test {

/// Pages of the process that have been touched since forgetTouchedMemory(), in bytes.
inline std::size_t touchedMemory() {
    std::ifstream maps("/proc/self/smaps");
    std::size_t kilobytes = 0;
    for (std::string word; maps >> word;) {
        if (std::size_t here = 0; word == "Referenced:" && maps >> here) {
            kilobytes += here;
        }
    }
    return 1024 * kilobytes;
}

/// False where the system does not count.
inline bool forgetTouchedMemory() {
    std::ofstream clear("/proc/self/clear_refs");
    return static_cast<bool>(clear << "1" << std::flush);
}

/// What `work` touches beside what counting itself does; nothing where the system does not count.
template <class Work>
std::optional<std::size_t> touchedBy(const Work& work) {
    prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0); // a large page counts whole
    if (!forgetTouchedMemory()) {
        return std::nullopt;
    }
    const std::size_t before = touchedMemory();
    forgetTouchedMemory();
    work();
    const std::size_t after = touchedMemory();
    return after > before ? after - before : 0;
}

} // namespace spacetow::test
