// Parsing is nlohmann-json's job; this file counts lines, builds the flat tree and says what went wrong where.

#include "core/level/fields.h"
#include "core/level/json_text.h"
#include "core/level/json_tree.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <unordered_map>

namespace spacetow {

namespace {

/// How far the lexer has read.
struct LineCount {
    std::uint32_t line = 1;
    bool atNewline = false; // the last character read ends a line
    const char* next = nullptr;
};

/// Goes over the text and counts the lines that the lexer has read.
class CountingIterator {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator() = default;
    CountingIterator(const char* at, LineCount* count) : m_at(at), m_count(count) {}
    const char& operator*() const { return *m_at; }
    CountingIterator& operator++() {
        m_count->atNewline = *m_at == '\n';
        m_count->line += m_count->atNewline ? 1 : 0;
        ++m_at;
        m_count->next = m_at;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return m_at == other.m_at; }
    bool operator!=(const CountingIterator& other) const { return m_at != other.m_at; }

  private:
    const char* m_at = nullptr;
    LineCount* m_count = nullptr;
};

int lineOf(std::string_view text, std::size_t position) {
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, position), '\n'));
}

/// The letters, digits and signs around a position: what a person would call the word that is wrong.
std::string wordAt(std::string_view text, std::size_t position) {
    const auto isPart = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
               std::string_view("+-._").find(c) != std::string_view::npos;
    };
    if (position >= text.size() || !isPart(text[position])) {
        return position < text.size() ? std::string(1, text[position]) : std::string();
    }
    std::size_t begin = position;
    std::size_t end = position;
    while (begin > 0 && isPart(text[begin - 1]) && position - begin < 40) {
        --begin;
    }
    while (end < text.size() && isPart(text[end]) && end - position < 40) {
        ++end;
    }
    return std::string(text.substr(begin, end - begin));
}

Problem problemAt(std::string_view text, std::size_t position, LevelCode code, std::vector<std::string> arguments) {
    Problem problem;
    problem.code = code;
    problem.arguments = std::move(arguments);
    problem.line = lineOf(text, position);
    return problem;
}

bool isNotFiniteWord(std::string word) {
    std::erase_if(word, [](char c) { return c == '-' || c == '+'; });
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return word == "nan" || word == "inf" || word == "infinity";
}

/// Something at `position` is not what JSON allows there.
Problem syntaxProblem(std::string_view text, std::size_t position) {
    if (position >= text.size()) {
        return problemAt(text, text.size(), "unexpected-end", {});
    }
    if (text[position] == '\n') { // elsewhere a line break is never wrong
        return problemAt(text, position, "open-text", {});
    }
    if (static_cast<unsigned char>(text[position]) < 0x20) {
        return problemAt(text, position, "control-character", {std::to_string(text[position])});
    }
    const std::string word = wordAt(text, position);
    if (isNotFiniteWord(word)) {
        return problemAt(text, position, "not-finite-literal", {word});
    }
    const std::size_t before = position == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", position - 1);
    if ((word == "]" || word == "}") && before != std::string_view::npos && text[before] == ',') {
        return problemAt(text, before, "trailing-comma", {word});
    }
    return problemAt(text, position, "not-json", {word});
}

/// Problems that nlohmann-json would not see, or would report without a useful place.
std::optional<Problem> rawProblem(std::string_view text) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        return problemAt(text, 0, "empty-file", {});
    }
    for (std::size_t i = 0; i < text.size();) {
        const int length = utf8Length(text.substr(i, 4));
        if (length == 0) {
            return problemAt(text, i, "not-utf8", {});
        }
        if (text[i] == '\0') {
            return problemAt(text, i, "zero-byte", {});
        }
        i += static_cast<std::size_t>(length);
    }
    return {};
}

} // namespace

// NOLINTBEGIN(readability-identifier-naming): the names are the library's
/// Receives nlohmann-json's events.
class JsonTreeBuilder {
  public:
    JsonTreeBuilder(std::string_view text, const LineCount& lines) : m_text(text), m_lines(lines) {
        m_tree.m_text = text;
        m_tree.m_names.emplace_back();
        m_vertices = nameIndex("vertices");
    }

    bool null() { return addLiteral(JsonKind::Null); }
    bool boolean(bool value) { return addLiteral(value ? JsonKind::True : JsonKind::False); }
    bool number_integer(std::int64_t value) {
        return addNumber(JsonKind::Integer, [&](JsonNode& n) { n.integer = value; });
    }
    bool number_unsigned(std::uint64_t value) {
        return addNumber(JsonKind::Unsigned, [&](JsonNode& n) { n.natural = value; });
    }
    bool number_float(double value, const std::string&) {
        return addNumber(JsonKind::Float, [&](JsonNode& n) { n.real = value; });
    }
    bool string(std::string& value) {
        m_tree.m_texts.push_back(std::move(value));
        return add(JsonKind::String, [this](JsonNode& n) { n.natural = m_tree.m_texts.size() - 1; });
    }
    bool binary(std::vector<std::uint8_t>&) { return false; }
    bool start_object(std::size_t) { return open(JsonKind::Object); }
    bool end_object() { return close(); }
    bool start_array(std::size_t) {
        if (!m_open.empty()) {
            const JsonNode& parent = m_tree.m_nodes[m_open.back()];
            if (parent.kind == JsonKind::Array && parent.name == m_vertices && ++m_vertexCount > limits::vertices) {
                return refuse("too-many-vertices", {std::to_string(limits::vertices)});
            }
        }
        return open(JsonKind::Array);
    }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        m_name = nameIndex(std::move(name));
        m_before = read();
        return true;
    }
    bool parse_error(std::size_t position, const std::string& token, const nlohmann::detail::exception& e) {
        const std::size_t at = position == 0 ? 0 : position - 1;
        if (dynamic_cast<const nlohmann::detail::out_of_range*>(&e) != nullptr) {
            m_problem = problemAt(m_text, at, "number-too-large", {token.substr(0, 40)});
        } else {
            m_problem = syntaxProblem(m_text, at);
        }
        return false;
    }

    std::variant<JsonTree, Problem> result() && {
        if (m_problem) {
            return std::move(*m_problem);
        }
        return std::move(m_tree);
    }

  private:
    std::uint32_t nameIndex(std::string name) {
        const auto [found, isNew] = m_names.emplace(std::move(name), static_cast<std::uint32_t>(m_tree.m_names.size()));
        if (isNew) {
            m_tree.m_names.push_back(found->first);
        }
        return found->second;
    }
    template <class Fill>
    bool add(JsonKind kind, Fill fill, std::uint32_t line) {
        if (m_tree.m_nodes.size() >= JsonTree::maxValues) {
            return refuse("too-many-values", {std::to_string(JsonTree::maxValues)});
        }
        JsonNode node{};
        node.kind = kind;
        node.line = line;
        node.name = std::exchange(m_name, 0) & 0xffffffu;
        node.begin = begin();
        node.end = static_cast<std::uint32_t>(m_tree.m_nodes.size()) + 1;
        fill(node);
        m_tree.m_nodes.push_back(node);
        return true;
    }
    template <class Fill>
    bool add(JsonKind kind, Fill fill) {
        const bool added = add(kind, fill, m_lines.line);
        m_before = read();
        return added;
    }
    std::size_t read() const {
        return m_lines.next == nullptr ? 0 : static_cast<std::size_t>(m_lines.next - m_text.data());
    }
    /// Of the value that has just been read.
    std::uint32_t begin() const {
        return static_cast<std::uint32_t>(std::min(m_text.find_first_not_of(" \t\r\n,:", m_before), m_text.size()));
    }
    bool addLiteral(JsonKind kind) {
        return add(kind, [](JsonNode&) {});
    }
    /// The lexer has to read one character past a number to know that it ends.
    template <class Fill>
    bool addNumber(JsonKind kind, Fill fill) {
        const bool added = add(kind, fill, m_lines.line - (m_lines.atNewline ? 1 : 0));
        m_before = std::min(m_text.find_first_of(" \t\r\n,]}", begin()), m_text.size());
        return added;
    }
    bool open(JsonKind kind) {
        if (m_open.size() >= static_cast<std::size_t>(JsonTree::maxDepth)) {
            return refuse("nested-too-deep", {std::to_string(JsonTree::maxDepth)});
        }
        m_open.push_back(static_cast<std::uint32_t>(m_tree.m_nodes.size()));
        return addLiteral(kind);
    }
    bool close() {
        m_tree.m_nodes[m_open.back()].end = static_cast<std::uint32_t>(m_tree.m_nodes.size());
        m_open.pop_back();
        m_before = read();
        return true;
    }
    bool refuse(LevelCode code, std::vector<std::string> arguments) {
        Problem problem;
        problem.code = code;
        problem.arguments = std::move(arguments);
        problem.line = static_cast<int>(m_lines.line);
        m_problem = std::move(problem);
        return false;
    }

    std::string_view m_text;
    const LineCount& m_lines;
    JsonTree m_tree;
    std::unordered_map<std::string, std::uint32_t> m_names;
    std::vector<std::uint32_t> m_open;
    std::uint32_t m_name = 0;
    std::uint32_t m_vertices = 0;
    std::size_t m_before = 0; // the place after what was read before
    int m_vertexCount = 0;
    std::optional<Problem> m_problem;
};
// NOLINTEND(readability-identifier-naming)

std::variant<JsonTree, Problem> JsonTree::parsed(std::string_view text) {
    if (std::optional<Problem> problem = rawProblem(text)) {
        return std::move(*problem);
    }
    LineCount lines;
    JsonTreeBuilder builder(text, lines);
    nlohmann::json::sax_parse(CountingIterator(text.data(), &lines),
                              CountingIterator(text.data() + text.size(), &lines), &builder);
    return std::move(builder).result();
}

} // namespace spacetow
