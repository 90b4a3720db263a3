#include "core/level/build.h"
#include "core/level/lint_findings.h"
#include "core/physics/world/make_body.h"

namespace spacetow {

namespace {

void checkMass(Findings& findings, const FindingPlace& place, std::span<const Shape> shapes, double density,
               std::optional<double> mass) {
    if (usableMass(shapes, density, mass)) {
        return;
    }
    // Whichever would have been alright by itself is not to blame.
    const bool massIsToBlame = mass && usableMass(shapes, density, {});
    findings.add(Severity::Error, massIsToBlame ? LevelCode("mass-not-usable") : "body-not-usable", {},
                 {place.index, place.key, massIsToBlame ? "/mass" : place.path});
}

} // namespace

void checkMasses(const Level& level, Findings& findings) {
    for (int i = 0; i < level.objects.size(); ++i) {
        const Object& object = level.objects[i];
        if (findings.isBad(i)) {
            continue;
        }
        if (const auto* body = std::get_if<BodyObject>(&object.data); body && body->kind != BodyKind::Static) {
            checkMass(findings, {i, object.key, "/shapes"}, physicsShapes(*body), body->density, body->mass);
        } else if (const auto* payload = std::get_if<PayloadObject>(&object.data)) {
            const Shape ball = Circle{{0, 0}, payload->radius};
            checkMass(findings, {i, object.key, "/radius"}, {&ball, 1}, 1, payload->mass);
        }
    }
}

} // namespace spacetow
