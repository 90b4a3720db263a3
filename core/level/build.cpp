#include "core/level/build.h"

#include "core/geometry/polygon.h"
#include "core/level/lint.h"

#include <algorithm>

namespace spacetow {

namespace {

/// Calls `make(a, b)` for each segment of the chain that has a length.
template <class Make>
void forEachSegment(const std::vector<Vec2>& vertices, bool closed, Make make) {
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
        if (vertices[i] != vertices[i + 1]) {
            make(vertices[i], vertices[i + 1]);
        }
    }
    if (closed && count > 1 && vertices.back() != vertices.front()) {
        make(vertices.back(), vertices.front());
    }
}

/// Anticlockwise and without repeated vertices, as the physics demands.
Polygon normalized(const Polygon& polygon) {
    Polygon result = polygon;
    std::vector<Vec2>& vertices = result.vertices;
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    while (vertices.size() > 1 && vertices.back() == vertices.front()) {
        vertices.pop_back();
    }
    if (signedArea(vertices) < 0) {
        std::ranges::reverse(vertices);
    }
    return result;
}

struct AddShapes {
    std::vector<Shape>& out;

    void operator()(const EdgeChain& chain) const {
        forEachSegment(chain.vertices, chain.closed, [&](const Vec2& a, const Vec2& b) {
            out.emplace_back(Edge{a, b, chain.depth});
        });
    }
    void operator()(const LineChain& chain) const {
        forEachSegment(chain.vertices, chain.closed, [&](const Vec2& a, const Vec2& b) {
            out.emplace_back(Line{a, b});
        });
    }
    void operator()(const Polygon& polygon) const { out.emplace_back(normalized(polygon)); }
    void operator()(const Circle& circle) const { out.emplace_back(circle); }
};

std::vector<Key> keysWithErrors(const Level& level) {
    std::vector<Key> keys;
    for (const Problem& problem : problemsLeftOut(level)) {
        keys.push_back(problem.object);
    }
    std::ranges::sort(keys);
    return keys;
}

} // namespace

std::vector<Shape> physicsShapes(const BodyObject& body) {
    std::vector<Shape> shapes;
    for (const LevelShape& shape : body.shapes) {
        std::visit(AddShapes{shapes}, shape);
    }
    return shapes;
}

BodyDef bodyDef(const BodyObject& body, Key key) {
    BodyDef def;
    def.kind = body.kind;
    def.shapes = physicsShapes(body);
    def.position = body.position;
    def.angle = body.angle;
    def.velocity = body.velocity;
    def.angularVelocity = body.angularVelocity;
    def.mass = body.mass;
    def.density = body.density;
    def.restitution = body.restitution;
    def.friction = body.friction;
    def.linearDamping = body.linearDamping;
    def.angularDamping = body.angularDamping;
    def.filter = body.filter;
    def.tangible = body.tangible;
    def.positionFrozen = body.frozen;
    def.rotationFrozen = body.frozen;
    def.user = key;
    return def;
}

ConnectorDef connectorDef(const ConnectorObject& connector, BodyId a, BodyId b) {
    ConnectorDef def;
    def.a = a;
    def.b = b;
    def.anchorA = connector.anchorA;
    def.anchorB = connector.anchorB;
    def.length = connector.length;
    def.stiffness = connector.stiffness;
    def.damping = connector.damping;
    def.slack = connector.slack;
    def.bodiesCollide = connector.bodiesCollide;
    def.truncation.rule = connector.truncation;
    def.truncation.limit = connector.limit;
    def.truncation.proportion = connector.proportion;
    return def;
}

std::vector<Problem> problemsLeftOut(const Level& level) {
    std::vector<Problem> problems = buildingProblems(level);
    std::erase_if(problems,
                  [](const Problem& problem) { return problem.severity != Severity::Error || problem.object == 0; });
    // Those of an object stand together.
    const auto sameObject = [](const Problem& a, const Problem& b) { return a.object == b.object; };
    problems.erase(std::unique(problems.begin(), problems.end(), sameObject), problems.end());
    return problems;
}

std::size_t partsToBuild(const Level& level, std::size_t most) {
    std::size_t parts = 0;
    for (const Object& object : level.objects) {
        const auto* const body = std::get_if<BodyObject>(&object.data);
        for (std::size_t i = 0; body != nullptr && i < body->shapes.size() && parts <= most; ++i) {
            parts += std::visit(
                [](const auto& shape) -> std::size_t {
                    if constexpr (requires { shape.vertices; }) {
                        return shape.vertices.size();
                    }
                    return 1;
                },
                body->shapes[i]);
        }
        if (parts > most) {
            break;
        }
    }
    return parts;
}

BuiltWorld builtWorld(const Level& level) {
    BuiltWorld built{World(updateParameters(level)), {}, {}};
    built.world.setSleeping(level.sleeping);
    const std::vector<Key> bad = keysWithErrors(level);
    const auto isBad = [&bad](Key key) { return std::ranges::binary_search(bad, key); };
    for (const Object& object : level.objects) {
        const auto* body = std::get_if<BodyObject>(&object.data);
        if (body == nullptr || isBad(object.key)) {
            continue;
        }
        if (const Result<BodyId> id = built.world.addBody(bodyDef(*body, object.key))) {
            built.bodies.emplace_back(object.key, id.value());
        }
    }
    std::ranges::sort(built.bodies, {}, &std::pair<Key, BodyId>::first);
    const auto bodyOf = [&built](Key key) {
        const auto found = std::ranges::lower_bound(built.bodies, key, {}, &std::pair<Key, BodyId>::first);
        return found != built.bodies.end() && found->first == key ? found->second : BodyId();
    };
    for (const Object& object : level.objects) {
        const auto* connector = std::get_if<ConnectorObject>(&object.data);
        if (connector == nullptr || isBad(object.key)) {
            continue;
        }
        const BodyId a = bodyOf(connector->a);
        const BodyId b = bodyOf(connector->b);
        if (a && b) {
            if (const Result<ConnectorId> id = built.world.addConnector(connectorDef(*connector, a, b))) {
                built.connectors.emplace_back(object.key, id.value());
            }
        }
    }
    std::ranges::sort(built.connectors, {}, &std::pair<Key, ConnectorId>::first);
    return built;
}

UpdateParameters updateParameters(const Level& level) {
    UpdateParameters parameters{level.gravity, level.updateSeconds, level.iterations, level.substeps};
    const Level standard;
    // What lint rejects must not stop the simulation for good; it runs as a new level would.
    if (!isFinite(parameters.gravity)) {
        parameters.gravity = standard.gravity;
    }
    if (!(parameters.seconds > 0 && parameters.seconds <= 0.1)) {
        parameters.seconds = standard.updateSeconds;
    }
    if (parameters.iterations < 1 || parameters.iterations > 1000) {
        parameters.iterations = standard.iterations;
    }
    if (parameters.substeps < 1 || parameters.substeps > 100) {
        parameters.substeps = standard.substeps;
    }
    return parameters;
}

} // namespace spacetow
