// Paints a level as it is edited.
#include "core/geometry/polygon.h"
#include "core/level/groups.h"
#include "core/level/level_index.h"
#include "core/level/object_geometry.h"
#include "editor/canvas/body_painter.h"
#include "editor/canvas/scene_painter.h"
#include "editor/canvas/seen_points.h"
#include "editor/canvas/wall_painter.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

constexpr double pensAndMarks = 18; // px around the view, for pens and marks
constexpr double mitre = 2.5;       // how much further than its depth the back of a wall reaches at corners

/// The objects of a part of a level that can be seen.
class SeenObjects {
  public:
    SeenObjects(const Stage& stage, const Level& level, const PaintedPart& part)
        : m_stage(stage), m_level(level), m_index(levelIndex(level)), m_tree(level), m_part(part) {}

    /// By place, ascending: those that have an outline or a mark in view.
    std::vector<int> inView() const {
        std::vector<int> places;
        const Aabb area = grownView(fadeDepth);
        m_index.visitReaching(area, [&](int place) {
            if (m_index.boundsOf(place).overlaps(area) || isKinematic(at(place))) {
                add(places, place);
            }
        });
        return places;
    }
    /// Those that have matter in view, wherever their outline is.
    std::vector<int> reachingView() const {
        std::vector<int> places;
        m_index.visitReaching(grownView(fadeDepth), [&](int place) { add(places, place); });
        return places;
    }

    const Object& at(int place) const { return m_level.objects[place]; }
    const ObjectList& objects() const { return m_level.objects; }

    /// The wall as far as it matters in view.
    WallRun run(int place, int shape) const {
        const auto& body = std::get<BodyObject>(at(place).data);
        const auto& chain = std::get<EdgeChain>(body.shapes[static_cast<std::size_t>(shape)]);
        const double reach = std::isfinite(chain.depth) ? mitre * chain.depth : fadeDepth;
        const bool closed = chain.closed && chain.vertices.size() > 2;
        return {points(place, shape, {chain.vertices, chain.closed}, reach), closed, chain.depth,
                closed && signedArea(chain.vertices) > 0};
    }
    std::vector<Vec2> line(int place, int shape) const {
        const auto& body = std::get<BodyObject>(at(place).data);
        const auto& chain = std::get<LineChain>(body.shapes[static_cast<std::size_t>(shape)]);
        return points(place, shape, {chain.vertices, chain.closed}, 0);
    }
    /// Of the static walls that can be touched.
    Ground ground() const {
        Ground ground;
        for (const int place : reachingView()) {
            const auto* body = std::get_if<BodyObject>(&at(place).data);
            if (body == nullptr || body->kind != BodyKind::Static || !body->tangible) {
                continue;
            }
            for (std::size_t i = 0; i < body->shapes.size(); ++i) {
                if (std::holds_alternative<EdgeChain>(body->shapes[i])) {
                    WallRun wall = run(place, static_cast<int>(i));
                    ground.hollow = ground.hollow || (wall.hollow && std::isinf(wall.depth));
                    // Of a closed wall that is out of view, only on which side its matter lies is of interest.
                    if (!std::isinf(wall.depth) || m_index.boundsOf(place).overlaps(grownView(fadeDepth))) {
                        ground.runs.push_back(std::move(wall));
                    }
                }
            }
        }
        return ground;
    }

  private:
    /// Its mark may be somewhere else than its outline.
    static bool isKinematic(const Object& object) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        return body != nullptr && body->kind == BodyKind::Kinematic;
    }
    Aabb grownView(double metres) const {
        return m_stage.view.visible().grown(metres + pensAndMarks * m_stage.view.pixel());
    }
    void add(std::vector<int>& places, int place) const {
        const bool wanted = (m_part.only == nullptr || std::ranges::binary_search(*m_part.only, place)) &&
                            (m_part.without == nullptr || !std::ranges::binary_search(*m_part.without, place));
        if (wanted && m_tree.isVisible(at(place))) {
            places.push_back(place);
        }
    }
    std::vector<Vec2> points(int place, int shape, SeenOutline outline, double reach) const {
        outline.pose = *poseOf(at(place));
        outline.tree = m_index.treeOf(place, shape);
        return seenPoints(outline, {grownView(reach), finestDetail(m_stage)});
    }

    const Stage& m_stage;
    const Level& m_level;
    const LevelIndex& m_index;
    GroupTree m_tree;
    PaintedPart m_part;
};

void paintBodyObject(const Stage& stage, const SeenObjects& seen, int place) {
    const auto& body = std::get<BodyObject>(seen.at(place).data);
    const Transform pose = *poseOf(seen.at(place));
    const BodyStyle style{body.kind, body.tangible};
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
        const LevelShape& shape = body.shapes[i];
        const int number = static_cast<int>(i);
        if (std::holds_alternative<EdgeChain>(shape)) {
            const WallRun run = seen.run(place, number);
            if (style.kind != BodyKind::Static && style.tangible) {
                paintRims(stage, std::span(&run, 1), stage.theme.body(style.kind, Edge{}).line);
            }
            paintChain(stage, run.points, run.closed, {style, WallKind::OneWay});
        } else if (const auto* lines = std::get_if<LineChain>(&shape)) {
            paintChain(stage, seen.line(place, number), lines->closed && lines->vertices.size() > 2,
                       {style, WallKind::TwoWay});
        } else if (const auto* polygon = std::get_if<Polygon>(&shape)) {
            paintShape(stage, *polygon, pose, style);
        } else {
            paintShape(stage, std::get<Circle>(shape), pose, style);
        }
    }
    if (body.kind == BodyKind::Kinematic) {
        paintKinematicMark(stage, body.position);
    }
}

void paintObject(const Stage& stage, const SeenObjects& seen, int place) {
    const Object& object = seen.at(place);
    if (std::holds_alternative<BodyObject>(object.data)) {
        paintBodyObject(stage, seen, place);
    } else if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        paintShip(stage, {ship->position, Rot::fromAngle(ship->angle)});
    } else if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
        paintPayload(stage, payload->position, payload->radius);
    } else if (const auto* finish = std::get_if<FinishObject>(&object.data)) {
        paintFinish(stage, finish->a, finish->b);
    }
}

} // namespace

void paintLevel(const Stage& stage, const Level& level, const Selection& selection) {
    paintRock(stage, level, {});
    paintObjects(stage, level, {});
    paintSelection(stage, level, selection);
}

void paintRock(const Stage& stage, const Level& level, const PaintedPart& part) {
    const SavedPainter saved(stage.painter);
    stage.painter.fillPath(rockBehind(stage, SeenObjects(stage, level, part).ground()), stage.theme.rock);
}

void paintObjects(const Stage& stage, const Level& level, const PaintedPart& part) {
    const SavedPainter saved(stage.painter);
    const SeenObjects seen(stage, level, part);
    paintGroundRims(stage, seen.ground());
    const std::vector<int> places = seen.inView();
    for (const int place : places) {
        paintObject(stage, seen, place);
    }
    for (const int place : places) {
        const auto* connector = std::get_if<ConnectorObject>(&seen.at(place).data);
        if (const auto ends = connector == nullptr ? std::nullopt : endsOf(*connector, seen.objects())) {
            const auto& [from, to] = *ends;
            paintConnector(stage, from, to, connector->length.value_or((to - from).norm()));
        }
    }
}

} // namespace spacetow
