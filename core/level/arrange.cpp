#include "core/level/arrange.h"

#include "core/level/edits.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"

#include <algorithm>
#include <map>

namespace spacetow {

namespace {

/// What is arranged as a whole: an object, or a group with all that is in it.
struct Unit {
    std::vector<Key> keys; // that move
    Aabb box;
};

/// The outermost selected object that holds this one, or 0.
Key unitOf(const GroupTree& tree, const std::vector<Key>& selected, const Object& object) {
    Key unit = 0;
    for (const Object* each = &object; each != nullptr; each = tree.parentOf(*each)) {
        unit = std::ranges::binary_search(selected, each->key) ? each->key : unit;
    }
    return unit;
}

/// Of what has a place and is not locked, in the order of the level.
std::vector<Unit> unitsOf(const Level& level, std::span<const Key> keys) {
    std::vector<Key> selected(keys.begin(), keys.end());
    std::ranges::sort(selected);
    const std::vector<Key> movable = unlockedKeys(level, keys);
    const GroupTree tree(level);
    const LevelIndex& index = levelIndex(level);
    std::map<Key, std::size_t> places;
    std::vector<Unit> units;
    int place = -1;
    for (const Object& object : level.objects) {
        ++place;
        const bool placed = !std::holds_alternative<ConnectorObject>(object.data) && !index.boundsOf(place).isEmpty();
        if (!placed || !std::ranges::binary_search(movable, object.key)) {
            continue;
        }
        const auto [found, isNew] = places.emplace(unitOf(tree, selected, object), units.size());
        if (isNew) {
            units.emplace_back();
        }
        Unit& unit = units[found->second];
        unit.keys.push_back(object.key);
        unit.box.include(index.boundsOf(place));
    }
    return units;
}

/// Each unit by its own way.
Level movedEach(Level level, const std::vector<Unit>& units, const std::vector<Vec2>& ways) {
    std::map<Key, Vec2> wayOf;
    for (std::size_t i = 0; i < units.size(); ++i) {
        for (const Key key : units[i].keys) {
            if (ways[i] != Vec2(0, 0)) {
                wayOf.emplace(key, ways[i]);
            }
        }
    }
    for (const auto& [key, way] : wayOf) {
        const int index = level.objects.indexOf(key);
        Object object = level.objects[index];
        move(object.data, way);
        level.objects.replace(index, std::move(object));
    }
    return level;
}

Vec2 wayTo(const Aabb& all, const Aabb& box, AlignTo side) {
    switch (side) {
    case AlignTo::Left:
        return {all.min.x() - box.min.x(), 0};
    case AlignTo::Right:
        return {all.max.x() - box.max.x(), 0};
    case AlignTo::Top:
        return {0, all.max.y() - box.max.y()};
    case AlignTo::Bottom:
        return {0, all.min.y() - box.min.y()};
    case AlignTo::MiddleAcross:
        return {all.center().x() - box.center().x(), 0};
    case AlignTo::MiddleUpright:
        break;
    }
    return {0, all.center().y() - box.center().y()};
}

/// The place of the next object that overlaps a wanted one drawn before it (downwards: after it), or −1.
int nextOverlapping(const Level& level, const std::vector<Key>& wanted, bool upwards) {
    const LevelIndex& index = levelIndex(level);
    std::vector<Aabb> passed;
    Aabb all;
    const int size = level.objects.size();
    for (int step = 0; step < size; ++step) {
        const int place = upwards ? step : size - 1 - step;
        const Aabb& box = index.boundsOf(place);
        if (std::ranges::binary_search(wanted, level.objects[place].key)) {
            passed.push_back(box);
            all.include(box);
        } else if (all.overlaps(box) &&
                   std::ranges::any_of(passed, [&box](const Aabb& other) { return other.overlaps(box); })) {
            return place;
        }
    }
    return -1;
}

/// Takes out, and gives, those of the keys at `places`, from the first on and before the second.
std::vector<Object> takenOut(Level& level, const std::vector<Key>& wanted, const std::pair<int, int>& places) {
    std::vector<Object> taken;
    for (int i = places.first; i < places.second; ++i) {
        if (std::ranges::binary_search(wanted, level.objects[i].key)) {
            taken.push_back(level.objects[i]);
        }
    }
    std::vector<Key> keys;
    std::ranges::transform(taken, std::back_inserter(keys), &Object::key);
    std::ranges::sort(keys);
    level.objects.eraseIf([&keys](const Object& object) { return std::ranges::binary_search(keys, object.key); });
    return taken;
}

void putAt(Level& level, int place, std::vector<Object> objects) {
    for (Object& object : objects) {
        level.objects.insert(place++, std::move(object));
    }
}

} // namespace

std::vector<Key> unlockedKeys(const Level& level, std::span<const Key> keys) {
    std::vector<Key> wanted = withMembers(level, keys);
    const GroupTree tree(level);
    std::vector<Key> held; // what is locked, and the groups that it is in
    for (const Key key : wanted) {
        const Object* object = level.objects.find(key);
        if (object == nullptr || !tree.isLocked(*object)) {
            continue;
        }
        for (; object != nullptr; object = tree.parentOf(*object)) {
            held.push_back(object->key);
        }
    }
    std::ranges::sort(held);
    std::erase_if(wanted,
                  [&](Key key) { return std::ranges::binary_search(held, key) || level.objects.find(key) == nullptr; });
    return wanted;
}

Aabb placedBounds(const Level& level, std::span<const Key> keys) {
    const LevelIndex& index = levelIndex(level);
    Aabb box;
    for (const Key key : withMembers(level, keys)) {
        const int place = level.objects.indexOf(key);
        if (place >= 0 && !std::holds_alternative<ConnectorObject>(level.objects[place].data)) {
            box.include(index.boundsOf(place));
        }
    }
    return box;
}

Level flipped(Level level, std::span<const Key> keys, FlipAxis axis) {
    const std::vector<Key> wanted = unlockedKeys(level, keys);
    const Aabb box = placedBounds(level, wanted);
    if (box.isEmpty()) {
        return level;
    }
    const Vec2 factors = axis == FlipAxis::Horizontal ? Vec2(-1, 1) : Vec2(1, -1);
    return transformed(std::move(level), wanted, Affine::scaling(box.center(), factors));
}

Level aligned(Level level, std::span<const Key> keys, AlignTo side) {
    const std::vector<Unit> units = unitsOf(level, keys);
    Aabb all;
    for (const Unit& unit : units) {
        all.include(unit.box);
    }
    std::vector<Vec2> ways;
    std::ranges::transform(units, std::back_inserter(ways),
                           [&](const Unit& unit) { return wayTo(all, unit.box, side); });
    return movedEach(std::move(level), units, ways);
}

Level distributed(Level level, std::span<const Key> keys, const Spacing& spacing) {
    std::vector<Unit> units = unitsOf(level, keys);
    if (units.size() < 3) {
        return level;
    }
    const int axis = spacing.across ? 0 : 1;
    const auto placeOf = [&](const Unit& unit) {
        return spacing.what == Spread::Middles ? unit.box.center()[axis] : unit.box.min[axis];
    };
    std::ranges::stable_sort(units, {}, placeOf);
    const double count = static_cast<double>(units.size() - 1);
    double taken = 0; // by what stands between the gaps
    for (const Unit& unit : units) {
        taken += spacing.what == Spread::Gaps ? unit.box.size()[axis] : 0;
    }
    const double first = placeOf(units.front());
    const double last = spacing.what == Spread::Gaps ? units.back().box.max[axis] : placeOf(units.back());
    const double step = (last - first - taken) / count;
    std::vector<Vec2> ways;
    double before = 0;
    for (std::size_t i = 0; i < units.size(); ++i) {
        Vec2 way(0, 0);
        if (i > 0 && i + 1 < units.size()) {
            way[axis] = first + step * static_cast<double>(i) + before - placeOf(units[i]);
        }
        ways.push_back(way);
        before += spacing.what == Spread::Gaps ? units[i].box.size()[axis] : 0;
    }
    return movedEach(std::move(level), units, ways);
}

Level reordered(Level level, std::span<const Key> keys, OrderTo where) {
    const std::vector<Key> wanted = unlockedKeys(level, keys);
    const bool upwards = where == OrderTo::Front || where == OrderTo::Forward;
    if (where == OrderTo::Front || where == OrderTo::Back) {
        std::vector<Object> taken = takenOut(level, wanted, {0, level.objects.size()});
        putAt(level, upwards ? level.objects.size() : 0, std::move(taken));
        return level;
    }
    const int next = nextOverlapping(level, wanted, upwards);
    if (next < 0) {
        return level;
    }
    const Key passed = level.objects[next].key;
    std::vector<Object> taken =
        takenOut(level, wanted, upwards ? std::pair(0, next) : std::pair(next + 1, level.objects.size()));
    putAt(level, level.objects.indexOf(passed) + (upwards ? 1 : 0), std::move(taken));
    return level;
}

Level isolated(Level level, std::span<const Key> keys) {
    const std::vector<Key> kept = withMembers(level, keys);
    const auto isKept = [&kept](Key key) { return std::ranges::binary_search(kept, key); };
    const GroupTree tree(level);
    std::vector<Key> above; // the groups that what is kept is in
    for (const Key key : kept) {
        const Object* object = level.objects.find(key);
        for (object = object == nullptr ? nullptr : tree.parentOf(*object); object != nullptr;
             object = tree.parentOf(*object)) {
            above.push_back(object->key);
        }
    }
    std::ranges::sort(above);
    std::vector<Key> hidden;
    for (const Object& object : level.objects) {
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        const Object* parent = tree.parentOf(object);
        const bool goesWithGroup = parent != nullptr && !std::ranges::binary_search(above, parent->key);
        const bool joins = connector != nullptr && isKept(connector->a) && isKept(connector->b);
        if (!isKept(object.key) && !std::ranges::binary_search(above, object.key) && !goesWithGroup && !joins) {
            hidden.push_back(object.key);
        }
    }
    return withVisible(std::move(level), hidden, false);
}

} // namespace spacetow
