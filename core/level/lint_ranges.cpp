#include "core/level/fields.h"
#include "core/level/json_text.h"
#include "core/level/lint_findings.h"

#include <cmath>

namespace spacetow {

namespace {

/// The visitor of core/level/fields.h that compares numbers with their ranges.
class RangeChecker {
  public:
    RangeChecker(Findings& findings, int index, Key key) : m_findings(findings), m_index(index), m_key(key) {}

    void number(const Field& field, double value, double) { check(field, value, ""); }
    void integer(const Field& field, int value, int) { check(field, value, ""); }
    void optionalNumber(const Field& field, const std::optional<double>& value) {
        if (value) {
            check(field, *value, "");
        }
    }
    void depth(const Field& field, double value, double) {
        if (value != noBack) {
            check(field, value, "");
        }
    }
    void point(const Field& field, const Vec2& value, const Vec2&) {
        check(field, value.x(), "/0");
        check(field, value.y(), "/1");
    }
    void points(const Field& field, const std::vector<Vec2>& value) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            const bool inside = value[i].cwiseAbs().maxCoeff() <= field.max; // false for what is not a number
            if (!inside || !isFinite(value[i])) {
                check(field, value[i].x(), '/' + std::to_string(i) + "/0");
                check(field, value[i].y(), '/' + std::to_string(i) + "/1");
            }
        }
    }
    void shapes(const Field& field, const std::vector<LevelShape>& value) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            m_shape = static_cast<int>(i);
            m_list = field.name;
            std::visit([this](const auto& shape) { visitFields(*this, shape); }, value[i]);
        }
        m_shape = -1;
    }
    void flag(const Field&, bool, bool) {}
    void text(const Field&, const std::string&, const std::string&) {}
    void tags(const Field&, TagMask, TagMask) {}
    void touches(const Field&, TagMask) {}
    void key(const Field&, Key) {}
    void optionalKey(const Field&, Key) {}
    void optionalColor(const Field&, const std::optional<std::uint32_t>&) {}
    template <class Enum, std::size_t n>
    void choice(const Field&, Enum, Enum, const Spellings<n>&) {}

    void enter(std::string part) { m_part = '/' + std::move(part); }

  private:
    void check(const Field& field, double value, const std::string& path) {
        if (value >= field.min && value <= field.max && !(field.openMin && value == field.min)) {
            return;
        }
        const std::string list = m_shape < 0 ? m_part : '/' + std::string(m_list) + '/' + std::to_string(m_shape);
        const FindingPlace place{m_index, m_key, list + '/' + field.name + path};
        if (!std::isfinite(value)) {
            m_findings.add(Severity::Error, "not-finite", {field.name}, place);
        } else if (field.openMin && value <= field.min) {
            m_findings.add(Severity::Error, "not-positive", {field.name, spelledNumber(value)}, place);
        } else {
            m_findings.add(Severity::Error, "out-of-range",
                           {field.name, spelledNumber(value), spelledNumber(field.min), spelledNumber(field.max)},
                           place);
        }
    }

    Findings& m_findings;
    int m_index;
    Key m_key;
    std::string m_part;
    const char* m_list = "";
    int m_shape = -1;
};

} // namespace

void checkRanges(const Level& level, Findings& findings) {
    RangeChecker ofLevel(findings, -1, 0);
    visitFields(ofLevel, level);
    ofLevel.enter("rules");
    visitFields(ofLevel, level.rules);
    ofLevel.enter("rules/rope");
    visitFields(ofLevel, level.rules.rope);
    for (std::size_t i = 0; i < level.guides.size(); ++i) {
        ofLevel.enter("guides/" + std::to_string(i));
        visitFields(ofLevel, level.guides[i]);
    }
    for (int i = 0; i < level.objects.size(); ++i) {
        const Object& object = level.objects[i];
        RangeChecker checker(findings, i, object.key);
        std::visit([&checker](const auto& data) { visitFields(checker, data); }, object.data);
    }
}

} // namespace spacetow
