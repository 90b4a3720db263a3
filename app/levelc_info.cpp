#include "app/levelc_commands.h"
#include "app/levelc_support.h"
#include "core/level/bounds.h"
#include "core/level/fields.h"
#include "core/level/json_text.h"

namespace spacetow {

namespace {

void printField(const char* name, const QString& value) {
    printLine(QStringLiteral("%1: %2").arg(QLatin1String(name), value));
}

QString numberText(double value) {
    return QString::fromStdString(spelledNumber(value));
}

QString pointText(const Vec2& p) {
    return QStringLiteral("(%1, %2)").arg(numberText(p.x()), numberText(p.y()));
}

std::size_t vertexCount(const LevelShape& shape) {
    if (const auto* edges = std::get_if<EdgeChain>(&shape)) {
        return edges->vertices.size();
    }
    if (const auto* lines = std::get_if<LineChain>(&shape)) {
        return lines->vertices.size();
    }
    const auto* polygon = std::get_if<Polygon>(&shape);
    return polygon == nullptr ? 0 : polygon->vertices.size();
}

QString objectCounts(const Level& level) {
    std::array<int, objectTypeNames.size()> counts{};
    for (const Object& object : level.objects) {
        ++counts[object.data.index()];
    }
    QStringList parts;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        parts << QStringLiteral("%1 %2").arg(counts[i]).arg(QString::fromUtf8(objectTypeNames[i].data()));
    }
    return parts.join(QStringLiteral(", "));
}

QString shapeCounts(const Level& level) {
    std::array<int, shapeTypeNames.size()> counts{};
    std::size_t vertices = 0;
    for (const Object& object : level.objects) {
        if (const auto* body = std::get_if<BodyObject>(&object.data)) {
            for (const LevelShape& shape : body->shapes) {
                ++counts[shape.index()];
                vertices += vertexCount(shape);
            }
        }
    }
    QStringList parts;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        parts << QStringLiteral("%1 %2").arg(counts[i]).arg(QString::fromUtf8(shapeTypeNames[i].data()));
    }
    parts << QStringLiteral("%1 vertices").arg(vertices);
    return parts.join(QStringLiteral(", "));
}

QString tagNames(const TagTable& tags) {
    QStringList names;
    for (int i = 0; i < TagTable::size; ++i) {
        if (!tags[i].name.empty()) {
            names << QString::fromStdString(tags[i].name);
        }
    }
    return names.join(QStringLiteral(", "));
}

void printInfo(const Level& level) {
    printField("name", QString::fromStdString(level.name));
    printField("author", QString::fromStdString(level.author));
    printField("description", QString::fromStdString(level.description));
    printField("objects", objectCounts(level));
    printField("shapes", shapeCounts(level));
    const Aabb bounds = boundsOf(level);
    printField("bounds", bounds.isEmpty() ? QStringLiteral("empty")
                                          : pointText(bounds.min) + " to " + pointText(bounds.max) + " m");
    printField("gravity", pointText(level.gravity) + " m/s²");
    printField("update", QStringLiteral("%1 s, %2 iterations, %3 sub-steps")
                             .arg(numberText(level.updateSeconds))
                             .arg(level.iterations)
                             .arg(level.substeps));
    printField("rules", QStringLiteral("%1 lives, tow range %2 m, gravity %3 on towing, background %4")
                            .arg(level.rules.lives)
                            .arg(numberText(level.rules.towRange),
                                 level.rules.flipGravityOnTow ? QStringLiteral("flips") : QStringLiteral("stays"),
                                 QString::fromStdString(level.rules.background)));
    printField("tags", tagNames(level.tags));
}

} // namespace

int infoCommand(const QStringList& arguments) {
    CommandLine line(QStringLiteral("info"), QStringLiteral("Says what is in a level."));
    line.parser.addPositionalArgument(QStringLiteral("file"), QStringLiteral("Level file."), QStringLiteral("FILE"));
    if (!line.read(arguments, 1, 1)) {
        return exit_status::unusable;
    }
    if (line.helpWanted()) {
        printText(line.helpText());
        return exit_status::good;
    }
    const std::optional<Level> level = loadedLevel(line.parser.positionalArguments().front());
    if (!level) {
        return exit_status::unusable;
    }
    printInfo(*level);
    return exit_status::good;
}

} // namespace spacetow
