#pragma once
// Hands the newest value from one thread to another. A post replaces what was not collected yet; the lock is held
// for the swap of a pointer only, never while either side works with the value.

#include <memory>
#include <mutex>
#include <utility>

namespace spacetow {

template <class T>
class Mailbox {
  public:
    void post(std::shared_ptr<const T> value) {
        const std::lock_guard lock(m_mutex);
        m_value.swap(value);
    }
    /// The newest value posted, or null before the first. It stays in the box.
    std::shared_ptr<const T> latest() const {
        const std::lock_guard lock(m_mutex);
        return m_value;
    }

  private:
    mutable std::mutex m_mutex;
    std::shared_ptr<const T> m_value;
};

} // namespace spacetow
