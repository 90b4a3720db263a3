#pragma once
// What happened in a run, in order, as a value. Copies share what is stored, and a mark more goes behind what they know
// of: marking takes as long after hours as at the start, while others read.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace spacetow {

enum class MarkKind : std::uint8_t { Touch, Tow, LetGo, Crash, Attempt, Win, Edit, FocusTouch, FocusPart };

/// Something that happened in the update that led to this number of updates.
struct TimelineMark {
    std::int64_t update = 0;
    MarkKind kind = MarkKind::Touch;

    bool operator==(const TimelineMark&) const = default;
};

class MarkList {
  public:
    std::span<const TimelineMark> all() const;
    bool empty() const { return m_count == 0; }
    std::size_t size() const { return m_count; }
    const TimelineMark& front() const { return all().front(); }
    const TimelineMark& back() const { return all().back(); }

    /// Not before the last one. Constant, but for what storage has to grow.
    void append(const TimelineMark& mark);
    /// Forgets all before this update. Copies nothing.
    void dropBefore(std::int64_t update);
    /// Forgets all after this update. Copies nothing.
    void dropAfter(std::int64_t update);
    void eraseIf(const std::function<bool(const TimelineMark&)>& goes);

    bool operator==(const MarkList& other) const;

  private:
    struct Storage {
        std::vector<TimelineMark> places;
        std::atomic<std::size_t> used; // by whichever list has most
    };
    void storeAnew();

    std::shared_ptr<Storage> m_storage; // null while empty
    std::size_t m_first = 0;
    std::size_t m_count = 0;
};

} // namespace spacetow
