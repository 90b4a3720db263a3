#include "core/level/json_tree.h"

#include "core/base/contract.h"
#include "core/level/json_text.h"

#include <algorithm>
#include <charconv>

namespace spacetow {

const JsonNode& JsonView::node() const {
    return m_tree->m_nodes[m_index];
}
JsonKind JsonView::kind() const {
    return node().kind;
}
int JsonView::line() const {
    return static_cast<int>(node().line);
}

bool JsonView::isNumber() const {
    return kind() == JsonKind::Integer || kind() == JsonKind::Unsigned || kind() == JsonKind::Float;
}

double JsonView::number() const {
    EXPECTS(isNumber());
    switch (kind()) {
    case JsonKind::Integer:
        return static_cast<double>(node().integer);
    case JsonKind::Unsigned:
        return static_cast<double>(node().natural);
    default:
        return node().real;
    }
}

const std::string& JsonView::text() const {
    EXPECTS(isText());
    return m_tree->m_texts[node().natural];
}

const std::string& JsonView::name() const {
    return m_tree->m_names[node().name];
}

JsonView::Iterator& JsonView::Iterator::operator++() {
    m_index = JsonView(*m_tree, m_index).node().end;
    return *this;
}

JsonView::Iterator JsonView::end() const {
    return {*m_tree, node().end};
}

int JsonView::size() const {
    int count = 0;
    for (auto i = begin(); !(i == end()); ++i) {
        ++count;
    }
    return count;
}

namespace {

/// The place after the text whose opening quote stands at `at`.
std::size_t afterText(std::string_view json, std::size_t at) {
    for (++at; json[at] != '"'; ++at) {
        at += json[at] == '\\' ? 1 : 0;
    }
    return at + 1;
}

/// The place after the value that starts at `at`. The text is known to be JSON.
std::size_t afterValue(std::string_view json, std::size_t at) {
    int depth = 0;
    do {
        const char c = json[at];
        if (c == '"') {
            at = afterText(json, at);
        } else if (c == '{' || c == '[') {
            ++depth;
            ++at;
        } else if (c == '}' || c == ']') {
            --depth;
            ++at;
        } else if (depth > 0) {
            ++at;
        } else {
            return std::min(json.find_first_of(" \t\r\n,]}", at), json.size());
        }
    } while (depth > 0);
    return at;
}

void spell(std::string& out, JsonView value, std::size_t limit) {
    switch (value.kind()) {
    case JsonKind::Null:
        out += "null";
        break;
    case JsonKind::False:
        out += "false";
        break;
    case JsonKind::True:
        out += "true";
        break;
    case JsonKind::Integer:
        out += std::to_string(value.node().integer);
        break;
    case JsonKind::Unsigned:
        out += std::to_string(value.node().natural);
        break;
    case JsonKind::Float:
        out += spelledNumber(value.number());
        break;
    case JsonKind::String:
        out += spelledText(value.text());
        break;
    case JsonKind::Array:
    case JsonKind::Object: {
        const bool isObject = value.isObject();
        out += isObject ? '{' : '[';
        bool first = true;
        for (const JsonView member : value) {
            if (out.size() > limit) {
                return;
            }
            out += first ? "" : ", ";
            first = false;
            if (isObject) {
                out += spelledText(member.name()) + ": ";
            }
            spell(out, member, limit);
        }
        out += isObject ? '}' : ']';
        break;
    }
    }
}

} // namespace

std::string JsonView::spelled(std::size_t limit) const {
    std::string out;
    spell(out, *this, limit);
    if (out.size() > limit) {
        std::size_t cut = 0;
        while (cut < limit) {
            cut += static_cast<std::size_t>(std::max(utf8Length(std::string_view(out).substr(cut)), 1));
        }
        out = out.substr(0, cut) + "…";
    }
    return out;
}

std::string_view JsonView::source() const {
    const std::string_view text = m_tree->m_text;
    const std::size_t begin = node().begin;
    return text.substr(begin, afterValue(text, begin) - begin);
}

std::string_view JsonView::spelledName() const {
    const std::string_view text = m_tree->m_text;
    const std::size_t end = text.rfind('"', text.rfind(':', node().begin - std::size_t{1}));
    // A quote within the name comes after an odd number of backslashes.
    std::size_t begin = end;
    for (bool escaped = true; escaped;) {
        begin = text.rfind('"', begin - 1);
        escaped = (begin - 1 - text.find_last_not_of('\\', begin - 1)) % 2 != 0;
    }
    return text.substr(begin + 1, end - begin - 1);
}

std::vector<std::uint32_t> JsonTree::duplicateMembers() const {
    std::vector<std::uint32_t> duplicates;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> members; // name, index
    for (std::uint32_t i = 0; i < m_nodes.size(); ++i) {
        if (m_nodes[i].kind != JsonKind::Object) {
            continue;
        }
        members.clear();
        for (const JsonView member : JsonView(*this, i)) {
            members.emplace_back(std::uint32_t{member.node().name}, member.index());
        }
        std::ranges::sort(members);
        for (std::size_t j = 1; j < members.size(); ++j) {
            if (members[j].first == members[j - 1].first) {
                duplicates.push_back(members[j].second);
            }
        }
    }
    return duplicates;
}

std::vector<Problem> JsonTree::duplicateNames() const {
    constexpr std::size_t enough = 1000;
    std::vector<Problem> problems;
    for (const std::uint32_t member : duplicateMembers()) {
        if (problems.size() == enough) {
            break;
        }
        Problem problem;
        problem.code = "duplicate-field";
        problem.arguments = {m_names[m_nodes[member].name]};
        problem.pointer = pointerTo(member);
        problem.line = static_cast<int>(m_nodes[member].line);
        problems.push_back(std::move(problem));
    }
    return problems;
}

std::string JsonTree::pointerTo(std::uint32_t index) const {
    std::string pointer;
    JsonView place = root();
    while (place.index() != index) {
        int position = 0;
        auto member = place.begin();
        while ((*member).node().end <= index) {
            ++member;
            ++position;
        }
        pointer += '/' + (place.isArray() ? std::to_string(position) : pointerSegment((*member).name()));
        place = *member;
    }
    return pointer;
}

int JsonTree::lineAt(std::string_view pointer) const {
    JsonView place = root();
    for (const std::string& segment : pointerSegments(pointer)) {
        bool found = false;
        int position = 0;
        int wanted = -1;
        std::from_chars(segment.data(), segment.data() + segment.size(), wanted);
        for (const JsonView member : place) {
            if (place.isArray() ? position++ == wanted : member.name() == segment) {
                place = member;
                found = true;
                break;
            }
        }
        if (!found) {
            break;
        }
    }
    return place.line();
}

std::string pointerSegment(std::string_view name) {
    std::string out;
    for (const char c : name) {
        if (c == '~') {
            out += "~0";
        } else if (c == '/') {
            out += "~1";
        } else {
            out += c;
        }
    }
    return out;
}

std::vector<std::string> pointerSegments(std::string_view pointer) {
    std::vector<std::string> segments;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            segments.emplace_back();
        } else if (segments.empty()) {
            break;
        } else if (pointer[i] == '~' && i + 1 < pointer.size()) {
            segments.back() += pointer[++i] == '1' ? '/' : '~';
        } else {
            segments.back() += pointer[i];
        }
    }
    return segments;
}

} // namespace spacetow
