#include "core/level/field_survey.h"

#include "core/level/tag_spelling.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace spacetow {

/// The visitor of core/level/fields.h that compares what it sees with what it saw before. Fields come in the same order
/// each time, so a field finds its slot by counting.
class FieldLooker {
  public:
    FieldLooker(std::vector<FieldSummary>& slots, bool counts) : m_slots(slots), m_counts(counts) {}

    void number(const Field& field, double value, double standard) { see(field, "", value, standard); }
    void integer(const Field& field, int value, int standard) {
        see(field, "", double(value), double(standard)).isWhole = true;
    }
    void optionalNumber(const Field& field, const std::optional<double>& value) {
        seeOptional(field, value ? FieldValue(*value) : FieldValue(Unset{}));
    }
    void depth(const Field& field, double value, double) {
        seeOptional(field, std::isinf(value) ? FieldValue(Unset{}) : FieldValue(value));
    }
    void flag(const Field& field, bool value, bool standard) { see(field, "", value, standard); }
    void text(const Field& field, const std::string& value, const std::string& standard) {
        see(field, "", value, standard);
    }
    template <class Enum, std::size_t n>
    void choice(const Field& field, Enum value, Enum standard, const Spellings<n>&) {
        see(field, "", Choice{static_cast<int>(value)}, Choice{static_cast<int>(standard)});
    }
    void point(const Field& field, const Vec2& value, const Vec2& standard) {
        see(field, ".x", value.x(), standard.x());
        see(field, ".y", value.y(), standard.y());
    }
    void points(const Field& field, const std::vector<Vec2>& value) {
        const PointCount count{static_cast<int>(value.size())};
        see(field, "", count, count);
    }
    void tags(const Field& field, TagMask value, TagMask standard) { seeMask(field, value, standard); }
    void touches(const Field& field, TagMask value) { seeMask(field, value, TagMask::all()); }
    void key(const Field& field, Key value) { see(field, "", KeyValue{value}, KeyValue{}); }
    void optionalKey(const Field& field, Key value) {
        seeOptional(field, value == 0 ? FieldValue(Unset{}) : FieldValue(KeyValue{value}));
    }
    void optionalColor(const Field& field, const std::optional<std::uint32_t>& value) {
        seeOptional(field, value ? FieldValue(ColorValue{*value}) : FieldValue(Unset{}));
    }
    void shapes(const Field&, const std::vector<LevelShape>&) {}

  private:
    FieldSummary& slot(const Field& field, const char* part) {
        if (m_next == m_slots.size()) {
            FieldSummary& made = m_slots.emplace_back();
            made.id = std::string(field.name) + part;
            made.field = field;
            made.hasStandard = field.presence != Presence::Required;
        }
        FieldSummary& slot = m_slots[m_next++];
        slot.count += m_counts ? 1 : 0;
        return slot;
    }

    template <class T>
    FieldSummary& see(const Field& field, const char* part, const T& value, const T& standard) {
        FieldSummary& at = slot(field, part);
        at.mayBeUnset = false;
        return compare(at, value, standard);
    }
    void seeOptional(const Field& field, const FieldValue& value) {
        compare(slot(field, ""), value, FieldValue(Unset{}));
    }
    void seeMask(const Field& field, TagMask value, TagMask standard) {
        FieldSummary& at = see(field, "", value, standard);
        at.any = at.any | value;
        at.every = TagMask{at.every.bits & value.bits};
        at.exceptions += isSpelledByExceptions(value) ? 1 : 0;
    }

    template <class T>
    static bool isEqual(const FieldValue& a, const T& b) {
        if constexpr (std::is_same_v<T, FieldValue>) {
            return a == b;
        } else {
            const T* value = std::get_if<T>(&a);
            return value != nullptr && *value == b;
        }
    }
    template <class T>
    static FieldSummary& compare(FieldSummary& at, const T& value, const T& standard) {
        if (!at.isSeen) {
            at.isSeen = true;
            at.value = value;
            at.standard = standard;
        } else if (!at.isMixed) {
            at.isMixed = !isEqual(at.value, value);
        }
        at.isStandard = at.isStandard && value == standard;
        return at;
    }

    std::vector<FieldSummary>& m_slots;
    bool m_counts;
    std::size_t m_next = 0;
};

namespace {

void join(FieldSummary& into, const FieldSummary& other) {
    into.isMixed = into.isMixed || other.isMixed || !(into.value == other.value);
    into.hasStandard = into.hasStandard && other.hasStandard && into.standard == other.standard;
    into.isStandard = into.isStandard && other.isStandard;
    into.mayBeUnset = into.mayBeUnset && other.mayBeUnset;
    into.field.min = std::max(into.field.min, other.field.min);
    into.field.max = std::min(into.field.max, other.field.max);
    into.count += other.count;
    into.any = into.any | other.any;
    into.every = TagMask{into.every.bits & other.every.bits};
    into.exceptions += other.exceptions;
}

void append(std::vector<FieldSummary>& all, const std::vector<FieldSummary>& slots, bool ofShape) {
    for (const FieldSummary& slot : slots) {
        const auto known = std::ranges::find(all, slot.id, &FieldSummary::id);
        if (known != all.end()) {
            join(*known, slot);
        } else {
            all.push_back(slot);
            all.back().isOfShape = ofShape;
        }
    }
}

} // namespace

void FieldSurvey::add(const Object& object, std::span<const int> shapes) {
    ++m_objects;
    FieldLooker common(m_common, true);
    visitFields(common, object);
    FieldLooker own(m_ofKind[object.data.index()], true);
    std::visit([&own](const auto& data) { visitFields(own, data); }, object.data);
    const auto* body = std::get_if<BodyObject>(&object.data);
    if (body == nullptr) {
        return;
    }
    const auto look = [this](const LevelShape& shape) {
        const std::size_t kind = shape.index();
        const bool isFirst = std::exchange(m_lastWithShape[kind], m_objects) != m_objects;
        FieldLooker looker(m_ofShape[kind], isFirst);
        std::visit([&looker](const auto& of) { visitFields(looker, of); }, shape);
    };
    if (shapes.empty()) {
        std::ranges::for_each(body->shapes, look);
    }
    for (const int index : shapes) {
        if (index >= 0 && index < static_cast<int>(body->shapes.size())) {
            look(body->shapes[static_cast<std::size_t>(index)]);
        }
    }
}

void FieldSurvey::add(const Level& level) {
    FieldLooker looker(m_ofLevel, true);
    visitFields(looker, level);
    visitFields(looker, level.rules);
    visitFields(looker, level.rules.rope);
}

std::vector<FieldSummary> FieldSurvey::summaries() const {
    std::vector<FieldSummary> all;
    append(all, m_common, false);
    append(all, m_ofLevel, false);
    for (const Slots& slots : m_ofKind) {
        append(all, slots, false);
    }
    for (const Slots& slots : m_ofShape) {
        append(all, slots, true);
    }
    return all;
}

const FieldSummary* summaryOf(std::span<const FieldSummary> summaries, std::string_view id) {
    const auto found = std::ranges::find(summaries, id, &FieldSummary::id);
    return found == summaries.end() ? nullptr : &*found;
}

} // namespace spacetow
