#pragma once
// Width and height of what was drawn as a rectangle: a body of one polygon with four right angles. The file knows only
// its corners; these two are worked out, and shown and edited like the fields of core/level/fields.h, as "width" and
// "height". Along the axes of the body, m.

#include "core/level/field_edits.h"
#include "core/level/field_survey.h"

#include <optional>
#include <span>
#include <vector>

namespace spacetow {

/// The shape's x and y; nothing for what is no rectangle.
std::optional<Vec2> rectangleSize(const Object& object);

/// What the rectangles among some objects have for width and height: one value, or several.
class SizeSurvey {
  public:
    void add(const Object& object);
    /// None when there was no rectangle.
    std::vector<FieldSummary> summaries() const;

  private:
    std::vector<FieldSummary> m_sizes;
};

/// Whether the id is that of a width or a height.
bool isSizeField(const std::string& id);
/// What is no rectangle stays. Middle and angle stay where they are; anchors of connectors go with the corners.
FieldEditResult withSizeEdited(Level level, std::span<const Key> keys, const FieldEdit& edit);

} // namespace spacetow
