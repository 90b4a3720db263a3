#include "editor/panels/names.h"

#include "core/level/bounds.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTextDocument>

#include <cmath>

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

QString listedName(const Level& level, const Object& object) {
    const QString kind = kindName(object);
    if (!object.name.empty()) {
        return Names::tr("%1 (%2)").arg(QString::fromStdString(object.name), kind);
    }
    const Aabb box = boundsOf(level, object);
    if (box.isEmpty()) {
        return kind;
    }
    const auto metres = [](double value) {
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        return locale.toString(std::round(100 * value) / 100 + 0.0, 'g', 12); // no minus before zero
    };
    return Names::tr("%1 at %2; %3").arg(kind, metres(box.center().x()), metres(box.center().y()));
}

QString menuSafe(const QString& name) {
    return QString(name).replace(QLatin1Char('&'), QStringLiteral("&&"));
}

QString plainToolTip(const QString& text) {
    return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text) : text;
}

QString displayName(const Object& object) {
    return object.name.empty() ? kindName(object) : QString::fromStdString(object.name);
}

} // namespace spacetow
