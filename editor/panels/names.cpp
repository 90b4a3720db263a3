#include "editor/panels/names.h"

#include <QCoreApplication>

namespace spacetow {

namespace {

struct Names {
    Q_DECLARE_TR_FUNCTIONS(Names)
};

QString bodyName(const BodyObject& body) {
    if (body.shapes.size() != 1) {
        return Names::tr("Body");
    }
    switch (body.shapes.front().index()) {
    case 0:
        return Names::tr("One-way wall");
    case 1:
        return Names::tr("Two-way line");
    case 2:
        return Names::tr("Polygon");
    default:
        return Names::tr("Circle");
    }
}

} // namespace

QString kindName(const Object& object) {
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        return bodyName(*body);
    }
    if (std::holds_alternative<ShipObject>(object.data)) {
        return Names::tr("Ship");
    }
    if (std::holds_alternative<PayloadObject>(object.data)) {
        return Names::tr("Payload");
    }
    if (const auto* group = std::get_if<GroupObject>(&object.data)) {
        return group->layer ? Names::tr("Layer") : Names::tr("Group");
    }
    return std::holds_alternative<FinishObject>(object.data) ? Names::tr("Finish") : Names::tr("Connector");
}

QString displayName(const Object& object) {
    return object.name.empty() ? kindName(object) : QString::fromStdString(object.name);
}

} // namespace spacetow
