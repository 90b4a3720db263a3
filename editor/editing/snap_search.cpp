#include "editor/editing/snap_search.h"

#include "core/level/guides.h"
#include "core/math/affine.h"
#include "editor/editing/snap_align.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr std::size_t mostCrossing = 24; // segments near the point, of which each two are intersected
constexpr double same = sameStretch;     // m, between points that are one
constexpr double leastTurn = 4;          // reaches from the point before, nearer to which no angle draws

/// A line that something may come to lie on, and what it is.
struct Track {
    Stretch stretch;
    SnapKind kind = SnapKind::Edge;
    Key key = 0;
    int guide = -1;
    int axis = -1; // of alignments: the coordinate that it fixes
};

class Search {
  public:
    Search(const Level& level, const SnapSettings& settings, const SnapSubject& subject, const SnapQuery& query)
        : m_level(level), m_settings(settings), m_subject(subject), m_query(query),
          m_reach(settings.reach * query.pixel) {
        m_sources.push_back(query.at);
        for (const Vec2& offset : subject.points) {
            if (offset != Vec2(0, 0)) {
                m_sources.push_back(query.at + offset);
            }
        }
    }

    SnapAnswer answer() {
        m_best.point = m_best.mark = m_query.at;
        if (m_settings.grid) {
            offerGrid();
        }
        if (m_settings.smart) {
            gather();
            offerPoints();
            offerMidpoints();
            offerFeet();
            offerTracks();
            offerCrossings();
            offerAligned();
        }
        return m_best;
    }

  private:
    void gather() {
        Aabb box;
        for (const Vec2& source : m_sources) {
            box.include(source);
        }
        m_near = nearby(m_level, m_subject, box.grown(m_reach));
        for (const NearSegment& segment : m_near.segments) {
            m_edges.push_back({Stretch::between(segment.a, segment.b), SnapKind::Edge, segment.key});
        }
        if (m_settings.guides) {
            addGuides();
        }
        if (m_settings.angles && m_query.from && !m_query.along) {
            addAngle(*m_query.from);
        }
        if (m_settings.alignment) {
            addAlignments();
        }
    }

    void addGuides() {
        for (std::size_t i = 0; i < m_level.guides.size(); ++i) {
            const Guide& guide = m_level.guides[i];
            if (static_cast<int>(i) == m_subject.guide) {
                continue;
            }
            const Vec2 along = directionOf(guide);
            m_lines.push_back({Stretch::endless(guide.point, along), SnapKind::Guide, 0, static_cast<int>(i)});
        }
    }

    void addAngle(const Vec2& from) {
        const Vec2 way = m_query.at - from;
        if (way.norm() > leastTurn * m_reach) {
            m_lines.push_back({Stretch::endless(from, snappedDirection(way)), SnapKind::Angle});
        }
    }

    void addAlignments() {
        for (int axis = 0; axis < 2; ++axis) {
            m_aligned[axis] = alignmentOf(m_level, m_settings, m_subject, m_query, axis);
            if (m_aligned[axis]) {
                // The line on which the placed point itself comes to lie.
                Vec2 through = m_query.at;
                through[axis] += m_aligned[axis]->value - m_aligned[axis]->mine;
                if (m_aligned[axis]->mine == m_query.at[axis]) {
                    through[axis] = m_aligned[axis]->value;
                }
                const Vec2 along = axis == 0 ? Vec2(0, 1) : Vec2(1, 0);
                m_lines.push_back(
                    {Stretch::endless(through, along), SnapKind::Alignment, m_aligned[axis]->key, -1, axis});
            }
        }
    }

    void offerGrid() {
        SnapAnswer answer;
        answer.kind = SnapKind::Grid;
        answer.mark = m_query.along
                          ? onGridLine(m_settings, {m_query.through.value_or(m_query.at), *m_query.along}, m_query.at)
                          : onGrid(m_settings, m_query.at);
        answer.point = answer.mark;
        take(answer, (answer.mark - m_query.at).norm());
    }

    void offerPoints() {
        for (const NearPoint& point : m_near.points) {
            if (m_settings.vertices) {
                offer(point.kind, point.at, {.key = point.key});
            }
        }
    }

    void offerMidpoints() {
        for (const NearSegment& segment : m_near.segments) {
            if (m_settings.midpoints) {
                offer(SnapKind::Midpoint, tidied(Vec2(0.5 * (segment.a + segment.b))), {.key = segment.key});
            }
        }
    }

    void offerFeet() {
        if (!m_settings.perpendiculars || !m_query.from) {
            return;
        }
        for (const Track& edge : m_edges) {
            const double metres = edge.stretch.along(*m_query.from);
            const Vec2 foot = edge.stretch.at(metres);
            if (edge.stretch.reaches(metres) && (foot - *m_query.from).norm() > m_reach) {
                offerFrom(m_query.at, SnapKind::Perpendicular, foot, {.key = edge.key});
            }
        }
        for (const NearRim& rim : m_near.rims) {
            const Vec2 way = rim.circle.center - *m_query.from;
            if (way.norm() > same) {
                const Vec2 radius = rim.circle.radius / way.norm() * way;
                offerFrom(m_query.at, SnapKind::Perpendicular, rim.circle.center - radius, {.key = rim.key});
                offerFrom(m_query.at, SnapKind::Perpendicular, rim.circle.center + radius, {.key = rim.key});
            }
        }
    }

    /// Edges draw every point that snaps, lines without ends only the one that is placed, or the side that aligns.
    void offerTracks() {
        for (const Vec2& source : m_sources) {
            for (const Track& edge : m_edges) {
                if (m_settings.edges) {
                    offerOn(edge, source);
                }
            }
            for (const Track& line : m_lines) {
                if (line.kind == SnapKind::Guide || source == m_query.at) {
                    offerOn(line, source);
                }
            }
        }
        for (const NearRim& rim : m_near.rims) {
            if (m_settings.edges && !m_query.along) {
                offerRim(rim);
            }
        }
    }

    void offerRim(const NearRim& rim) {
        for (const Vec2& source : m_sources) {
            const Vec2 way = source - rim.circle.center;
            if (way.norm() > same) {
                offerFrom(source, SnapKind::Edge, rim.circle.center + rim.circle.radius / way.norm() * way,
                          {.key = rim.key});
            }
        }
    }

    void offerOn(const Track& track, const Vec2& source) {
        Vec2 at = track.guide >= 0 ? footOn(m_level.guides[static_cast<std::size_t>(track.guide)], source)
                                   : track.stretch.nearest(source);
        if (m_query.along) {
            const std::optional<Vec2> met = crossing(Stretch::endless(source, *m_query.along), track.stretch);
            if (!met) {
                return;
            }
            at = *met;
        } else if (m_settings.grid && source == m_query.at && track.stretch.from != track.stretch.to) {
            const Vec2 even = onGridLine(m_settings, track.stretch.line, at);
            const bool on = track.stretch.reaches(track.stretch.along(even));
            at = on && (even - at).norm() <= m_reach ? even : at;
            offerTrack(track, source, at, track.stretch.distanceTo(source));
            return;
        }
        offerTrack(track, source, at, (at - source).norm());
    }

    void offerTrack(const Track& track, const Vec2& source, const Vec2& at, double distance) {
        SnapAnswer answer{.kind = track.kind, .key = track.key, .guide = track.guide};
        land(answer, source, tidied(at));
        if (track.axis >= 0) {
            answer.key = 0;
            addLine(answer, track.axis);
        }
        if (distance <= (track.kind == SnapKind::Angle ? calm : 1) * m_reach) {
            take(answer, distance);
        }
    }

    void offerCrossings() {
        std::vector<Track> tracks = nearestEdges();
        const std::size_t edges = m_settings.intersections ? tracks.size() : 0;
        tracks.resize(edges);
        std::ranges::copy_if(m_lines, std::back_inserter(tracks),
                             [](const Track& line) { return line.kind == SnapKind::Guide; });
        for (std::size_t i = 0; m_settings.intersections && i < tracks.size(); ++i) {
            for (std::size_t k = i + 1; k < tracks.size(); ++k) {
                const std::optional<Vec2> met = crossing(tracks[i].stretch, tracks[k].stretch);
                if (met && !isJoint(tracks[i], tracks[k], *met)) {
                    const int guide = std::max(tracks[i].guide, tracks[k].guide);
                    offer(SnapKind::Intersection, tidied(*met),
                          {.key = tracks[i].key, .other = tracks[k].key, .guide = guide});
                }
            }
        }
    }

    /// In line with two objects at once, or with one and on an edge or guide.
    void offerAligned() {
        if (m_query.along) {
            return;
        }
        const std::vector<Track> edges = m_settings.edges ? nearestEdges() : std::vector<Track>();
        for (const Track& line : m_lines) {
            if (line.kind != SnapKind::Alignment) {
                continue;
            }
            for (const Track& edge : edges) {
                offerBoth(line, edge);
            }
            for (const Track& other : m_lines) {
                if (&other > &line || other.kind != SnapKind::Alignment) {
                    offerBoth(line, other);
                }
            }
        }
    }

    void offerBoth(const Track& line, const Track& other) {
        const std::optional<Vec2> met = crossing(line.stretch, other.stretch);
        if (!met || (*met - m_query.at).norm() > std::sqrt(2.0) * m_reach) {
            return;
        }
        SnapAnswer answer{.kind = other.kind, .key = other.axis < 0 ? other.key : 0, .guide = other.guide};
        land(answer, m_query.at, tidied(*met));
        addLine(answer, line.axis);
        if (other.axis >= 0) {
            addLine(answer, other.axis);
        }
        // Both at once is worth more than the nearer of them alone.
        const double away = std::min(line.stretch.distanceTo(m_query.at), other.stretch.distanceTo(m_query.at));
        take(answer, away - 0.25 * m_reach);
    }

    std::vector<Track> nearestEdges() const {
        std::vector<Track> edges = m_edges;
        const auto away = [&](const Track& edge) { return edge.stretch.distanceTo(m_query.at); };
        if (edges.size() > mostCrossing) {
            std::ranges::nth_element(edges, edges.begin() + mostCrossing, {}, away);
            edges.resize(mostCrossing);
        }
        return edges;
    }

    /// Where segments of a chain join there is a vertex.
    static bool isJoint(const Track& a, const Track& b, const Vec2& at) {
        const auto ends = [&](const Track& track) {
            const double metres = track.stretch.along(at);
            return std::abs(metres - track.stretch.from) < same || std::abs(metres - track.stretch.to) < same;
        };
        return ends(a) && ends(b);
    }

    void addLine(SnapAnswer& answer, int axis) const {
        const Alignment& line = *m_aligned[axis];
        SnapLine drawn{answer.point, answer.point, line.key};
        drawn.from[axis] = drawn.to[axis] = line.value;
        drawn.to[1 - axis] = line.far;
        answer.lines.push_back(drawn);
    }

    void offer(SnapKind kind, const Vec2& target, const SnapAnswer& about) {
        for (const Vec2& source : m_sources) {
            offerFrom(source, kind, target, about);
        }
    }

    void offerFrom(const Vec2& source, SnapKind kind, const Vec2& target, const SnapAnswer& about) {
        const Vec2 way = target - source;
        const bool possible = !m_query.along || std::abs(cross(way, *m_query.along)) <= same;
        if (way.norm() <= m_reach && possible) {
            SnapAnswer answer = about;
            answer.kind = kind;
            land(answer, source, target);
            take(answer, way.norm());
        }
    }

    void land(SnapAnswer& answer, const Vec2& source, const Vec2& target) const {
        answer.mark = target;
        answer.point = source == m_query.at ? target : Vec2(m_query.at + (target - source));
    }

    void take(const SnapAnswer& answer, double distance) {
        const double cost = distance + snapHandicap(answer.kind) * m_reach;
        const bool better = m_best.kind == SnapKind::None || cost < m_cost - same ||
                            (cost < m_cost + same && answer.kind < m_best.kind);
        if (better) {
            m_best = answer;
            m_cost = cost;
        }
    }

    const Level& m_level;
    const SnapSettings& m_settings;
    const SnapSubject& m_subject;
    const SnapQuery& m_query;
    double m_reach; // m
    std::vector<Vec2> m_sources;
    Nearby m_near;
    std::vector<Track> m_edges, m_lines;
    std::optional<Alignment> m_aligned[2];
    SnapAnswer m_best;
    double m_cost = 0;
};

} // namespace

double snapHandicap(SnapKind kind) {
    switch (kind) {
    case SnapKind::None:
    case SnapKind::Vertex:
    case SnapKind::Center:
    case SnapKind::Anchor:
    case SnapKind::Intersection:
        break;
    case SnapKind::Midpoint:
        return 0.25;
    case SnapKind::Perpendicular:
        return 0.5;
    case SnapKind::Edge:
    case SnapKind::Guide:
        return 1;
    case SnapKind::Alignment:
    case SnapKind::Angle:
        return 2.25;
    case SnapKind::Grid:
        return 2.5;
    }
    return 0;
}

SnapAnswer snapAnswer(const Level& level, const SnapSettings& settings, const SnapSubject& subject,
                      const SnapQuery& query) {
    return Search(level, settings, subject, query).answer();
}

} // namespace spacetow
