#include "core/physics/lanes/batch_plan.h"

#include <algorithm>

namespace spacetow {

namespace {

// A body is in at most every second batch, so that a batch need not wait for the results of the one before.
constexpr std::uint32_t pause = 2;

} // namespace

void BatchPlan::reset(std::size_t bodies) {
    constexpr std::uint32_t most = 1U << 30;
    m_before += static_cast<std::uint32_t>(m_filled.size()) + pause;
    if (m_free.size() != bodies || m_before > most) {
        m_free.assign(bodies, 0);
        m_before = 0;
    }
    m_next.clear();
    m_filled.clear();
}

void BatchPlan::reserve(const BatchPlan& other) {
    m_free.reserve(other.m_free.capacity());
    m_next.reserve(other.m_next.capacity());
    m_filled.reserve(other.m_filled.capacity());
}

std::uint32_t BatchPlan::firstWithRoom(std::uint32_t from) {
    while (from < m_next.size() && m_next[from] != from) {
        const std::uint32_t next = m_next[from];
        if (next < m_next.size()) {
            m_next[from] = m_next[next];
        }
        from = next;
    }
    return from;
}

std::uint32_t BatchPlan::place(Slot a, bool movableA, Slot b, bool movableB) {
    const std::uint32_t earliest = std::max(movableA ? freeFrom(a) : 0, movableB ? freeFrom(b) : 0);
    const std::uint32_t batch = firstWithRoom(earliest);
    while (batch >= m_filled.size()) {
        m_next.push_back(static_cast<std::uint32_t>(m_filled.size()));
        m_filled.push_back(0);
    }
    if (++m_filled[batch] == 4) {
        m_next[batch] = batch + 1;
    }
    m_free[a] = m_free[b] = m_before + batch + pause;
    return batch;
}

void BatchPlan::release(std::uint32_t batch) {
    --m_filled[batch];
    m_next[batch] = batch;
}

} // namespace spacetow
