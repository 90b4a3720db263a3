#include "core/level/kept_changes.h"

#include "core/level/each_field.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace spacetow {

namespace {

/// The field's name, of both parts of a point.
std::string wholeField(const std::string& id) {
    const bool isPart = id.ends_with(".x") || id.ends_with(".y");
    return isPart ? id.substr(0, id.size() - 2) : id;
}

using FieldNames = std::set<std::string, std::less<>>;

FieldNames namesOf(const std::vector<FieldDifference>& fields) {
    FieldNames names;
    for (const FieldDifference& field : fields) {
        names.insert(wholeField(field.id));
    }
    return names;
}

/// The fields of these names become as `from` has them.
template <class T>
void takeFields(T& to, const T& from, const FieldNames& names) {
    const std::vector<const void*> values = valuesOfFields(from);
    std::size_t next = 0;
    EachField visitor([&]<class Value>(const Field& field, Value& value) {
        const auto& other = *static_cast<const Value*>(values[next++]);
        if (names.contains(field.name)) {
            value = other;
        }
    });
    visitFields(visitor, to);
}

/// What is kept of one object that is in both levels.
void takeOfObject(Object& object, const Object& after, const ObjectDifference& what) {
    if (what.otherKind) {
        object = after;
        return;
    }
    FieldNames names = namesOf(what.fields);
    if (what.shapesMoved || what.shapesChanged) {
        names.insert("shapes");
    }
    takeFields(object, after, names);
    std::visit([&]<class Data>(Data& data) { takeFields(data, std::get<Data>(after.data), names); }, object.data);
    if (what.unknownFields) {
        object.unknownFields = after.unknownFields;
    }
}

void takeOfLevel(Level& level, const Level& after, const LevelChange& change) {
    const FieldNames names = namesOf(change.what.fields);
    takeFields(level, after, names);
    takeFields(level.rules, after.rules, names);
    takeFields(level.rules.rope, after.rules.rope, names);
    for (const TagDifference& tag : change.what.tags) {
        level.tags.set(tag.index, tag.after);
    }
    if (change.guides) {
        level.guides = after.guides;
    }
    if (change.what.hiddenProblems) {
        level.hiddenProblems = after.hiddenProblems;
    }
    if (change.what.unknownFields) {
        level.unknownFields = after.unknownFields;
    }
}

/// The order of drawing, where some of the changes are kept.
class KeptOrder {
  public:
    KeptOrder(const Level& before, const Level& after, std::span<const LevelChange> changes,
              const std::vector<int>& kept)
        : m_before(before), m_after(after) {
        for (const LevelChange& change : changes) {
            if (change.object != 0 && change.what.objects.front().reordered) {
                m_out.insert(change.object);
            }
        }
        for (const int place : kept) {
            const LevelChange& change = changes[static_cast<std::size_t>(place)];
            if (change.object != 0) {
                note(change.what.objects.front());
            }
        }
    }

    bool changesNothing() const { return m_added.empty() && m_removed.empty() && m_moved.empty(); }
    const std::set<Key>& removed() const { return m_removed; }
    const std::set<Key>& added() const { return m_added; }

    /// What stands where it stands after them, and all else behind what it followed before them.
    std::vector<Key> keys() const {
        std::map<Key, std::vector<Key>> behind; // 0: before all
        Key last = 0;
        for (const Object& object : m_before.objects) {
            const bool isOut = m_out.contains(object.key) && !m_moved.contains(object.key);
            if (m_removed.contains(object.key) || m_moved.contains(object.key)) {
                continue;
            }
            if (isOut || m_after.objects.indexOf(object.key) < 0) {
                behind[last].push_back(object.key);
            } else {
                last = object.key;
            }
        }
        std::vector<Key> keys = behind[0];
        for (const Object& object : m_after.objects) {
            const bool isThere = m_before.objects.indexOf(object.key) >= 0;
            const bool isOut = m_out.contains(object.key) && !m_moved.contains(object.key);
            if (isThere ? isOut : !m_added.contains(object.key)) {
                continue;
            }
            keys.push_back(object.key);
            if (const auto found = behind.find(object.key); found != behind.end()) {
                keys.insert(keys.end(), found->second.begin(), found->second.end());
            }
        }
        return keys;
    }

  private:
    void note(const ObjectDifference& object) {
        if (object.change == ObjectChange::Added) {
            m_added.insert(object.key);
        } else if (object.change == ObjectChange::Removed) {
            m_removed.insert(object.key);
        } else if (object.reordered) {
            m_moved.insert(object.key);
        }
    }

    const Level& m_before;
    const Level& m_after;
    std::set<Key> m_out; // in another place among those that both levels have
    std::set<Key> m_added, m_removed, m_moved;
};

/// `order` is of `before`, whose objects those of the level still are.
void arrange(ObjectList& objects, const Level& after, const KeptOrder& order) {
    const std::vector<Key> keys = order.keys();
    objects.eraseIf([&order](const Object& object) { return order.removed().contains(object.key); });
    for (const Key key : order.added()) {
        objects.append(*after.objects.find(key));
    }
    std::vector<int> places;
    places.reserve(keys.size());
    for (const Key key : keys) {
        places.push_back(objects.indexOf(key));
    }
    if (!std::ranges::is_sorted(places)) {
        objects.rearrange(places);
    }
}

/// What is kept of it but for the order, and objects that come and go.
void takeChange(Level& level, const Level& after, const LevelChange& change) {
    if (change.object == 0) {
        takeOfLevel(level, after, change);
        return;
    }
    const int at = level.objects.indexOf(change.object);
    const Object* now = after.objects.find(change.object);
    if (at >= 0 && now != nullptr) {
        Object object = level.objects[at];
        takeOfObject(object, *now, change.what.objects.front());
        if (!(object == level.objects[at])) {
            level.objects.replace(at, std::move(object));
        }
    }
}

Level inOrder(Level level, const Level& after, const KeptOrder& order) {
    if (!order.changesNothing()) {
        arrange(level.objects, after, order);
    }
    return level;
}

} // namespace

std::vector<int> keptTogether(std::span<const LevelChange> changes, std::span<const int> places) {
    std::set<int> kept(places.begin(), places.end());
    std::vector<int> open(places.begin(), places.end());
    while (!open.empty()) {
        const LevelChange& change = changes[static_cast<std::size_t>(open.back())];
        open.pop_back();
        for (const int needed : change.needs) {
            if (kept.insert(needed).second) {
                open.push_back(needed);
            }
        }
    }
    return {kept.begin(), kept.end()};
}

Level withKept(const Level& before, const Level& after, std::span<const LevelChange> changes,
               std::span<const int> places) {
    const std::vector<int> kept = keptTogether(changes, places);
    if (kept.size() == changes.size()) {
        return after; // with what counts as equal and is spelled otherwise, as −0
    }
    Level level = before;
    for (const int place : kept) {
        takeChange(level, after, changes[static_cast<std::size_t>(place)]);
    }
    return inOrder(std::move(level), after, KeptOrder(before, after, changes, kept));
}

ChangesKept::ChangesKept(const Level& before, const Level& after, std::span<const LevelChange> changes)
    : m_before(before), m_after(after), m_changes(changes), m_taken(before), m_isKept(changes.size()) {}

void ChangesKept::take(int place) {
    if (m_isKept[static_cast<std::size_t>(place)]) {
        return;
    }
    m_isKept[static_cast<std::size_t>(place)] = true;
    m_kept.push_back(place);
    const LevelChange& change = m_changes[static_cast<std::size_t>(place)];
    takeChange(m_taken, m_after, change);
    std::ranges::for_each(change.needs, [this](int needed) { take(needed); });
}

Level ChangesKept::with(int place) {
    take(place);
    return m_kept.size() == m_changes.size()
               ? m_after
               : inOrder(m_taken, m_after, KeptOrder(m_before, m_after, m_changes, m_kept));
}

} // namespace spacetow
