#include "core/level/adopt_tags.h"

#include "core/level/codes.h"
#include "core/level/tag_edits.h"
#include "core/level/tag_spelling.h"

#include <array>

namespace spacetow {

namespace {

constexpr int ownTags = debrisTag + 1; // tags that the game itself knows

/// Finds a place here for each tag that foreign objects use.
class Adoption {
  public:
    Adoption(AdoptedObjects& result, const TagTable& foreign, TagMask used)
        : m_result(result), m_foreign(foreign), m_taken(tagsInUse(result.level) | result.level.tags.named()) {
        m_places.fill(-1);
        for (int tag = 0; tag < TagTable::size; ++tag) {
            if (used.contains(tag)) {
                m_places[static_cast<std::size_t>(tag)] = place(tag);
            }
        }
    }

    void tell() const {
        if (!m_made.empty()) {
            m_result.notes.push_back(Error{LevelCode("tags-made"), {m_made}});
        }
        if (!m_dropped.empty()) {
            m_result.notes.push_back(Error{LevelCode("tags-dropped"), {m_dropped}});
        }
    }

    TagMask mapped(TagMask mask) const {
        const bool isException = isSpelledByExceptions(mask);
        const TagMask listed{isException ? ~mask.bits : mask.bits};
        TagMask here;
        for (int tag = 0; tag < TagTable::size; ++tag) {
            const int at = m_places[static_cast<std::size_t>(tag)];
            if (listed.contains(tag) && at >= 0) {
                here = here | TagMask::bit(at);
            }
        }
        return isException ? TagMask{~here.bits} : here;
    }

  private:
    int place(int tag) {
        TagTable& tags = m_result.level.tags;
        const TagInfo& info = m_foreign[tag];
        if (info.name.empty()) {
            return tags[tag].name.empty() ? tag : reserved({}, '#' + std::to_string(tag));
        }
        if (const std::optional<int> known = tags.indexOf(info.name)) {
            return *known;
        }
        if (tag < ownTags && !tags[tag].name.empty()) {
            m_result.notes.push_back(Error{LevelCode("tag-renamed"), {info.name, tags[tag].name}});
            return tag;
        }
        return reserved(info, info.name);
    }

    /// Of a free tag, which gets the name; −1 when there is none.
    int reserved(const TagInfo& info, const std::string& spelling) {
        for (int tag = 0; tag < TagTable::size; ++tag) {
            if (!m_taken.contains(tag)) {
                m_taken = m_taken | TagMask::bit(tag);
                if (!info.name.empty()) {
                    m_result.level.tags.set(tag, info);
                    add(m_made, info.name);
                }
                return tag;
            }
        }
        add(m_dropped, spelling);
        return -1;
    }

    static void add(std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; }

    AdoptedObjects& m_result;
    std::string m_made;
    std::string m_dropped;
    const TagTable& m_foreign;
    TagMask m_taken;
    std::array<int, TagTable::size> m_places{};
};

} // namespace

AdoptedObjects withTagsAdopted(Level level, ForeignObjects foreign) {
    AdoptedObjects result{std::move(level), std::move(foreign.objects), {}};
    TagMask used;
    for (const Object& object : result.objects) {
        used = used | tagsInUse(object);
    }
    const Adoption adoption(result, foreign.tags, used);
    adoption.tell();
    for (Object& object : result.objects) {
        if (auto* body = std::get_if<BodyObject>(&object.data)) {
            body->filter = {adoption.mapped(body->filter.tags), adoption.mapped(body->filter.touches)};
        }
    }
    return result;
}

} // namespace spacetow
