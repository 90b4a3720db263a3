#include "editor/panels/field_access.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr Field nameField = fields::plain("name");

/// The visitor of core/level/fields.h that lists what it sees.
class Reader {
  public:
    std::vector<FieldEntry> entries;

    void number(const Field& field, double value, double) { add(field.name, field, value); }
    void integer(const Field& field, int value, int) { add(field.name, field, double(value)).whole = true; }
    void optionalNumber(const Field& field, const std::optional<double>& value) {
        add(field.name, field, value ? FieldValue(*value) : FieldValue(Unset{})).mayBeUnset = true;
    }
    void depth(const Field& field, double value, double) {
        add(field.name, field, std::isinf(value) ? FieldValue(Unset{}) : FieldValue(value)).mayBeUnset = true;
    }
    void flag(const Field& field, bool value, bool) { add(field.name, field, value); }
    void text(const Field& field, const std::string& value, const std::string&) { add(field.name, field, value); }
    template <class Enum, std::size_t n>
    void choice(const Field& field, Enum value, Enum, const Spellings<n>&) {
        add(field.name, field, Choice{static_cast<int>(value)});
    }
    void point(const Field& field, const Vec2& value, const Vec2&) {
        if (!m_inShape) {
            add(std::string(field.name) + ".x", field, value.x());
            add(std::string(field.name) + ".y", field, value.y());
        }
    }
    void points(const Field&, const std::vector<Vec2>&) {}
    void tags(const Field& field, TagMask value, TagMask) { add(field.name, field, value); }
    void touches(const Field& field, TagMask value) { add(field.name, field, value); }
    void key(const Field&, Key) {}
    void optionalKey(const Field&, Key) {}
    void optionalColor(const Field&, const std::optional<std::uint32_t>&) {}
    void shapes(const Field&, const std::vector<LevelShape>& shapes) {
        m_inShape = true;
        for (const LevelShape& shape : shapes) {
            std::visit([this](const auto& of) { visitFields(*this, of); }, shape);
        }
        m_inShape = false;
    }

  private:
    FieldEntry& add(std::string id, const Field& field, FieldValue value) {
        if (m_inShape) {
            const auto known = std::ranges::find(entries, id, &FieldEntry::id);
            if (known != entries.end()) {
                m_ignored = *known;
                return m_ignored;
            }
        }
        return entries.emplace_back(FieldEntry{std::move(id), field, std::move(value)});
    }

    bool m_inShape = false;
    FieldEntry m_ignored;
};

/// The visitor that changes one field, wherever it is met.
class Writer {
  public:
    Writer(const std::string& id, const FieldValue& value) : m_id(id), m_value(value) {}

    void number(const Field& field, double& value, double) const { set(field.name, value); }
    void integer(const Field& field, int& value, int) const {
        if (const double* number = wanted<double>(field.name)) {
            value = static_cast<int>(std::lround(std::clamp(*number, field.min, field.max)));
        }
    }
    void optionalNumber(const Field& field, std::optional<double>& value) const {
        if (const double* number = wanted<double>(field.name)) {
            value = *number;
        } else if (wanted<Unset>(field.name) != nullptr) {
            value.reset();
        }
    }
    void depth(const Field& field, double& value, double) const {
        set(field.name, value);
        if (wanted<Unset>(field.name) != nullptr) {
            value = noBack;
        }
    }
    void flag(const Field& field, bool& value, bool) const { set(field.name, value); }
    void text(const Field& field, std::string& value, const std::string&) const { set(field.name, value); }
    template <class Enum, std::size_t n>
    void choice(const Field& field, Enum& value, Enum, const Spellings<n>&) const {
        const Choice* choice = wanted<Choice>(field.name);
        if (choice != nullptr && choice->index >= 0 && choice->index < static_cast<int>(n)) {
            value = static_cast<Enum>(choice->index);
        }
    }
    void point(const Field& field, Vec2& value, const Vec2&) const {
        set(std::string(field.name) + ".x", value.x());
        set(std::string(field.name) + ".y", value.y());
    }
    void points(const Field&, const std::vector<Vec2>&) const {}
    void tags(const Field& field, TagMask& value, TagMask) const { set(field.name, value); }
    void touches(const Field& field, TagMask& value) const { set(field.name, value); }
    void key(const Field&, Key) const {}
    void optionalKey(const Field&, Key) const {}
    void optionalColor(const Field&, const std::optional<std::uint32_t>&) const {}
    void shapes(const Field&, std::vector<LevelShape>& shapes) const {
        for (LevelShape& shape : shapes) {
            std::visit([this](auto& of) { visitFields(*this, of); }, shape);
        }
    }

  private:
    template <class T>
    const T* wanted(const std::string& name) const {
        return name == m_id ? std::get_if<T>(&m_value) : nullptr;
    }
    template <class T>
    void set(const std::string& name, T& value) const {
        if (const T* to = wanted<T>(name)) {
            value = *to;
        }
    }

    const std::string& m_id;
    const FieldValue& m_value;
};

} // namespace

std::vector<FieldEntry> fieldsOf(const Object& object) {
    Reader reader;
    reader.text(nameField, object.name, {});
    std::visit([&reader](const auto& of) { visitFields(reader, of); }, object.data);
    return std::move(reader.entries);
}

std::vector<FieldEntry> fieldsOf(const Level& level) {
    Reader reader;
    visitFields(reader, level);
    visitFields(reader, level.rules);
    return std::move(reader.entries);
}

void setField(Object& object, const std::string& id, const FieldValue& value) {
    Writer writer(id, value);
    writer.text(nameField, object.name, {});
    std::visit([&writer](auto& of) { visitFields(writer, of); }, object.data);
}

void setField(Level& level, const std::string& id, const FieldValue& value) {
    Writer writer(id, value);
    visitFields(writer, level);
    visitFields(writer, level.rules);
}

} // namespace spacetow
