#include "core/level/unknown_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <unordered_set>

namespace spacetow {

namespace {

/// A spelled name as the last segment of a pointer: "~" and "/" escaped, and an escaped "/" first made a plain one.
std::string segmentOf(std::string_view spelled) {
    std::string plain;
    for (std::size_t i = 0; i < spelled.size(); ++i) {
        if (spelled[i] == '\\' && i + 1 < spelled.size()) {
            plain += spelled[i + 1] == '/' ? "" : "\\";
            plain += spelled[++i];
        } else {
            plain += spelled[i];
        }
    }
    return pointerSegment(plain);
}

/// Calls `visit(place, name, value)`, all as they are spelled in the text.
template <class Visit>
void visitUnknown(const std::string& text, Visit visit) {
    if (text.empty()) {
        return;
    }
    const auto parsed = JsonTree::parsed(text);
    const auto* tree = std::get_if<JsonTree>(&parsed);
    if (tree == nullptr || !tree->root().isObject()) {
        return;
    }
    for (const JsonView member : tree->root()) {
        const std::string_view pointer = member.spelledName();
        const std::size_t last = pointer.rfind('/');
        if (last != std::string_view::npos) {
            visit(pointer.substr(0, last), pointer.substr(last + 1), member.source());
        }
    }
}

std::string unescaped(std::string_view segment) {
    const std::vector<std::string> segments = pointerSegments('/' + std::string(segment));
    return segments.front();
}

void addSpelled(std::string& members, std::string_view place, std::string_view segment, std::string_view value) {
    members += members.empty() ? "\"" : ", \"";
    members.append(place).append("/").append(segment).append("\": ").append(value);
}

std::string inBraces(const std::string& members) {
    return members.empty() ? members : '{' + members + '}';
}

} // namespace

void UnknownCollection::add(const std::string& place, JsonView member) {
    std::string text;
    addSpelled(text, place, segmentOf(member.spelledName()), member.source());
    m_members.emplace_back(place, std::move(text));
}

std::string UnknownCollection::take() {
    std::stable_sort(m_members.begin(), m_members.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string members;
    for (const auto& [place, text] : m_members) {
        members += (members.empty() ? "" : ", ") + text;
    }
    m_members.clear();
    return inBraces(members);
}

std::vector<UnknownField> unknownFields(const std::string& text) {
    std::vector<UnknownField> fields;
    visitUnknown(text, [&fields](std::string_view place, std::string_view segment, std::string_view value) {
        fields.push_back({std::string(place), unescaped(segment), std::string(value)});
    });
    return fields;
}

std::string unknownFieldsText(std::span<const UnknownField> fields) {
    std::string members;
    for (const UnknownField& field : fields) {
        addSpelled(members, field.place, pointerSegment(field.name), field.value);
    }
    return inBraces(members);
}

std::string withEntriesSwapped(const std::string& text, const std::string& list, int a, int b) {
    const std::array places{list + '/' + std::to_string(a), list + '/' + std::to_string(b)};
    std::vector<UnknownField> fields = unknownFields(text);
    for (UnknownField& field : fields) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const std::string& place = places[i];
            if (field.place.starts_with(place) && (field.place + '/')[place.size()] == '/') {
                field.place.replace(0, place.size(), places[1 - i]);
                break;
            }
        }
    }
    std::ranges::stable_sort(fields, {}, &UnknownField::place); // as a reader has them
    return unknownFieldsText(fields);
}

std::string withoutEntries(const std::string& text, const std::string& list, std::span<const int> lost) {
    const std::string start = list + '/';
    std::string kept;
    visitUnknown(text, [&](std::string_view place, std::string_view segment, std::string_view value) {
        std::string now(place);
        int index = -1;
        if (place.starts_with(start)) {
            const char* end = place.data() + place.size();
            const auto [rest, error] = std::from_chars(place.data() + start.size(), end, index);
            const auto after = std::ranges::lower_bound(lost, index);
            if (error == std::errc{} && after != lost.end() && *after == index) {
                return;
            }
            if (error == std::errc{}) {
                now = start + std::to_string(index - (after - lost.begin())) + std::string(rest, end);
            }
        }
        addSpelled(kept, now, segment, value);
    });
    return inBraces(kept);
}

void insertUnknownFields(JsonText& out, const std::string& text,
                         const std::function<std::string(const std::string& place)>& moved) {
    // All of a place at once, as looking for a place and for what is in it takes time.
    std::map<std::string, std::vector<UnknownField>> places;
    visitUnknown(text, [&places](std::string_view place, std::string_view segment, std::string_view value) {
        places[std::string(place)].push_back({{}, unescaped(segment), std::string(value)});
    });
    // The outer places come first in the map, and adding to them moves the inner ones: these are therefore looked for
    // when it is their turn, and found before what was added, which stands behind.
    for (auto& [from, fields] : places) {
        const std::string place = moved && !from.empty() ? moved(from) : from;
        JsonText* found = from.empty() || !place.empty() ? out.at(pointerSegments(place)) : nullptr;
        if (found == nullptr || !found->isObject()) {
            continue;
        }
        std::unordered_set<std::string> taken;
        for (int i = 0; i < found->size(); ++i) {
            taken.insert(found->spelledName(i));
        }
        for (UnknownField& field : fields) {
            std::string name = '"' + field.name + '"';
            if (taken.insert(name).second) {
                found->appendSpelled(std::move(name), JsonText::raw(std::move(field.value)));
            }
        }
    }
}

} // namespace spacetow
