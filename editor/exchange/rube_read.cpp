#include "editor/exchange/rube_read.h"

#include "core/level/fields.h"
#include "editor/exchange/json_values.h"
#include "editor/exchange/rube_fixtures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace spacetow {

namespace {

/// Box2D's rigid joints are springs here, as stiff as a fixed step follows them well.
constexpr double stiffHertz = 8;

class RubeReader {
  public:
    RubeReader(const JsonView& root, Report& report) : m_root(root), m_report(report), m_tags(root) {}

    Drawing read() {
        const std::optional<JsonView> bodies = jsonMember(m_root, "body");
        if (bodies && bodies->isArray()) {
            for (const JsonView body : *bodies) {
                readBody(body);
            }
        }
        const std::optional<JsonView> joints = jsonMember(m_root, "joint");
        if (joints && joints->isArray()) {
            for (const JsonView joint : *joints) {
                readJoint(joint);
            }
        }
        const std::optional<JsonView> images = jsonMember(m_root, "image");
        if (images && images->isArray()) {
            for (const JsonView image : *images) {
                m_report.refuse("import-image", image.line(), jsonText(image, "name"));
            }
        }
        if (const std::optional<JsonView> gravity = jsonMember(m_root, "gravity")) {
            m_report.refuse("import-gravity", gravity->line());
        }
        m_drawing.tags = m_tags.table();
        return std::move(m_drawing);
    }

  private:
    double number(const JsonView& object, const char* name, double most) {
        return rubeNumber(object, {name, -most, most, 0}, m_report);
    }

    void readBody(const JsonView& json) {
        BodyObject body;
        const double type = jsonNumber(json, "type");
        body.kind = type == 2 ? BodyKind::Dynamic : type == 1 ? BodyKind::Kinematic : BodyKind::Static;
        body.position = jsonPoint(json, "position");
        body.angle = number(json, "angle", limits::angle);
        if (body.kind != BodyKind::Static) {
            constexpr double fastest = limits::speed;
            const Vec2 velocity = jsonPoint(json, "linearVelocity");
            body.velocity = velocity.cwiseMax(Vec2(-fastest, -fastest)).cwiseMin(Vec2(fastest, fastest));
            body.angularVelocity = number(json, "angularVelocity", limits::spin);
        }
        body.linearDamping = rubeNumber(json, {"linearDamping", 0, limits::damping, 0}, m_report);
        body.angularDamping = rubeNumber(json, {"angularDamping", 0, limits::damping, 0}, m_report);
        addFixtures(json, body, m_tags, m_report);
        const std::string name = jsonText(json, "name");
        for (const char* const setting : {"fixedRotation", "bullet"}) {
            if (jsonFlag(json, setting)) {
                m_report.refuse("import-body-setting", json.line(), name + ": " + setting);
            }
        }
        if (jsonNumber(json, "gravityScale", 1) != 1) {
            m_report.refuse("import-body-setting", json.line(), name + ": gravityScale");
        }
        if (body.shapes.empty()) {
            m_report.refuse("import-no-fixture", json.line(), name);
            m_keys.push_back(0);
            m_masses.push_back(0);
            return;
        }
        const bool isMoved = body.kind == BodyKind::Dynamic;
        m_masses.push_back(isMoved ? std::max(0.0, jsonNumber(json, "massData-mass", 1)) : 0);
        m_drawing.items.push_back({name, -1, true, false, json.line(), ReadyObject{std::move(body)}});
        m_keys.push_back(static_cast<Key>(m_drawing.items.size()));
    }

    /// Which body an end of a joint holds; −1 for one that is not there.
    int bodyAt(const JsonView& joint, const char* name) const {
        const double index = jsonNumber(joint, name, -1);
        const bool isThere =
            index >= 0 && index < static_cast<double>(m_keys.size()) && m_keys[static_cast<std::size_t>(index)] != 0;
        return isThere ? static_cast<int>(index) : -1;
    }

    /// What counts in the vibration of two bodies; of those that do not move, the other's mass.
    double reducedMass(int a, int b) const {
        const double massA = m_masses[static_cast<std::size_t>(a)];
        const double massB = m_masses[static_cast<std::size_t>(b)];
        const double mass = massA > 0 && massB > 0 ? massA * massB / (massA + massB) : std::max(massA, massB);
        return mass > 0 && mass <= limits::mass ? mass : 1;
    }

    void readJoint(const JsonView& joint) {
        const std::string type = jsonText(joint, "type");
        const std::string name = jsonText(joint, "name");
        const int a = bodyAt(joint, "bodyA");
        const int b = bodyAt(joint, "bodyB");
        const bool isRope = type == "rope";
        const double length = jsonNumber(joint, isRope ? "maxLength" : "length");
        const Vec2 anchorA = jsonPoint(joint, "anchorA");
        const Vec2 anchorB = jsonPoint(joint, "anchorB");
        constexpr double farthest = limits::coordinate / 2; // m
        const bool isFar = !(std::max(anchorA.cwiseAbs().maxCoeff(), anchorB.cwiseAbs().maxCoeff()) < farthest);
        if ((type != "distance" && !isRope) || isFar || a < 0 || b < 0 || a == b || !(length > 0)) {
            m_report.refuse("import-joint", joint.line(), name.empty() ? type : name + " (" + type + ')');
            return;
        }
        const double hertz = isRope ? 0 : std::max(0.0, jsonNumber(joint, "frequency"));
        const bool isRigid = hertz == 0;
        const double omega = 2 * std::numbers::pi * (isRigid ? stiffHertz : hertz);
        const double mass = reducedMass(a, b);
        const double ratio = isRigid ? 1 : std::max(0.0, jsonNumber(joint, "dampingRatio"));
        ConnectorObject connector;
        connector.a = m_keys[static_cast<std::size_t>(a)];
        connector.b = m_keys[static_cast<std::size_t>(b)];
        connector.anchorA = anchorA;
        connector.anchorB = anchorB;
        connector.length = std::min(length, limits::coordinate);
        connector.stiffness = std::min(mass * omega * omega, limits::stiffness);
        connector.damping = std::min(2 * mass * ratio * omega, limits::stiffness);
        connector.slack = isRope;
        connector.bodiesCollide = jsonFlag(joint, "collideConnected");
        if (isRigid) {
            m_report.refuse("import-rigid-joint", joint.line(), name);
        }
        m_drawing.items.push_back({name, -1, true, false, joint.line(), ReadyObject{connector}});
    }

    JsonView m_root;
    Report& m_report;
    RubeTags m_tags;
    Drawing m_drawing;
    std::vector<Key> m_keys;      // of bodies, by their places in the file; 0 for those left out
    std::vector<double> m_masses; // kg, likewise; 0 for those that do not move
};

} // namespace

Drawing rubeDrawing(const JsonView& root, Report& report) {
    return RubeReader(root, report).read();
}

} // namespace spacetow
