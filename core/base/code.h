#pragma once
// Stable names, in kebab-case, of what went wrong or was done: "cannot-write". A layer has its own in a table and a
// type that is made of a literal only when one of its tables has it, or does not compile. Sentences are made of codes
// in one place, editor/window/messages.

#include <string_view>
#include <type_traits>

namespace spacetow {

/// A code of any layer, or none. Its text lives as long as the program.
class Code {
  public:
    constexpr Code() = default;

    constexpr std::string_view text() const { return m_text; }

    friend constexpr bool operator==(Code a, Code b) { return a.m_text == b.m_text; }
    friend constexpr auto operator<=>(Code a, Code b) { return a.m_text <=> b.m_text; }

  protected:
    constexpr explicit Code(std::string_view text) : m_text(text) {}

  private:
    std::string_view m_text;
};

/// A code that, where it is spelled, is one of these tables: those of a layer and of the layers below it.
template <const auto&... tables>
class CodeOf : public Code {
    template <const auto& table>
    struct Table; // stands for it: under a sanitizer, addresses are not compared while the compiler runs
    template <const auto& table>
    static constexpr bool has = (... || std::is_same_v<Table<table>, Table<tables>>);

  public:
    constexpr CodeOf() = default;
    /// A code that is known to be one of them.
    constexpr explicit CodeOf(Code code) : Code(code) {}
    /// What a layer below has, the layers above have as well.
    template <const auto&... some>
    requires(has<some>&&...) constexpr CodeOf(CodeOf<some...> code) : Code(code) {}
    consteval CodeOf(const char* text) : Code(registered(text)) {}

    /// With further tables.
    template <const auto&... more>
    using And = CodeOf<tables..., more...>;

    /// `visit(text)` for all that there are.
    template <class Visit>
    static constexpr void each(Visit visit) {
        const auto walk = [&visit](const auto& table) {
            for (const std::string_view code : table) {
                visit(code);
            }
        };
        (walk(tables), ...);
    }

    friend constexpr bool operator==(CodeOf a, CodeOf b) { return a.text() == b.text(); }
    friend constexpr bool operator==(CodeOf a, Code b) { return a.text() == b.text(); }

  private:
    static consteval std::string_view registered(std::string_view text) {
        std::string_view found;
        each([&found, text](std::string_view code) { found = code == text ? code : found; });
        if (found.empty()) {
            throw "no table of this layer has this code";
        }
        return found;
    }
};

} // namespace spacetow
