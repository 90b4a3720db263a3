#include "editor/window/fuzzy_query.h"

#include <algorithm>
#include <limits>

namespace spacetow {

namespace {

constexpr int hit = 10;
constexpr int wordStart = 12;
constexpr int capital = 9; // within a word, as in zoomIn
constexpr int inARow = 10;
constexpr int wholeWord = 6;
constexpr int mostGap = 6;          // of what a gap costs, a character each
constexpr int mostText = 200;       // characters that are looked at
constexpr int charactersAPoint = 8; // by which a longer text loses
constexpr int never = std::numeric_limits<int>::min() / 2;

QChar foldedCharacter(QChar c) {
    if (c.unicode() < 0x80) {
        return c.toLower();
    }
    switch (c.unicode()) {
    case u'ß':
    case u'ẞ':
        return u's';
    case u'ø':
    case u'Ø':
        return u'o';
    case u'æ':
    case u'Æ':
        return u'a';
    case u'ł':
    case u'Ł':
        return u'l';
    default:
        break;
    }
    const QString parts = c.decomposition();
    return (c.decompositionTag() == QChar::Canonical && !parts.isEmpty() ? parts.front() : c).toCaseFolded();
}

/// What finding a letter here is worth by itself.
std::vector<int> worths(QStringView text) {
    std::vector<int> all;
    all.reserve(static_cast<std::size_t>(text.size()));
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool starts = i == 0 || !text[i - 1].isLetterOrNumber();
        const bool isCapital = !starts && text[i].isUpper() && text[i - 1].isLower();
        all.push_back(hit + (starts ? wordStart : isCapital ? capital : 0));
    }
    return all;
}

bool isWithin(QStringView word, QStringView text) {
    qsizetype found = 0;
    for (qsizetype i = 0; i < text.size() && found < word.size(); ++i) {
        found += text[i] == word[found] ? 1 : 0;
    }
    return found == word.size();
}

/// The best ways to find the first letters of a word, each by where it puts the last of them.
class Alignment {
  public:
    Alignment(QStringView word, QStringView text, const std::vector<int>& worth)
        : m_width(text.size()), m_word(word), m_best(static_cast<std::size_t>(word.size() * m_width), never),
          m_from(m_best.size(), -1) {
        for (qsizetype i = 0; i < word.size(); ++i) {
            fill(i, text, worth);
        }
        addWholeWord(text);
    }

    int score() const { return m_end < 0 ? never : m_best[at(m_word.size() - 1, m_end)]; }
    void addPlaces(std::vector<int>& places) const {
        qsizetype place = m_end;
        for (qsizetype i = m_word.size() - 1; i >= 0 && place >= 0; --i) {
            places.push_back(static_cast<int>(place));
            place = m_from[at(i, place)];
        }
    }

  private:
    std::size_t at(qsizetype letter, qsizetype place) const {
        return static_cast<std::size_t>(letter * m_width + place);
    }

    void fill(qsizetype letter, QStringView text, const std::vector<int>& worth) {
        int gap = never; // the best way to have come here with a gap, and where it was last
        qsizetype gapFrom = -1;
        for (qsizetype j = 0; j < m_width; ++j) {
            if (letter > 0 && j >= 2) {
                const int before = m_best[at(letter - 1, j - 2)];
                const int older = gapFrom < 0 ? never : gap - (j - gapFrom - 1 <= mostGap ? 1 : 0);
                if (before > never && before - 1 >= older) {
                    gap = before - 1;
                    gapFrom = j - 2;
                } else {
                    gap = older;
                }
            }
            if (text[j] != m_word[letter]) {
                continue;
            }
            const int own = worth[static_cast<std::size_t>(j)];
            if (letter == 0) {
                m_best[at(0, j)] = own - static_cast<int>(std::min<qsizetype>(j, mostGap));
                continue;
            }
            const int before = j > 0 ? m_best[at(letter - 1, j - 1)] : never;
            const int row = before > never ? before + inARow : never;
            if (std::max(row, gap) > never) {
                m_best[at(letter, j)] = own + std::max(row, gap);
                m_from[at(letter, j)] = row >= gap ? j - 1 : gapFrom;
            }
        }
    }

    void addWholeWord(QStringView text) {
        const qsizetype last = m_word.size() - 1;
        for (qsizetype j = 0; j < m_width; ++j) {
            int& best = m_best[at(last, j)];
            if (best > never && (j + 1 == m_width || !text[j + 1].isLetterOrNumber())) {
                best += wholeWord;
            }
            if (best > never && (m_end < 0 || best > m_best[at(last, m_end)])) {
                m_end = j;
            }
        }
    }

    qsizetype m_width;
    QStringView m_word;
    std::vector<int> m_best;
    std::vector<qsizetype> m_from; // where the letter before is
    qsizetype m_end = -1;
};

} // namespace

QString folded(QStringView text) {
    QString result(text.size(), Qt::Uninitialized);
    std::transform(text.begin(), text.end(), result.begin(), foldedCharacter);
    return result;
}

FuzzyQuery::FuzzyQuery(QStringView typed) {
    for (const QStringView word : typed.split(u' ', Qt::SkipEmptyParts)) {
        m_words.push_back(folded(word.left(mostText)));
    }
}

std::optional<int> FuzzyQuery::score(QStringView text) const {
    const QStringView shown = text.left(mostText);
    const QString plain = folded(shown);
    for (const QString& word : m_words) {
        if (!isWithin(word, plain)) {
            return {};
        }
    }
    const std::vector<int> worth = worths(shown);
    int sum = -static_cast<int>(shown.size()) / charactersAPoint;
    for (const QString& word : m_words) {
        sum += Alignment(word, plain, worth).score();
    }
    return sum;
}

std::vector<int> FuzzyQuery::places(QStringView text) const {
    const QStringView shown = text.left(mostText);
    const QString plain = folded(shown);
    const std::vector<int> worth = worths(shown);
    std::vector<int> places;
    for (const QString& word : m_words) {
        if (isWithin(word, plain)) {
            Alignment(word, plain, worth).addPlaces(places);
        }
    }
    std::ranges::sort(places);
    const auto twice = std::ranges::unique(places);
    places.erase(twice.begin(), twice.end());
    return places;
}

} // namespace spacetow
