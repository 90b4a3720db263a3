#include "core/level/field_reader.h"

#include "core/level/json_read.h"
#include "core/level/json_text.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr std::size_t excerpt = 40; // characters of a rejected value that are shown

std::string joined(std::span<const std::string_view> names) {
    std::string out;
    for (const std::string_view name : names) {
        out += out.empty() ? "" : ", ";
        out += name;
    }
    return out;
}

} // namespace

std::string Place::pointer() const {
    if (parent == nullptr) {
        return {};
    }
    return parent->pointer() + '/' + (index >= 0 ? std::to_string(index) : pointerSegment(name));
}

FieldReader::FieldReader(ReadState& state, JsonView object, const Place& place)
    : m_state(state), m_object(object), m_place(place), m_next(object.begin()) {
    EXPECTS(object.isObject());
}

void FieldReader::report(Severity severity, Error error, JsonView at, const Place& place) {
    m_state.hasErrors = m_state.hasErrors || severity == Severity::Error;
    std::size_t& count = severity == Severity::Error ? m_state.errors : m_state.others;
    if (count++ < maxProblems) { // whatever warnings there are, the errors among them are told
        m_state.problems.push_back(
            {severity, LevelCode(error.code), std::move(error.arguments), place.pointer(), at.line(), m_state.object});
    }
}

void FieldReader::reject(LevelCode code, const Place& place, JsonView value) {
    std::string name = place.index >= 0 ? std::string(place.parent->name) : std::string(place.name);
    report(Severity::Error, {code, {std::move(name), value.spelled(excerpt)}}, value, place);
}

std::optional<JsonView> FieldReader::member(const char* name, bool required) {
    m_known.emplace_back(name);
    const auto end = m_object.end();
    if (!(m_next == end) && (*m_next).name() == name) {
        const JsonView found = *m_next;
        ++m_next;
        return found;
    }
    for (auto i = m_object.begin(); !(i == end); ++i) {
        if ((*i).name() == name) {
            const JsonView found = *i;
            m_next = ++i;
            return found;
        }
    }
    if (required) {
        report(Severity::Error, {LevelCode("missing-field"), {name}}, m_object, m_place);
    }
    return {};
}

void FieldReader::number(const Field& field, double& value, double byDefault) {
    value = byDefault;
    if (const auto json = member(field.name, field.presence == Presence::Required)) {
        if (json->isNumber()) {
            value = json->number();
        } else {
            reject("not-a-number", {&m_place, field.name}, *json);
        }
    }
}

void FieldReader::integer(const Field& field, int& value, int byDefault) {
    value = byDefault;
    const auto json = member(field.name, field.presence == Presence::Required);
    if (!json) {
        return;
    }
    const Place place{&m_place, field.name};
    if (!json->isNumber() || json->number() != std::floor(json->number())) {
        reject("not-an-integer", place, *json);
    } else if (json->number() < field.min || json->number() > field.max) {
        report(Severity::Error,
               {LevelCode("out-of-range"),
                {field.name, json->spelled(excerpt), spelledNumber(field.min), spelledNumber(field.max)}},
               *json, place);
    } else {
        value = static_cast<int>(json->number());
    }
}

void FieldReader::optionalNumber(const Field& field, std::optional<double>& value) {
    value.reset();
    if (const auto json = member(field.name, false)) {
        if (json->isNumber()) {
            value = json->number();
        } else {
            reject("not-a-number", {&m_place, field.name}, *json);
        }
    }
}

void FieldReader::depth(const Field& field, double& value, double byDefault) {
    value = byDefault;
    if (const auto json = member(field.name, false)) {
        if (json->isNumber()) {
            value = json->number();
        } else if (json->kind() == JsonKind::Null) {
            value = noBack;
        } else {
            reject("not-a-depth", {&m_place, field.name}, *json);
        }
    }
}

void FieldReader::flag(const Field& field, bool& value, bool byDefault) {
    value = byDefault;
    if (const auto json = member(field.name, false)) {
        if (json->isBool()) {
            value = json->kind() == JsonKind::True;
        } else {
            reject("not-a-flag", {&m_place, field.name}, *json);
        }
    }
}

void FieldReader::text(const Field& field, std::string& value, const std::string& byDefault) {
    value = byDefault;
    if (const auto json = member(field.name, false)) {
        if (json->isText()) {
            value = json->text();
        } else {
            reject("not-a-text", {&m_place, field.name}, *json);
        }
    }
}

bool FieldReader::readPoint(JsonView value, Vec2& point) const {
    if (!value.isArray() || value.size() != 2) {
        return false;
    }
    auto i = value.begin();
    const JsonView x = *i;
    const JsonView y = *++i;
    if (!x.isNumber() || !y.isNumber()) {
        return false;
    }
    point = Vec2(x.number(), y.number());
    return true;
}

void FieldReader::point(const Field& field, Vec2& value, const Vec2& byDefault) {
    value = byDefault;
    const auto json = member(field.name, field.presence == Presence::Required);
    if (json && !readPoint(*json, value)) {
        reject("not-a-point", {&m_place, field.name}, *json);
    }
}

void FieldReader::points(const Field& field, std::vector<Vec2>& value) {
    value.clear();
    const Place place{&m_place, field.name};
    const auto json = list(field.name, true, place);
    if (!json) {
        return;
    }
    int index = 0;
    for (const JsonView vertex : *json) {
        value.emplace_back(0, 0);
        if (!readPoint(vertex, value.back())) {
            reject("not-a-point", {&place, {}, index}, vertex);
        }
        ++index;
    }
}

int FieldReader::tagOf(const std::string& text) {
    const int unnamed = unnamedTag(text);
    const std::optional<int> named = m_state.tags.indexOf(text);
    if (named || unnamed >= 0 || !m_state.adoptsTags || text.empty()) {
        return named.value_or(unnamed);
    }
    // From the end, away from the tags of the game and those that are numbered by hand.
    for (int tag = TagTable::size - 1; tag > debrisTag; --tag) {
        if (m_state.tags[tag].name.empty()) {
            m_state.tags.set(tag, {text});
            return tag;
        }
    }
    return -1;
}

TagMask FieldReader::maskOf(JsonView list, const Place& place) {
    TagMask mask;
    int index = 0;
    for (const JsonView tag : list) {
        const Place here{&place, {}, index++};
        if (!tag.isText()) {
            reject("not-a-text", here, tag);
            continue;
        }
        if (const int known = tagOf(tag.text()); known >= 0) {
            mask = mask | TagMask::bit(known);
        } else {
            report(Severity::Error, {LevelCode("unknown-tag"), {tag.text()}}, tag, here);
        }
    }
    return mask;
}

void FieldReader::tags(const Field& field, TagMask& value, TagMask byDefault) {
    value = byDefault;
    const Place place{&m_place, field.name};
    if (const auto json = list(field.name, false, place)) {
        value = maskOf(*json, place);
    }
}

void FieldReader::touches(const Field& field, TagMask& value) {
    value = TagMask::all();
    if (const auto json = member(field.name, false)) {
        const Place place{&m_place, field.name};
        if (json->isArray()) {
            value = maskOf(*json, place);
        } else if (json->isObject() && json->size() == 1 && (*json->begin()).name() == "except" &&
                   (*json->begin()).isArray()) {
            value = TagMask{~maskOf(*json->begin(), {&place, "except"}).bits};
        } else if (!json->isText() || json->text() != "all") {
            reject("not-touches", place, *json);
        }
    }
}

void FieldReader::readKey(const Field& field, JsonView json, Key& value) {
    const std::optional<Key> read = json.isText() ? keyFromText(json.text()) : std::nullopt;
    if (read) {
        value = *read;
    } else {
        reject("bad-key", {&m_place, field.name}, json);
    }
}

void FieldReader::key(const Field& field, Key& value) {
    if (const auto json = member(field.name, true)) {
        readKey(field, *json, value);
    }
}

void FieldReader::optionalKey(const Field& field, Key& value) {
    value = 0;
    if (const auto json = member(field.name, false)) {
        readKey(field, *json, value);
    }
}

void FieldReader::optionalColor(const Field& field, std::optional<std::uint32_t>& value) {
    value.reset();
    if (const auto json = member(field.name, false)) {
        value = json->isText() ? colorFromText(json->text()) : std::nullopt;
        if (!value) {
            reject("bad-color", {&m_place, field.name}, *json);
        }
    }
}

int FieldReader::spelling(JsonView value, std::string_view name, std::span<const std::string_view> names) {
    const auto found = value.isText() ? std::ranges::find(names, value.text()) : names.end();
    if (found != names.end()) {
        return static_cast<int>(found - names.begin());
    }
    report(Severity::Error, {LevelCode("unknown-choice"), {std::string(name), value.spelled(excerpt), joined(names)}},
           value, {&m_place, name});
    return -1;
}

void FieldReader::chooseFrom(const Field& field, int& index, std::span<const std::string_view> names) {
    if (const auto json = member(field.name, field.presence == Presence::Required)) {
        const int read = spelling(*json, field.name, names);
        index = read >= 0 ? read : index;
    }
}

void FieldReader::shapes(const Field& field, std::vector<LevelShape>& value) {
    value.clear();
    const Place place{&m_place, field.name};
    const auto json = list(field.name, true, place);
    if (!json) {
        return;
    }
    eachObjectIn(*json, place, [this, &value](JsonView item, const Place& here) {
        FieldReader reader(m_state, item, here);
        const auto type = reader.member("type", true);
        const int kind = type ? reader.spelling(*type, "type", shapeTypeNames) : -1;
        if (kind < 0) {
            return;
        }
        constexpr auto makers =
            std::array{+[]() -> LevelShape { return EdgeChain(); }, +[]() -> LevelShape { return LineChain(); },
                       +[]() -> LevelShape { return Polygon(); }, +[]() -> LevelShape { return Circle(); }};
        LevelShape shape = makers[static_cast<std::size_t>(kind)]();
        std::visit([&reader](auto& s) { visitFields(reader, s); }, shape);
        reader.finish();
        value.push_back(std::move(shape));
    });
}

std::optional<JsonView> FieldReader::list(const char* name, bool required, const Place& place) {
    auto json = member(name, required);
    if (json && !json->isArray()) {
        reject("not-a-list", place, *json);
        json.reset();
    }
    return json;
}

void FieldReader::finish() {
    std::string where; // made for the first
    bool isMade = false;
    for (const JsonView value : m_object) {
        if (std::ranges::find(m_known, value.name()) != m_known.end()) {
            continue;
        }
        if (!std::exchange(isMade, true)) {
            where = m_state.ownerPointer + m_place.pointer().substr(m_state.owner->pointer().size());
        }
        report(Severity::Warning, {LevelCode("unknown-field"), {std::string(value.name())}}, value,
               {&m_place, value.name()});
        m_state.unknownFields.add(where, value);
    }
}

} // namespace spacetow
