#include "core/geometry/mass.h"
#include "core/level/build.h"
#include "core/level/json_text.h"
#include "core/level/key_text.h"
#include "core/level/lint_findings.h"

#include <cmath>
#include <map>

namespace spacetow {

namespace {

MassProperties massOf(const BodyObject& body) {
    std::vector<MassProperties> parts;
    for (const Shape& shape : physicsShapes(body)) {
        parts.push_back(massOf(shape, body.density));
    }
    return sum(parts);
}

/// 1/kg: how easily a pull at the anchor moves it, at most (the pull being across the arm). `total` is that of its
/// shapes.
double yieldingOf(const BodyObject& body, const MassProperties& total, const Vec2& anchor) {
    if (!(total.mass > 0) || !(total.inertia > 0)) {
        return 0;
    }
    const double mass = body.mass.value_or(total.mass);
    const double inertia = total.inertia * mass / total.mass;
    return 1 / mass + (anchor - total.center).squaredNorm() / inertia;
}

class ConnectorChecker {
  public:
    ConnectorChecker(const Level& level, Findings& findings)
        : m_objects(level.objects), m_findings(findings),
          m_substep(level.updateSeconds / level.iterations / level.substeps), m_substeps(level.substeps) {}

    void check(int index, Key key, const ConnectorObject& connector) {
        const BodyObject* a = end(index, key, connector.a, "a");
        const BodyObject* b = end(index, key, connector.b, "b");
        if (connector.a == connector.b) {
            m_findings.add(Severity::Error, "connector-same-ends", {}, {index, key, "/b"});
            return;
        }
        if (a == nullptr || b == nullptr || m_findings.isBad(index)) {
            return;
        }
        if (a->kind != BodyKind::Dynamic && b->kind != BodyKind::Dynamic) {
            m_findings.add(Severity::Warning, "connector-moves-nothing", {}, {index, key, {}});
            return;
        }
        checkStiffness(index, key, connector, yielding(*a, connector.anchorA) + yielding(*b, connector.anchorB));
    }

  private:
    double yielding(const BodyObject& body, const Vec2& anchor) {
        if (body.kind != BodyKind::Dynamic || body.frozen) {
            return 0;
        }
        // Many connectors may hang on a body of many shapes.
        auto [found, isNew] = m_masses.try_emplace(&body);
        if (isNew) {
            found->second = massOf(body);
        }
        return yieldingOf(body, found->second, anchor);
    }
    const BodyObject* end(int index, Key key, Key wanted, const char* name) {
        const Object* object = m_objects.find(wanted);
        const auto* body = object == nullptr ? nullptr : std::get_if<BodyObject>(&object->data);
        if (body == nullptr) {
            const LevelCode code = object == nullptr ? LevelCode("connector-end-missing") : "connector-end-no-body";
            m_findings.add(Severity::Error, code, {name, keyText(wanted)}, {index, key, std::string("/") + name});
        }
        return body;
    }
    /// The sub-steps follow an oscillation of less than one radian a step; beyond two it grows without end.
    void checkStiffness(int index, Key key, const ConnectorObject& connector, double compliance) {
        const double stiffness = connector.truncation == TruncationRule::Zero ? 0 : connector.stiffness;
        const double turn = std::sqrt(stiffness * compliance) * m_substep;
        if (turn > 1) {
            m_findings.add(Severity::Warning, "spring-too-stiff",
                           {spelledNumber(connector.stiffness), spelledNumber(m_substeps * std::ceil(turn))},
                           {index, key, "/stiffness"});
        }
        const double decay = connector.damping * compliance * m_substep;
        if (decay > 1) {
            m_findings.add(Severity::Warning, "damping-too-strong",
                           {spelledNumber(connector.damping), spelledNumber(m_substeps * std::ceil(decay))},
                           {index, key, "/damping"});
        }
    }

    const ObjectList& m_objects;
    std::map<const BodyObject*, MassProperties> m_masses;
    Findings& m_findings;
    double m_substep;  // s
    double m_substeps; // an iteration
};

} // namespace

void checkConnectors(const Level& level, Findings& findings) {
    ConnectorChecker checker(level, findings);
    for (int i = 0; i < level.objects.size(); ++i) {
        const Object& object = level.objects[i];
        if (const auto* connector = std::get_if<ConnectorObject>(&object.data)) {
            checker.check(i, object.key, *connector);
        }
    }
}

} // namespace spacetow
