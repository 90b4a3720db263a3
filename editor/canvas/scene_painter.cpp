#include "editor/canvas/scene_painter.h"

#include "core/level/edits.h"
#include "core/level/groups.h"
#include "editor/canvas/body_painter.h"
#include "editor/canvas/overlay_painter.h"
#include "editor/canvas/wall_painter.h"

#include <algorithm>
#include <cmath>

namespace spacetow {

namespace {

/// Leaves the painter as it was found.
class Saved {
  public:
    explicit Saved(QPainter& painter) : m_painter(painter) {
        m_painter.save();
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setBrush(Qt::NoBrush);
    }
    ~Saved() { m_painter.restore(); }
    Saved(const Saved&) = delete;
    Saved& operator=(const Saved&) = delete;

  private:
    QPainter& m_painter;
};

Transform poseOf(const BodyObject& body) {
    return {body.position, Rot::fromAngle(body.angle)};
}

/// Rock and rims of the static walls that can be touched.
void paintGround(const Stage& stage, std::span<const WallRun> runs) {
    const QPainterPath rock = rockBehind(stage, runs);
    stage.painter.fillPath(rock, stage.theme.rock);
    std::vector<WallRun> closed;
    std::vector<WallRun> open;
    for (const WallRun& run : runs) {
        (run.closed && std::isinf(run.depth) ? closed : open).push_back(run);
    }
    if (!closed.empty()) {
        // Thin pillars: the band must not come out on the other side.
        stage.painter.save();
        stage.painter.setClipPath(rock, Qt::IntersectClip);
        paintRims(stage, closed, stage.theme.rim);
        stage.painter.restore();
    }
    paintRims(stage, open, stage.theme.rim);
}

void paintLevelShape(const Stage& stage, const LevelShape& shape, const Transform& pose, const BodyStyle& style) {
    if (const auto* edges = std::get_if<EdgeChain>(&shape)) {
        const WallRun run = thinned(stage, wallRun(*edges, pose));
        if (style.kind != BodyKind::Static && style.tangible) {
            paintRims(stage, std::span(&run, 1), stage.theme.body(style.kind, Edge{}).line);
        }
        paintChain(stage, run.points, run.closed, {style, WallKind::OneWay});
    } else if (const auto* lines = std::get_if<LineChain>(&shape)) {
        std::vector<Vec2> world;
        for (const Vec2& vertex : lines->vertices) {
            world.push_back(pose.toWorld(vertex));
        }
        paintChain(stage, world, lines->closed && world.size() > 2, {style, WallKind::TwoWay});
    } else if (const auto* polygon = std::get_if<Polygon>(&shape)) {
        paintShape(stage, *polygon, pose, style);
    } else {
        paintShape(stage, std::get<Circle>(shape), pose, style);
    }
}

void paintBodyObject(const Stage& stage, const BodyObject& body) {
    const Transform pose = poseOf(body);
    const BodyStyle style{body.kind, body.tangible};
    for (const LevelShape& shape : body.shapes) {
        paintLevelShape(stage, shape, pose, style);
    }
    if (body.kind == BodyKind::Kinematic) {
        paintKinematicMark(stage, body.position);
    }
}

/// Poses by key, for the ends of connectors.
class Poses {
  public:
    explicit Poses(const Level& level) {
        for (const Object& object : level.objects) {
            if (const auto* body = std::get_if<BodyObject>(&object.data)) {
                m_entries.emplace_back(object.key, poseOf(*body));
            }
        }
        std::ranges::sort(m_entries, {}, &Entry::first);
    }
    const Transform* find(Key key) const {
        const auto found = std::ranges::lower_bound(m_entries, key, {}, &Entry::first);
        return found != m_entries.end() && found->first == key ? &found->second : nullptr;
    }

  private:
    using Entry = std::pair<Key, Transform>;
    std::vector<Entry> m_entries;
};

void paintConnectors(const Stage& stage, const Level& level, const Wanted& wanted) {
    std::optional<Poses> poses;
    for (const Object& object : level.objects) {
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        if (connector == nullptr || !wanted(object)) {
            continue;
        }
        if (!poses) {
            poses.emplace(level);
        }
        const Transform* a = poses->find(connector->a);
        const Transform* b = poses->find(connector->b);
        if (a != nullptr && b != nullptr) {
            const Vec2 from = a->toWorld(connector->anchorA);
            const Vec2 to = b->toWorld(connector->anchorB);
            paintConnector(stage, from, to, connector->length.value_or((to - from).norm()));
        }
    }
}

void paintObject(const Stage& stage, const Object& object) {
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        paintBodyObject(stage, *body);
    } else if (const auto* ship = std::get_if<ShipObject>(&object.data)) {
        paintShip(stage, {ship->position, Rot::fromAngle(ship->angle)});
    } else if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
        paintPayload(stage, payload->position, payload->radius);
    } else if (const auto* finish = std::get_if<FinishObject>(&object.data)) {
        paintFinish(stage, finish->a, finish->b);
    }
}

void paintPicture(const Stage& stage, const BodyPicture& body) {
    const BodyLook& look = *body.look;
    if (look.role == BodyRole::Ship) {
        paintShip(stage, body.pose);
        return;
    }
    const BodyStyle style{look.kind, look.tangible};
    if (look.kind != BodyKind::Static && look.tangible) {
        paintRims(stage, wallRuns(look.shapes, body.pose), stage.theme.body(look.kind, Edge{}).line);
    }
    for (const Shape& shape : look.shapes) {
        const auto* circle = std::get_if<Circle>(&shape);
        const auto* line = std::get_if<Line>(&shape);
        if (look.role == BodyRole::Payload && circle != nullptr) {
            paintPayload(stage, body.pose.toWorld(circle->center), circle->radius);
        } else if (look.role == BodyRole::Finish && line != nullptr) {
            paintFinish(stage, body.pose.toWorld(line->a), body.pose.toWorld(line->b));
        } else if (!std::holds_alternative<Edge>(shape)) {
            paintShape(stage, shape, body.pose, style);
        }
    }
    for (const WallRun& run : wallRuns(look.shapes, body.pose)) {
        paintChain(stage, run.points, run.closed, {style, WallKind::OneWay});
    }
}

} // namespace

void paintLevel(const Stage& stage, const Level& level, const Selection& selection) {
    paintObjects(stage, level, [](const Object&) { return true; });
    paintSelection(stage, level, selection);
}

void paintObjects(const Stage& stage, const Level& level, const Wanted& wantedOnes) {
    const Saved saved(stage.painter);
    const GroupTree tree(level);
    const Wanted wanted = [&](const Object& object) { return wantedOnes(object) && tree.isVisible(object); };
    std::vector<WallRun> ground;
    for (const Object& object : level.objects) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body == nullptr || body->kind != BodyKind::Static || !body->tangible || !wanted(object)) {
            continue;
        }
        for (const LevelShape& shape : body->shapes) {
            if (const auto* edges = std::get_if<EdgeChain>(&shape)) {
                ground.push_back(thinned(stage, wallRun(*edges, poseOf(*body))));
            }
        }
    }
    paintGround(stage, ground);
    for (const Object& object : level.objects) {
        if (wanted(object)) {
            paintObject(stage, object);
        }
    }
    paintConnectors(stage, level, wanted);
}

void paintSnapshot(const Stage& stage, const Snapshot& snapshot, const OverlayFlags& overlays) {
    const Saved saved(stage.painter);
    std::vector<WallRun> ground;
    for (const BodyPicture& body : snapshot.bodies) {
        if (body.look->kind == BodyKind::Static && body.look->tangible) {
            for (WallRun& run : wallRuns(body.look->shapes, body.pose)) {
                ground.push_back(thinned(stage, std::move(run)));
            }
        }
    }
    paintGround(stage, ground);
    for (const BodyPicture& body : snapshot.bodies) {
        paintPicture(stage, body);
    }
    for (const ConnectorPicture& connector : snapshot.connectors) {
        paintConnector(stage, connector.a, connector.b, connector.length);
    }
    if (overlays.any()) {
        paintSnapshotOverlays(stage, snapshot, overlays);
    }
}

} // namespace spacetow
