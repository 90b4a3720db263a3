#pragma once
// Drags that select: what lies in a box between two corners, or within a line that is drawn round it.

#include "core/math/aabb.h"
#include "editor/editing/tool.h"

#include <vector>

namespace spacetow {

enum class MarqueeShape : std::uint8_t { Box, Lasso };

/// What is selected, and how it is told, is for those made of it to say.
class MarqueeGesture : public Gesture {
  public:
    MarqueeGesture(const Edit& edit, const Vec2& start, MarqueeShape shape)
        : m_edit(edit), m_shape(shape), m_way{start} {}

    void follow(const Pointer& pointer) override;
    Label label() const override { return {}; }
    Overlay overlay(const Pointer& pointer) const override;
    bool edits() const override { return false; }

  protected:
    /// From which the drag started.
    const Edit& edit() const { return m_edit; }
    bool isLasso() const { return m_shape == MarqueeShape::Lasso; }
    /// The closed line around what is to be selected, and the box around that.
    std::vector<Vec2> lineAt(const Pointer& pointer) const;
    Aabb boxAt(const Pointer& pointer) const;

  private:
    Edit m_edit;
    MarqueeShape m_shape;
    std::vector<Vec2> m_way; // of a lasso, from the start on
};

} // namespace spacetow
