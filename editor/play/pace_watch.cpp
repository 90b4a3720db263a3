#include "editor/play/pace_watch.h"

#include <algorithm>

namespace spacetow {

/// A moment's hold-up is nothing to speak of.
double PaceWatch::behind(const Reading& reading) {
    constexpr double interval = 1;   // s
    constexpr double bearable = 0.1; // of the time that has passed
    if (!m_last || reading.paused || reading.update < m_last->update) {
        m_last = reading;
        m_behind = 0;
        return 0;
    }
    const double passed = reading.now - m_last->now;
    if (passed < interval) {
        return m_behind;
    }
    const double made = static_cast<double>(reading.update - m_last->update) * reading.period;
    m_last = reading;
    const double missing = std::max(0.0, passed - made);
    const bool fallsBack = missing > bearable * passed;
    m_lost += fallsBack ? missing : 0;
    m_behind = fallsBack ? m_lost : 0;
    return m_behind;
}

} // namespace spacetow
