#pragma once
// Which key does what while a game is running, and what is held down at the moment.

#include "core/game/controls.h"

#include <Qt>

#include <map>

class QKeyEvent;

namespace spacetow {

enum class PlayKey {
    None, // belongs to somebody else, or to nobody
    Left,
    Right,
    Thrust,
    Tow,
    Menu,
    Pause,
    Step,
    Restart,
    Follow,
};

/// With modifiers other than Shift and the keypad's, a key belongs to the editor. What steers goes by the place of the
/// key, so that W, A and D lie as they should on any keyboard, and by its letter as well.
PlayKey playKey(const QKeyEvent& event);

/// The keys that steer, by what is pressed: letting go of A while Left is held keeps turning.
class HeldKeys {
  public:
    /// True when the key steers.
    bool press(const QKeyEvent& event);
    void release(const QKeyEvent& event);
    void clear() { m_keys.clear(); }
    Controls controls() const;

  private:
    std::map<quint32, PlayKey> m_keys; // by number of the key
};

} // namespace spacetow
