#include "core/level/fix_edits.h"

#include "core/geometry/polygon.h"
#include "core/geometry/triangulate.h"
#include "core/level/chain_ends.h"
#include "core/level/edits.h"
#include "core/level/level_index.h"
#include "core/level/lint.h"
#include "core/level/lint_findings.h"
#include "core/level/nodes.h"
#include "core/level/object_geometry.h"
#include "core/level/unknown_fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

/// Replaces the object when `change(object)` says that it has changed it.
template <class Change>
Level withChanged(Level level, Key key, Change change) {
    const int index = level.objects.indexOf(key);
    if (index >= 0) {
        Object object = level.objects[index];
        if (change(object)) {
            level.objects.replace(index, std::move(object));
        }
    }
    return level;
}

/// Likewise for the vertices of all its outlines: `change(vertices, closed)`.
template <class Change>
Level withVerticesChanged(Level level, Key key, Change change) {
    return withChanged(std::move(level), key, [&change](Object& object) {
        auto* body = std::get_if<BodyObject>(&object.data);
        bool isChanged = false;
        for (std::size_t i = 0; body != nullptr && i < body->shapes.size(); ++i) {
            LevelShape shape = std::as_const(body->shapes)[i];
            std::vector<Vec2>* vertices = verticesOf(shape);
            if (vertices != nullptr && change(*vertices, isClosed(shape), shape)) {
                body->shapes[i] = std::move(shape);
                isChanged = true;
            }
        }
        return isChanged;
    });
}

/// Likewise for one shape of a body: `change(body, shape)`.
template <class Change>
Level withShapeChanged(Level level, const ShapeRef& ref, Change change) {
    return withChanged(std::move(level), ref.key, [&](Object& object) {
        auto* body = std::get_if<BodyObject>(&object.data);
        return body != nullptr && ref.shape >= 0 && ref.shape < std::ssize(std::as_const(body->shapes)) &&
               change(*body, body->shapes[static_cast<std::size_t>(ref.shape)]);
    });
}

std::size_t fewest(const LevelShape& shape) {
    return std::holds_alternative<Polygon>(shape) ? 3 : 2;
}

bool closeOnItself(LevelShape& shape) {
    return std::visit(
        [](auto& chain) {
            if constexpr (requires { chain.closed; }) {
                if (chain.vertices.size() > 3) {
                    chain.vertices.pop_back();
                    chain.closed = true;
                } else {
                    chain.vertices.back() = chain.vertices.front();
                }
                return true;
            }
            return false;
        },
        shape);
}

/// The point of the body's own coordinates that is at `world`: that of another end where there is one, bit for bit.
Vec2 localAt(const BodyObject& body, const Vec2& world) {
    constexpr double same = 1e-9; // m
    const Transform pose{body.position, Rot::fromAngle(body.angle)};
    for (const LevelShape& shape : body.shapes) {
        const std::vector<Vec2>* vertices = verticesOf(shape);
        if (vertices == nullptr || vertices->empty()) {
            continue;
        }
        for (const Vec2& end : {vertices->front(), vertices->back()}) {
            if ((pose.toWorld(end) - world).norm() <= same) {
                return end;
            }
        }
    }
    return pose.toLocal(world);
}

bool canBeBuilt(const LevelShape& shape) {
    const std::vector<Vec2>* given = verticesOf(shape);
    if (given == nullptr) {
        return true;
    }
    std::vector<Vec2> v = *given;
    v.erase(std::unique(v.begin(), v.end()), v.end());
    while (isClosed(shape) && v.size() > 1 && v.back() == v.front()) {
        v.pop_back();
    }
    const bool isPolygon = std::holds_alternative<Polygon>(shape);
    return v.size() >= fewest(shape) &&
           (!isPolygon || !isSimple(v) || (signedArea(v) != 0 && !cleanOutline(v).empty()));
}

bool startsWell(const Level& level, Key key) {
    return std::ranges::none_of(placingProblems(level), [key](const Problem& problem) {
        return problem.object == key &&
               (problem.code.text().ends_with("-in-wall") || problem.code.text().ends_with("-outside"));
    });
}

} // namespace

int numberAfter(std::string_view pointer, std::string_view name) {
    const std::size_t at = pointer.find(name);
    int number = -1;
    if (at != std::string_view::npos) {
        std::from_chars(pointer.data() + at + name.size(), pointer.data() + pointer.size(), number);
    }
    return number;
}

Level withoutRepeats(Level level, Key key) {
    return withVerticesChanged(std::move(level), key, [](std::vector<Vec2>& v, bool closed, const LevelShape& shape) {
        std::vector<Vec2> kept = v;
        kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
        while (closed && kept.size() > 1 && kept.back() == kept.front()) {
            kept.pop_back();
        }
        if (kept.size() == v.size() || kept.size() < fewest(shape)) {
            return false;
        }
        v = std::move(kept);
        return true;
    });
}

Level withoutIdlePoints(Level level, Key key) {
    return withVerticesChanged(std::move(level), key, [](std::vector<Vec2>& v, bool closed, const LevelShape& shape) {
        bool isChanged = false;
        for (std::vector<int> idle = idlePoints(v, closed); !idle.empty(); idle = idlePoints(v, closed)) {
            if (v.size() - idle.size() < fewest(shape)) {
                break;
            }
            std::vector<Vec2> kept;
            auto next = idle.begin();
            for (std::size_t i = 0; i < v.size(); ++i) {
                if (next != idle.end() && *next == static_cast<int>(i)) {
                    ++next;
                } else {
                    kept.push_back(v[i]);
                }
            }
            v = std::move(kept);
            isChanged = true;
        }
        return isChanged;
    });
}

Level anticlockwise(Level level, Key key) {
    return withVerticesChanged(std::move(level), key, [](std::vector<Vec2>& v, bool, const LevelShape& shape) {
        const bool turns = std::holds_alternative<Polygon>(shape) && signedArea(v) < 0;
        if (turns) {
            reverse(v, true);
        }
        return turns;
    });
}

Level reversedShape(Level level, Key key, int shape) {
    return withShapeChanged(std::move(level), {key, shape}, [](BodyObject&, LevelShape& changed) {
        std::vector<Vec2>* vertices = verticesOf(changed);
        if (vertices != nullptr) {
            reverse(*vertices, isClosed(changed));
        }
        return vertices != nullptr;
    });
}

Level withEndMoved(Level level, const ShapeRef& chain, const Vec2& from, const Vec2& to) {
    constexpr double same = 1e-9; // m
    return withShapeChanged(std::move(level), chain, [&](BodyObject& body, LevelShape& shape) {
        std::vector<Vec2>* v = verticesOf(shape);
        if (v == nullptr || isClosed(shape) || v->size() < 2) {
            return false;
        }
        const Transform pose{body.position, Rot::fromAngle(body.angle)};
        const auto isAt = [&](const Vec2& local, const Vec2& world) {
            return (pose.toWorld(local) - world).norm() <= same;
        };
        const bool first = isAt(v->front(), from);
        if (!first && !isAt(v->back(), from)) {
            return false;
        }
        if (isAt(first ? v->back() : v->front(), to)) {
            return closeOnItself(shape);
        }
        (first ? v->front() : v->back()) = localAt(body, to);
        return true;
    });
}

Level withWallAdded(Level level, const ShapeRef& chain, const Vec2& from, const Vec2& to) {
    constexpr double same = 1e-6; // m
    for (const bool first : {true, false}) {
        const ChainEnd end{chain.key, chain.shape, first};
        const std::optional<OpenChain> open = openChain(level, end);
        if (open && (open->at - from).norm() <= same && (to - from).norm() > same) {
            const bool closes = (open->other - to).norm() <= same;
            const std::vector<Vec2> points = closes ? std::vector<Vec2>() : std::vector{to};
            return extended(std::move(level), end, points, closes);
        }
    }
    return level;
}

Level withDepthAtMost(Level level, const ShapeRef& chain, double thickness) {
    return withShapeChanged(std::move(level), chain, [thickness](BodyObject&, LevelShape& shape) {
        auto* edges = std::get_if<EdgeChain>(&shape);
        const double centimetres = std::floor(100 * thickness + 1e-6) / 100;
        const double depth = centimetres > 0 ? centimetres : 0.5 * thickness;
        if (edges == nullptr || edges->depth <= depth) {
            return false;
        }
        edges->depth = depth;
        return true;
    });
}

Level withoutTwin(Level level, Key key) {
    for (const int place : levelIndex(level).connectors()) {
        const auto& connector = std::get<ConnectorObject>(level.objects[place].data);
        if (connector.a == key || connector.b == key) {
            return level;
        }
    }
    const std::array keys{key};
    return removed(std::move(level), keys);
}

Level withoutUnbuildable(Level level, Key key) {
    bool isEmpty = false;
    level = withChanged(std::move(level), key, [&isEmpty](Object& object) {
        auto* body = std::get_if<BodyObject>(&object.data);
        if (body == nullptr) {
            return false;
        }
        std::vector<LevelShape> kept;
        std::vector<int> lost;
        for (int i = 0; const LevelShape& shape : std::as_const(body->shapes)) {
            if (canBeBuilt(shape)) {
                kept.push_back(shape);
            } else {
                lost.push_back(i);
            }
            ++i;
        }
        isEmpty = kept.empty();
        body->shapes = std::move(kept);
        object.unknownFields = withoutEntries(object.unknownFields, "/shapes", lost);
        return !lost.empty();
    });
    const std::array keys{key};
    return isEmpty ? removed(std::move(level), keys) : level;
}

Level withFreshKey(Level level, int index) {
    if (index >= 0 && index < level.objects.size()) {
        Object object = level.objects[index];
        object.key = freshKey(level, static_cast<std::uint64_t>(index) + 1);
        level.objects.replace(index, std::move(object));
    }
    return level;
}

Level withoutParent(Level level, Key key) {
    return withChanged(std::move(level), key, [](Object& object) { return std::exchange(object.parent, 0) != 0; });
}

Level taggedAsWall(Level level, Key key) {
    return withChanged(std::move(level), key, [](Object& object) {
        auto* body = std::get_if<BodyObject>(&object.data);
        if (body != nullptr) {
            body->filter.tags = body->filter.tags | TagMask::bit(wallTag);
        }
        return body != nullptr;
    });
}

Level movedFree(Level level, Key key) {
    constexpr double step = 0.1; // m, between the rings that are tried
    constexpr int rings = 100;
    constexpr int directions = 16;
    constexpr int mostLooks = 40; // at the whole level
    int looks = 0;
    const int index = level.objects.indexOf(key);
    if (index < 0) {
        return level;
    }
    std::set<Key> unsound;
    for (const Problem& problem : buildingProblems(level)) {
        if (problem.severity == Severity::Error) {
            unsound.insert(problem.object);
        }
    }
    for (int ring = 1; ring <= rings && looks < mostLooks; ++ring) {
        for (int i = 0; i < directions && looks < mostLooks; ++i) {
            const double angle = 2 * std::numbers::pi * i / directions;
            Object object = level.objects[index];
            move(object.data, ring * step * Vec2(std::sin(angle), std::cos(angle)));
            if (!startsFree(level, object, unsound)) {
                continue;
            }
            ++looks;
            Level there = level;
            there.objects.replace(index, std::move(object));
            if (startsWell(there, key)) {
                return there;
            }
        }
    }
    return level;
}

} // namespace spacetow
