#pragma once
// How often this thread has asked for memory. Only for programs that compile allocation_count.cpp, which replaces the
// operators new and delete; calls of malloc by other libraries are not seen.

#include <cstdint>

namespace spacetow::test {

/// Calls of any operator new by the calling thread since it began.
std::uint64_t allocationCount();

/// What they asked for, of which some may have been given back.
std::uint64_t allocatedBytes();

} // namespace spacetow::test
