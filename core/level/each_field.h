#pragma once
// A visitor of core/level/fields.h for those to whom fields of all types are alike.

#include "core/level/fields.h"

#include <string>
#include <utility>
#include <vector>

namespace spacetow {

/// Calls `each(field, value)`.
template <class Each>
class EachField {
  public:
    explicit EachField(Each each) : m_each(std::move(each)) {}

    void number(const Field& field, auto& value, double) { m_each(field, value); }
    void integer(const Field& field, auto& value, int) { m_each(field, value); }
    void optionalNumber(const Field& field, auto& value) { m_each(field, value); }
    void depth(const Field& field, auto& value, double) { m_each(field, value); }
    void flag(const Field& field, auto& value, bool) { m_each(field, value); }
    void text(const Field& field, auto& value, const std::string&) { m_each(field, value); }
    void choice(const Field& field, auto& value, const auto&, const auto&) { m_each(field, value); }
    void point(const Field& field, auto& value, const Vec2&) { m_each(field, value); }
    void points(const Field& field, auto& value) { m_each(field, value); }
    void tags(const Field& field, auto& value, TagMask) { m_each(field, value); }
    void touches(const Field& field, auto& value) { m_each(field, value); }
    void key(const Field& field, auto& value) { m_each(field, value); }
    void optionalKey(const Field& field, auto& value) { m_each(field, value); }
    void optionalColor(const Field& field, auto& value) { m_each(field, value); }
    void shapes(const Field& field, auto& value) { m_each(field, value); }

  private:
    Each m_each;
};

/// Where the values of all fields are, in the order of the fields.
template <class T>
std::vector<const void*> valuesOfFields(const T& object) {
    std::vector<const void*> values;
    EachField visitor([&values](const Field&, const auto& value) { values.push_back(&value); });
    visitFields(visitor, object);
    return values;
}

} // namespace spacetow
