#pragma once
// Merging of the fields of one thing, of which core/level/fields.h tells. For merge.cpp alone.

#include "core/level/merge.h"

namespace spacetow {

/// `base`, `ours` and `theirs` in one; conflicts carry `key`.
class FieldMerger {
  public:
    FieldMerger(MergeSide preferred, Key key, std::vector<MergeConflict>& conflicts)
        : m_preferred(preferred), m_key(key), m_conflicts(conflicts) {}

    Object merged(const Object& base, const Object& ours, const Object& theirs);
    /// The simple fields and rules of the level; everything else as ours has it.
    void mergeSimpleFields(Level& ours, const Level& base, const Level& theirs);
    /// Guides, hidden problems, and the fields that nobody understands, of all but objects.
    void mergeLists(Level& ours, const Level& base, const Level& theirs);

    /// The value that the merge has of one that is a whole.
    template <class T>
    const T& choose(const char* field, const T& base, const T& ours, const T& theirs) {
        if (theirs == base || ours == theirs) {
            return ours;
        }
        if (ours == base) {
            return theirs;
        }
        m_conflicts.push_back({ConflictKind::Field, m_key, field});
        return m_preferred == MergeSide::Ours ? ours : theirs;
    }

  private:
    template <class T>
    void mergeFields(T& ours, const T& base, const T& theirs);

    MergeSide m_preferred;
    Key m_key;
    std::vector<MergeConflict>& m_conflicts;
};

/// A bit that one side has changed is as that side has it.
inline TagMask mergedMask(TagMask base, TagMask ours, TagMask theirs) {
    const std::uint32_t changed = base.bits ^ ours.bits;
    return {(ours.bits & changed) | (theirs.bits & ~changed)};
}

} // namespace spacetow
