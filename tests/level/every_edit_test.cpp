// Every edit there is, on levels made at random: its input stays as it was, and what comes out can be written, read
// and is whole.
#include "core/level/adopt_tags.h"
#include "core/level/arrange.h"
#include "core/level/arrays.h"
#include "core/level/chain_ends.h"
#include "core/level/combine.h"
#include "core/level/edits.h"
#include "core/level/field_edits.h"
#include "core/level/field_survey.h"
#include "core/level/file.h"
#include "core/level/groups.h"
#include "core/level/guides.h"
#include "core/level/knife.h"
#include "core/level/lint.h"
#include "core/level/merge.h"
#include "core/level/node_edits.h"
#include "core/level/nodes.h"
#include "core/level/tag_edits.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A level and what an edit may be asked to do with it.
struct Task {
    Task(std::uint64_t seed, const Level& given) : level(given), random(seed) {
        for (const Object& object : level.objects) {
            all.push_back(object.key);
        }
        std::ranges::sort(all);
        keys = some(all);
        const std::vector<NodeRef> every = allNodes(level, all);
        nodes = some(every);
        // Neighbours, and the two ends of one path, which some edits are about.
        if (!every.empty() && below(2) == 0) {
            const std::size_t first = static_cast<std::size_t>(below(static_cast<int>(every.size())));
            std::size_t end = first + 1;
            while (end < every.size() && every[end].key == every[first].key && every[end].shape == every[first].shape &&
                   below(6) != 0) {
                ++end;
            }
            nodes.assign(every.begin() + static_cast<std::ptrdiff_t>(first),
                         every.begin() + static_cast<std::ptrdiff_t>(end));
            if (below(3) == 0 && nodes.size() > 2) {
                nodes = {nodes.front(), nodes.back()};
            }
        }
        key = all.empty() ? 0 : all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
    }

    template <class T>
    std::vector<T> some(const std::vector<T>& from) {
        const double share = random.unit();
        std::vector<T> chosen;
        std::ranges::copy_if(from, std::back_inserter(chosen), [&](const T&) { return random.unit() < share; });
        return chosen;
    }
    int below(int count) { return static_cast<int>(random.below(static_cast<std::uint32_t>(count))); }
    bool chance() { return below(2) == 0; }
    double number() { return random.uniform(-20, 20); }
    Vec2 point() { return {number(), number()}; }
    template <class Enum>
    Enum oneOf(std::initializer_list<Enum> values) {
        return values.begin()[below(static_cast<int>(values.size()))];
    }
    Affine map() {
        const Affine made{point(), point(), point()};
        return std::abs(made.determinant()) > 1e-3 ? made : Affine::translation({1, 2});
    }
    /// A group, or 0 for the top.
    Key group() {
        std::vector<Key> groups{0};
        for (const Object& object : level.objects) {
            if (std::holds_alternative<GroupObject>(object.data)) {
                groups.push_back(object.key);
            }
        }
        return groups[static_cast<std::size_t>(below(static_cast<int>(groups.size())))];
    }
    Object fresh(ObjectData data) { return {freshKey(level, random.next()), "made", std::move(data), {}}; }
    Guide guide() { return {point(), number(), "made"}; }
    std::size_t guideIndex() { return static_cast<std::size_t>(below(4)); }
    std::vector<Object> foreign() {
        std::vector<Object> objects;
        for (const Object& object : soundLevel(random.next()).objects) {
            objects.push_back(object);
        }
        return objects;
    }
    CopyPlace place() { return {point(), random.next(), group(), chance()}; }

    Level level;
    Random random;
    std::vector<Key> all, keys; // ascending
    std::vector<NodeRef> nodes; // ascending
    Key key = 0;                // of some object; 0 when there is none
    std::vector<Key> copies;
};

/// Sets a field that some of the objects, or the level, have to its default.
FieldEdit fieldReset(Task& task, const FieldSurvey& survey) {
    const std::vector<FieldSummary> summaries = survey.summaries();
    if (summaries.empty()) {
        return {"none", [](const FieldValue& value) { return std::optional(value); }};
    }
    const FieldSummary& chosen = summaries[static_cast<std::size_t>(task.below(static_cast<int>(summaries.size())))];
    return {chosen.id,
            [chosen](const FieldValue& value) { return std::optional(chosen.hasStandard ? chosen.standard : value); }};
}

Level fieldsEdited(Task& task) {
    FieldSurvey survey;
    for (const Key key : task.keys) {
        survey.add(*task.level.objects.find(key));
    }
    const FieldEditResult result = withFieldEdited(task.level, {task.keys, {}}, fieldReset(task, survey));
    return result.refused == 0 ? result.level : task.level;
}

Level levelFieldsEdited(Task& task) {
    FieldSurvey survey;
    survey.add(task.level);
    const FieldEditResult result = withLevelFieldEdited(task.level, fieldReset(task, survey));
    return result.refused == 0 ? result.level : task.level;
}

Level objectReplaced(Task& task) {
    if (task.key == 0) {
        return task.level;
    }
    Object object = *task.level.objects.find(task.key);
    object.name = "replaced";
    object.visible = !object.visible;
    return withObject(task.level, std::move(object));
}

Level chainExtended(Task& task) {
    const ChainEnd end{task.key, task.below(2), task.chance()};
    std::vector<Vec2> points;
    for (int i = 1 + task.below(3); i > 0; --i) {
        points.push_back(task.point());
    }
    const std::optional<OpenChain> chain = openChain(task.level, end);
    return extended(task.level, end, points, chain && chain->vertices + std::ssize(points) > 2 && task.chance());
}

Level shapesTakenApart(Task& task) {
    return reshaped(task.level, task.nodes,
                    [](const BodyObject& body, const NodeRef& first,
                       std::span<const NodeRef>) -> std::optional<std::vector<ShapePiece>> {
                        if (first.vertex % 2 == 0) {
                            return {};
                        }
                        const LevelShape& shape = body.shapes[static_cast<std::size_t>(first.shape)];
                        return first.vertex % 3 == 0 ? std::vector<ShapePiece>()
                                                     : std::vector<ShapePiece>{{shape, {0}}, {shape, {1}}};
                    })
        .level;
}

Level bodiesCombined(Task& task) {
    auto result =
        combinedBodies(task.level, task.keys,
                       task.oneOf({PolygonBoolean::Union, PolygonBoolean::Difference, PolygonBoolean::Intersection}));
    return result ? result.value().level : task.level;
}

/// Of what two people made of the level, each without the other.
Level editsMerged(Task& task) {
    const Level ours = task.chance() ? removed(task.level, task.keys)
                                     : regrouped(task.level, task.keys, {task.group(), task.chance() ? task.key : 0});
    Level theirs = regrouped(task.level, task.some(task.all), {task.group()});
    theirs = grouped(moved(std::move(theirs), task.some(task.all), task.point()), task.some(task.all),
                     task.fresh(GroupObject{}));
    return merged(task.level, ours, theirs, task.oneOf({MergeSide::Ours, MergeSide::Theirs})).level;
}

Level arrayMade(Task& task) {
    const ArraySpec spec = task.chance() ? ArraySpec(LinearArray{1 + task.below(3), task.point()})
                                         : ArraySpec(RadialArray{1 + task.below(3), task.number(), task.point()});
    return arrayed(task.level, task.keys, spec, task.random.next(), task.copies);
}

struct EditRow {
    const char* name;
    Level (*run)(Task& task);
};

constexpr EditRow edits[] = {
    {"added",
     [](Task& t) {
         return added(t.level, t.fresh(BodyObject{.shapes = {Circle{t.point(), 1}}}));
     }},
    {"removed", [](Task& t) { return removed(t.level, t.keys); }},
    {"moved", [](Task& t) { return moved(t.level, t.keys, t.point()); }},
    {"transformed", [](Task& t) { return transformed(t.level, t.keys, t.map()); }},
    {"rotated", [](Task& t) { return rotated(t.level, t.keys, t.point(), t.number()); }},
    {"reversed", [](Task& t) { return reversed(t.level, t.keys); }},
    {"duplicated", [](Task& t) { return duplicated(t.level, t.keys, t.place(), t.copies); }},
    {"pasted",
     [](Task& t) {
         return pasted(t.level, t.foreign(), {t.point(), 7, t.group()}, t.copies);
     }},
    {"withObject", objectReplaced},
    {"renamed", [](Task& t) { return renamed(t.level, t.key, "renamed"); }},
    {"withTag",
     [](Task& t) {
         return withTag(t.level, t.below(TagTable::size), {"made", 0x112233});
     }},
    {"flipped",
     [](Task& t) {
         return flipped(t.level, t.keys, t.oneOf({FlipAxis::Horizontal, FlipAxis::Vertical}));
     }},
    {"aligned",
     [](Task& t) {
         return aligned(t.level, t.keys,
                        t.oneOf({AlignTo::Left, AlignTo::Right, AlignTo::Top, AlignTo::Bottom, AlignTo::MiddleAcross,
                                 AlignTo::MiddleUpright}));
     }},
    {"distributed",
     [](Task& t) {
         return distributed(t.level, t.keys, {t.oneOf({Spread::Edges, Spread::Middles, Spread::Gaps}), t.chance()});
     }},
    {"reordered",
     [](Task& t) {
         return reordered(t.level, t.keys,
                          t.oneOf({OrderTo::Front, OrderTo::Forward, OrderTo::Backward, OrderTo::Back}));
     }},
    {"isolated", [](Task& t) { return isolated(t.level, t.keys); }},
    {"withNode",
     [](Task& t) { return t.nodes.empty() ? t.level : withNode(t.level, t.nodes.front(), t.point()).level; }},
    {"withMidpoints", [](Task& t) { return withMidpoints(t.level, t.nodes).level; }},
    {"withoutNodes", [](Task& t) { return withoutNodes(t.level, t.nodes); }},
    {"withoutSegments", [](Task& t) { return withoutSegments(t.level, t.nodes).level; }},
    {"brokenAt", [](Task& t) { return brokenAt(t.level, t.nodes).level; }},
    {"reversedPart", [](Task& t) { return reversedPart(t.level, t.nodes).level; }},
    {"straightened", [](Task& t) { return straightened(t.level, t.nodes).level; }},
    {"joined",
     [](Task& t) {
         return joined(t.level, t.nodes, t.oneOf({JoinWay::Weld, JoinWay::Segment})).level;
     }},
    {"withMappedNodes", [](Task& t) { return withMappedNodes(t.level, t.nodes, t.map()); }},
    {"reshaped", shapesTakenApart},
    {"cutAlong", [](Task& t) { return cutAlong(t.level, t.keys, 5 * t.point(), 5 * t.point()).level; }},
    {"combinedBodies", bodiesCombined},
    {"grouped", [](Task& t) { return grouped(t.level, t.keys, t.fresh(GroupObject{})); }},
    {"ungrouped", [](Task& t) { return ungrouped(t.level, t.keys); }},
    {"regrouped",
     [](Task& t) {
         return regrouped(t.level, t.keys, {t.group(), t.chance() ? t.key : 0});
     }},
    {"withVisible", [](Task& t) { return withVisible(t.level, t.keys, t.chance()); }},
    {"withLocked", [](Task& t) { return withLocked(t.level, t.keys, t.chance()); }},
    {"arrayed", arrayMade},
    {"merged", editsMerged},
    {"withTagsMeeting",
     [](Task& t) { return withTagsMeeting(t.level, t.below(TagTable::size), t.below(TagTable::size), t.chance()); }},
    {"guideAdded", [](Task& t) { return guideAdded(t.level, t.guide()); }},
    {"guideReplaced", [](Task& t) { return guideReplaced(t.level, t.guideIndex(), t.guide()); }},
    {"guideRemoved", [](Task& t) { return guideRemoved(t.level, t.guideIndex()); }},
    {"guidesCleared", [](Task& t) { return guidesCleared(t.level); }},
    {"withFieldEdited", fieldsEdited},
    {"withLevelFieldEdited", levelFieldsEdited},
    {"extended", chainExtended},
    {"withTagsAdopted",
     [](Task& t) {
         return withTagsAdopted(t.level, {t.foreign(), soundLevel(t.random.next()).tags}).level;
     }},
};

/// What no edit may bring about, whatever is drawn.
QStringList breaches(const Level& level) {
    constexpr std::array<std::string_view, 17> structural{"bad-tag-name",
                                                          "chain-too-short",
                                                          "connector-end-missing",
                                                          "connector-end-no-body",
                                                          "duplicate-tag",
                                                          "connector-same-ends",
                                                          "key-taken",
                                                          "layer-in-group",
                                                          "no-shape",
                                                          "not-finite",
                                                          "parent-circle",
                                                          "parent-missing",
                                                          "parent-no-group",
                                                          "polygon-too-few-vertices",
                                                          "several-finishes",
                                                          "several-payloads",
                                                          "several-ships"};
    QStringList codes;
    for (const Problem& problem : lint(level)) {
        if (std::ranges::find(structural, problem.code) != structural.end()) {
            codes << QString::fromStdString(problem.code);
        }
    }
    return codes;
}

/// What is not as it should be after the edit of this level; empty when all is well.
QString faultOf(const EditRow& edit, std::uint64_t seed, const Level& input) {
    Task task(seed, input);
    const Level output = edit.run(task);
    if (!(task.level == soundLevel(seed))) {
        return QStringLiteral("changes its input");
    }
    if (const QStringList codes = breaches(output); !codes.isEmpty()) {
        return codes.join(QLatin1Char(' '));
    }
    if (const std::optional<Error> error = notWritable(output)) {
        return QString::fromStdString(error->code);
    }
    const LevelFile read = parseLevel(levelText(output), Checks::FileOnly);
    return read.level == output && read.problems.empty() ? QString() : QStringLiteral("is read differently");
}

/// The functions in the headers of the folder that make one level of another: by their names.
std::set<QString> editsDeclared() {
    const QDir folder(sourceFolder() + QStringLiteral("/core/level"));
    QString text;
    for (const QString& name : folder.entryList({QStringLiteral("*.h")})) {
        QFile file(folder.filePath(name));
        if (file.open(QIODevice::ReadOnly)) {
            text += QString::fromUtf8(file.readAll());
        }
    }
    QStringList results{QStringLiteral("Level")};
    const QRegularExpression holders(QStringLiteral("\\nstruct (\\w+) \\{\\n    Level level;"));
    for (QRegularExpressionMatchIterator i = holders.globalMatch(text); i.hasNext();) {
        results << i.next().captured(1);
    }
    const QRegularExpression functions(
        QStringLiteral("\\n(?:Result<)?(?:%1)>? (\\w+)\\(").arg(results.join(QLatin1Char('|'))));
    std::set<QString> names;
    for (QRegularExpressionMatchIterator i = functions.globalMatch(text); i.hasNext();) {
        names.insert(i.next().captured(1));
    }
    return names;
}

} // namespace

class EveryEditTest : public QObject {
    Q_OBJECT

  private slots:
    void theTableNamesEveryEdit() {
        std::set<QString> named;
        for (const EditRow& edit : edits) {
            named.insert(QString::fromLatin1(edit.name));
        }
        const std::set<QString> declared = editsDeclared();
        QVERIFY(declared.contains(QStringLiteral("cutAlong"))); // a result that holds a level
        QStringList missing;
        std::ranges::set_symmetric_difference(declared, named, std::back_inserter(missing));
        QCOMPARE(missing, QStringList());
    }

    void theLevelsTheyAreTriedOnAreSound() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            QCOMPARE(breaches(soundLevel(seed)), QStringList());
        }
    }

    void anEditLeavesItsInputUntouchedAndItsOutputValid_data() {
        QTest::addColumn<int>("row");
        for (int row = 0; row < static_cast<int>(std::size(edits)); ++row) {
            QTest::newRow(edits[row].name) << row;
        }
    }
    void anEditLeavesItsInputUntouchedAndItsOutputValid() {
        QFETCH(int, row);
        const int seeds = fullOrQuick(400, usualOrThin(25, 4));
        int changes = 0;
        for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(seeds); ++seed) {
            const Level input = soundLevel(seed);
            const QString fault = faultOf(edits[row], seed, input);
            QVERIFY2(fault.isEmpty(), qPrintable(QStringLiteral("seed %1: %2").arg(seed).arg(fault)));
            Task again(seed, input);
            changes += edits[row].run(again) == input ? 0 : 1;
        }
        QVERIFY(changes > 0); // or it would prove nothing
    }
};

SPACETOW_TEST(EveryEditTest)
#include "every_edit_test.moc"
