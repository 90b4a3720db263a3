#include "core/level/json_read.h"

#include "core/level/field_reader.h"
#include "core/level/migrate.h"

#include <algorithm>
#include <map>
#include <type_traits>

namespace spacetow {

namespace {

const Place documentPlace{};

ObjectData emptyData(int type) {
    constexpr auto makers =
        std::array{+[]() -> ObjectData { return BodyObject(); },      +[]() -> ObjectData { return ShipObject(); },
                   +[]() -> ObjectData { return PayloadObject(); },   +[]() -> ObjectData { return FinishObject(); },
                   +[]() -> ObjectData { return ConnectorObject(); }, +[]() -> ObjectData { return GroupObject(); }};
    return makers[static_cast<std::size_t>(type)]();
}

/// One entry of the tag table.
void readTag(ReadState& state, JsonView entry, const Place& place) {
    FieldReader reader(state, entry, place);
    const auto index = reader.member("index", true);
    const auto name = reader.member("name", false);
    const auto color = reader.member("color", false);
    TagInfo info;
    if (name && !name->isText()) {
        reader.reject("not-a-text", {&place, "name"}, *name);
    } else if (name && state.tags.indexOf(name->text())) {
        reader.report(Severity::Error, {LevelCode("duplicate-tag"), {std::string(name->text())}}, *name,
                      {&place, "name"});
    } else if (name && unnamedTag(name->text()) >= 0) {
        reader.report(Severity::Error, {LevelCode("bad-tag-name"), {std::string(name->text())}}, *name,
                      {&place, "name"});
    } else if (name) {
        info.name = name->text();
    }
    const auto rgb = color && color->isText() ? colorFromText(color->text()) : std::nullopt;
    if (color && !rgb) {
        reader.reject("bad-color", {&place, "color"}, *color);
    }
    info.color = rgb.value_or(info.color);
    if (!index) {
        return;
    }
    const double number = index->isNumber() ? index->number() : -1;
    if (!(number >= 0 && number < TagTable::size && number == static_cast<int>(number))) {
        reader.reject("bad-tag-index", {&place, "index"}, *index);
        return;
    }
    const int position = static_cast<int>(number);
    if (state.seenTags.contains(position)) {
        reader.report(Severity::Error, {LevelCode("duplicate-tag-index"), {std::to_string(position)}}, *index,
                      {&place, "index"});
    }
    state.seenTags = state.seenTags | TagMask::bit(position);
    state.tags.set(position, std::move(info));
    state.owner = &place;
    state.ownerPointer = "/tags/" + std::to_string(position);
    reader.finish();
}

void readTags(ReadState& state, FieldReader& level, const Place& parent) {
    const Place place{&parent, "tags"};
    const auto json = level.list("tags", false, place);
    if (!json) {
        return;
    }
    state.tags = TagTable::empty();
    level.eachObjectIn(*json, place, [&state](JsonView entry, const Place& here) { readTag(state, entry, here); });
}

/// The entries of a list that an old file may not have.
template <class T>
void readEntries(ReadState& state, FieldReader& level, const char* name, std::vector<T>& entries) {
    const Place place{&documentPlace, name};
    const auto json = level.list(name, false, place);
    if (!json) {
        return;
    }
    level.eachObjectIn(*json, place, [&state, &entries](JsonView item, const Place& here) {
        FieldReader reader(state, item, here);
        visitFields(reader, entries.emplace_back());
        state.owner = &here;
        state.ownerPointer = here.pointer();
        reader.finish();
    });
}

/// The key of an object, 0 after reporting that it has none.
Key readKey(ReadState& state, FieldReader& reader, const Place& place) {
    const auto json = reader.member("key", true);
    if (!json) {
        return 0;
    }
    const std::optional<Key> key = json->isText() ? keyFromText(json->text()) : std::nullopt;
    if (!key) {
        reader.reject("bad-key", {&place, "key"}, *json);
    }
    state.object = key.value_or(0);
    return state.object;
}

std::optional<Object> readObject(ReadState& state, JsonView json, const Place& place) {
    state.object = 0;
    state.owner = &place;
    state.ownerPointer.clear();
    state.unknownFields.take(); // those of an object that was left out
    FieldReader reader(state, json, place);
    Object object;
    object.key = readKey(state, reader, place);
    const auto type = reader.member("type", true);
    visitFields(reader, object);
    const int kind = type ? reader.spelling(*type, "type", objectTypeNames) : -1;
    if (kind < 0) {
        return {};
    }
    object.data = emptyData(kind);
    std::visit([&reader](auto& data) { visitFields(reader, data); }, object.data);
    reader.finish();
    object.unknownFields = state.unknownFields.take();
    return object;
}

/// Calls `take(item, object)` for each object of the member "objects" that could be read without an error.
template <class Take>
void readObjectList(ReadState& state, FieldReader& document, JsonView list, const Take& take) {
    const Place place{&documentPlace, "objects"};
    std::map<Key, int> lines;
    document.eachObjectIn(list, place, [&](JsonView item, const Place& here) {
        const bool errorsBefore = std::exchange(state.hasErrors, false);
        std::optional<Object> object = readObject(state, item, here);
        if (object && object->key != 0) {
            const auto [first, isNew] = lines.emplace(object->key, item.line());
            if (!isNew) {
                document.report(Severity::Error,
                                {LevelCode("duplicate-key"), {keyText(object->key), std::to_string(first->second)}},
                                item, here);
            }
        }
        if (object && !state.hasErrors) {
            take(item, std::move(*object));
        }
        state.hasErrors = state.hasErrors || errorsBefore;
    });
    state.object = 0;
}

void addDuplicateNames(ReadState& state, const JsonTree& tree) {
    for (Problem& problem : tree.duplicateNames()) {
        state.hasErrors = true;
        state.problems.push_back(std::move(problem));
    }
}

void readRope(ReadState& state, FieldReader& rules, const Place& rulesPlace, RopeRules& out) {
    const auto rope = rules.member("rope", false);
    const Place ropePlace{&rulesPlace, "rope"};
    if (rope && rope->isObject()) {
        FieldReader reader(state, *rope, ropePlace);
        visitFields(reader, out);
        reader.finish();
    } else if (rope) {
        rules.reject("not-an-object", ropePlace, *rope);
    }
}

/// False when the document is no object or of a schema that this version cannot read; it has then been reported.
bool checkDocument(ReadState& state, const JsonTree& tree) {
    if (std::optional<Problem> problem = schemaProblem(tree)) {
        state.hasErrors = true;
        state.problems.push_back(std::move(*problem));
        return false;
    }
    addDuplicateNames(state, tree);
    return true;
}

} // namespace

LevelReading readTree(const JsonTree& tree) {
    ReadState state;
    if (!checkDocument(state, tree)) {
        return {{}, std::move(state.problems), 0};
    }
    state.owner = &documentPlace;
    Level level;
    FieldReader reader(state, tree.root(), documentPlace);
    reader.member("schema", true);
    visitFields(reader, level);
    const auto rules = reader.member("rules", false);
    const Place rulesPlace{&documentPlace, "rules"};
    if (rules && rules->isObject()) {
        FieldReader rulesReader(state, *rules, rulesPlace);
        visitFields(rulesReader, level.rules);
        readRope(state, rulesReader, rulesPlace, level.rules.rope);
        rulesReader.finish();
    } else if (rules) {
        reader.reject("not-an-object", rulesPlace, *rules);
    }
    readTags(state, reader, documentPlace);
    readEntries(state, reader, "guides", level.guides);
    readEntries(state, reader, "hiddenProblems", level.hiddenProblems);
    const auto objects = reader.list("objects", true, {&documentPlace, "objects"});
    state.owner = &documentPlace;
    state.ownerPointer.clear();
    reader.finish();
    level.unknownFields = state.unknownFields.take();
    level.tags = state.tags;
    if (objects) {
        readObjectList(state, reader, *objects,
                       [&level](JsonView, Object object) { level.objects.append(std::move(object)); });
    }
    LevelReading reading;
    reading.unlisted =
        state.errors + state.others - std::min(state.errors, maxProblems) - std::min(state.others, maxProblems);
    reading.problems = std::move(state.problems);
    if (!state.hasErrors) {
        reading.level = std::move(level);
    }
    return reading;
}

ForeignObjects readObjects(const JsonTree& tree, std::vector<Problem>& problems) {
    ReadState state;
    state.tags = TagTable::empty();
    state.adoptsTags = true;
    ForeignObjects result;
    if (checkDocument(state, tree)) {
        state.owner = &documentPlace;
        FieldReader reader(state, tree.root(), documentPlace);
        readTags(state, reader, documentPlace);
        if (const auto objects = reader.list("objects", true, {&documentPlace, "objects"})) {
            std::vector<std::uint32_t> duplicates = tree.duplicateMembers();
            std::ranges::sort(duplicates);
            readObjectList(state, reader, *objects, [&result, &duplicates](JsonView item, Object object) {
                const auto first = std::ranges::lower_bound(duplicates, item.index());
                if (first == duplicates.end() || *first >= item.node().end) {
                    result.objects.push_back(std::move(object));
                }
            });
        }
    }
    result.tags = state.tags;
    std::ranges::move(state.problems, std::back_inserter(problems));
    return result;
}

} // namespace spacetow
