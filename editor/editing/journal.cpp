#include "editor/editing/journal.h"

#include "core/level/file_state.h"

#include <charconv>

namespace spacetow {

namespace {

constexpr std::string_view magic = "spacetow-journal 1";

/// On one line: file names may hold anything.
std::string escapedLine(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || c == '%') {
            line += {'%', digits[byte >> 4], digits[byte & 15]};
        } else {
            line += c;
        }
    }
    return line;
}

template <class Number>
std::optional<Number> numberIn(std::string_view text, int base = 10) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole ? std::optional(number) : std::nullopt;
}

std::string fromOneLine(std::string_view line) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const auto code = line[i] == '%' ? numberIn<int>(line.substr(i + 1, 2), 16) : std::nullopt;
        text += code ? static_cast<char>(*code) : line[i];
        i += code ? 2 : 0;
    }
    return text;
}

std::string hexadecimal(std::uint64_t number) {
    char digits[16];
    return {digits, std::to_chars(digits, digits + sizeof digits, number, 16).ptr};
}

/// Takes lines off the front of a text.
class Lines {
  public:
    explicit Lines(std::string_view text) : m_rest(text) {}
    /// What follows the word on the next line; nothing when that begins otherwise.
    std::optional<std::string_view> after(std::string_view word) {
        const std::size_t end = m_rest.find('\n');
        if (end == std::string_view::npos || end < word.size() || m_rest.substr(0, word.size()) != word) {
            return {};
        }
        const std::string_view found = m_rest.substr(word.size(), end - word.size());
        m_rest.remove_prefix(end + 1);
        return found;
    }
    std::string_view rest() const { return m_rest; }

  private:
    std::string_view m_rest;
};

} // namespace

std::string journalText(const JournalEntry& entry) {
    std::string text(magic);
    text += "\npath " + escapedLine(entry.path) + "\nname " + escapedLine(entry.name) + "\nfile ";
    text += entry.fileHash ? hexadecimal(*entry.fileHash) : "-";
    text += "\ntime " + std::to_string(entry.time) + "\nbytes " + std::to_string(entry.text.size());
    text += "\nhash " + hexadecimal(contentHash(entry.text)) + '\n';
    text += entry.text;
    return text;
}

std::optional<JournalEntry> parsedJournal(std::string_view text) {
    Lines lines(text);
    if (lines.after(magic) != std::string_view()) {
        return {};
    }
    const auto path = lines.after("path ");
    const auto name = lines.after("name ");
    const auto file = lines.after("file ");
    const auto time = lines.after("time ");
    const auto bytes = lines.after("bytes ");
    const auto hash = lines.after("hash ");
    if (!path || !name || !file || !time || !bytes || !hash) {
        return {};
    }
    const bool whole = numberIn<std::size_t>(*bytes) == lines.rest().size() &&
                       numberIn<std::uint64_t>(*hash, 16) == contentHash(lines.rest());
    if (!whole) {
        return {};
    }
    return JournalEntry{fromOneLine(*path), fromOneLine(*name), numberIn<std::uint64_t>(*file, 16),
                        numberIn<std::int64_t>(*time).value_or(0), std::string(lines.rest())};
}

} // namespace spacetow
