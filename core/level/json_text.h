#pragma once
// JSON as it is laid out in level files: what fits on a line of 120 characters stands on one line, everything else
// takes a line a member. Numbers are spelled with the fewest digits that read back as the same number.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace spacetow {

class JsonText {
  public:
    static JsonText number(double value);
    static JsonText integer(long long value);
    static JsonText flag(bool value);
    static JsonText text(std::string_view value);
    static JsonText null();
    /// JSON that is spelled already and stays as it is.
    static JsonText raw(std::string json);
    static JsonText array();
    static JsonText object();
    /// Takes a line a member even when it would fit on one.
    JsonText broken() &&;

    void append(JsonText value) { m_members.emplace_back(std::string(), std::move(value)); }
    void append(std::string_view name, JsonText value);
    /// The name is in its quotes already.
    void appendSpelled(std::string name, JsonText value) { m_members.emplace_back(std::move(name), std::move(value)); }
    /// Appends the members of another object.
    void take(const JsonText& object) {
        m_members.insert(m_members.end(), object.m_members.begin(), object.m_members.end());
    }
    /// Where the segments of a JSON pointer lead, null when the way is not there. Valid until something is appended.
    JsonText* at(const std::vector<std::string>& segments);

    bool isObject() const { return m_kind == Kind::Object; }
    /// Of the i-th member of an object, in its quotes.
    const std::string& spelledName(int i) const { return m_members[static_cast<std::size_t>(i)].first; }
    int size() const { return static_cast<int>(m_members.size()); }

    std::string onOneLine() const;
    /// With a newline at the end.
    std::string laidOut() const;

  private:
    enum class Kind : unsigned char { Scalar, Array, Object };
    bool addOnOneLine(std::string& out, std::size_t limit) const;
    void addLaidOut(std::string& out, int depth, std::size_t lineStart) const;

    Kind m_kind = Kind::Scalar;
    bool m_broken = false;
    std::string m_scalar;
    std::vector<std::pair<std::string, JsonText>> m_members; // with their names as spelled
};

/// The shortest decimal number that reads back as `value`; "null" for one that is not finite.
std::string spelledNumber(double value);
/// In quotes, with what JSON demands escaped and bytes that are not UTF-8 replaced by U+FFFD.
std::string spelledText(std::string_view value);
/// Length of the UTF-8 character that `text` starts with, 0 when it is not one.
int utf8Length(std::string_view text);

} // namespace spacetow
