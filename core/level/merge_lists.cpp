// Guides and hidden problems, which have no names to be known by, and the fields that nobody here understands: these
// are kept by the places of what they belong to, and the merge has other places.
#include "core/level/merge_fields.h"
#include "core/level/unknown_fields.h"

#include <algorithm>
#include <charconv>
#include <map>

namespace spacetow {

namespace {

constexpr std::string_view mergedLists[] = {"/guides", "/hiddenProblems"};

/// The unknown fields of a level, those of the entries of lists apart.
struct UnknownByEntry {
    std::string rest;
    std::map<std::pair<std::string_view, int>, std::vector<UnknownField>> entries; // by list; places within the entry

    explicit UnknownByEntry(const Level& level) {
        std::vector<UnknownField> others;
        for (UnknownField& field : unknownFields(level.unknownFields)) {
            if (!take(field)) {
                others.push_back(std::move(field));
            }
        }
        rest = unknownFieldsText(others);
    }
    std::string of(std::string_view list, int place) const {
        const auto found = entries.find({list, place});
        return found == entries.end() ? std::string() : unknownFieldsText(found->second);
    }

  private:
    bool take(UnknownField& field) {
        for (const std::string_view list : mergedLists) {
            const std::string_view place = field.place;
            int entry = -1;
            if (place.starts_with(list) && place.size() > list.size() && place[list.size()] == '/') {
                const char* const end = place.data() + place.size();
                const auto parsed = std::from_chars(place.data() + list.size() + 1, end, entry);
                if (parsed.ec == std::errc{}) {
                    field.place = std::string(parsed.ptr, end);
                    entries[{list, entry}].push_back(std::move(field));
                    return true;
                }
            }
        }
        return false;
    }
};

/// −1 for none.
template <class T>
int placeOf(const std::vector<T>& list, const T& entry) {
    const auto found = std::ranges::find(list, entry);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

class ListMerger {
  public:
    ListMerger(FieldMerger& fields, const Level& base, const Level& ours, const Level& theirs)
        : m_fields(fields), m_base(base), m_ours(ours), m_theirs(theirs),
          m_unknown(unknownFields(fields.choose("unknown fields", m_base.rest, m_ours.rest, m_theirs.rest))) {}

    /// What both have, and what one of them has made, each entry counted once.
    template <class T>
    std::vector<T> merged(std::string_view list, const std::vector<T>& base, const std::vector<T>& ours,
                          const std::vector<T>& theirs) {
        std::vector<T> result;
        for (int i = 0; i < static_cast<int>(ours.size()); ++i) {
            const T& entry = ours[static_cast<std::size_t>(i)];
            const int was = placeOf(base, entry);
            const int there = placeOf(theirs, entry);
            if (there >= 0 || was < 0) {
                const std::string mine = m_ours.of(list, i);
                addUnknown(list, result.size(),
                           there < 0 ? mine
                                     : m_fields.choose("unknown fields", m_base.of(list, was), mine,
                                                       m_theirs.of(list, there)));
                result.push_back(entry);
            }
        }
        for (int i = 0; i < static_cast<int>(theirs.size()); ++i) {
            const T& entry = theirs[static_cast<std::size_t>(i)];
            if (placeOf(base, entry) < 0 && placeOf(ours, entry) < 0) {
                addUnknown(list, result.size(), m_theirs.of(list, i));
                result.push_back(entry);
            }
        }
        return result;
    }

    std::string unknown() && {
        std::ranges::stable_sort(m_unknown, {}, &UnknownField::place); // as a reader has them
        return unknownFieldsText(m_unknown);
    }

  private:
    void addUnknown(std::string_view list, std::size_t place, const std::string& text) {
        for (UnknownField& field : unknownFields(text)) {
            field.place.insert(0, std::string(list) + '/' + std::to_string(place));
            m_unknown.push_back(std::move(field));
        }
    }

    FieldMerger& m_fields;
    UnknownByEntry m_base, m_ours, m_theirs;
    std::vector<UnknownField> m_unknown; // of the merge
};

} // namespace

void FieldMerger::mergeLists(Level& ours, const Level& base, const Level& theirs) {
    ListMerger lists(*this, base, ours, theirs);
    std::vector<Guide> guides = lists.merged(mergedLists[0], base.guides, ours.guides, theirs.guides);
    ours.hiddenProblems = lists.merged(mergedLists[1], base.hiddenProblems, ours.hiddenProblems, theirs.hiddenProblems);
    ours.guides = std::move(guides);
    ours.unknownFields = std::move(lists).unknown();
}

} // namespace spacetow
