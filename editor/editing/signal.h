#pragma once
// A list of listeners, for the part of the editor that knows no toolkit. One thread only.

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace spacetow {

template <class... Arguments>
class Signal {
  public:
    using Listener = std::function<void(Arguments...)>;

    /// Listeners are called in the order in which they were connected, for as long as the signal lives; a listener
    /// must outlive the signal or be disconnected with the number returned here.
    int connect(Listener listener) {
        m_listeners.emplace_back(++m_last, std::move(listener));
        return m_last;
    }
    void disconnect(int number) {
        std::erase_if(m_listeners, [number](const auto& entry) { return entry.first == number; });
    }
    void emit(Arguments... arguments) const {
        for (const auto& [number, listener] : std::vector(m_listeners)) {
            listener(arguments...);
        }
    }

  private:
    std::vector<std::pair<int, Listener>> m_listeners;
    int m_last = 0;
};

} // namespace spacetow
