#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"
#include "core/level/fields.h"
#include "core/level/lint_findings.h"

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

/// Whether two sides of the outline, i before j, meet where they should not.
bool clash(const std::vector<Vec2>& v, std::size_t i, std::size_t j) {
    const std::size_t n = v.size();
    const Vec2& a = v[i];
    const Vec2& b = v[(i + 1) % n];
    const Vec2& c = v[j];
    const Vec2& d = v[(j + 1) % n];
    if (j == i + 1 || (i == 0 && j == n - 1)) {
        // Neighbours share a vertex; they clash when one runs back over the other.
        const bool next = j == i + 1;
        const Vec2 back = next ? Vec2(a - b) : Vec2(b - a);
        const Vec2 on = next ? Vec2(d - c) : Vec2(c - d);
        return cross(back, on) == 0 && back.dot(on) > 0;
    }
    return segmentsMeet(a, b, c, d);
}

/// The first pair of clashing sides, by the number of their first vertex.
std::optional<std::array<std::size_t, 2>> firstClash(const std::vector<Vec2>& v) {
    for (std::size_t i = 0; i < v.size(); ++i) {
        for (std::size_t j = i + 1; j < v.size(); ++j) {
            if (clash(v, i, j)) {
                return std::array{i, j};
            }
        }
    }
    return {};
}

class ShapeChecker {
  public:
    ShapeChecker(Findings& findings, int& searches) : m_findings(findings), m_searches(searches) {}

    void enter(int object, Key key) {
        m_object = object;
        m_key = key;
    }
    void check(const std::vector<LevelShape>& shapes) {
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            m_path = "/shapes/" + std::to_string(i);
            std::visit(*this, shapes[i]);
        }
    }

    void operator()(const EdgeChain& chain) { checkChain(chain.vertices, chain.closed); }
    void operator()(const LineChain& chain) { checkChain(chain.vertices, chain.closed); }
    void operator()(const Circle&) {}
    void operator()(const Polygon& polygon) {
        const std::vector<Vec2>& given = polygon.vertices;
        if (given.size() > static_cast<std::size_t>(limits::polygonVertices)) {
            add(Severity::Error, "polygon-too-large",
                {std::to_string(given.size()), std::to_string(limits::polygonVertices)});
            return;
        }
        reportRepeats(given, true, "repeated-vertex");
        std::vector<Vec2> v = given;
        v.erase(std::unique(v.begin(), v.end()), v.end());
        while (v.size() > 1 && v.back() == v.front()) {
            v.pop_back();
        }
        if (v.size() < 3) {
            add(Severity::Error, "polygon-too-few-vertices", {std::to_string(v.size())});
        } else if (!isSimple(v)) {
            reportCrossing(v);
        } else if (cleanOutline(v).empty() || signedArea(v) == 0) {
            add(Severity::Error, "polygon-flat", {});
        } else if (signedArea(v) < 0) {
            add(Severity::Warning, "polygon-clockwise", {});
            noteIdle(given, true);
        } else {
            noteIdle(given, true);
        }
    }

  private:
    void add(Severity severity, LevelCode code, std::vector<std::string> arguments, const std::string& path = {}) {
        m_findings.add(severity, code, std::move(arguments), {m_object, m_key, m_path + path});
    }
    /// Points on straight sides do nothing. They are told of once a shape, and only when nothing worse is wrong.
    void noteIdle(const std::vector<Vec2>& vertices, bool closed) {
        const std::vector<int> idle = idlePoints(vertices, closed);
        if (!idle.empty()) {
            add(Severity::Note, "idle-points", {std::to_string(idle.size())},
                "/vertices/" + std::to_string(idle.front()));
        }
    }
    void checkChain(const std::vector<Vec2>& vertices, bool closed) {
        if (vertices.size() < 2) {
            add(Severity::Error, "chain-too-short", {std::to_string(vertices.size())});
        } else if (std::ranges::all_of(vertices, [&](const Vec2& v) { return v == vertices.front(); })) {
            add(Severity::Error, "chain-without-length", {});
        } else {
            reportRepeats(vertices, closed, "zero-length-wall");
            noteIdle(vertices, closed);
        }
    }
    void reportRepeats(const std::vector<Vec2>& v, bool closed, LevelCode code) {
        for (std::size_t i = 1; i < v.size() + (closed ? 1 : 0); ++i) {
            const std::size_t here = i % v.size();
            if (v[i - 1] == v[here] && v.size() > 1) {
                add(Severity::Warning, code, {std::to_string(i - 1), std::to_string(here)},
                    "/vertices/" + std::to_string(here));
            }
        }
    }
    void reportCrossing(const std::vector<Vec2>& v) {
        // Naming the place takes the square of the number of sides, so only the first few polygons get it.
        constexpr int maxSearches = 20;
        const auto place = ++m_searches <= maxSearches ? firstClash(v) : std::nullopt;
        if (place) {
            add(Severity::Error, "polygon-crosses-itself", {std::to_string((*place)[0]), std::to_string((*place)[1])});
        } else {
            add(Severity::Error, "polygon-not-simple", {});
        }
    }

    Findings& m_findings;
    int& m_searches;
    int m_object = 0;
    Key m_key = 0;
    std::string m_path;
};

} // namespace

std::vector<int> idlePoints(const std::vector<Vec2>& vertices, bool closed) {
    std::vector<int> idle;
    const auto count = static_cast<int>(vertices.size());
    const auto at = [&](int i) -> const Vec2& { return vertices[static_cast<std::size_t>((i + count) % count)]; };
    for (int i = closed ? 0 : 1; i < count - (closed ? 0 : 1); ++i) {
        const Vec2 arriving = at(i) - at(i - 1);
        const Vec2 leaving = at(i + 1) - at(i);
        if (cross(arriving, leaving) == 0 && arriving.dot(leaving) > 0) {
            idle.push_back(i);
        }
    }
    return idle;
}

void checkShapes(const Level& level, Findings& findings) {
    int searches = 0;
    ShapeChecker checker(findings, searches);
    for (int i = 0; i < level.objects.size(); ++i) {
        const Object& object = level.objects[i];
        if (const auto* body = std::get_if<BodyObject>(&object.data)) {
            if (body->shapes.empty()) {
                findings.add(Severity::Error, "no-shape", {}, {i, object.key, "/shapes"});
            }
            checker.enter(i, object.key);
            checker.check(body->shapes);
        }
    }
}

} // namespace spacetow
