#include "core/level/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

namespace spacetow {

namespace {

constexpr std::size_t maxWidth = 120; // characters of a line
constexpr std::size_t anyWidth = std::numeric_limits<std::size_t>::max();

} // namespace

std::string spelledNumber(double value) {
    if (!std::isfinite(value)) {
        return "null";
    }
    std::array<char, 32> buffer{};
    const double size = std::abs(value);
    // Plain notation where people would use it; to_chars alone would write 100000 as 1e+05.
    const auto format =
        size == 0 || (size >= 1e-5 && size < 1e15) ? std::chars_format::fixed : std::chars_format::general;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), size == 0 ? 0.0 : value, format).ptr;
    return {buffer.data(), end};
}

int utf8Length(std::string_view text) {
    if (text.empty()) {
        return 0;
    }
    const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const int length = first < 0x80 ? 1 : first >> 5 == 6 ? 2 : first >> 4 == 14 ? 3 : first >> 3 == 30 ? 4 : 0;
    if (length < 2) {
        return length;
    }
    if (text.size() < static_cast<std::size_t>(length)) {
        return 0;
    }
    std::uint32_t code = first & (0x7fu >> length);
    for (int i = 1; i < length; ++i) {
        const unsigned next = byte(static_cast<std::size_t>(i));
        if (next >> 6 != 2) {
            return 0;
        }
        code = code << 6 | (next & 0x3fu);
    }
    constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool isSurrogate = code >= 0xd800 && code < 0xe000;
    return code < least[static_cast<std::size_t>(length)] || code > 0x10ffff || isSurrogate ? 0 : length;
}

std::string spelledText(std::string_view value) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string out = "\"";
    while (!value.empty()) {
        const char c = value.front();
        const int length = utf8Length(value);
        if (length == 0) {
            out += "\xef\xbf\xbd";
        } else if (c == '"' || c == '\\') {
            out += {'\\', c};
        } else if (c == '\n') {
            out += "\\n";
        } else if (c == '\t') {
            out += "\\t";
        } else if (static_cast<unsigned char>(c) < 0x20) {
            const auto code = static_cast<unsigned char>(c);
            out += {'\\', 'u', '0', '0', hex[code >> 4u], hex[code & 15u]};
        } else {
            out += value.substr(0, static_cast<std::size_t>(length));
        }
        value.remove_prefix(length == 0 ? 1 : static_cast<std::size_t>(length));
    }
    return out + '"';
}

JsonText JsonText::raw(std::string json) {
    JsonText result;
    result.m_scalar = std::move(json);
    return result;
}

JsonText JsonText::number(double value) {
    return raw(spelledNumber(value));
}
JsonText JsonText::integer(long long value) {
    return raw(std::to_string(value));
}
JsonText JsonText::flag(bool value) {
    return raw(value ? "true" : "false");
}
JsonText JsonText::text(std::string_view value) {
    return raw(spelledText(value));
}
JsonText JsonText::null() {
    return raw("null");
}

JsonText JsonText::array() {
    JsonText result;
    result.m_kind = Kind::Array;
    return result;
}

JsonText JsonText::object() {
    JsonText result;
    result.m_kind = Kind::Object;
    return result;
}

JsonText JsonText::broken() && {
    m_broken = true;
    return std::move(*this);
}

void JsonText::append(std::string_view name, JsonText value) {
    m_members.emplace_back(spelledText(name), std::move(value));
}

JsonText* JsonText::at(const std::vector<std::string>& segments) {
    JsonText* place = this;
    for (const std::string& segment : segments) {
        std::size_t index = place->m_members.size();
        if (place->m_kind == Kind::Array) {
            std::from_chars(segment.data(), segment.data() + segment.size(), index);
        } else {
            const std::string name = spelledText(segment);
            const auto found = std::ranges::find(place->m_members, name, &std::pair<std::string, JsonText>::first);
            index = static_cast<std::size_t>(found - place->m_members.begin());
        }
        if (index >= place->m_members.size()) {
            return nullptr;
        }
        place = &place->m_members[index].second;
    }
    return place;
}

bool JsonText::addOnOneLine(std::string& out, std::size_t limit) const {
    if (m_kind == Kind::Scalar) {
        out += m_scalar;
        return out.size() <= limit && (limit == anyWidth || m_scalar.find('\n') == std::string::npos);
    }
    out += m_kind == Kind::Array ? '[' : '{';
    bool first = true;
    for (const auto& [name, value] : m_members) {
        if (!first) {
            out += ", ";
        }
        first = false;
        if (m_kind == Kind::Object) {
            out += name;
            out += ": ";
        }
        if ((value.m_broken && !value.m_members.empty() && limit != anyWidth) || !value.addOnOneLine(out, limit)) {
            return false;
        }
    }
    out += m_kind == Kind::Array ? ']' : '}';
    return out.size() <= limit;
}

void JsonText::addLaidOut(std::string& out, int depth, std::size_t lineStart) const {
    const std::size_t start = out.size();
    const bool mustBreak = m_broken && !m_members.empty();
    // One place is kept free for the comma that may follow.
    if (m_kind == Kind::Scalar || (!mustBreak && addOnOneLine(out, lineStart + maxWidth - 1))) {
        if (m_kind == Kind::Scalar) {
            out += m_scalar;
        }
        return;
    }
    out.resize(start);
    out += m_kind == Kind::Array ? '[' : '{';
    const std::string indent(static_cast<std::size_t>(depth + 1) * 2, ' ');
    bool first = true;
    for (const auto& [name, value] : m_members) {
        out += first ? "\n" : ",\n";
        first = false;
        const std::size_t begin = out.size();
        out += indent;
        if (m_kind == Kind::Object) {
            out += name;
            out += ": ";
        }
        value.addLaidOut(out, depth + 1, begin);
    }
    out += '\n';
    out.append(static_cast<std::size_t>(depth) * 2, ' ');
    out += m_kind == Kind::Array ? ']' : '}';
}

std::string JsonText::onOneLine() const {
    std::string out;
    addOnOneLine(out, anyWidth);
    return out;
}

std::string JsonText::laidOut() const {
    std::string out;
    addLaidOut(out, 0, 0);
    return out + '\n';
}

} // namespace spacetow
