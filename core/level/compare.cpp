#include "core/level/compare.h"

#include "core/base/overloaded.h"
#include "core/level/adopt_tags.h"
#include "core/level/edits.h"
#include "core/level/field_survey.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <utility>

namespace spacetow {

namespace {

template <class Subject>
std::vector<FieldSummary> fieldsOf(const Subject& subject) {
    FieldSurvey survey;
    survey.add(subject);
    return survey.summaries();
}

template <class Subject>
std::vector<FieldDifference> differingFields(const Subject& before, const Subject& after) {
    const std::vector<FieldSummary> old = fieldsOf(before);
    const std::vector<FieldSummary> now = fieldsOf(after);
    std::vector<FieldDifference> result;
    for (const FieldSummary& each : now) {
        const FieldSummary* was = summaryOf(old, each.id);
        if (!each.isOfShape && was != nullptr && !was->isOfShape && !(was->value == each.value)) {
            result.push_back({each.id, each.field, was->value, each.value});
        }
    }
    return result;
}

const std::vector<LevelShape>& shapesOf(const Object& object) {
    static const std::vector<LevelShape> none;
    const auto* body = std::get_if<BodyObject>(&object.data);
    return body != nullptr ? static_cast<const std::vector<LevelShape>&>(body->shapes) : none;
}

std::span<const Vec2> pointsOf(const LevelShape& shape) {
    return std::visit(Overloaded{[](const Circle& circle) { return std::span(&circle.center, 1); },
                                 [](const auto& outline) { return std::span<const Vec2>(outline.vertices); }},
                      shape);
}

/// Equal but for where its points are.
bool isAlike(const LevelShape& a, const LevelShape& b) {
    if (a.index() != b.index() || pointsOf(a).size() != pointsOf(b).size()) {
        return false;
    }
    return std::visit(Overloaded{
                          [&b](const EdgeChain& x) {
                              return x.closed == std::get<EdgeChain>(b).closed &&
                                     x.depth == std::get<EdgeChain>(b).depth;
                          },
                          [&b](const LineChain& x) { return x.closed == std::get<LineChain>(b).closed; },
                          [](const Polygon&) { return true; },
                          [&b](const Circle& x) { return x.radius == std::get<Circle>(b).radius; },
                      },
                      a);
}

bool isOfMotion(std::string_view id) {
    constexpr std::array<std::string_view, 7> names{"position.x", "position.y", "angle", "a.x", "a.y", "b.x", "b.y"};
    return std::ranges::find(names, id) != names.end();
}

bool isOfTags(std::string_view id) {
    return id == "tags" || id == "touches";
}

ObjectChange kindOf(const ObjectDifference& difference) {
    const bool plain = !difference.otherKind && !difference.shapesChanged && !difference.unknownFields;
    const auto all = [&](auto predicate) {
        return std::ranges::all_of(difference.fields, predicate, &FieldDifference::id);
    };
    const bool anything = !difference.fields.empty() || difference.shapesMoved;
    if (plain && !anything) {
        return ObjectChange::Reordered;
    }
    if (plain && !difference.reordered && all(isOfMotion)) {
        return ObjectChange::Moved;
    }
    return plain && !difference.reordered && !difference.shapesMoved && all(isOfTags) ? ObjectChange::Retagged
                                                                                      : ObjectChange::Changed;
}

/// None when they are equal.
std::optional<ObjectDifference> compared(const Object& before, const Object& after, bool reordered) {
    ObjectDifference result;
    result.key = after.key;
    result.reordered = reordered;
    if (!(before == after)) {
        result.otherKind = before.data.index() != after.data.index();
        result.fields = differingFields(before, after);
        result.unknownFields = before.unknownFields != after.unknownFields;
        const std::vector<LevelShape>& old = shapesOf(before);
        const std::vector<LevelShape>& now = shapesOf(after);
        result.shapesMoved = !result.otherKind && old != now && commonWay(old, now).has_value();
        result.shapesChanged = !result.otherKind && old != now && !result.shapesMoved;
    } else if (!reordered) {
        return std::nullopt;
    }
    result.change = kindOf(result);
    return result;
}

/// Which of the numbers are not part of the longest ascending series (patience sorting, Fredman 1975).
std::vector<bool> outOfOrder(const std::vector<int>& numbers) {
    std::vector<int> ends; // places in `numbers` where the best series of each length ends
    std::vector<int> before(numbers.size(), -1);
    for (int i = 0; i < static_cast<int>(numbers.size()); ++i) {
        const auto at = std::ranges::lower_bound(ends, numbers[static_cast<std::size_t>(i)], {},
                                                 [&](int place) { return numbers[static_cast<std::size_t>(place)]; });
        before[static_cast<std::size_t>(i)] = at == ends.begin() ? -1 : *(at - 1);
        if (at == ends.end()) {
            ends.push_back(i);
        } else {
            *at = i;
        }
    }
    std::vector<bool> out(numbers.size(), true);
    for (int i = ends.empty() ? -1 : ends.back(); i >= 0; i = before[static_cast<std::size_t>(i)]) {
        out[static_cast<std::size_t>(i)] = false;
    }
    return out;
}

std::vector<ObjectDifference> differingObjects(const ObjectList& before, const ObjectList& after) {
    std::vector<ObjectDifference> result;
    if (before == after) {
        return result;
    }
    for (const Object& object : before) {
        if (after.find(object.key) == nullptr) {
            result.push_back({.key = object.key, .change = ObjectChange::Removed});
        }
    }
    std::vector<int> places; // before, of what both have, in the order after
    for (const Object& object : after) {
        if (const int place = before.indexOf(object.key); place >= 0) {
            places.push_back(place);
        }
    }
    const std::vector<bool> out = outOfOrder(places);
    std::size_t common = 0;
    for (const Object& object : after) {
        const Object* old = before.find(object.key);
        if (old == nullptr) {
            result.push_back({.key = object.key, .change = ObjectChange::Added});
        } else if (std::optional<ObjectDifference> found = compared(*old, object, out[common++])) {
            result.push_back(std::move(*found));
        }
    }
    return result;
}

/// Those of `guides` that `others` does not have, each counted as often as it is there.
std::vector<Guide> missingIn(std::vector<Guide> others, const std::vector<Guide>& guides) {
    std::vector<Guide> result;
    for (const Guide& guide : guides) {
        const auto same = std::ranges::find(others, guide);
        if (same == others.end()) {
            result.push_back(guide);
        } else {
            others.erase(same);
        }
    }
    return result;
}

/// The keys, and those of what these objects of `other` refer to and `level` does not have.
std::set<Key> withNeeded(const Level& level, const Level& other, std::span<const Key> keys) {
    std::set<Key> all(keys.begin(), keys.end());
    std::vector<Key> open(keys.begin(), keys.end());
    while (!open.empty()) {
        const Object* const object = other.objects.find(open.back());
        open.pop_back();
        if (object == nullptr) {
            continue;
        }
        std::vector<Key> needed{object->parent};
        if (const auto* connector = std::get_if<ConnectorObject>(&object->data)) {
            needed.insert(needed.end(), {connector->a, connector->b});
        }
        for (const Key key : needed) {
            if (level.objects.find(key) == nullptr && other.objects.find(key) != nullptr && all.insert(key).second) {
                open.push_back(key);
            }
        }
    }
    return all;
}

} // namespace

std::optional<Vec2> commonWay(const std::vector<LevelShape>& before, const std::vector<LevelShape>& after) {
    if (before.empty() || before.size() != after.size() || !isAlike(before.front(), after.front()) ||
        pointsOf(before.front()).empty()) {
        return std::nullopt;
    }
    const Vec2 way = pointsOf(after.front()).front() - pointsOf(before.front()).front();
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (!isAlike(before[i], after[i])) {
            return std::nullopt;
        }
        const std::span<const Vec2> old = pointsOf(before[i]);
        const std::span<const Vec2> now = pointsOf(after[i]);
        for (std::size_t k = 0; k < old.size(); ++k) {
            // Sums round; a nanometre is none of anybody's edits.
            if (!((now[k] - old[k] - way).norm() < 1e-9)) {
                return std::nullopt;
            }
        }
    }
    return way;
}

LevelDifference differenceBetween(const Level& before, const Level& after) {
    LevelDifference result;
    result.fields = differingFields(before, after);
    for (int i = 0; i < TagTable::size; ++i) {
        if (!(before.tags[i] == after.tags[i])) {
            result.tags.push_back({i, before.tags[i], after.tags[i]});
        }
    }
    result.guidesAdded = missingIn(before.guides, after.guides);
    result.guidesRemoved = missingIn(after.guides, before.guides);
    result.objects = differingObjects(before.objects, after.objects);
    result.unknownFields = before.unknownFields != after.unknownFields;
    result.hiddenProblems = before.hiddenProblems != after.hiddenProblems;
    return result;
}

Level takenOver(Level level, const Level& other, std::span<const Key> keys) {
    const std::set<Key> wanted = withNeeded(level, other, keys);
    ForeignObjects foreign{{}, other.tags};
    std::vector<Key> gone;
    for (const Object& object : other.objects) {
        if (wanted.contains(object.key)) {
            foreign.objects.push_back(object);
        }
    }
    std::ranges::copy_if(keys, std::back_inserter(gone), [&other](Key key) { return other.objects.indexOf(key) < 0; });
    AdoptedObjects adopted{std::move(level), std::move(foreign.objects), {}};
    if (!(adopted.level.tags == other.tags)) {
        adopted = withTagsAdopted(std::move(adopted.level), {std::move(adopted.objects), other.tags});
    }
    std::map<Key, std::vector<Object>> behind; // of an object that is there; 0: before all
    std::map<Key, Object> instead;
    auto next = adopted.objects.begin();
    Key last = 0;
    for (const Object& object : other.objects) {
        const bool isThere = adopted.level.objects.indexOf(object.key) >= 0;
        last = isThere ? object.key : last;
        if (next != adopted.objects.end() && next->key == object.key) {
            if (isThere) {
                instead.emplace(object.key, std::move(*next));
            } else {
                behind[last].push_back(std::move(*next));
            }
            ++next;
        }
    }
    ObjectList objects;
    const auto append = [&objects](std::vector<Object>& some) {
        std::ranges::for_each(some, [&objects](Object& object) { objects.append(std::move(object)); });
    };
    append(behind[0]);
    for (const Object& object : adopted.level.objects) {
        const auto found = instead.find(object.key);
        objects.append(found == instead.end() ? Object(object) : std::move(found->second));
        if (const auto after = behind.find(object.key); after != behind.end()) {
            append(after->second);
        }
    }
    adopted.level.objects = std::move(objects);
    return removed(std::move(adopted.level), gone);
}

} // namespace spacetow
