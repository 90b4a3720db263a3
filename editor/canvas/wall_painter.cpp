#include "editor/canvas/wall_painter.h"

#include "core/geometry/polygon.h"
#include "editor/canvas/seen_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spacetow {

namespace {

constexpr double fadeLeast = 6; // px, so that it is seen from far away
constexpr double fadeMost = 56; // px, so that its other end is seen from near by
constexpr double bandLeast = 6; // px, of a wall that has a back
constexpr int fadeLayers = 8;
constexpr double minMitre = 0.35; // sharper corners are bevelled

struct Segment {
    Vec2 a, b;
    Vec2 free; // unit, to the free side
};

/// The segments of a run that have a length, with their normals.
std::vector<Segment> segmentsOf(const WallRun& run) {
    std::vector<Segment> segments;
    const std::size_t count = run.points.size();
    const std::size_t last = run.closed ? count : count - 1;
    for (std::size_t i = 0; count >= 2 && i < last; ++i) {
        const Vec2& a = run.points[i];
        const Vec2& b = run.points[(i + 1) % count];
        const Vec2 along = b - a;
        const double length = along.norm();
        if (length > 0 && std::isfinite(length)) {
            segments.push_back({a, b, leftOf(along / length)});
        }
    }
    return segments;
}

Aabb boxOf(const Segment& segment) {
    Aabb box;
    box.include(segment.a);
    box.include(segment.b);
    return box;
}

/// What is filled behind walls.
struct Bands {
    const Stage& stage;
    double depth; // m
    QPainterPath path{};

    void clear() {
        path.clear();
        path.setFillRule(Qt::WindingFill);
    }
};

/// Adds the band behind the segment, clockwise in the world like every piece, so that overlaps stay filled.
void addBand(Bands& bands, const Segment& s) {
    const double depth = bands.depth;
    const std::array<Vec2, 4> corners{s.a, s.b, s.b - depth * s.free, s.a - depth * s.free};
    bands.path.addPolygon(bands.stage.at(corners));
    bands.path.closeSubpath();
}

/// Fills the gap between two bands at a corner that points to the solid side.
void addCorner(Bands& bands, const Segment& before, const Segment& after) {
    const double depth = bands.depth;
    if (cross(before.free, after.free) <= 0) {
        return;
    }
    const Vec2 sum = before.free + after.free;
    const double length = sum.norm();
    const Vec2 middle = length > 1e-9 ? Vec2(sum / length) : Vec2(leftOf(before.free));
    const std::array<Vec2, 4> corners{before.b, before.b - depth * after.free, before.b - depth * middle,
                                      before.b - depth * before.free};
    bands.path.addPolygon(bands.stage.at(corners));
    bands.path.closeSubpath();
}

/// Fills the band piece by piece: one path over a whole cave would take time with the square of its length.
void fillRim(const Stage& stage, const WallRun& run, double depth, const QColor& color) {
    constexpr std::size_t pieceLength = 128; // segments
    const std::vector<Segment> segments = segmentsOf(run);
    const Aabb visible = stage.view.visible().grown(depth + stage.view.pixel());
    Bands bands{stage, depth};
    bands.clear();
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (visible.overlaps(boxOf(segments[i]))) {
            addBand(bands, segments[i]);
            const bool joined = i + 1 < segments.size() || run.closed;
            if (joined) {
                addCorner(bands, segments[i], segments[(i + 1) % segments.size()]);
            }
        }
        if (i % pieceLength == pieceLength - 1) {
            stage.painter.fillPath(bands.path, color);
            bands.clear();
        }
    }
    stage.painter.fillPath(bands.path, color);
}

/// Where the backs of two neighbouring walls meet.
Vec2 backCorner(const Vec2& at, const Vec2& before, const Vec2& after, double depth) {
    const double one = 1 + before.dot(after);
    return one < minMitre ? Vec2(at - depth * after) : Vec2(at - depth / one * (before + after));
}

void paintBack(const Stage& stage, const WallRun& run) {
    const std::vector<Segment> segments = segmentsOf(run);
    std::vector<Vec2> back;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const bool first = i == 0 && !run.closed;
        const Segment& before = segments[i == 0 ? segments.size() - 1 : i - 1];
        back.push_back(first ? Vec2(segments[i].a - run.depth * segments[i].free)
                             : backCorner(segments[i].a, before.free, segments[i].free, run.depth));
    }
    if (!segments.empty() && !run.closed) {
        back.emplace_back(segments.back().b - run.depth * segments.back().free);
    }
    for (std::size_t i = 0; i + (run.closed ? 0 : 1) < back.size(); ++i) {
        paintDashed(stage, back[i], back[(i + 1) % back.size()], {1, 2});
    }
}

QColor faded(QColor color, double factor) {
    color.setAlphaF(static_cast<float>(color.alphaF() * factor));
    return color;
}

} // namespace

std::vector<WallRun> wallRuns(std::span<const Shape> shapes, const Transform& pose) {
    std::vector<WallRun> runs;
    const Edge* last = nullptr;
    for (const Shape& shape : shapes) {
        const Edge* edge = std::get_if<Edge>(&shape);
        if (edge == nullptr) {
            continue;
        }
        if (last == nullptr || last->b != edge->a || last->depth != edge->depth || runs.back().closed) {
            runs.push_back({{pose.toWorld(edge->a)}, false, edge->depth});
        }
        const Vec2 end = pose.toWorld(edge->b);
        if (end == runs.back().points.front()) {
            runs.back().closed = true;
        } else {
            runs.back().points.push_back(end);
        }
        last = edge;
    }
    for (WallRun& run : runs) {
        run.hollow = run.closed && signedArea(run.points) > 0;
    }
    return runs;
}

QPainterPath rockBehind(const Stage& stage, const Ground& ground) {
    QPainterPath rock;
    rock.setFillRule(Qt::WindingFill);
    for (const WallRun& run : ground.runs) {
        if (run.closed && std::isinf(run.depth)) {
            rock.addPolygon(stage.at(run.points));
            rock.closeSubpath();
        }
    }
    if (ground.hollow) {
        // Clockwise in the world, so that an anticlockwise loop cuts a hole and a clockwise one inside it fills again.
        const Aabb box = stage.view.visible().grown(20 * stage.view.pixel());
        const std::array<Vec2, 4> corners{box.min, Vec2(box.min.x(), box.max.y()), box.max,
                                          Vec2(box.max.x(), box.min.y())};
        rock.addPolygon(stage.at(corners));
        rock.closeSubpath();
    }
    return rock;
}

int rimLayers(double scale) {
    // Layers that cannot be told apart would only cost time.
    return std::clamp(static_cast<int>(std::clamp(fadeDepth * scale, fadeLeast, fadeMost) / 3), 1, fadeLayers);
}

void paintRims(const Stage& stage, std::span<const WallRun> runs, const QColor& color) {
    const double reach = std::clamp(stage.pixels(fadeDepth), fadeLeast, fadeMost);
    const int layers = rimLayers(stage.view.scale);
    for (const WallRun& run : runs) {
        if (std::isfinite(run.depth)) {
            fillRim(stage, run, std::max(run.depth, bandLeast * stage.view.pixel()), faded(color, 0.34));
            if (stage.pixels(run.depth) > 3) {
                QPen pen = stroke(faded(color, 0.8), 1);
                pen.setCapStyle(Qt::FlatCap);
                stage.painter.setPen(pen);
                paintBack(stage, run);
            }
            continue;
        }
        for (int i = layers; i >= 1; --i) {
            fillRim(stage, run, reach * stage.view.pixel() * i / layers, faded(color, 0.55 / layers));
        }
    }
}

void paintGroundRims(const Stage& stage, const Ground& ground) {
    Ground closed{{}, ground.hollow};
    std::vector<WallRun> open;
    for (const WallRun& run : ground.runs) {
        (run.closed && std::isinf(run.depth) ? closed.runs : open).push_back(run);
    }
    if (!closed.runs.empty()) {
        // Thin pillars: the band must not come out on the other side.
        stage.painter.save();
        stage.painter.setClipPath(rockBehind(stage, closed), Qt::IntersectClip);
        paintRims(stage, closed.runs, stage.theme.rim);
        stage.painter.restore();
    }
    paintRims(stage, open, stage.theme.rim);
}

double finestDetail(const Stage& stage) {
    return 0.35 * stage.view.pixel();
}

WallRun thinned(const Stage& stage, WallRun run) {
    constexpr std::size_t few = 64;
    if (run.points.size() > few) {
        run.points = simplified(run.points, finestDetail(stage));
    }
    return run;
}

void paintPolyline(const Stage& stage, std::span<const Vec2> points, bool closed) {
    const Aabb visible = stage.view.visible().grown(8 * stage.view.pixel());
    const std::size_t count = points.size();
    QPolygonF piece;
    const auto flush = [&] {
        if (piece.size() > 1) {
            stage.painter.drawPolyline(piece);
        }
        piece.clear();
    };
    const std::size_t last = closed ? count : count - std::min<std::size_t>(count, 1);
    for (std::size_t i = 0; i < last; ++i) {
        const Vec2& a = points[i];
        const Vec2& b = points[(i + 1) % count];
        Aabb box;
        box.include(a);
        box.include(b);
        if (!visible.overlaps(box)) {
            flush();
            continue;
        }
        if (piece.isEmpty()) {
            piece << stage.at(a);
        }
        piece << stage.at(b);
    }
    flush();
}

} // namespace spacetow
