#pragma once
// How long work in another thread is followed and ended from outside.

#include <atomic>
#include <stop_token>

namespace spacetow {

struct Watch {
    std::stop_token stop = {};
    std::atomic<int>* percent = nullptr; // of the work that is done

    bool isStopped() const { return stop.stop_requested(); }
    void tell(int done) const {
        if (percent != nullptr) {
            percent->store(done, std::memory_order_relaxed);
        }
    }
};

} // namespace spacetow
