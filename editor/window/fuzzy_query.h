#pragma once
// Finds what somebody remembers by halves: the letters of what was typed, in their order, anywhere in a name. Starts of
// words, capitals and letters in a row count for more, gaps for less; case and accents count for nothing. Of several
// typed words all must be found, in any order.

#include <QString>
#include <QStringView>

#include <optional>
#include <vector>

namespace spacetow {

class FuzzyQuery {
  public:
    FuzzyQuery() = default;
    explicit FuzzyQuery(QStringView typed);

    bool isEmpty() const { return m_words.empty(); }
    /// Higher is better; nothing where a word is not in the text.
    std::optional<int> score(QStringView text) const;
    /// Of the characters that make the score, ascending; for marking them.
    std::vector<int> places(QStringView text) const;

  private:
    std::vector<QString> m_words; // folded
};

/// Without case and accents, a character for each character.
QString folded(QStringView text);

} // namespace spacetow
