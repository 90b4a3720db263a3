#include "core/level/knife.h"

#include "core/geometry/intersect.h"
#include "core/geometry/polygon.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/shape_pieces.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

struct Knife {
    Vec2 a, b; // local to the body
};

/// Where the knife meets an outline: at a vertex (`inserted` false), or within the segment that begins there.
struct Crossing {
    int vertex = 0;
    bool inserted = false;
    double along = 0; // the outline, from the vertex on, 0 … 1
    double onKnife = 0;
    Vec2 at{0, 0};
};

/// In the order of the outline, no two at one place. What runs along the knife does not cross it.
std::vector<Crossing> crossingsOf(const std::vector<Vec2>& vertices, bool closed, const Knife& knife) {
    const std::size_t count = vertices.size();
    const double near = 1e-9 * std::max({1.0, knife.a.norm(), knife.b.norm()});
    std::vector<Crossing> found;
    for (std::size_t i = 0; i < (closed ? count : count - 1); ++i) {
        const Vec2& c = vertices[i];
        const Vec2& d = vertices[(i + 1) % count];
        const auto along =
            cross(Vec2(d - c), Vec2(knife.b - knife.a)) == 0 ? std::nullopt : segmentFraction(c, d, knife.a, knife.b);
        if (!along) {
            continue;
        }
        Crossing crossing{static_cast<int>(i), true, *along, 0, tidied(Vec2(c + *along * (d - c)))};
        for (const std::size_t end : {i, (i + 1) % count}) {
            if ((vertices[end] - crossing.at).norm() <= near) {
                crossing = {static_cast<int>(end), false, 0, 0, vertices[end]};
            }
        }
        const Vec2 way = knife.b - knife.a;
        crossing.onKnife = (crossing.at - knife.a).dot(way) / way.squaredNorm();
        found.push_back(crossing);
    }
    const auto place = [](const Crossing& crossing) { return std::pair(crossing.vertex, crossing.along); };
    std::ranges::sort(found, {}, place);
    const auto same = [&place](const Crossing& a, const Crossing& b) { return place(a) == place(b); };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

/// The vertices with those of the crossings among them, and where these have come to stand.
struct Marked {
    std::vector<Vec2> vertices;
    std::vector<int> places; // one for each crossing
};

Marked marked(const std::vector<Vec2>& vertices, const std::vector<Crossing>& crossings) {
    Marked result;
    auto next = crossings.begin();
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        result.vertices.push_back(vertices[i]);
        for (; next != crossings.end() && next->vertex == static_cast<int>(i); ++next) {
            if (next->inserted) {
                result.vertices.push_back(next->at);
            }
            result.places.push_back(static_cast<int>(result.vertices.size()) - 1);
        }
    }
    return result;
}

bool isInside(const std::vector<Vec2>& outline, const Vec2& point) {
    const double near = 1e-9 * std::max(1.0, point.norm());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        if ((closestOnSegment(outline[i], outline[(i + 1) % outline.size()], point) - point).norm() <= near) {
            return false;
        }
    }
    return contains(outline, point);
}

std::vector<Vec2> stretch(const std::vector<Vec2>& outline, int from, int to) {
    std::vector<Vec2> part;
    const int count = static_cast<int>(outline.size());
    for (int i = from;; i = (i + 1) % count) {
        part.push_back(outline[static_cast<std::size_t>(i)]);
        if (i == to) {
            return part;
        }
    }
}

/// The first cut of the knife right through the polygon; the two halves.
std::optional<std::pair<std::vector<Vec2>, std::vector<Vec2>>> halvesOf(const std::vector<Vec2>& outline,
                                                                        const Knife& knife, std::vector<Vec2>& places) {
    std::vector<Crossing> crossings = crossingsOf(outline, true, knife);
    std::ranges::sort(crossings, {}, &Crossing::onKnife);
    for (std::size_t i = 1; i < crossings.size(); ++i) {
        std::vector<Crossing> chord{crossings[i - 1], crossings[i]};
        if (!isInside(outline, 0.5 * (chord[0].at + chord[1].at))) {
            continue;
        }
        std::ranges::sort(chord, {}, [](const Crossing& end) { return std::pair(end.vertex, end.along); });
        const Marked with = marked(outline, chord);
        std::pair halves{stretch(with.vertices, with.places[0], with.places[1]),
                         stretch(with.vertices, with.places[1], with.places[0])};
        if (isSimple(halves.first) && isSimple(halves.second)) {
            places.push_back(chord[0].at);
            places.push_back(chord[1].at);
            return halves;
        }
    }
    return {};
}

std::optional<std::vector<ShapePiece>> cutPolygon(const LevelShape& shape, const Knife& knife,
                                                  std::vector<Vec2>& places) {
    std::vector<std::vector<Vec2>> open{*verticesOf(shape)};
    std::vector<ShapePiece> done;
    if (!isSimple(open.front())) {
        return {};
    }
    while (!open.empty()) {
        std::vector<Vec2> outline = std::move(open.back());
        open.pop_back();
        if (auto halves = halvesOf(outline, knife, places)) {
            open.push_back(std::move(halves->second));
            open.push_back(std::move(halves->first));
        } else {
            done.push_back({withVertices(shape, std::move(outline), true)});
        }
    }
    return done.size() > 1 ? std::optional(std::move(done)) : std::nullopt;
}

std::optional<std::vector<ShapePiece>> cutChain(const LevelShape& shape, const Knife& knife,
                                                std::vector<Vec2>& places) {
    const std::vector<Vec2>& vertices = *verticesOf(shape);
    std::vector<Crossing> crossings = crossingsOf(vertices, isClosed(shape), knife);
    std::erase_if(crossings, [&](const Crossing& crossing) {
        const bool end = crossing.vertex == 0 || crossing.vertex + 1 == static_cast<int>(vertices.size());
        return !crossing.inserted && end && !isClosed(shape);
    });
    if (crossings.empty()) {
        return {};
    }
    const Marked with = marked(vertices, crossings);
    std::vector<bool> split(with.vertices.size(), false);
    for (const int place : with.places) {
        split[static_cast<std::size_t>(place)] = true;
        places.push_back(with.vertices[static_cast<std::size_t>(place)]);
    }
    const LevelShape whole = withVertices(shape, with.vertices, isClosed(shape));
    std::vector<ShapePiece> pieces;
    for (const auto& run : splitRuns(static_cast<int>(with.vertices.size()), isClosed(shape), split)) {
        ShapePiece piece{chainOf(whole, run)};
        if (isWhole(piece.shape)) {
            pieces.push_back(std::move(piece));
        }
    }
    return pieces;
}

/// One node of each shape that the knife meets, ascending.
std::vector<NodeRef> shapesMet(const Level& level, std::span<const Key> keys, const Vec2& a, const Vec2& b) {
    std::vector<NodeRef> met;
    Aabb box{a, a};
    box.include(b);
    const std::vector<Key> wanted = withMembers(level, keys);
    levelIndex(level).visitSegments(box, [&](const SegmentRef& ref, const Vec2& c, const Vec2& d) {
        const Object& object = level.objects[ref.object];
        if (std::ranges::binary_search(wanted, object.key) && segmentsMeet(a, b, c, d)) {
            met.push_back({object.key, ref.shape, 0});
        }
    });
    std::ranges::sort(met);
    met.erase(std::unique(met.begin(), met.end()), met.end());
    return met;
}

} // namespace

CutLevel cutAlong(Level level, std::span<const Key> keys, const Vec2& a, const Vec2& b) {
    const std::vector<NodeRef> met = a == b ? std::vector<NodeRef>() : shapesMet(level, keys, a, b);
    CutLevel result;
    NodeEdit edit =
        reshaped(std::move(level), met, [&](const BodyObject& body, const NodeRef& node, std::span<const NodeRef>) {
            const Transform pose{body.position, Rot::fromAngle(body.angle)};
            const Knife knife{pose.toLocal(a), pose.toLocal(b)};
            const LevelShape& shape = body.shapes[static_cast<std::size_t>(node.shape)];
            std::vector<Vec2> places;
            auto pieces = std::holds_alternative<Polygon>(shape) ? cutPolygon(shape, knife, places)
                                                                 : cutChain(shape, knife, places);
            for (const Vec2& place : places) {
                result.places.push_back(pose.toWorld(place));
            }
            return pieces;
        });
    result.level = std::move(edit.level);
    return result;
}

} // namespace spacetow
