#include "core/level/merge_fields.h"

#include "core/level/each_field.h"

namespace spacetow {

namespace {

/// Shape for shape where none has come or gone.
ShapeList mergedShapes(FieldMerger& merger, const ShapeList& base, const ShapeList& ours, const ShapeList& theirs) {
    if (base.size() != ours.size() || base.size() != theirs.size()) {
        return merger.choose("shapes", base, ours, theirs);
    }
    ShapeList result = ours;
    for (std::size_t i = 0; i < base.size(); ++i) {
        const LevelShape& chosen = merger.choose("shapes", base[i], std::as_const(ours)[i], theirs[i]);
        if (!(chosen == std::as_const(ours)[i])) {
            result[i] = chosen;
        }
    }
    return result;
}

} // namespace

template <class T>
void FieldMerger::mergeFields(T& ours, const T& base, const T& theirs) {
    const std::vector<const void*> old = valuesOfFields(base);
    const std::vector<const void*> others = valuesOfFields(theirs);
    std::size_t next = 0;
    EachField visitor([&]<class Value>(const Field& field, Value& value) {
        const auto& before = *static_cast<const Value*>(old[next]);
        const auto& other = *static_cast<const Value*>(others[next++]);
        if constexpr (std::is_same_v<Value, TagMask>) {
            value = mergedMask(before, value, other);
        } else if constexpr (std::is_same_v<Value, ShapeList>) {
            value = mergedShapes(*this, before, value, other);
        } else {
            value = Value(choose(field.name, before, value, other));
        }
    });
    visitFields(visitor, ours);
}

Object FieldMerger::merged(const Object& base, const Object& ours, const Object& theirs) {
    Object result = ours;
    mergeFields(result, base, theirs);
    result.unknownFields = choose("unknown fields", base.unknownFields, ours.unknownFields, theirs.unknownFields);
    if (ours.data.index() != base.data.index() || theirs.data.index() != base.data.index()) {
        if (ours.data == base.data) {
            result.data = theirs.data;
        } else if (!(theirs.data == base.data) && !(theirs.data == ours.data)) {
            m_conflicts.push_back({ConflictKind::Kind, m_key, {}});
            result.data = m_preferred == MergeSide::Ours ? ours.data : theirs.data;
        }
        return result;
    }
    std::visit(
        [&]<class Data>(Data& data) { mergeFields(data, std::get<Data>(base.data), std::get<Data>(theirs.data)); },
        result.data);
    return result;
}

void FieldMerger::mergeSimpleFields(Level& ours, const Level& base, const Level& theirs) {
    mergeFields(ours, base, theirs);
    mergeFields(ours.rules, base.rules, theirs.rules);
    mergeFields(ours.rules.rope, base.rules.rope, theirs.rules.rope);
}

} // namespace spacetow
