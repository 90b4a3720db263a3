#pragma once
// Waits for what another thread does.

#include <chrono>
#include <thread>

namespace spacetow::test {

/// Lets others work until the condition holds; false after two minutes.
template <class Condition>
bool comesTrue(Condition condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > deadline) {
            return false;
        }
        std::this_thread::yield();
    }
    return true;
}

} // namespace spacetow::test
