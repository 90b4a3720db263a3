#include "editor/panels/object_filter.h"

#include "editor/panels/names.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

constexpr std::array shapeWords{"wall", "line", "polygon", "circle"};                      // as in LevelShape
constexpr std::array motionWords{"static", "kinematic", "dynamic"};                        // as in BodyKind
constexpr std::array dataWords{"body", "ship", "payload", "finish", "connector", "group"}; // as in ObjectData
static_assert(shapeWords.size() == std::variant_size_v<LevelShape>);
static_assert(dataWords.size() == std::variant_size_v<ObjectData>);

bool begins(const char* word, const QString& part) {
    return QLatin1String(word).startsWith(part, Qt::CaseInsensitive);
}

/// At blanks that stand in no quotation marks.
QStringList wordsOf(const QString& text) {
    QStringList words;
    QString word;
    bool isQuoted = false;
    for (const QChar c : text) {
        if (c == QLatin1Char('"')) {
            isQuoted = !isQuoted;
        } else if (c.isSpace() && !isQuoted) {
            words << word;
            word.clear();
        } else {
            word += c;
        }
    }
    words << word;
    words.removeAll(QString());
    return words;
}

} // namespace

ObjectFilter::ObjectFilter(const QString& text) {
    for (const QString& word : wordsOf(text)) {
        m_terms.push_back(termOf(word));
    }
}

ObjectFilter::Term ObjectFilter::termOf(QString word) {
    Term term;
    if (word.size() > 1 && word.startsWith(QLatin1Char('-'))) {
        term.isNegated = true;
        word.remove(0, 1);
    }
    constexpr std::array<std::pair<QLatin1String, About>, 3> keys{
        std::pair{QLatin1String("kind:"), About::Kind},
        {QLatin1String("tag:"), About::Tag},
        {QLatin1String("is:"), About::State},
    };
    for (const auto& [key, about] : keys) {
        if (word.startsWith(key, Qt::CaseInsensitive)) {
            term.about = about;
            word.remove(0, key.size());
            break;
        }
    }
    term.word = word;
    return term;
}

bool ObjectFilter::asksForTags() const {
    return std::ranges::any_of(m_terms, [](const Term& term) { return term.about == About::Tag; });
}

void ObjectFilter::prepare(const TagTable& tags) {
    for (Term& term : m_terms) {
        term.tags = {};
        for (int i = 0; i < TagTable::size; ++i) {
            const QString name = QString::fromStdString(tags[i].name);
            if (!name.isEmpty() && name.contains(term.word, Qt::CaseInsensitive)) {
                term.tags = term.tags | TagMask::bit(i);
            }
        }
    }
}

bool ObjectFilter::finds(const Object& object) const {
    return std::ranges::all_of(m_terms, [&](const Term& term) { return holds(term, object) != term.isNegated; });
}

bool ObjectFilter::holds(const Term& term, const Object& object) const {
    const auto* body = std::get_if<BodyObject>(&object.data);
    switch (term.about) {
    case About::Name:
        return displayName(object).contains(term.word, Qt::CaseInsensitive);
    case About::Kind:
        return isKind(term, object);
    case About::Tag:
        return body != nullptr && body->filter.tags.intersects(term.tags);
    case About::State:
        break;
    }
    return (begins("hidden", term.word) && !object.visible) || (begins("locked", term.word) && object.locked);
}

bool ObjectFilter::isKind(const Term& term, const Object& object) const {
    if (begins(dataWords[object.data.index()], term.word)) {
        return true;
    }
    const auto* group = std::get_if<GroupObject>(&object.data);
    if (group != nullptr && group->layer && begins("layer", term.word)) {
        return true;
    }
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        const auto isShape = [&](const LevelShape& shape) { return begins(shapeWords[shape.index()], term.word); };
        if (begins(motionWords[static_cast<std::size_t>(body->kind)], term.word) ||
            std::ranges::any_of(body->shapes, isShape)) {
            return true;
        }
    }
    return kindName(object).contains(term.word, Qt::CaseInsensitive); // in the language of the user
}

QStringList ObjectFilter::kinds() {
    QStringList words;
    for (const char* word : shapeWords) {
        words << QLatin1String(word);
    }
    for (const char* word : motionWords) {
        words << QLatin1String(word);
    }
    for (const char* word : dataWords) {
        words << QLatin1String(word);
    }
    words.removeAll(QStringLiteral("body")); // they are listed by shape and motion
    words << QStringLiteral("layer");
    return words;
}

QStringList ObjectFilter::states() {
    return {QStringLiteral("hidden"), QStringLiteral("locked")};
}

QString ObjectFilter::term(const QString& key, const QString& word) {
    const bool hasBlank = std::ranges::any_of(word, [](QChar c) { return c.isSpace(); });
    return key + QLatin1Char(':') + (hasBlank ? QLatin1Char('"') + word + QLatin1Char('"') : word);
}

} // namespace spacetow
