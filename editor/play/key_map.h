#pragma once
// Which key does what while a game is running, and what is held down at the moment.

#include "core/game/controls.h"

#include <Qt>

#include <set>

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

/// With modifiers other than Shift and the keypad's, a key belongs to the editor.
PlayKey playKey(int key, Qt::KeyboardModifiers modifiers);

/// The keys that steer, by what is pressed: letting go of A while Left is held keeps turning.
class HeldKeys {
  public:
    /// True when the key steers.
    bool press(int key, PlayKey meaning);
    void release(int key) { m_keys.erase(key); }
    void clear() { m_keys.clear(); }
    Controls controls() const;

  private:
    std::set<int> m_keys;
};

} // namespace spacetow
