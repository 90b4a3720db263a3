#include "editor/exchange/file_mark.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

constexpr std::string_view markBlanks = " \t\r\n";

/// Goes through the members of the outermost object only.
class MemberScan {
  public:
    explicit MemberScan(std::string_view text) : m_text(text) {}

    FileMark mark() {
        while (m_at < m_text.size()) {
            const char c = m_text[m_at];
            if (c == '"') {
                const std::string_view word = string();
                if (const FileMark found = markOfWord(word); found != FileMark::None) {
                    return found;
                }
                continue;
            }
            m_depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
            ++m_at;
        }
        return FileMark::None;
    }

  private:
    /// Without quotes, escapes as they are; empty when the text ends before.
    std::string_view string() {
        const std::size_t start = ++m_at;
        while (m_at < m_text.size() && m_text[m_at] != '"') {
            m_at += m_text[m_at] == '\\' ? 2 : 1;
        }
        const bool whole = m_at < m_text.size();
        m_at = std::min(m_at, m_text.size());
        return m_text.substr(start, whole ? m_at++ - start : 0);
    }

    bool isNext(char wanted) {
        m_at = std::min(m_text.find_first_not_of(markBlanks, m_at), m_text.size());
        return m_at < m_text.size() && m_text[m_at] == wanted;
    }

    FileMark markOfWord(std::string_view word) {
        if (m_depth != 1 || !isNext(':')) {
            return FileMark::None;
        }
        ++m_at;
        if (word == "schema" || word == "objects") {
            return FileMark::Level;
        }
        if (word == "replay") {
            return FileMark::Replay;
        }
        if (word == "tilewidth" || (word == "body" && isNext('['))) {
            return FileMark::Foreign;
        }
        if (word == "type" && isNext('"')) {
            const std::string_view type = string();
            return type == "map" || type == "tileset" || type == "template" ? FileMark::Foreign : FileMark::None;
        }
        return FileMark::None;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    int m_depth = 0;
};

/// By the first element, after declarations and comments.
FileMark markOfXml(std::string_view text) {
    constexpr std::array<std::string_view, 4> roots{"svg", "map", "tileset", "template"};
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string_view::npos;) {
        const std::string_view rest = text.substr(at + 1);
        if (rest.starts_with("!--")) {
            at = std::min(text.find("-->", at), text.size());
        } else if (rest.starts_with('!') || rest.starts_with('?')) {
            ++at; // what stands inside of it begins with one of these as well
        } else {
            std::string_view name = rest.substr(0, rest.find_first_of(" \t\r\n/>"));
            if (name.size() == rest.size()) {
                return FileMark::None; // there is more of it
            }
            name.remove_prefix(name.find(':') == std::string_view::npos ? 0 : name.find(':') + 1);
            return std::ranges::find(roots, name) == roots.end() ? FileMark::None : FileMark::Foreign;
        }
    }
    return FileMark::None;
}

} // namespace

FileMark markOf(std::string_view text) {
    using namespace std::string_view_literals;
    if (text.starts_with("\xff\xfe<\0"sv) || text.starts_with("\xfe\xff\0<"sv)) {
        return FileMark::Foreign; // UTF-16, in which there is XML alone
    }
    if (text.starts_with("\xef\xbb\xbf")) {
        text.remove_prefix(3);
    }
    const std::size_t first = text.find_first_not_of(markBlanks);
    if (first == std::string_view::npos) {
        return FileMark::None;
    }
    text.remove_prefix(first);
    return text[0] == '<' ? markOfXml(text) : text[0] == '{' ? MemberScan(text).mark() : FileMark::None;
}

} // namespace spacetow
