#include "tests/support/every_edit.h"

#include "core/level/adopt_tags.h"
#include "core/level/arrange.h"
#include "core/level/arrays.h"
#include "core/level/chain_ends.h"
#include "core/level/combine.h"
#include "core/level/compare.h"
#include "core/level/field_edits.h"
#include "core/level/field_survey.h"
#include "core/level/groups.h"
#include "core/level/guides.h"
#include "core/level/kept_changes.h"
#include "core/level/knife.h"
#include "core/level/level_delta.h"
#include "core/level/merge.h"
#include "core/level/node_edits.h"
#include "core/level/rectangles.h"
#include "core/level/tag_edits.h"
#include "tests/support/random_level.h"

#include <string>
#include <utility>

namespace spacetow::test {

EditTask::EditTask(std::uint64_t seed, const Level& given) : level(given), random(seed) {
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

Affine EditTask::map() {
    const Affine made{point(), point(), point()};
    return std::abs(made.determinant()) > 1e-3 ? made : Affine::translation({1, 2});
}

Key EditTask::group() {
    std::vector<Key> groups{0};
    for (const Object& object : level.objects) {
        if (std::holds_alternative<GroupObject>(object.data)) {
            groups.push_back(object.key);
        }
    }
    return groups[static_cast<std::size_t>(below(static_cast<int>(groups.size())))];
}

std::vector<Object> EditTask::foreign() {
    std::vector<Object> objects;
    for (const Object& object : soundLevel(random.next()).objects) {
        objects.push_back(object);
    }
    return objects;
}

namespace {

/// Sets a field that some of the objects, or the level, have to its default.
FieldEdit fieldReset(EditTask& task, const FieldSurvey& survey) {
    const std::vector<FieldSummary> summaries = survey.summaries();
    if (summaries.empty()) {
        return {"none", [](const FieldValue& value) { return std::optional(value); }};
    }
    const FieldSummary& chosen = summaries[static_cast<std::size_t>(task.below(static_cast<int>(summaries.size())))];
    return {chosen.id,
            [chosen](const FieldValue& value) { return std::optional(chosen.hasStandard ? chosen.standard : value); }};
}

Level fieldsEdited(EditTask& task) {
    FieldSurvey survey;
    for (const Key key : task.keys) {
        survey.add(*task.level.objects.find(key));
    }
    const FieldEditResult result = withFieldEdited(task.level, {task.keys, {}}, fieldReset(task, survey));
    return result.refused == 0 ? result.level : task.level;
}

Level sizesEdited(EditTask& task) {
    const double factor = 0.25 * (1 + task.below(8));
    const FieldEdit edit{task.chance() ? "width" : "height", [factor](const FieldValue& value) {
                             return std::optional(FieldValue(factor * std::get<double>(value)));
                         }};
    const FieldEditResult result = withSizeEdited(task.level, task.keys, edit);
    return result.refused == 0 ? result.level : task.level;
}

Level levelFieldsEdited(EditTask& task) {
    FieldSurvey survey;
    survey.add(task.level);
    const FieldEditResult result = withLevelFieldEdited(task.level, fieldReset(task, survey));
    return result.refused == 0 ? result.level : task.level;
}

Level objectReplaced(EditTask& task) {
    if (task.key == 0) {
        return task.level;
    }
    Object object = *task.level.objects.find(task.key);
    object.name = "replaced";
    object.visible = !object.visible;
    return withObject(task.level, std::move(object));
}

Level chainExtended(EditTask& task) {
    const ChainEnd end{task.key, task.below(2), task.chance()};
    std::vector<Vec2> points;
    for (int i = 1 + task.below(3); i > 0; --i) {
        points.push_back(task.point());
    }
    const std::optional<OpenChain> chain = openChain(task.level, end);
    return extended(task.level, end, points, chain && chain->vertices + std::ssize(points) > 2 && task.chance());
}

Level shapesTakenApart(EditTask& task) {
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

Level bodiesCombined(EditTask& task) {
    auto result =
        combinedBodies(task.level, task.keys,
                       task.oneOf({PolygonBoolean::Union, PolygonBoolean::Difference, PolygonBoolean::Intersection}));
    return result ? result.value().level : task.level;
}

/// Of what two people made of the level, each without the other.
Level editsMerged(EditTask& task) {
    const Level ours = task.chance() ? removed(task.level, task.keys)
                                     : regrouped(task.level, task.keys, {task.group(), task.chance() ? task.key : 0});
    Level theirs = regrouped(task.level, task.some(task.all), {task.group()});
    theirs = grouped(moved(std::move(theirs), task.some(task.all), task.point()), task.some(task.all),
                     task.fresh(GroupObject{}));
    return merged(task.level, ours, theirs, task.oneOf({MergeSide::Ours, MergeSide::Theirs})).level;
}

Level arrayMade(EditTask& task) {
    const ArraySpec spec = task.chance() ? ArraySpec(LinearArray{1 + task.below(3), task.point()})
                                         : ArraySpec(RadialArray{1 + task.below(3), task.number(), task.point()});
    return arrayed(task.level, task.keys, {spec, task.random.next()}, task.copies);
}

/// What somebody else has made of the level.
Level objectsTakenOver(EditTask& task) {
    const Level other = moved(removed(task.level, task.keys), task.some(task.all), task.point());
    return takenOver(task.level, other, task.some(task.all));
}

/// Of what a run has changed, some.
Level changesKept(EditTask& task) {
    Level after = regrouped(removed(task.level, task.keys), task.some(task.all), {task.group()});
    after = reordered(moved(std::move(after), task.some(task.all), task.point()), task.some(task.all), OrderTo::Front);
    const std::vector<LevelChange> changes = changesBetween(task.level, after);
    std::vector<int> places;
    for (int i = 0; i < static_cast<int>(changes.size()); ++i) {
        places.push_back(i);
    }
    return withKept(task.level, after, changes, task.some(places));
}

/// What a recording has of an edit, told to the level that has been edited by somebody else meanwhile.
Level deltaMade(EditTask& task) {
    const Level after = reordered(removed(task.level, task.keys), task.some(task.all), OrderTo::Front);
    return withDelta(moved(task.level, task.some(task.all), task.point()), deltaBetween(task.level, after));
}

constexpr EditRow editRows[] = {
    {"added",
     [](EditTask& t) {
         return added(t.level, t.fresh(BodyObject{.shapes = {Circle{t.point(), 1}}}));
     }},
    {"removed", [](EditTask& t) { return removed(t.level, t.keys); }},
    {"moved", [](EditTask& t) { return moved(t.level, t.keys, t.point()); }},
    {"transformed", [](EditTask& t) { return transformed(t.level, t.keys, t.map()); }},
    {"rotated", [](EditTask& t) { return rotated(t.level, t.keys, t.point(), t.number()); }},
    {"reversed", [](EditTask& t) { return reversed(t.level, t.keys); }},
    {"duplicated", [](EditTask& t) { return duplicated(t.level, t.keys, t.place(), t.copies); }},
    {"pasted",
     [](EditTask& t) {
         return pasted(t.level, t.foreign(), {t.point(), 7, t.group()}, t.copies);
     }},
    {"withObject", objectReplaced},
    {"renamed", [](EditTask& t) { return renamed(t.level, t.key, "renamed"); }},
    {"withTag",
     [](EditTask& t) {
         const int tag = t.below(TagTable::size);
         return withTag(t.level, tag, {"made " + std::to_string(tag), 0x112233}); // no two tags have one name
     }},
    {"flipped",
     [](EditTask& t) {
         return flipped(t.level, t.keys, t.oneOf({FlipAxis::Horizontal, FlipAxis::Vertical}));
     }},
    {"aligned",
     [](EditTask& t) {
         return aligned(t.level, t.keys,
                        t.oneOf({AlignTo::Left, AlignTo::Right, AlignTo::Top, AlignTo::Bottom, AlignTo::MiddleAcross,
                                 AlignTo::MiddleUpright}));
     }},
    {"distributed",
     [](EditTask& t) {
         return distributed(t.level, t.keys, {t.oneOf({Spread::Edges, Spread::Middles, Spread::Gaps}), t.chance()});
     }},
    {"reordered",
     [](EditTask& t) {
         return reordered(t.level, t.keys,
                          t.oneOf({OrderTo::Front, OrderTo::Forward, OrderTo::Backward, OrderTo::Back}));
     }},
    {"isolated", [](EditTask& t) { return isolated(t.level, t.keys); }},
    {"withNode",
     [](EditTask& t) { return t.nodes.empty() ? t.level : withNode(t.level, t.nodes.front(), t.point()).level; }},
    {"withMidpoints", [](EditTask& t) { return withMidpoints(t.level, t.nodes).level; }},
    {"withoutNodes", [](EditTask& t) { return withoutNodes(t.level, t.nodes); }},
    {"withoutSegments", [](EditTask& t) { return withoutSegments(t.level, t.nodes).level; }},
    {"brokenAt", [](EditTask& t) { return brokenAt(t.level, t.nodes).level; }},
    {"reversedPart", [](EditTask& t) { return reversedPart(t.level, t.nodes).level; }},
    {"straightened", [](EditTask& t) { return straightened(t.level, t.nodes).level; }},
    {"joined",
     [](EditTask& t) {
         return joined(t.level, t.nodes, t.oneOf({JoinWay::Weld, JoinWay::Segment})).level;
     }},
    {"withMappedNodes", [](EditTask& t) { return withMappedNodes(t.level, t.nodes, t.map()); }},
    {"reshaped", shapesTakenApart},
    {"cutAlong", [](EditTask& t) { return cutAlong(t.level, t.keys, 5 * t.point(), 5 * t.point()).level; }},
    {"combinedBodies", bodiesCombined},
    {"grouped", [](EditTask& t) { return grouped(t.level, t.keys, t.fresh(GroupObject{})); }},
    {"ungrouped", [](EditTask& t) { return ungrouped(t.level, t.keys); }},
    {"regrouped",
     [](EditTask& t) {
         return regrouped(t.level, t.keys, {t.group(), t.chance() ? t.key : 0});
     }},
    {"withVisible", [](EditTask& t) { return withVisible(t.level, t.keys, t.chance()); }},
    {"withLocked", [](EditTask& t) { return withLocked(t.level, t.keys, t.chance()); }},
    {"arrayed", arrayMade},
    {"merged", editsMerged},
    {"takenOver", objectsTakenOver},
    {"withKept", changesKept},
    {"withDelta", deltaMade},
    {"withTagsMeeting",
     [](EditTask& t) {
         return withTagsMeeting(t.level, t.below(TagTable::size), t.below(TagTable::size), t.chance());
     }},
    {"guideAdded", [](EditTask& t) { return guideAdded(t.level, t.guide()); }},
    {"guideReplaced", [](EditTask& t) { return guideReplaced(t.level, t.guideIndex(), t.guide()); }},
    {"guideRemoved", [](EditTask& t) { return guideRemoved(t.level, t.guideIndex()); }},
    {"guidesCleared", [](EditTask& t) { return guidesCleared(t.level); }},
    {"withFieldEdited", fieldsEdited},
    {"withSizeEdited", sizesEdited},
    {"withLevelFieldEdited", levelFieldsEdited},
    {"extended", chainExtended},
    {"withTagsAdopted",
     [](EditTask& t) {
         return withTagsAdopted(t.level, {t.foreign(), soundLevel(t.random.next()).tags}).level;
     }},
};

} // namespace

std::span<const EditRow> everyEdit() {
    return editRows;
}

} // namespace spacetow::test
