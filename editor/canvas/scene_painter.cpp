#include "editor/canvas/scene_painter.h"

#include "editor/canvas/body_painter.h"
#include "editor/canvas/disc_stamps.h"
#include "editor/canvas/wall_painter.h"

#include <cmath>

namespace spacetow {

namespace {

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

bool isSmallDisc(const Stage& stage, const BodyPicture& body) {
    const std::vector<Shape>& shapes = body.look->shapes;
    const auto* const circle = shapes.size() == 1 ? std::get_if<Circle>(&shapes.front()) : nullptr;
    return body.look->role == BodyRole::Object && circle != nullptr &&
           stage.pixels(circle->radius) <= DiscStamps::largest;
}

void paintStamp(const Stage& stage, const BodyPicture& body, DiscStamps& stamps) {
    const auto& circle = std::get<Circle>(body.look->shapes.front());
    const Vec2 center = body.pose.toWorld(circle.center);
    if (stage.sees(Aabb{center, center}.grown(circle.radius))) {
        const BodyStyle style{body.look->kind, body.look->tangible};
        stamps.paint(stage, stage.at(center), stage.pixels(circle.radius), style);
        paintSpoke(stage, circle, body.pose, style);
    }
}

} // namespace

Ground groundOf(const BodyPictures& statics) {
    Ground ground;
    for (const BodyPicture& body : statics) {
        if (body.look->tangible) {
            for (WallRun& run : wallRuns(body.look->shapes, body.pose)) {
                ground.hollow = ground.hollow || (run.hollow && std::isinf(run.depth));
                ground.runs.push_back(std::move(run));
            }
        }
    }
    return ground;
}

void paintStatics(const Stage& stage, const BodyPictures& statics, const Ground& ground) {
    const SavedPainter saved(stage.painter);
    Ground thin{{}, ground.hollow};
    for (const WallRun& run : ground.runs) {
        thin.runs.push_back(thinned(stage, run));
    }
    stage.painter.fillPath(rockBehind(stage, thin), stage.theme.rock);
    paintGroundRims(stage, thin);
    for (const BodyPicture& body : statics) {
        paintPicture(stage, body);
    }
}

void paintMoving(const Stage& stage, const Snapshot& snapshot, DiscStamps* stamps) {
    constexpr std::size_t crowd = 300; // bodies
    const SavedPainter saved(stage.painter);
    const bool stamped = stamps != nullptr && snapshot.moving.size() > crowd;
    for (const BodyPicture& body : snapshot.moving) {
        if (stamped && isSmallDisc(stage, body)) {
            paintStamp(stage, body, *stamps);
        } else {
            paintPicture(stage, body);
        }
    }
    for (const ConnectorPicture& connector : snapshot.connectors) {
        paintConnector(stage, connector.a, connector.b, connector.length);
    }
}

void paintSnapshot(const Stage& stage, const Snapshot& snapshot) {
    paintStatics(stage, *snapshot.statics, groundOf(*snapshot.statics));
    paintMoving(stage, snapshot);
}

} // namespace spacetow
