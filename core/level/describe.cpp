#include "core/level/describe.h"

#include "core/level/fields.h"
#include "core/level/json_text.h"
#include "core/level/key_text.h"
#include "core/level/migrate.h"

#include <algorithm>
#include <optional>

namespace spacetow {

namespace {

constexpr std::string_view keyPattern = "^(?!0{8})[0-9a-fA-F]{8}$";
constexpr std::string_view keyRange = "8 hexadecimal digits, not all 0";
constexpr std::string_view colorPattern = "^#[0-9a-fA-F]{6}$";
constexpr std::string_view unnamedTagPattern = "^#([0-9]|[0-2][0-9]|3[01])$";

/// One field as both documents have it.
struct Row {
    std::string name, meaning, range;
    std::string byDefault; // as it is spelled, or in words; empty for a field that must be there
    JsonText schema;       // without the description
    bool written = false;
};

std::string code(std::string_view text) {
    return '`' + std::string(text) + '`';
}

JsonText constant(std::string_view text) {
    JsonText json = JsonText::object();
    json.append("const", JsonText::text(text));
    return json;
}

JsonText typed(std::string_view type) {
    JsonText json = JsonText::object();
    json.append("type", JsonText::text(type));
    return json;
}

JsonText patterned(std::string_view pattern) {
    JsonText json = typed("string");
    json.append("pattern", JsonText::text(pattern));
    return json;
}

JsonText reference(std::string_view definition) {
    JsonText json = JsonText::object();
    json.append("$ref", JsonText::text("#/$defs/" + std::string(definition)));
    return json;
}

std::string rangeText(const Field& field) {
    return field.openMin ? "> " + spelledNumber(field.min) + ", ≤ " + spelledNumber(field.max)
                         : spelledNumber(field.min) + " … " + spelledNumber(field.max);
}

JsonText numeric(const Field& field, std::string_view type) {
    JsonText json = typed(type);
    json.append(field.openMin ? "exclusiveMinimum" : "minimum", JsonText::number(field.min));
    json.append("maximum", JsonText::number(field.max));
    return json;
}

JsonText pointSchema(const Field& field) {
    JsonText json = typed("array");
    JsonText items = JsonText::array();
    items.append(numeric(field, "number"));
    items.append(numeric(field, "number"));
    json.append("prefixItems", std::move(items));
    json.append("items", JsonText::flag(false));
    json.append("minItems", JsonText::integer(2));
    return json;
}

std::string pointSpelling(const Vec2& point) {
    return '[' + spelledNumber(point.x()) + ", " + spelledNumber(point.y()) + ']';
}

template <std::size_t n>
JsonText spellings(const Spellings<n>& names) {
    JsonText list = JsonText::array();
    for (const std::string_view name : names) {
        if (!name.empty()) {
            list.append(JsonText::text(name));
        }
    }
    JsonText json = JsonText::object();
    json.append("enum", std::move(list));
    return json;
}

/// The visitor of core/level/fields.h that makes rows.
class Describer {
  public:
    std::vector<Row> rows;

    void number(const Field& f, double, double byDefault) {
        JsonText schema = numeric(f, "number");
        add(f, rangeText(f), std::move(schema), JsonText::number(byDefault));
    }
    void integer(const Field& f, int, int byDefault) {
        add(f, rangeText(f) + ", whole", numeric(f, "integer"), JsonText::integer(byDefault));
    }
    void optionalNumber(const Field& f, const std::optional<double>&) {
        addUnset(f, rangeText(f), numeric(f, "number"));
    }
    void optionalColor(const Field& f, const std::optional<std::uint32_t>&) {
        addUnset(f, "`#rrggbb`", patterned(colorPattern));
    }
    void depth(const Field& f, double, double) {
        JsonText schema = JsonText::object();
        JsonText types = JsonText::array();
        types.append(JsonText::text("number"));
        types.append(JsonText::text("null"));
        schema.append("type", std::move(types));
        schema.append("minimum", JsonText::number(f.min));
        schema.append("maximum", JsonText::number(f.max));
        add(f, rangeText(f) + ", or null", std::move(schema), JsonText::null());
    }
    void flag(const Field& f, bool, bool byDefault) {
        add(f, "true, false", typed("boolean"), JsonText::flag(byDefault));
    }
    void text(const Field& f, const std::string&, const std::string& byDefault) {
        add(f, "text", typed("string"), JsonText::text(byDefault));
    }
    template <class Enum, std::size_t n>
    void choice(const Field& f, Enum, Enum byDefault, const Spellings<n>& names) {
        std::string range;
        for (const std::string_view name : names) {
            range += (range.empty() ? "" : ", ") + code(name);
        }
        add(f, range, spellings(names), JsonText::text(names[static_cast<std::size_t>(byDefault)]));
    }
    void point(const Field& f, const Vec2&, const Vec2& byDefault) {
        add(f, "[x, y], each " + rangeText(f), pointSchema(f), JsonText::raw(pointSpelling(byDefault)));
    }
    void points(const Field& f, const std::vector<Vec2>&) {
        JsonText schema = typed("array");
        schema.append("minItems", JsonText::integer(f.least));
        if (f.most > 0) {
            schema.append("maxItems", JsonText::integer(f.most));
        }
        schema.append("items", pointSchema(f));
        std::string range = "≥ " + std::to_string(f.least);
        range += f.most > 0 ? ", ≤ " + std::to_string(f.most) : "";
        add(f, range + " points [x, y], each " + rangeText(f), std::move(schema), {});
    }
    void tags(const Field& f, TagMask, TagMask) {
        add(f, "names of tags", names(), {}).byDefault = "the tag of index 0";
    }
    void touches(const Field& f, TagMask) {
        JsonText both = JsonText::array();
        both.append(constant("all"));
        both.append(names());
        JsonText required = JsonText::array();
        required.append(JsonText::text("except"));
        JsonText properties = JsonText::object();
        properties.append("except", names());
        JsonText exceptions = typed("object");
        exceptions.append("required", std::move(required));
        exceptions.append("additionalProperties", JsonText::flag(false));
        exceptions.append("properties", std::move(properties));
        both.append(std::move(exceptions));
        JsonText schema = JsonText::object();
        schema.append("oneOf", std::move(both));
        add(f, "`\"all\"`, names of tags or `{\"except\": names of tags}`", std::move(schema), JsonText::text("all"));
    }
    void key(const Field& f, Key) { add(f, std::string(keyRange), patterned(keyPattern), {}); }
    void optionalKey(const Field& f, Key) { addUnset(f, std::string(keyRange), patterned(keyPattern)); }
    void shapes(const Field& f, const std::vector<LevelShape>&) {
        JsonText kinds = JsonText::array();
        for (const std::string_view name : shapeTypeNames) {
            kinds.append(reference(name));
        }
        JsonText item = JsonText::object();
        item.append("oneOf", std::move(kinds));
        JsonText schema = typed("array");
        schema.append("minItems", JsonText::integer(f.least));
        schema.append("items", std::move(item));
        add(f, "≥ " + std::to_string(f.least) + " shapes, see below", std::move(schema), {});
    }

    /// A field that is read and written apart from the visitors.
    void structural(Row row) { rows.push_back(std::move(row)); }

  private:
    static JsonText names() {
        JsonText schema = typed("array");
        schema.append("items", typed("string"));
        return schema;
    }
    /// The default is spelled as in the file.
    Row& add(const Field& f, std::string range, JsonText schema, std::optional<JsonText> byDefault) {
        Row row{f.name, f.meaning, std::move(range), "", std::move(schema), false};
        row.written = f.presence == Presence::Written;
        if (byDefault && f.presence != Presence::Required) {
            const std::string spelled = byDefault->onOneLine();
            row.byDefault = spelled.front() == '"' ? code(spelled) : spelled;
            row.schema.append("default", std::move(*byDefault));
        }
        return rows.emplace_back(std::move(row));
    }
    void addUnset(const Field& f, std::string range, JsonText schema) {
        add(f, std::move(range), std::move(schema), {}).byDefault = "none";
    }
};

template <class T>
std::vector<Row> rowsOf() {
    Describer describer;
    visitFields(describer, static_cast<const T&>(T()));
    return std::move(describer.rows);
}

std::vector<Row> tagRows() {
    Field index = fields::between("index", "", 0, TagTable::size - 1);
    JsonText name = typed("string");
    JsonText unnamed = JsonText::object();
    unnamed.append("pattern", JsonText::text(unnamedTagPattern));
    name.append("not", std::move(unnamed));
    name.append("default", JsonText::text(""));
    JsonText color = patterned(colorPattern);
    const std::string gray = colorText(TagInfo().color);
    color.append("default", JsonText::text(gray));
    return {{"index", "Which of the 32 tags.", rangeText(index) + ", whole", "", numeric(index, "integer"), false},
            {"name", "Unique; empty for a tag that is not in use. Not # with a number below 32.", "text", "`\"\"`",
             std::move(name), true},
            {"color", "Red, green and blue.", "`#rrggbb`", code('"' + gray + '"'), std::move(color), true}};
}

std::vector<Row> objectRows() {
    std::vector<Row> rows = rowsOf<Object>();
    rows.insert(rows.begin(), {"key", "Identity: random, never used again.", std::string(keyRange), "",
                               patterned(keyPattern), false});
    return rows;
}

JsonText definition(const std::vector<Row>& rows, std::string_view type, std::string_view meaning);

JsonText listOf(JsonText items) {
    JsonText schema = typed("array");
    schema.append("items", std::move(items));
    return schema;
}

std::vector<Row> rulesRows() {
    std::vector<Row> rows = rowsOf<Rules>();
    rows.push_back({"rope", "That tows the payload.", "", "as below", definition(rowsOf<RopeRules>(), "", ""), false});
    return rows;
}

std::vector<Row> levelRows() {
    JsonText versions = JsonText::array();
    std::string range = code(std::to_string(newestSchema));
    for (int schema = oldestSchema; schema <= newestSchema; ++schema) {
        versions.append(JsonText::integer(schema));
        range += schema < newestSchema ? "; " + code(std::to_string(schema)) + " is read too" : "";
    }
    JsonText schema = JsonText::object();
    schema.append("enum", std::move(versions));
    std::vector<Row> rows = rowsOf<Level>();
    rows.insert(rows.begin(), {"schema", "Version of this format.", range, "", std::move(schema), false});
    rows.push_back({"rules", "Of the game in this level.", "", "as below", definition(rulesRows(), "", ""), true});
    JsonText tags = typed("array");
    tags.append("maxItems", JsonText::integer(TagTable::size));
    tags.append("items", definition(tagRows(), "", ""));
    rows.push_back(
        {"tags", "Names and colours of the 32 tags.", "list", "those of a new level", std::move(tags), true});
    rows.push_back({"guides", "Lines that points snap to in the editor; not part of the game.", "list", "none",
                    listOf(definition(rowsOf<Guide>(), "", "")), false});
    rows.push_back({"hiddenProblems", "What lint finds here and is not to be shown.", "list", "none",
                    listOf(definition(rowsOf<HiddenProblem>(), "", "")), false});
    JsonText kinds = JsonText::array();
    for (const std::string_view name : objectTypeNames) {
        kinds.append(reference(name));
    }
    JsonText item = JsonText::object();
    item.append("oneOf", std::move(kinds));
    rows.push_back({"objects", "In drawing order.", "list", "", listOf(std::move(item)), false});
    return rows;
}

struct DescribedPart {
    std::string_view name;
    std::string_view meaning; // of the objects and shapes
    std::vector<Row> (*rows)();
};

constexpr DescribedPart parts[] = {
    {"level", "", levelRows},
    {"rules", "", rulesRows},
    {"rope", "", rowsOf<RopeRules>},
    {"tag", "", tagRows},
    {"guide", "", rowsOf<Guide>},
    {"hidden-problem", "", rowsOf<HiddenProblem>},
    {"object", "", objectRows},
    {"body", "A rigid body.", rowsOf<BodyObject>},
    {"ship", "Where the ship starts.", rowsOf<ShipObject>},
    {"payload", "The ball to be towed.", rowsOf<PayloadObject>},
    {"finish", "The segment that wins the level when the payload crosses it.", rowsOf<FinishObject>},
    {"connector", "A damped spring between two bodies.", rowsOf<ConnectorObject>},
    {"group", "Objects that belong together: those that name it as their parent.", rowsOf<GroupObject>},
    {"edges", "One-way walls joined end to end: each stops what comes from its left on the way from vertex to vertex.",
     rowsOf<EdgeChain>},
    {"lines", "Walls joined end to end that stop what comes from either side.", rowsOf<LineChain>},
    {"polygon", "A filled outline that does not cross itself, anticlockwise; it may be concave.", rowsOf<Polygon>},
    {"circle", "A filled circle.", rowsOf<Circle>},
};

/// `type` is empty for what has no member of that name.
JsonText definition(const std::vector<Row>& rows, std::string_view type, std::string_view meaning) {
    JsonText required = JsonText::array();
    JsonText properties = JsonText::object();
    if (!type.empty()) {
        required.append(JsonText::text("type"));
        properties.append("type", constant(type));
    }
    for (const Row& row : rows) {
        if (row.byDefault.empty()) {
            required.append(JsonText::text(row.name));
        }
        JsonText property = JsonText::object();
        property.append("description", JsonText::text(row.meaning));
        property.take(row.schema);
        properties.append(row.name, std::move(property));
    }
    JsonText json = JsonText::object();
    if (!meaning.empty()) {
        json.append("description", JsonText::text(meaning));
    }
    json.append("type", JsonText::text("object"));
    if (required.size() > 0) {
        json.append("required", std::move(required));
    }
    json.append("properties", std::move(properties));
    return json;
}

} // namespace

std::vector<std::string_view> describedParts() {
    std::vector<std::string_view> names;
    for (const DescribedPart& part : parts) {
        names.push_back(part.name);
    }
    return names;
}

std::string fieldTable(std::string_view name) {
    for (const DescribedPart& part : parts) {
        if (part.name != name) {
            continue;
        }
        std::string table = "| field | meaning | range | default |\n|---|---|---|---|\n";
        for (const Row& row : part.rows()) {
            table += "| " + code(row.name) + " | " + row.meaning + " | " + row.range + " | ";
            table += row.byDefault.empty() ? "required" : row.byDefault;
            table += row.written ? " (always written) |\n" : " |\n";
        }
        return table;
    }
    return {};
}

std::string levelSchemaText() {
    JsonText definitions = JsonText::object();
    for (const DescribedPart& part : parts) {
        if (part.meaning.empty()) {
            continue;
        }
        std::vector<Row> rows = part.rows();
        if (std::ranges::find(objectTypeNames, part.name) != objectTypeNames.end()) {
            std::vector<Row> common = objectRows();
            rows.insert(rows.begin(), common.begin(), common.end());
        }
        definitions.append(std::string(part.name), definition(rows, part.name, part.meaning));
    }
    JsonText json = JsonText::object();
    json.append("$schema", JsonText::text("https://json-schema.org/draft/2020-12/schema"));
    json.append("title", JsonText::text("SpaceTow level"));
    json.take(definition(levelRows(), "",
                         "Lengths in metres, angles in radians, y up. Fields that are not listed are kept, but do "
                         "nothing."));
    json.append("$defs", std::move(definitions));
    return std::move(json).broken().laidOut();
}

} // namespace spacetow
