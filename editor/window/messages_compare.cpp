#include "editor/window/messages_compare.h"

#include "core/base/overloaded.h"
#include "core/level/key_text.h"
#include "core/level/tag_spelling.h"
#include "editor/canvas/tag_text.h"
#include "editor/panels/form_rows.h"
#include "editor/panels/names.h"
#include "editor/panels/number_text.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace spacetow {

namespace {

struct Compared {
    Q_DECLARE_TR_FUNCTIONS(Compared)
};

const FormRow* rowOf(std::span<const FormRow> rows, const std::string& id) {
    const auto found = std::ranges::find_if(rows, [&id](const FormRow& row) { return id == row.id; });
    return found == rows.end() ? nullptr : &*found;
}

/// Of "Locked: cannot be picked or moved" the first word.
QString shortLabel(const FormRow& row) {
    return rowText(row.label).section(QLatin1Char(':'), 0, 0);
}

} // namespace

QString fieldName(std::span<const FormRow> rows, const std::string& id) {
    if (const FormRow* row = rowOf(rows, id); row != nullptr && *row->label != '\0') {
        return id.ends_with(".x") ? shortLabel(*row) + QStringLiteral(" x") : shortLabel(*row);
    }
    if (id.ends_with(".y")) {
        if (const FormRow* first = rowOf(rows, id.substr(0, id.size() - 1) + 'x')) {
            return shortLabel(*first) + QStringLiteral(" y");
        }
    }
    const FormRow* point = rowOf(rows, id + ".x");
    return point != nullptr ? shortLabel(*point) : QString::fromStdString(id);
}

namespace {

QString tagsText(const TagTable& table, TagMask mask) {
    const bool byExceptions = isSpelledByExceptions(mask);
    if (mask == TagMask::all() || mask == TagMask{}) {
        return mask.bits == 0 ? Compared::tr("none") : Compared::tr("all");
    }
    QStringList names;
    for (int tag = 0; tag < TagTable::size; ++tag) {
        if (mask.contains(tag) != byExceptions) {
            names << tagText(table, tag);
        }
    }
    const QString list = names.join(QStringLiteral(", "));
    return byExceptions ? Compared::tr("all but %1").arg(list) : list;
}

QString keyWords(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    return object == nullptr ? QString::fromStdString(keyText(key)) : listedName(level, *object);
}

QString quoted(const std::string& text) {
    return text.empty() ? Compared::tr("none") : Compared::tr("“%1”").arg(QString::fromStdString(text));
}

using NumberWords = QString (*)(double);

/// A field with its name in the form, if it has a row there.
struct NamedField {
    const FormRow* row;
    const Field& field;
};

QString valueText(const Level& level, const NamedField& named, const FieldValue& value, NumberWords words) {
    const FormRow* const row = named.row;
    const Field& field = named.field;
    return std::visit(Overloaded{
                          [](Unset) { return Compared::tr("none"); },
                          [&](double number) {
                              const QString unit = QString::fromUtf8(shownUnit(field.unit));
                              const QString text = words(shownNumber(number, field.unit));
                              return unit.isEmpty() ? text : text + QChar(0xa0) + unit;
                          },
                          [](bool flag) { return flag ? Compared::tr("yes") : Compared::tr("no"); },
                          [&](Choice choice) {
                              const bool known = row != nullptr && choice.index < static_cast<int>(row->choices.size());
                              return known ? rowText(row->choices[static_cast<std::size_t>(choice.index)])
                                           : QString::number(choice.index);
                          },
                          [](const std::string& text) { return quoted(text); },
                          [&](TagMask mask) { return tagsText(level.tags, mask); },
                          [&](KeyValue key) { return keyWords(level, key.key); },
                          [](ColorValue color) { return QString::fromStdString(colorText(color.rgb)); },
                          [](PointCount points) { return QString::number(points.count); },
                      },
                      value);
}

/// Says the differences between two levels.
class Speaker {
  public:
    Speaker(const Level& before, const Level& after) : m_before(before), m_after(after) {}

    std::vector<DifferenceLine> lines(const LevelDifference& difference) {
        for (const FieldDifference& field : difference.fields) {
            say(Compared::tr("Level: %1").arg(changed(levelRows(), field)));
        }
        for (const TagDifference& tag : difference.tags) {
            say(tagLine(tag));
        }
        for (const Guide& guide : difference.guidesAdded) {
            say(Compared::tr("Guide %1: added").arg(guideText(guide)));
        }
        for (const Guide& guide : difference.guidesRemoved) {
            say(Compared::tr("Guide %1: removed").arg(guideText(guide)));
        }
        if (difference.unknownFields) {
            say(Compared::tr("Level: fields that this program does not know"));
        }
        if (difference.hiddenProblems) {
            say(Compared::tr("Level: other problems are hidden"));
        }
        for (const ObjectDifference& object : difference.objects) {
            const bool gone = object.change == ObjectChange::Removed;
            const Level& level = gone ? m_before : m_after;
            m_lines.push_back(
                {object.key, object.change, Compared::tr("%1: %2").arg(keyWords(level, object.key), whatOf(object))});
        }
        return std::move(m_lines);
    }
    /// Several fields of the level in one line.
    QString levelLine(const std::vector<FieldDifference>& fields) const {
        QStringList parts;
        for (const FieldDifference& field : fields) {
            parts << changed(levelRows(), field);
        }
        return Compared::tr("Level: %1").arg(parts.join(QStringLiteral("; ")));
    }

  private:
    void say(const QString& text) { m_lines.push_back({0, ObjectChange::Changed, text}); }

    QString changed(std::span<const FormRow> rows, const FieldDifference& field) const {
        const FormRow* row = rowOf(rows, field.id);
        const auto both = [&](NumberWords words) {
            const NamedField named{row, field.field};
            return std::pair(valueText(m_before, named, field.before, words),
                             valueText(m_after, named, field.after, words));
        };
        std::pair<QString, QString> texts = both(shortNumberText);
        if (texts.first == texts.second) {
            texts = both(exactNumberText); // all digits are needed to tell them apart
        }
        return Compared::tr("%1 %2 → %3").arg(fieldName(rows, field.id), texts.first, texts.second);
    }
    static QString tagLine(const TagDifference& tag) {
        const QString name = QString::fromStdString(tag.after.name.empty() ? tag.before.name : tag.after.name);
        if (tag.before.name.empty()) {
            return Compared::tr("Tag “%1”: added").arg(name);
        }
        if (tag.after.name.empty()) {
            return Compared::tr("Tag “%1”: removed").arg(name);
        }
        return tag.before.name != tag.after.name
                   ? Compared::tr("Tag “%1”: renamed to “%2”").arg(QString::fromStdString(tag.before.name), name)
                   : Compared::tr("Tag “%1”: color %2 → %3")
                         .arg(name, QString::fromStdString(colorText(tag.before.color)),
                              QString::fromStdString(colorText(tag.after.color)));
    }
    static QString guideText(const Guide& guide) {
        return guide.name.empty()
                   ? Compared::tr("at %1; %2").arg(shortNumberText(guide.point.x()), shortNumberText(guide.point.y()))
                   : quoted(guide.name);
    }
    static int pointsOf(const Level& level, Key key) {
        const Object* object = level.objects.find(key);
        const auto* body = object == nullptr ? nullptr : std::get_if<BodyObject>(&object->data);
        int count = 0;
        for (std::size_t i = 0; body != nullptr && i < body->shapes.size(); ++i) {
            count += std::visit(Overloaded{[](const Circle&) { return 1; },
                                           [](const auto& shape) { return static_cast<int>(shape.vertices.size()); }},
                                body->shapes[i]);
        }
        return count;
    }
    QString whatOf(const ObjectDifference& object) const {
        if (object.change == ObjectChange::Added) {
            return Compared::tr("added");
        }
        if (object.change == ObjectChange::Removed) {
            return Compared::tr("removed");
        }
        QStringList parts;
        if (object.otherKind) {
            parts << Compared::tr("was %1").arg(kindName(*m_before.objects.find(object.key)));
        }
        for (const FieldDifference& field : object.fields) {
            parts << changed(objectRows(), field);
        }
        if (object.shapesMoved) {
            parts << Compared::tr("shape moved");
        }
        if (object.shapesChanged) {
            const int before = pointsOf(m_before, object.key);
            const int after = pointsOf(m_after, object.key);
            parts << (before == after ? Compared::tr("shape changed")
                                      : Compared::tr("shape changed, points %1 → %2").arg(before).arg(after));
        }
        if (object.reordered) {
            parts << Compared::tr("drawn in another place");
        }
        if (object.unknownFields) {
            parts << Compared::tr("fields that this program does not know");
        }
        return parts.join(QStringLiteral("; "));
    }

    const Level& m_before;
    const Level& m_after;
    std::vector<DifferenceLine> m_lines;
};

} // namespace

std::vector<DifferenceLine> differenceLines(const Level& before, const Level& after,
                                            const LevelDifference& difference) {
    return Speaker(before, after).lines(difference);
}

QString changeText(const Level& before, const Level& after, const LevelChange& change) {
    Speaker speaker(before, after);
    if (!change.what.fields.empty()) {
        return speaker.levelLine(change.what.fields);
    }
    QStringList texts;
    for (const DifferenceLine& line : speaker.lines(change.what)) {
        texts << line.text;
    }
    return texts.isEmpty() ? Compared::tr("Guides: in another order") : texts.join(QStringLiteral("; "));
}

QString sentence(const MergeConflict& conflict, const Level& level) {
    const QString who = conflict.object == 0 ? Compared::tr("The level") : keyWords(level, conflict.object);
    const QString field = QString::fromStdString(conflict.field);
    switch (conflict.kind) {
    case ConflictKind::Field:
        return Compared::tr("%1: both sides changed “%2”.").arg(who, field);
    case ConflictKind::Kind:
        return Compared::tr("%1: both sides made something else of it.").arg(who);
    case ConflictKind::AddedTwice:
        return Compared::tr("%1: both sides added another object under the key %2.")
            .arg(who, QString::fromStdString(keyText(conflict.object)));
    case ConflictKind::RemovedOurs:
        return Compared::tr("%1: our side removed it, their side changed or needs it. It stays.").arg(who);
    case ConflictKind::RemovedTheirs:
        return Compared::tr("%1: their side removed it, our side changed or needs it. It stays.").arg(who);
    case ConflictKind::Circle:
        return Compared::tr("%1: groups would be in each other. It stays in the group that our side has put it in.")
            .arg(who);
    case ConflictKind::Order:
        return Compared::tr("%1: both sides changed the order of drawing.").arg(who);
    case ConflictKind::TagsFull:
        break;
    }
    return Compared::tr("There is no room for the tag “%1” of their side among the 32 tags.").arg(field);
}

} // namespace spacetow
