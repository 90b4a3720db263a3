#include "core/level/merge.h"

#include "core/base/overloaded.h"
#include "core/level/groups.h"
#include "core/level/merge_fields.h"
#include "core/level/tag_edits.h"
#include "core/level/tag_spelling.h"
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
    level.unknownFields = withEntriesSwapped(level.unknownFields, "/tags", a, b);
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

/// The level without the tag on any body: what stands in its place means something else.
void dropTag(Level& level, int tag) {
    for (int i = 0; i < level.objects.size(); ++i) {
        const auto* body = std::get_if<BodyObject>(&level.objects[i].data);
        if (body != nullptr && tagsInUse(level.objects[i]).contains(tag)) {
            const std::uint32_t bit = TagMask::bit(tag).bits;
            const bool isException = isSpelledByExceptions(body->filter.touches);
            Object object = level.objects[i];
            Filter& filter = std::get<BodyObject>(object.data).filter;
            filter.tags.bits &= ~bit;
            filter.touches.bits = isException ? filter.touches.bits | bit : filter.touches.bits & ~bit;
            level.objects.replace(i, std::move(object));
        }
    }
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
        fields.mergeLists(m_result.level, m_base, m_theirs);
        mergeObjects();
        return std::move(m_result);
    }

  private:
    // Tags

    /// Tags of theirs come to stand where ours has those of the same names, and those that only they have made where
    /// there is room. What is known to the base stays.
    void placeTheirTags() {
        for (int i = 0; i < TagTable::size; ++i) {
            while (isNew(i)) {
                const std::optional<int> same = m_ours.tags.indexOf(m_theirs.tags[i].name);
                if (same && *same != i && m_base.tags[*same].name.empty()) {
                    swapTags(m_theirs, i, *same); // what was there may have to go elsewhere, too
                    continue;
                }
                if (!same && !m_ours.tags[i].name.empty()) {
                    move(i);
                }
                break;
            }
        }
    }
    bool isNew(int tag) const { return !m_theirs.tags[tag].name.empty() && m_base.tags[tag].name.empty(); }
    void move(int from) {
        const TagMask taken =
            m_base.tags.named() | m_ours.tags.named() | m_theirs.tags.named() | tagsInUse(m_ours) | tagsInUse(m_theirs);
        for (int to = 0; to < TagTable::size; ++to) {
            if (!taken.contains(to)) {
                swapTags(m_theirs, from, to);
                return;
            }
        }
        m_result.conflicts.push_back({ConflictKind::TagsFull, 0, m_theirs.tags[from].name});
        m_theirs.tags.set(from, m_base.tags[from]);
        dropTag(m_theirs, from);
    }
    void mergeTags(FieldMerger& fields) {
        TagTable& tags = m_result.level.tags;
        for (int i = 0; i < TagTable::size; ++i) {
            const std::string field =
                "tag " + (m_base.tags[i].name.empty() ? m_ours.tags[i].name : m_base.tags[i].name);
            TagInfo info;
            info.name = fields.choose(field.c_str(), m_base.tags[i].name, m_ours.tags[i].name, m_theirs.tags[i].name);
            info.color =
                fields.choose(field.c_str(), m_base.tags[i].color, m_ours.tags[i].color, m_theirs.tags[i].color);
            tags.set(i, info);
        }
        while (const std::optional<int> twice = tagNamedTwice()) { // ends: each time one more is called as ours is
            m_result.conflicts.push_back({ConflictKind::Field, 0, "tag " + tags[*twice].name});
            tags.set(*twice, {m_ours.tags[*twice].name, tags[*twice].color});
        }
    }
    /// A tag that has, from theirs, a name that another one has as well: they keep ours' names.
    std::optional<int> tagNamedTwice() const {
        const TagTable& tags = m_result.level.tags;
        for (int i = 0; i < TagTable::size; ++i) {
            for (int j = 0; j < TagTable::size && !tags[i].name.empty(); ++j) {
                if (i != j && tags[j].name == tags[i].name && tags[i].name != m_ours.tags[i].name) {
                    return i;
                }
            }
        }
        return {};
    }

    // Objects

    void mergeObjects() {
        decideWhoStays();
        m_result.level.objects = {};
        for (const Key key : mergedOrder()) {
            if (std::optional<Object> object = mergedObject(key, m_result.conflicts)) {
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
        const std::vector<Key> all = woven(keysOf(m_ours), keysOf(m_theirs));
        for (bool more = true; more;) {
            more = false;
            for (const Key key : all) {
                more = keepNeeded(key) || more;
            }
        }
    }
    bool stays(Key key) const {
        return m_kept.contains(key) ||
               ((ours(key) != nullptr || base(key) == nullptr) && (theirs(key) != nullptr || base(key) == nullptr));
    }
    bool isAboutToGo(Key key) const {
        return key != 0 && base(key) != nullptr && !stays(key) && (ours(key) != nullptr || theirs(key) != nullptr);
    }
    static std::vector<Key> neededBy(const Object* object) {
        std::vector<Key> needed;
        if (object != nullptr) {
            needed.push_back(object->parent);
            if (const auto* connector = std::get_if<ConnectorObject>(&object->data)) {
                needed.insert(needed.end(), {connector->a, connector->b});
            }
        }
        return needed;
    }
    /// What the merged object refers to, which need not be what either side's does.
    bool keepNeeded(Key key) {
        bool isMatter = false;
        for (const Object* object : {ours(key), theirs(key)}) {
            const std::vector<Key> needed = neededBy(object);
            isMatter = isMatter || std::ranges::any_of(needed, [this](Key other) { return isAboutToGo(other); });
        }
        std::vector<MergeConflict> untold;
        const std::optional<Object> object = isMatter ? mergedObject(key, untold) : std::nullopt;
        bool any = false;
        for (const Key needed : neededBy(object ? &*object : nullptr)) {
            if (isAboutToGo(needed)) {
                keep(needed);
                any = true;
            }
        }
        return any;
    }
    void keep(Key key) { m_kept.insert(key); }

    std::optional<Object> mergedObject(Key key, std::vector<MergeConflict>& conflicts) const {
        const Object* old = base(key);
        const Object* mine = ours(key);
        const Object* other = theirs(key);
        if (m_kept.contains(key)) {
            conflicts.push_back({mine == nullptr ? ConflictKind::RemovedOurs : ConflictKind::RemovedTheirs, key, {}});
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
                conflicts.push_back({ConflictKind::AddedTwice, key, {}});
            }
            return m_preferred == MergeSide::Ours ? *mine : *other;
        }
        if (*mine == *other || *other == *old) {
            return *mine;
        }
        return *mine == *old ? *other : FieldMerger(m_preferred, key, conflicts).merged(*old, *mine, *other);
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
