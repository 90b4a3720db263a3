#include "core/level/json_write.h"

#include "core/level/fields.h"
#include "core/level/key_text.h"
#include "core/level/migrate.h"
#include "core/level/tag_spelling.h"
#include "core/level/unknown_fields.h"

#include <algorithm>
#include <cstdlib>

namespace spacetow {

namespace {

JsonText pointText(const Vec2& p) {
    return JsonText::raw('[' + spelledNumber(p.x()) + ", " + spelledNumber(p.y()) + ']');
}

/// The visitor of core/level/fields.h that writes.
class FieldWriter {
  public:
    FieldWriter(JsonText& out, const TagTable& tags) : m_out(out), m_tags(tags) {}

    void number(const Field& field, const double& value, double byDefault) {
        if (isWritten(field, value == byDefault)) {
            m_out.append(field.name, JsonText::number(value));
        }
    }
    void integer(const Field& field, const int& value, int byDefault) {
        if (isWritten(field, value == byDefault)) {
            m_out.append(field.name, JsonText::integer(value));
        }
    }
    void optionalNumber(const Field& field, const std::optional<double>& value) {
        if (value) {
            m_out.append(field.name, JsonText::number(*value));
        }
    }
    void depth(const Field& field, const double& value, double) {
        m_out.append(field.name, value == noBack ? JsonText::null() : JsonText::number(value));
    }
    void flag(const Field& field, const bool& value, bool byDefault) {
        if (isWritten(field, value == byDefault)) {
            m_out.append(field.name, JsonText::flag(value));
        }
    }
    void text(const Field& field, const std::string& value, const std::string& byDefault) {
        if (isWritten(field, value == byDefault)) {
            m_out.append(field.name, JsonText::text(value));
        }
    }
    template <class Enum, std::size_t n>
    void choice(const Field& field, const Enum& value, Enum byDefault, const Spellings<n>& names) {
        const auto index = static_cast<std::size_t>(value);
        EXPECTS(index < n);
        if (isWritten(field, value == byDefault)) {
            m_out.append(field.name, JsonText::text(names[index]));
        }
    }
    void point(const Field& field, const Vec2& value, const Vec2& byDefault) {
        if (isWritten(field, value == byDefault)) {
            m_out.append(field.name, pointText(value));
        }
    }
    void points(const Field& field, const std::vector<Vec2>& value) {
        JsonText list = JsonText::array();
        for (const Vec2& vertex : value) {
            list.append(pointText(vertex));
        }
        m_out.append(field.name, std::move(list));
    }
    void tags(const Field& field, const TagMask& value, TagMask) { m_out.append(field.name, maskText(value)); }
    void touches(const Field& field, const TagMask& value) {
        if (value == TagMask::all()) {
            return;
        }
        if (isSpelledByExceptions(value)) {
            JsonText exceptions = JsonText::object();
            exceptions.append("except", maskText(TagMask{~value.bits}));
            m_out.append(field.name, std::move(exceptions));
        } else {
            m_out.append(field.name, maskText(value));
        }
    }
    void key(const Field& field, const Key& value) { m_out.append(field.name, JsonText::text(keyText(value))); }
    void optionalKey(const Field& field, const Key& value) {
        if (value != 0) {
            key(field, value);
        }
    }
    void optionalColor(const Field& field, const std::optional<std::uint32_t>& value) {
        if (value) {
            m_out.append(field.name, JsonText::text(colorText(*value)));
        }
    }
    void shapes(const Field& field, const std::vector<LevelShape>& value) {
        JsonText list = JsonText::array();
        for (const LevelShape& shape : value) {
            JsonText json = JsonText::object();
            json.append("type", JsonText::text(shapeTypeNames[shape.index()]));
            FieldWriter writer(json, m_tags);
            std::visit([&writer](const auto& s) { visitFields(writer, s); }, shape);
            list.append(std::move(json));
        }
        m_out.append(field.name, std::move(list));
    }

  private:
    static bool isWritten(const Field& field, bool isDefault) {
        return field.presence != Presence::Optional || !isDefault;
    }
    JsonText maskText(TagMask mask) const {
        JsonText list = JsonText::array();
        for (int i = 0; i < TagTable::size; ++i) {
            if (mask.contains(i)) {
                const std::string& name = m_tags[i].name;
                list.append(JsonText::text(name.empty() ? '#' + std::to_string(i) : name));
            }
        }
        return list;
    }

    JsonText& m_out;
    const TagTable& m_tags;
};

constexpr std::string_view tagPlace = "/tags/";
constexpr std::string_view ropePlace = "/rules/rope";

bool hasUnknownAt(const std::string& text, std::string_view place) {
    const auto isThere = [place](const UnknownField& field) { return field.place == place; };
    return text.find(place) != std::string::npos && std::ranges::any_of(unknownFields(text), isThere);
}

/// The tags that have fields which this version does not know.
TagMask tagsWithUnknown(const std::string& text) {
    TagMask mask;
    if (text.find(tagPlace) != std::string::npos) {
        for (const UnknownField& field : unknownFields(text)) {
            const int tag = field.place.starts_with(tagPlace) ? std::atoi(field.place.c_str() + tagPlace.size()) : -1;
            mask = tag >= 0 && tag < TagTable::size ? mask | TagMask::bit(tag) : mask;
        }
    }
    return mask;
}

/// Fields of tags are kept by the index of the tag, which need not be its place in the list.
std::string placeOfTag(const std::string& place, const std::vector<int>& rows) {
    if (!place.starts_with(tagPlace)) {
        return place;
    }
    const auto index = static_cast<std::size_t>(std::atoi(place.c_str() + tagPlace.size()));
    return index < rows.size() && rows[index] >= 0 ? std::string(tagPlace) + std::to_string(rows[index])
                                                   : std::string();
}

template <class T>
void writeEntries(JsonText& json, const char* name, const std::vector<T>& entries, const TagTable& tags) {
    if (entries.empty()) {
        return;
    }
    JsonText list = JsonText::array();
    for (const T& entry : entries) {
        JsonText line = JsonText::object();
        FieldWriter writer(line, tags);
        visitFields(writer, entry);
        list.append(std::move(line));
    }
    json.append(name, std::move(list).broken());
}

} // namespace

JsonText writtenTags(const TagTable& tags, TagMask which, TagMask always) {
    JsonText list = JsonText::array();
    for (int i = 0; i < TagTable::size; ++i) {
        const TagInfo& info = tags[i];
        if (always.contains(i) || (which.contains(i) && !(info == TagInfo()))) {
            JsonText tag = JsonText::object();
            tag.append("index", JsonText::integer(i));
            tag.append("name", JsonText::text(info.name));
            tag.append("color", JsonText::text(colorText(info.color)));
            list.append(std::move(tag));
        }
    }
    return std::move(list).broken();
}

JsonText writtenObject(const Object& object, const TagTable& tags) {
    JsonText json = JsonText::object();
    json.append("key", JsonText::text(keyText(object.key)));
    json.append("type", JsonText::text(objectTypeNames[object.data.index()]));
    FieldWriter writer(json, tags);
    visitFields(writer, object);
    std::visit([&writer](const auto& data) { visitFields(writer, data); }, object.data);
    insertUnknownFields(json, object.unknownFields);
    return json;
}

JsonText writtenLevel(const Level& level) {
    JsonText json = JsonText::object();
    json.append("schema", JsonText::integer(newestSchema));
    FieldWriter writer(json, level.tags);
    visitFields(writer, level);
    JsonText rules = JsonText::object();
    FieldWriter rulesWriter(rules, level.tags);
    visitFields(rulesWriter, level.rules);
    JsonText rope = JsonText::object();
    FieldWriter ropeWriter(rope, level.tags);
    visitFields(ropeWriter, level.rules.rope);
    if (rope.size() > 0 || hasUnknownAt(level.unknownFields, ropePlace)) {
        rules.append("rope", std::move(rope));
    }
    json.append("rules", std::move(rules));

    const TagMask kept = tagsWithUnknown(level.unknownFields);
    std::vector<int> rows(TagTable::size, -1);
    int row = 0;
    for (int i = 0; i < TagTable::size; ++i) {
        rows[static_cast<std::size_t>(i)] = level.tags[i] == TagInfo() && !kept.contains(i) ? -1 : row++;
    }
    json.append("tags", writtenTags(level.tags, TagMask::all(), kept));

    writeEntries(json, "guides", level.guides, level.tags);
    writeEntries(json, "hiddenProblems", level.hiddenProblems, level.tags);

    JsonText objects = JsonText::array();
    for (const Object& object : level.objects) {
        objects.append(writtenObject(object, level.tags));
    }
    json.append("objects", std::move(objects).broken());
    insertUnknownFields(json, level.unknownFields,
                        [&rows](const std::string& place) { return placeOfTag(place, rows); });
    return std::move(json).broken();
}

} // namespace spacetow
