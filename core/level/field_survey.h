#pragma once
// What several objects have in each of their fields: one value, or several. Made from core/level/fields.h, so that a
// field that is added there is surveyed without a word here.

#include "core/level/field_value.h"
#include "core/level/fields.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace spacetow {

/// One field over all objects that were added.
struct FieldSummary {
    std::string id; // the field's name, with ".x" or ".y" for the parts of a point
    Field field;
    FieldValue value;         // of the first object
    FieldValue standard;      // the default
    bool hasStandard = false; // else it is required, or has none
    bool isStandard = true;   // in all of them
    bool isMixed = false;
    bool mayBeUnset = true;         // in all of them
    bool isWhole = false;           // an integer
    bool isOfShape = false;         // of shapes of bodies
    int count = 0;                  // objects that have it
    TagMask any;                    // of masks: bits set in some of them…
    TagMask every = TagMask::all(); // …and in all
    int exceptions = 0;             // masks that are spelled by what they leave out
    bool isSeen = false;            // whether `value` is there

    bool operator==(const FieldSummary&) const = default;
};

/// Cost: linear in the objects and their shapes, and little.
class FieldSurvey {
  public:
    /// With `shapes` (ascending) only those of a body are looked at.
    void add(const Object& object, std::span<const int> shapes = {});
    /// The level itself and its rules.
    void add(const Level& level);

    int objects() const { return m_objects; }
    /// In the order of core/level/fields.h, fields that several kinds have once.
    std::vector<FieldSummary> summaries() const;

  private:
    friend class FieldLooker;
    using Slots = std::vector<FieldSummary>;
    static constexpr std::size_t objectKinds = std::variant_size_v<ObjectData>;
    static constexpr std::size_t shapeKinds = std::variant_size_v<LevelShape>;

    int m_objects = 0;
    Slots m_common;
    std::array<Slots, objectKinds> m_ofKind;
    std::array<Slots, shapeKinds> m_ofShape;
    std::array<int, shapeKinds> m_lastWithShape{}; // number of the object that was counted last for these slots
    Slots m_ofLevel;
};

/// The summary of this id, or null.
const FieldSummary* summaryOf(std::span<const FieldSummary> summaries, std::string_view id);

} // namespace spacetow
