#pragma once
// "Press, move, release" for any tool, without a window: a document, a toolbox and a view, driven with world points.

#include "editor/editing/toolbox.h"
#include "editor/editing/viewport.h"
#include "tests/support/body_with.h"

#include <initializer_list>
#include <memory>
#include <string>

namespace spacetow::test {

// Keys that are held.
constexpr Modifiers none{};
constexpr Modifiers shift{true, false, false};
constexpr Modifiers ctrl{false, true, false};
constexpr Modifiers alt{false, false, true};

class Drive {
  public:
    /// The clock stands still until `later` is called, so that merging does not depend on the machine.
    explicit Drive(Level level = {});

    Document document;
    Toolbox toolbox;
    Viewport view;
    Modifiers held; // what is held down with everything that follows

    void press(const Vec2& world) { toolbox.press(at(world)); }
    void begin(std::unique_ptr<Gesture> gesture, const Vec2& world) { toolbox.begin(std::move(gesture), at(world)); }
    void move(const Vec2& world) { toolbox.move(at(world)); }
    void release(const Vec2& world) { toolbox.release(at(world)); }
    void click(const Vec2& world);
    void click(std::initializer_list<Vec2> points);
    /// As a mouse does it: a click, then the double click in place of the second press, then a release.
    void doubleClick(const Vec2& world);
    /// Presses, moves in several steps, releases.
    void drag(const Vec2& from, const Vec2& to);
    bool secondaryClick(const Vec2& world) { return toolbox.secondaryClick(at(world)); }
    void key(ToolKey key) { toolbox.key(key, m_last); }
    void later(std::chrono::milliseconds time) { m_now += time; }

    const Level& level() const { return document.level(); }
    /// The last object of the level; there must be one.
    const Object& newest() const { return level().objects[level().objects.size() - 1]; }

  private:
    Pointer at(const Vec2& world);

    std::chrono::steady_clock::time_point m_now{};
    Pointer m_last;
};

/// The points of a chain or polygon, or the centre of a circle, in world coordinates.
std::vector<Vec2> worldPoints(const Object& object);

} // namespace spacetow::test
