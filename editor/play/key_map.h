#pragma once
// Which key does what while a game is running, and what is held down at the moment.

#include "core/game/controls.h"

#include <QKeySequence>
#include <QList>
#include <QString>

#include <array>
#include <map>
#include <span>

class QKeyEvent;

namespace spacetow {

enum class PlayKey : std::uint8_t {
    None, // belongs to somebody else, or to nobody
    Left,
    Right,
    Thrust,
    Tow,
    Pause,
    Step,
    Restart,
    Follow,
    Slower,
    Faster,
    FrameBack,
    FrameForward,
    Rewind,
    Menu, // Esc, and nothing else
};

/// What can have other keys than it comes with.
struct PlayKeyRow {
    PlayKey meaning;
    const char* code; // by which it is remembered
    const char* text; // translate in the context "Keys"
    const char* keys; // portable, separated by blanks
};
std::span<const PlayKeyRow> playKeyRows();

/// The keys of the game, all of them single ones without modifiers. A value.
class PlayKeys {
  public:
    /// At first those that the program comes with.
    void set(PlayKey meaning, const QList<QKeySequence>& keys) { m_rows[static_cast<std::size_t>(meaning)] = keys; }
    const QList<QKeySequence>& of(PlayKey meaning) const { return m_rows[static_cast<std::size_t>(meaning)]; }
    /// The first one as people call it; empty where there is none.
    QString shown(PlayKey meaning) const;
    /// With modifiers other than Shift and the keypad's, a key belongs to the editor. What steers goes by the place of
    /// the key, so that W, A and D lie as they should on any keyboard, and by its letter as well. Keys that somebody
    /// has chosen go by their letter: that is what was pressed when they were chosen.
    PlayKey meaningOf(const QKeyEvent& event) const;

  private:
    using Rows = std::array<QList<QKeySequence>, static_cast<std::size_t>(PlayKey::Menu) + 1>; // by meaning

    static const Rows& usual();
    template <class Which>
    PlayKey find(int key, const Which& which) const;

    Rows m_rows = usual();
};

/// With the keys that the program comes with.
PlayKey playKey(const QKeyEvent& event);

/// The keys that steer, by what is pressed: letting go of A while Left is held keeps turning.
class HeldKeys {
  public:
    /// True when the key steers.
    bool press(const QKeyEvent& event, const PlayKeys& keys = {});
    void release(const QKeyEvent& event);
    void clear() { m_keys.clear(); }
    Controls controls() const;

  private:
    std::map<quint32, PlayKey> m_keys; // by number of the key
};

} // namespace spacetow
