#include "core/level/merge.h"

#include "core/base/overloaded.h"
#include "core/level/groups.h"
#include "core/level/merge_fields.h"
#include "core/level/unknown_fields.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace spacetow {

namespace {

TagMask swapped(TagMask mask, int a, int b) {
    const bool differ = mask.contains(a) != mask.contains(b);
    return differ ? TagMask{mask.bits ^ (TagMask::bit(a) | TagMask::bit(b)).bits} : mask;
}

/// The level with two tags in each other's place; it means the same.
void swapTags(Level& level, int a, int b) {
    const TagInfo kept = level.tags[a];
    level.tags.set(a, level.tags[b]);
    level.tags.set(b, kept);
    for (int i = 0; i < level.objects.size(); ++i) {
        const auto* body = std::get_if<BodyObject>(&level.objects[i].data);
        const Filter filter = body != nullptr ? body->filter : Filter{};
        const Filter other{swapped(filter.tags, a, b), swapped(filter.touches, a, b)};
        if (!(filter == other)) {
            Object object = level.objects[i];
            std::get<BodyObject>(object.data).filter = other;
            level.objects.replace(i, std::move(object));
        }
    }
}

/// The merge of what both have in a list, each entry counted once.
template <class T>
std::vector<T> mergedSet(const std::vector<T>& base, const std::vector<T>& ours, const std::vector<T>& theirs) {
    std::vector<T> result;
    const auto has = [](const std::vector<T>& list, const T& entry) {
        return std::ranges::find(list, entry) != list.end();
    };
    for (const T& entry : ours) {
        if (has(theirs, entry) || !has(base, entry)) {
            result.push_back(entry);
        }
    }
    for (const T& entry : theirs) {
        if (!has(base, entry) && !has(ours, entry)) {
            result.push_back(entry);
        }
    }
    return result;
}

/// Puts the merge together.
class Merge {
  public:
    Merge(const Level& base, const Level& ours, const Level& theirs, MergeSide preferred)
        : m_base(base), m_ours(ours), m_theirs(theirs), m_preferred(preferred) {}

    MergedLevel level() {
        placeTheirTags();
        m_result.level = m_ours;
        FieldMerger fields(m_preferred, 0, m_result.conflicts);
        fields.mergeSimpleFields(m_result.level, m_base, m_theirs);
        mergeTags(fields);
        mergeList(&Level::guides, "/guides");
        mergeList(&Level::hiddenProblems, "/hiddenProblems");
        mergeObjects();
        return std::move(m_result);
    }

  private:
    /// Unknown fields stay with the entries that are ours.
    template <class T>
    void mergeList(std::vector<T> Level::*list, const std::string& place) {
        std::vector<T>& merged = m_result.level.*list;
        merged = mergedSet(m_base.*list, m_ours.*list, m_theirs.*list);
        std::vector<int> lost;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < (m_ours.*list).size(); ++i) {
            if (kept < merged.size() && merged[kept] == (m_ours.*list)[i]) {
                ++kept;
            } else {
                lost.push_back(static_cast<int>(i));
            }
        }
        m_result.level.unknownFields = withoutEntries(m_result.level.unknownFields, place, lost);
    }

    // Tags

    /// Tags of theirs come to stand where ours has those of the same names, and those that only they have made where
    /// there is room. What is known to the base stays.
    void placeTheirTags() {
        for (int i = 0; i < TagTable::size; ++i) {
            const std::string name = m_theirs.tags[i].name;
            if (name.empty() || !m_base.tags[i].name.empty()) {
                continue;
            }
            const std::optional<int> same = m_ours.tags.indexOf(name);
            if (same && *same != i && m_base.tags[*same].name.empty()) {
                swapTags(m_theirs, i, *same);
            } else if (!same && !m_ours.tags[i].name.empty()) {
                move(i);
            }
        }
    }
    void move(int from) {
        for (int to = 0; to < TagTable::size; ++to) {
            if (m_ours.tags[to].name.empty() && m_theirs.tags[to].name.empty() && m_base.tags[to].name.empty()) {
                swapTags(m_theirs, from, to);
                return;
            }
        }
        m_result.conflicts.push_back({ConflictKind::TagsFull, 0, m_theirs.tags[from].name});
        m_theirs.tags.set(from, m_base.tags[from]);
    }
    void mergeTags(FieldMerger& fields) {
        TagTable& tags = m_result.level.tags;
        for (int i = 0; i < TagTable::size; ++i) {
            const auto field = "tag " + (m_base.tags[i].name.empty() ? m_ours.tags[i].name : m_base.tags[i].name);
            TagInfo info;
            info.name = fields.choose(field.c_str(), m_base.tags[i].name, m_ours.tags[i].name, m_theirs.tags[i].name);
            info.color =
                fields.choose(field.c_str(), m_base.tags[i].color, m_ours.tags[i].color, m_theirs.tags[i].color);
            if (!info.name.empty() && tags.indexOf(info.name).value_or(i) < i) {
                info.name = m_ours.tags[i].name; // two tags of one name: theirs keeps ours' name
                m_result.conflicts.push_back({ConflictKind::Field, 0, field});
            }
            tags.set(i, info);
        }
    }

    // Objects

    void mergeObjects() {
        decideWhoStays();
        m_result.level.objects = {};
        for (const Key key : mergedOrder()) {
            if (std::optional<Object> object = mergedObject(key)) {
                m_result.level.objects.append(std::move(*object));
            }
        }
        openCircles();
    }

    const Object* ours(Key key) const { return m_ours.objects.find(key); }
    const Object* theirs(Key key) const { return m_theirs.objects.find(key); }
    const Object* base(Key key) const { return m_base.objects.find(key); }

    /// Removed by one side: it goes, unless the other has changed it or something of the merge needs it.
    void decideWhoStays() {
        for (const Object& object : m_base.objects) {
            const Object* mine = ours(object.key);
            const Object* other = theirs(object.key);
            if ((mine == nullptr && other != nullptr && !(*other == object)) ||
                (other == nullptr && mine != nullptr && !(*mine == object))) {
                keep(object.key);
            }
        }
        for (bool more = true; more;) {
            more = false;
            for (const Level* level : std::initializer_list<const Level*>{&m_ours, &m_theirs}) {
                for (const Object& object : level->objects) {
                    more = (stays(object.key) && keepNeeded(object)) || more;
                }
            }
        }
    }
    bool stays(Key key) const {
        return m_kept.contains(key) ||
               ((ours(key) != nullptr || base(key) == nullptr) && (theirs(key) != nullptr || base(key) == nullptr));
    }
    bool keepNeeded(const Object& object) {
        std::vector<Key> needed{object.parent};
        if (const auto* connector = std::get_if<ConnectorObject>(&object.data)) {
            needed.insert(needed.end(), {connector->a, connector->b});
        }
        bool any = false;
        for (const Key key : needed) {
            if (key != 0 && base(key) != nullptr && !stays(key) && (ours(key) != nullptr || theirs(key) != nullptr)) {
                keep(key);
                any = true;
            }
        }
        return any;
    }
    void keep(Key key) { m_kept.insert(key); }

    std::optional<Object> mergedObject(Key key) {
        const Object* old = base(key);
        const Object* mine = ours(key);
        const Object* other = theirs(key);
        if (m_kept.contains(key)) {
            m_result.conflicts.push_back(
                {mine == nullptr ? ConflictKind::RemovedOurs : ConflictKind::RemovedTheirs, key, {}});
            return mine == nullptr ? *other : *mine;
        }
        if (!stays(key)) {
            return std::nullopt;
        }
        if (mine == nullptr || other == nullptr) {
            return mine == nullptr ? *other : *mine;
        }
        if (old == nullptr) {
            if (!(*mine == *other)) {
                m_result.conflicts.push_back({ConflictKind::AddedTwice, key, {}});
            }
            return m_preferred == MergeSide::Ours ? *mine : *other;
        }
        if (*mine == *other || *other == *old) {
            return *mine;
        }
        return *mine == *old ? *other : FieldMerger(m_preferred, key, m_result.conflicts).merged(*old, *mine, *other);
    }

    // Order

    static std::vector<Key> keysOf(const Level& level) {
        std::vector<Key> keys;
        for (const Object& object : level.objects) {
            keys.push_back(object.key);
        }
        return keys;
    }
    /// The keys of `level` that all three levels have.
    std::vector<Key> commonKeys(const Level& level) const {
        std::vector<Key> keys = keysOf(level);
        std::erase_if(
            keys, [this](Key key) { return base(key) == nullptr || ours(key) == nullptr || theirs(key) == nullptr; });
        return keys;
    }
    /// The order of the side that has changed it, with what only the other has behind what it follows there.
    std::vector<Key> mergedOrder() {
        const std::vector<Key> old = commonKeys(m_base);
        const std::vector<Key> mine = commonKeys(m_ours);
        const std::vector<Key> other = commonKeys(m_theirs);
        const bool both = mine != old && other != old && mine != other;
        if (both) {
            m_result.conflicts.push_back({ConflictKind::Order, 0, {}});
        }
        const bool byTheirs = both ? m_preferred == MergeSide::Theirs : mine == old && other != old;
        return byTheirs ? woven(keysOf(m_theirs), keysOf(m_ours)) : woven(keysOf(m_ours), keysOf(m_theirs));
    }
    static std::vector<Key> woven(const std::vector<Key>& first, const std::vector<Key>& second) {
        const std::set<Key> known(first.begin(), first.end());
        std::map<Key, std::vector<Key>> behind; // 0: before all
        Key last = 0;
        for (const Key key : second) {
            if (known.contains(key)) {
                last = key;
            } else {
                behind[last].push_back(key);
            }
        }
        std::vector<Key> result = behind[0];
        for (const Key key : first) {
            result.push_back(key);
            if (const auto found = behind.find(key); found != behind.end()) {
                result.insert(result.end(), found->second.begin(), found->second.end());
            }
        }
        return result;
    }

    /// One side has put A into B, the other B into A.
    void openCircles() {
        Level& level = m_result.level;
        const GroupTree tree(level);
        for (int i = 0; i < level.objects.size(); ++i) {
            const Object& object = level.objects[i];
            const Object* mine = ours(object.key);
            const bool lost = object.parent != 0 && tree.parentOf(object) == nullptr;
            const Object* parent = level.objects.find(object.parent);
            const bool isGroup = parent != nullptr && std::holds_alternative<GroupObject>(parent->data);
            if (lost && isGroup && mine != nullptr && mine->parent != object.parent) {
                m_result.conflicts.push_back({ConflictKind::Circle, object.key, {}});
                Object back = object;
                back.parent = mine->parent;
                level.objects.replace(i, std::move(back));
            }
        }
    }

    const Level& m_base;
    const Level& m_ours;
    Level m_theirs;
    MergeSide m_preferred;
    std::set<Key> m_kept; // though one side has removed them
    MergedLevel m_result;
};

} // namespace

MergedLevel merged(const Level& base, const Level& ours, const Level& theirs, MergeSide preferred) {
    return Merge(base, ours, theirs, preferred).level();
}

} // namespace spacetow
