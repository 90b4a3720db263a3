#pragma once
// Finds objects by words: parts of names, kind:wall, tag:ship, is:hidden. All words must hold; a minus turns one round.
// A word with blanks stands in quotation marks.

#include "core/level/level.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace spacetow {

class ObjectFilter {
  public:
    /// Empty: everything is found.
    ObjectFilter() = default;
    explicit ObjectFilter(const QString& text);

    bool isEmpty() const { return m_terms.empty(); }
    /// Whether what is found depends on the names of tags.
    bool asksForTags() const;
    /// Ready to be asked about objects of this level; to be called again when the names of its tags change.
    void prepare(const TagTable& tags);
    bool finds(const Object& object) const;

    /// What can stand after "kind:" and "is:", in the spelling of the program's sources.
    static QStringList kinds();
    static QStringList states();
    /// A term such as tag:"big rock", with quotation marks where they are needed.
    static QString term(const QString& key, const QString& word);

  private:
    enum class About : std::uint8_t { Name, Kind, Tag, State };
    struct Term {
        About about = About::Name;
        QString word;
        bool isNegated = false;
        TagMask tags; // whose names hold the word
    };
    static Term termOf(QString word);
    bool holds(const Term& term, const Object& object) const;
    bool isKind(const Term& term, const Object& object) const;

    std::vector<Term> m_terms;
};

} // namespace spacetow
