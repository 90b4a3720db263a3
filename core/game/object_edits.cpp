#include "core/game/object_edits.h"

#include "core/level/build.h"

#include <algorithm>

namespace spacetow {
namespace {

std::vector<Key> keysAtDifferences(const Level& before, const Level& after) {
    std::vector<Key> keys;
    after.objects.visitDifferences(before.objects, [&](int index) {
        for (const Level* level : {&before, &after}) {
            if (index < level->objects.size()) {
                keys.push_back(level->objects[index].key);
            }
        }
    });
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

} // namespace

std::vector<ObjectEdit> editsBetween(const Level& before, const Level& after) {
    std::vector<ObjectEdit> edits;
    std::vector<std::pair<int, ObjectEdit>> ordered;
    for (const Key key : keysAtDifferences(before, after)) {
        const ObjectEdit edit{before.objects.find(key), after.objects.find(key)};
        if (edit.before != edit.after && !(edit.before && edit.after && edit.before->data == edit.after->data)) {
            const int place =
                edit.after ? after.objects.indexOf(key) : before.objects.indexOf(key) - before.objects.size();
            ordered.emplace_back(place, edit);
        }
    }
    std::ranges::sort(ordered, {}, &std::pair<int, ObjectEdit>::first);
    edits.reserve(ordered.size());
    for (const auto& [place, edit] : ordered) {
        edits.push_back(edit);
    }
    return edits;
}

std::vector<Key> unbuildable(const Level& level, const std::vector<ObjectEdit>& edits) {
    std::vector<Key> wanted;
    for (const ObjectEdit& edit : edits) {
        if (edit.after == nullptr) {
            continue;
        }
        wanted.push_back(edit.after->key);
        if (const auto* connector = as<ConnectorObject>(edit.after)) {
            wanted.insert(wanted.end(), {connector->a, connector->b}); // without them it would be a fault
        }
    }
    Level some = level;
    some.objects = ObjectList();
    for (const int index : level.objects.indicesOf(wanted)) {
        some.objects.append(level.objects[index]);
    }
    std::vector<Key> bad;
    for (const Problem& problem : problemsLeftOut(some)) {
        bad.push_back(problem.object);
    }
    std::ranges::sort(bad);
    return bad;
}

} // namespace spacetow
