#include "editor/panels/names.h"

#include "core/level/bounds.h"
#include "core/level/object_geometry.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QTextDocument>

#include <array>
#include <cmath>
#include <optional>

namespace spacetow {

namespace {

struct Names {
    Q_DECLARE_TR_FUNCTIONS(Names)
};

constexpr auto kindsOfShape = static_cast<int>(std::variant_size_v<LevelShape>);

// Bodies of one shape by that, bodies of several, then the other kinds of objects, and layers.
constexpr std::array kindNames{QT_TRANSLATE_NOOP("Names", "One-way wall"), QT_TRANSLATE_NOOP("Names", "Two-way line"),
                               QT_TRANSLATE_NOOP("Names", "Polygon"),      QT_TRANSLATE_NOOP("Names", "Circle"),
                               QT_TRANSLATE_NOOP("Names", "Body"),         QT_TRANSLATE_NOOP("Names", "Ship"),
                               QT_TRANSLATE_NOOP("Names", "Payload"),      QT_TRANSLATE_NOOP("Names", "Finish"),
                               QT_TRANSLATE_NOOP("Names", "Connector"),    QT_TRANSLATE_NOOP("Names", "Group"),
                               QT_TRANSLATE_NOOP("Names", "Layer")};
static_assert(kindNames.size() == std::variant_size_v<LevelShape> + std::variant_size_v<ObjectData> + 1);

} // namespace

int kindCount() {
    return static_cast<int>(kindNames.size());
}

int kindOf(const Object& object) {
    const auto* body = std::get_if<BodyObject>(&object.data);
    if (body != nullptr && body->shapes.size() == 1) {
        return static_cast<int>(body->shapes.front().index());
    }
    const auto* group = std::get_if<GroupObject>(&object.data);
    return group != nullptr && group->layer ? kindCount() - 1 : kindsOfShape + static_cast<int>(object.data.index());
}

QString kindName(int kind) {
    return Names::tr(kindNames[static_cast<std::size_t>(kind)]);
}

QString kindName(const Object& object) {
    return kindName(kindOf(object));
}

QString kindIcon(const Object& object) {
    if (const auto* body = std::get_if<BodyObject>(&object.data)) {
        constexpr std::array shapes{"edge", "line", "polygon", "circle"}; // as in LevelShape
        return QLatin1String(body->shapes.size() == 1 ? shapes[body->shapes.front().index()] : "union");
    }
    constexpr std::array others{"", "ship", "payload", "finish", "connector", "group"}; // as in ObjectData
    const auto* group = std::get_if<GroupObject>(&object.data);
    return QLatin1String(group != nullptr && group->layer ? "layer" : others[object.data.index()]);
}

namespace {

/// Where everybody sees it: ship and payload at their place, everything else in the middle of its bounds.
QString placed(const Object& object, const Aabb& box) {
    const bool isOne =
        std::holds_alternative<ShipObject>(object.data) || std::holds_alternative<PayloadObject>(object.data);
    if (box.isEmpty()) {
        return kindName(object);
    }
    const Vec2 at = isOne ? *placeOf(object.data) : box.center();
    const auto metres = [](double value) {
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        return locale.toString(std::round(100 * value) / 100 + 0.0, 'g', 12); // no minus before zero
    };
    return Names::tr("%1 at %2; %3").arg(kindName(object), metres(at.x()), metres(at.y()));
}

} // namespace

QString placedKind(const Object& object) {
    return placed(object, ownBounds(object.data));
}

QString listedName(const Level& level, const Object& object) {
    return object.name.empty() ? placed(object, boundsOf(level, object))
                               : Names::tr("%1 (%2)").arg(QString::fromStdString(object.name), kindName(object));
}

QString menuSafe(const QString& name) {
    return QString(name).replace(QLatin1Char('&'), QStringLiteral("&&"));
}

QString withoutMnemonic(QString text) {
    static const QRegularExpression appended(QStringLiteral("\\s*\\(&[^&)]\\)"));
    text.remove(appended);
    for (qsizetype i = text.indexOf(QLatin1Char('&')); i >= 0; i = text.indexOf(QLatin1Char('&'), i + 1)) {
        text.remove(i, 1); // of two, one is meant as it stands
    }
    return text;
}

QString plainToolTip(const QString& text) {
    constexpr int longest = 90; // characters, in one line
    if (text.size() > longest && !text.contains(QLatin1Char('\n'))) {
        return QStringLiteral("<qt>%1</qt>").arg(text.toHtmlEscaped()); // which takes as many lines as it needs
    }
    return Qt::mightBeRichText(text) ? Qt::convertFromPlainText(text) : text;
}

QString displayName(const Object& object) {
    return object.name.empty() ? kindName(object) : QString::fromStdString(object.name);
}

} // namespace spacetow
