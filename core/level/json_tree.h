#pragma once
// JSON text as a flat array of values in the order of the file, each with its line. Bounded: deep nesting, too many
// values and too many vertices are refused while parsing, so that no file takes long or much memory.

#include "core/base/result.h"
#include "core/level/problem.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace spacetow {

enum class JsonKind : std::uint8_t { Null, False, True, Integer, Unsigned, Float, String, Array, Object };

struct JsonNode {
    JsonKind kind : 8;
    std::uint32_t name : 24; // place of the member's name among the names; 0 for values that have none
    std::uint32_t line;      // from 1
    std::uint32_t begin;     // of its spelling in the text
    std::uint32_t end;       // index after the last value inside this one
    union {
        std::int64_t integer;
        std::uint64_t natural; // also the place of a text among the texts
        double real;
    };
};

static_assert(sizeof(JsonNode) == 24); // there may be millions

class JsonTree;

/// One value of a tree. Valid as long as the tree is.
class JsonView {
  public:
    JsonView(const JsonTree& tree, std::uint32_t index) : m_tree(&tree), m_index(index) {}

    JsonKind kind() const;
    int line() const;
    bool isObject() const { return kind() == JsonKind::Object; }
    bool isArray() const { return kind() == JsonKind::Array; }
    bool isNumber() const;
    bool isBool() const { return kind() == JsonKind::True || kind() == JsonKind::False; }
    bool isText() const { return kind() == JsonKind::String; }

    double number() const;           // isNumber()
    const std::string& text() const; // isText()
    /// Name of this value as a member of an object, else empty.
    const std::string& name() const;
    /// The value as compact JSON, cut off after about `limit` characters.
    std::string spelled(std::size_t limit) const;
    /// The value as the text spells it.
    std::string_view source() const;
    /// Its name as the text spells it, between the quotes.
    std::string_view spelledName() const;

    std::uint32_t index() const { return m_index; }
    const JsonNode& node() const;

    class Iterator {
      public:
        Iterator(const JsonTree& tree, std::uint32_t index) : m_tree(&tree), m_index(index) {}
        JsonView operator*() const { return {*m_tree, m_index}; }
        Iterator& operator++();
        bool operator==(const Iterator& other) const { return m_index == other.m_index; }

      private:
        const JsonTree* m_tree;
        std::uint32_t m_index;
    };
    /// Over the values directly inside an array or object.
    Iterator begin() const { return {*m_tree, m_index + 1}; }
    Iterator end() const;
    /// Number of values directly inside.
    int size() const;

  private:
    const JsonTree* m_tree;
    std::uint32_t m_index;
};

class JsonTree {
  public:
    static constexpr int maxDepth = 64;
    static constexpr std::size_t maxValues = 8'000'000;

    /// The tree of the text, which must live as long, or the one problem that keeps it from being JSON.
    static std::variant<JsonTree, Problem> parsed(std::string_view text);

    JsonView root() const { return {*this, 0}; }
    /// Number of values, all in all.
    std::size_t size() const { return m_nodes.size(); }
    /// The values whose name another value of the same object had before them.
    std::vector<std::uint32_t> duplicateMembers() const;
    /// The same as problems; no more than a thousand.
    std::vector<Problem> duplicateNames() const;
    /// The line of the value at this JSON pointer, or of the innermost value around it that there is.
    int lineAt(std::string_view pointer) const;

  private:
    std::string pointerTo(std::uint32_t index) const;

    friend class JsonView;
    friend class JsonTreeBuilder;

    std::string_view m_text;
    std::vector<JsonNode> m_nodes;
    std::vector<std::string> m_names;
    std::vector<std::string> m_texts;
};

/// A name as a segment of a JSON pointer: "~" and "/" escaped.
std::string pointerSegment(std::string_view name);
/// The segments of a JSON pointer, unescaped.
std::vector<std::string> pointerSegments(std::string_view pointer);

} // namespace spacetow
