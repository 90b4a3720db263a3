#pragma once
// Edits of single fields, whatever kind of object they belong to: everything that has the field is changed, all else
// is left as it is.

#include "core/level/field_value.h"

#include <functional>
#include <span>
#include <string>

namespace spacetow {

struct ShapeRef {
    Key key = 0;
    int shape = 0;

    auto operator<=>(const ShapeRef&) const = default; // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

/// Which objects are meant, and of which of them only some shapes. Both ascending.
struct FieldTargets {
    std::span<const Key> keys;
    std::span<const ShapeRef> shapes;
};

struct FieldEdit {
    std::string id; // see FieldSummary
    /// The value after the edit, of the same type or Unset; nothing when this one cannot be had.
    std::function<std::optional<FieldValue>(const FieldValue&)> change;
};

/// The level as it would be, and how many values could not be had; then the level is not to be used.
struct FieldEditResult {
    Level level;
    int changed = 0;
    int refused = 0;
};

FieldEditResult withFieldEdited(Level level, const FieldTargets& targets, const FieldEdit& edit);
/// Of the level itself and its rules.
FieldEditResult withLevelFieldEdited(Level level, const FieldEdit& edit);

/// Each field of one object to its own value, for tests that go through all of them: whether it was there.
bool editField(Object& object, const FieldEdit& edit, std::span<const int> shapes = {});

} // namespace spacetow
