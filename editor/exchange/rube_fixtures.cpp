#include "editor/exchange/rube_fixtures.h"

#include "core/geometry/polygon.h"
#include "core/level/fields.h"
#include "editor/exchange/figure_shapes.h"
#include "editor/exchange/import_tags.h"
#include "editor/exchange/json_values.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr int rubeBits = 16;
constexpr std::uint32_t allRubeBits = 0xffff;

std::vector<Vec2> rubeVertices(const JsonView& shape) {
    std::vector<Vec2> points;
    const std::optional<JsonView> lists = jsonMember(shape, "vertices");
    const std::optional<JsonView> xs = lists ? jsonMember(*lists, "x") : std::nullopt;
    const std::optional<JsonView> ys = lists ? jsonMember(*lists, "y") : std::nullopt;
    if (!xs || !ys || !xs->isArray() || !ys->isArray()) {
        return points;
    }
    auto y = ys->begin();
    for (const JsonView x : *xs) {
        if (y == ys->end()) {
            break;
        }
        const Vec2 point = onMicrometres({jsonNumberIn(x).value_or(0), jsonNumberIn(*y).value_or(0)});
        if (points.empty() || points.back() != point) {
            points.push_back(point);
        }
        ++y;
    }
    return points;
}

std::optional<LevelShape> chainFrom(std::vector<Vec2> points, bool isLoop) {
    bool isClosed = isLoop;
    if (points.size() > 1 && points.front() == points.back()) {
        points.pop_back();
        isClosed = true;
    }
    if (points.size() < 2) {
        return {};
    }
    return LineChain{points, isClosed && points.size() > 2};
}

std::optional<LevelShape> polygonFrom(std::vector<Vec2> points) {
    if (points.size() > 1 && points.front() == points.back()) {
        points.pop_back();
    }
    if (points.size() == 2) { // older versions of Box2D had edges as polygons
        return chainFrom(std::move(points), false);
    }
    if (points.size() < 3 || points.size() > limits::polygonVertices || !isSimple(points)) {
        return {};
    }
    if (signedArea(points) < 0) {
        std::reverse(points.begin() + 1, points.end());
    }
    return signedArea(points) > 0 ? std::optional<LevelShape>(Polygon{std::move(points)}) : std::nullopt;
}

std::optional<LevelShape> rubeShape(const JsonView& fixture) {
    if (const std::optional<JsonView> circle = jsonMember(fixture, "circle")) {
        const double radius = jsonNumber(*circle, "radius");
        const bool isOne = radius > 0 && radius <= limits::coordinate;
        return isOne ? std::optional<LevelShape>(Circle{onMicrometres(jsonPoint(*circle, "center")), radius})
                     : std::nullopt;
    }
    if (const std::optional<JsonView> polygon = jsonMember(fixture, "polygon")) {
        return polygonFrom(rubeVertices(*polygon));
    }
    if (const std::optional<JsonView> edge = jsonMember(fixture, "edge")) {
        return chainFrom({jsonPoint(*edge, "vertex1"), jsonPoint(*edge, "vertex2")}, false);
    }
    for (const bool isLoop : {false, true}) {
        if (const std::optional<JsonView> chain = jsonMember(fixture, isLoop ? "loop" : "chain")) {
            return chainFrom(rubeVertices(*chain), isLoop);
        }
    }
    return {};
}

void takeMaterial(const JsonView& fixture, BodyObject& body, Report& report) {
    body.friction = rubeNumber(fixture, {"friction", 0, 100, 0}, report);
    body.restitution = rubeNumber(fixture, {"restitution", 0, 1, 0}, report);
    // Without a density Box2D takes a dynamic body for one of a kilogram.
    const double density = rubeNumber(fixture, {"density", 0, limits::mass, 0}, report);
    body.density = density > 0 ? density : 1;
}

} // namespace

RubeTags::RubeTags(const JsonView& root) {
    const std::optional<JsonView> planes = jsonMember(root, "collisionbitplanes");
    const std::optional<JsonView> names = planes ? jsonMember(*planes, "names") : std::nullopt;
    std::size_t bit = 0;
    if (names && names->isArray()) {
        for (const JsonView name : *names) {
            if (bit < m_names.size() && name.isText()) {
                m_names[bit] = name.text();
            }
            ++bit;
        }
    }
}

int RubeTags::tagOf(int bit) {
    if (bit == 0) {
        return wallTag;
    }
    const int tag = debrisTag + bit;
    if (m_table[tag].name.empty()) {
        const std::string& name = m_names[static_cast<std::size_t>(bit)];
        const std::string wanted = name.empty() ? "bitplane" + std::to_string(bit + 1) : spellableTag(name);
        const bool isTaken = m_table.indexOf(wanted).has_value();
        m_table.set(tag, {isTaken ? wanted + ' ' + std::to_string(bit + 1) : wanted, 0x808080});
    }
    return tag;
}

Filter RubeTags::filterOf(const JsonView& fixture) {
    const auto bitsOf = [&fixture](const char* name, std::uint32_t otherwise) {
        const double value = jsonNumber(fixture, name, otherwise);
        return value >= 0 && value <= allRubeBits ? static_cast<std::uint32_t>(value) : allRubeBits;
    };
    const std::uint32_t category = bitsOf("filter-categoryBits", 1);
    const std::uint32_t mask = bitsOf("filter-maskBits", allRubeBits);
    Filter filter{{0}, TagMask::all()};
    for (int bit = 0; bit < rubeBits; ++bit) {
        if ((category >> bit & 1u) != 0) {
            filter.tags = filter.tags | TagMask::bit(tagOf(bit));
        }
        if ((mask >> bit & 1u) == 0) {
            filter.touches = TagMask{filter.touches.bits & ~TagMask::bit(tagOf(bit)).bits};
        }
    }
    return filter;
}

double rubeNumber(const JsonView& object, const RubeRange& range, Report& report) {
    const double value = jsonNumber(object, range.name, range.otherwise);
    if (value < range.least || value > range.most) {
        report.refuse("import-range", object.line(), range.name);
    }
    return std::clamp(value, range.least, range.most);
}

void addFixtures(const JsonView& body, BodyObject& out, RubeTags& tags, Report& report) {
    const std::optional<JsonView> fixtures = jsonMember(body, "fixture");
    if (!fixtures || !fixtures->isArray()) {
        return;
    }
    std::vector<LevelShape> solid, felt; // felt by sensors
    std::optional<BodyObject> first;
    for (const JsonView fixture : *fixtures) {
        std::optional<LevelShape> shape = rubeShape(fixture);
        if (!shape) {
            report.refuse("import-fixture", fixture.line(), jsonText(fixture, "name"));
            continue;
        }
        (jsonFlag(fixture, "sensor") ? felt : solid).push_back(std::move(*shape));
        BodyObject like = out;
        takeMaterial(fixture, like, report);
        like.filter = tags.filterOf(fixture);
        if (jsonNumber(fixture, "filter-groupIndex") != 0) {
            report.refuse("import-filter-groups", fixture.line(), jsonText(body, "name"));
        }
        if (first && !(*first == like)) {
            report.refuse("import-material", fixture.line(), jsonText(body, "name"));
        }
        first = first ? first : like;
    }
    if (first) {
        out = std::move(*first);
    }
    if (!solid.empty() && !felt.empty()) {
        report.refuse("import-sensors", body.line(), jsonText(body, "name"));
    }
    out.tangible = !solid.empty();
    out.shapes = ShapeList(solid.empty() ? std::move(felt) : std::move(solid));
}

} // namespace spacetow
