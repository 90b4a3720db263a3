#include "core/level/field_edits.h"

#include "core/level/fields.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// The visitor of core/level/fields.h that changes one field wherever it is met.
class FieldChanger {
  public:
    explicit FieldChanger(const FieldEdit& edit) : m_edit(edit), m_name(edit.id) {
        if (m_name.ends_with(".x") || m_name.ends_with(".y")) {
            m_axis = m_name.back() == 'x' ? 0 : 1;
            m_name.remove_suffix(2);
        }
    }

    int changed() const { return m_changed; }
    int refused() const { return m_refused; }

    void number(const Field& field, double& value, double) { edit(field, value); }
    void integer(const Field& field, int& value, int) {
        double number = value;
        if (isMeant(field) && edit(field, number)) {
            m_refused += number == std::floor(number) ? 0 : 1;
            value = static_cast<int>(number);
        }
    }
    void optionalNumber(const Field& field, std::optional<double>& value) {
        if (!isMeant(field)) {
            return;
        }
        const auto next = asked(value ? FieldValue(*value) : FieldValue(Unset{}));
        if (next && std::holds_alternative<Unset>(*next)) {
            value.reset();
        } else if (const double* number = next ? std::get_if<double>(&*next) : nullptr) {
            value = inRange(field, *number) ? std::optional(*number) : value;
        }
    }
    void depth(const Field& field, double& value, double) {
        std::optional<double> asOptional = std::isinf(value) ? std::nullopt : std::optional(value);
        if (isMeant(field)) {
            optionalNumber(field, asOptional);
            value = asOptional.value_or(noBack);
        }
    }
    void flag(const Field& field, bool& value, bool) { edit(field, value); }
    void text(const Field& field, std::string& value, const std::string&) { edit(field, value); }
    template <class Enum, std::size_t n>
    void choice(const Field& field, Enum& value, Enum, const Spellings<n>&) {
        Choice choice{static_cast<int>(value)};
        if (isMeant(field) && edit(field, choice)) {
            const bool exists = choice.index >= 0 && choice.index < static_cast<int>(n);
            value = exists ? static_cast<Enum>(choice.index) : value;
        }
    }
    void point(const Field& field, Vec2& value, const Vec2&) {
        if (m_axis >= 0 && m_name == field.name) {
            edit(field, m_axis == 0 ? value.x() : value.y());
        }
    }
    void points(const Field&, const std::vector<Vec2>&) {}
    void tags(const Field& field, TagMask& value, TagMask) { edit(field, value); }
    void touches(const Field& field, TagMask& value) { edit(field, value); }
    void key(const Field& field, Key& value) {
        KeyValue key{value};
        if (isMeant(field) && edit(field, key)) {
            value = key.key;
        }
    }
    void optionalKey(const Field& field, Key& value) {
        if (!isMeant(field)) {
            return;
        }
        const auto next = asked(value == 0 ? FieldValue(Unset{}) : FieldValue(KeyValue{value}));
        if (next && std::holds_alternative<Unset>(*next)) {
            value = 0;
        } else if (const KeyValue* key = next ? std::get_if<KeyValue>(&*next) : nullptr) {
            value = key->key;
        }
    }
    void optionalColor(const Field& field, std::optional<std::uint32_t>& value) {
        if (!isMeant(field)) {
            return;
        }
        const auto next = asked(value ? FieldValue(ColorValue{*value}) : FieldValue(Unset{}));
        if (next && std::holds_alternative<Unset>(*next)) {
            value.reset();
        } else if (const ColorValue* color = next ? std::get_if<ColorValue>(&*next) : nullptr) {
            value = color->rgb;
        }
    }
    void shapes(const Field&, const std::vector<LevelShape>&) {}

  private:
    bool isMeant(const Field& field) const { return (m_axis < 0) && m_name == field.name; }

    std::optional<FieldValue> asked(const FieldValue& value) {
        std::optional<FieldValue> next = m_edit.change(value);
        m_refused += next ? 0 : 1;
        m_changed += next ? 1 : 0;
        return next;
    }
    bool inRange(const Field& field, double number) {
        const bool isIn = (field.openMin ? number > field.min : number >= field.min) && number <= field.max;
        m_refused += isIn ? 0 : 1;
        return isIn;
    }
    /// Whether the value has been changed: not when the answer is refused, out of range or of another type.
    template <class T>
    bool edit(const Field& field, T& value) {
        const bool isPoint = m_axis >= 0;
        if (m_name != field.name || (isPoint && !std::is_same_v<T, double>)) {
            return false;
        }
        const std::optional<FieldValue> next = asked(value);
        const T* to = next ? std::get_if<T>(&*next) : nullptr;
        if (to == nullptr) {
            return false;
        }
        if constexpr (std::is_same_v<T, double>) {
            if (!inRange(field, *to)) {
                return false;
            }
        }
        value = *to;
        return true;
    }

    const FieldEdit& m_edit;
    std::string_view m_name;
    int m_axis = -1; // of a point: 0 for x, 1 for y
    int m_changed = 0;
    int m_refused = 0;
};

void changeObject(FieldChanger& changer, Object& object, std::span<const int> shapes) {
    visitFields(changer, object);
    std::visit([&changer](auto& of) { visitFields(changer, of); }, object.data);
    auto* body = std::get_if<BodyObject>(&object.data);
    if (body == nullptr) {
        return;
    }
    for (std::size_t i = 0; i < body->shapes.size(); ++i) {
        if (shapes.empty() || std::ranges::find(shapes, static_cast<int>(i)) != shapes.end()) {
            std::visit([&changer](auto& of) { visitFields(changer, of); }, body->shapes[i]);
        }
    }
}

} // namespace

bool editField(Object& object, const FieldEdit& edit, std::span<const int> shapes) {
    FieldChanger changer(edit);
    changeObject(changer, object, shapes);
    return changer.changed() > 0;
}

FieldEditResult withFieldEdited(Level level, const FieldTargets& targets, const FieldEdit& edit) {
    FieldChanger changer(edit);
    std::vector<int> shapes;
    for (const Key key : targets.keys) {
        const int place = level.objects.indexOf(key);
        if (place < 0) {
            continue;
        }
        const Object& before = level.objects[place];
        shapes.clear();
        auto part = std::ranges::lower_bound(targets.shapes, ShapeRef{before.key, 0});
        for (; part != targets.shapes.end() && part->key == before.key; ++part) {
            shapes.push_back(part->shape);
        }
        const int changedBefore = changer.changed();
        Object object = before;
        changeObject(changer, object, shapes);
        if (changer.changed() != changedBefore) {
            level.objects.replace(place, std::move(object));
        }
    }
    return {std::move(level), changer.changed(), changer.refused()};
}

FieldEditResult withLevelFieldEdited(Level level, const FieldEdit& edit) {
    FieldChanger changer(edit);
    visitFields(changer, level);
    visitFields(changer, level.rules);
    visitFields(changer, level.rules.rope);
    return {std::move(level), changer.changed(), changer.refused()};
}

} // namespace spacetow
