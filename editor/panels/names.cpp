#include "editor/panels/names.h"

#include <QCoreApplication>

namespace spacetow {

namespace {

QString tr(const char* words) {
    return QCoreApplication::translate("Names", words);
}

QString bodyName(const BodyObject& body) {
    if (body.shapes.size() != 1) {
        return tr("Body");
    }
    switch (body.shapes.front().index()) {
    case 0:
        return tr("One-way wall");
    case 1:
        return tr("Two-way line");
    case 2:
        return tr("Polygon");
    default:
        return tr("Circle");
    }
}

} // namespace

QString kindName(const Object& object) {
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        return bodyName(*body);
    }
    if (std::holds_alternative<ShipObject>(object.data)) {
        return tr("Ship");
    }
    if (std::holds_alternative<PayloadObject>(object.data)) {
        return tr("Payload");
    }
    return std::holds_alternative<FinishObject>(object.data) ? tr("Finish") : tr("Connector");
}

QString displayName(const Object& object) {
    return object.name.empty() ? kindName(object) : QString::fromStdString(object.name);
}

} // namespace spacetow
