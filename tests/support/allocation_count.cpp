#include "tests/support/allocation_count.h"

#include <cstdlib>
#include <new>

namespace {

thread_local std::uint64_t count = 0;
thread_local std::uint64_t bytes = 0;

void* allocated(std::size_t size) noexcept {
    ++count;
    bytes += size;
    return std::malloc(size > 0 ? size : 1);
}

void* allocated(std::size_t size, std::align_val_t alignment) noexcept {
    ++count;
    bytes += size;
    const auto unit = static_cast<std::size_t>(alignment);
    return std::aligned_alloc(unit, size > 0 ? (size + unit - 1) / unit * unit : unit);
}

void* orThrow(void* memory) {
    return memory != nullptr ? memory : throw std::bad_alloc();
}

} // namespace

namespace spacetow::test {

std::uint64_t allocationCount() {
    return count;
}

std::uint64_t allocatedBytes() {
    return bytes;
}

} // namespace spacetow::test

// All forms, because a sanitizer replaces each by one of its own, whose memory must not meet the free() of these.
void* operator new(std::size_t size) {
    return orThrow(allocated(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return orThrow(allocated(size, alignment));
}
void* operator new(std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
    return allocated(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t& /*unused*/) noexcept {
    return allocated(size, alignment);
}
void* operator new[](std::size_t size) {
    return orThrow(allocated(size));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return orThrow(allocated(size, alignment));
}
void* operator new[](std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
    return allocated(size);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t& /*unused*/) noexcept {
    return allocated(size, alignment);
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t& /*unused*/) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t /*alignment*/, const std::nothrow_t& /*unused*/) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t /*size*/) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t /*size*/, std::align_val_t /*alignment*/) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, const std::nothrow_t& /*unused*/) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t /*alignment*/, const std::nothrow_t& /*unused*/) noexcept {
    std::free(memory);
}
