// What things are called that points snap to.
#include "editor/panels/names.h"
#include "editor/window/messages.h"

#include <QCoreApplication>

#include <QStringList>

namespace spacetow {

namespace {

struct SnapText {
    const char* alone;
    const char* of; // with the name of the object
};

SnapText textOf(SnapKind kind) {
    switch (kind) {
    case SnapKind::None:
        break;
    case SnapKind::Vertex:
        return {QT_TRANSLATE_NOOP("messages", "vertex"), QT_TRANSLATE_NOOP("messages", "vertex of %1")};
    case SnapKind::Center:
        return {QT_TRANSLATE_NOOP("messages", "center"), QT_TRANSLATE_NOOP("messages", "center of %1")};
    case SnapKind::Anchor:
        return {QT_TRANSLATE_NOOP("messages", "anchor"), QT_TRANSLATE_NOOP("messages", "anchor on %1")};
    case SnapKind::Intersection:
        return {QT_TRANSLATE_NOOP("messages", "intersection"), QT_TRANSLATE_NOOP("messages", "intersection with %1")};
    case SnapKind::Midpoint:
        return {QT_TRANSLATE_NOOP("messages", "midpoint"), QT_TRANSLATE_NOOP("messages", "midpoint of %1")};
    case SnapKind::Perpendicular:
        return {QT_TRANSLATE_NOOP("messages", "perpendicular"), QT_TRANSLATE_NOOP("messages", "perpendicular to %1")};
    case SnapKind::Edge:
        return {QT_TRANSLATE_NOOP("messages", "edge"), QT_TRANSLATE_NOOP("messages", "edge of %1")};
    case SnapKind::Guide:
        return {QT_TRANSLATE_NOOP("messages", "guide"), QT_TRANSLATE_NOOP("messages", "guide %1")};
    case SnapKind::Alignment:
        return {QT_TRANSLATE_NOOP("messages", "aligned"), QT_TRANSLATE_NOOP("messages", "in line with %1")};
    case SnapKind::Angle:
        return {QT_TRANSLATE_NOOP("messages", "multiple of 15°"), ""};
    case SnapKind::Grid:
        return {QT_TRANSLATE_NOOP("messages", "grid"), ""};
    }
    return {"", ""};
}

QString translatedName(const char* text) {
    return *text == '\0' ? QString() : QCoreApplication::translate("messages", text);
}

QString nameOf(const Level& level, Key key) {
    const Object* object = level.objects.find(key);
    return object == nullptr ? QString() : displayName(*object);
}

/// "a", "a and b"; equal names once.
QString joined(const QStringList& names) {
    return names.size() == 2 ? QCoreApplication::translate("messages", "%1 and %2").arg(names[0], names[1])
                             : names.value(0);
}

QString aligned(const Level& level, const SnapAnswer& snap) {
    QStringList names;
    for (const SnapLine& line : snap.lines) {
        names << nameOf(level, line.key);
    }
    names.removeAll(QString());
    names.removeDuplicates();
    return joined(names);
}

} // namespace

QString snapName(const Level& level, const SnapAnswer& snap) {
    const SnapText text = textOf(snap.kind);
    QStringList names;
    if (snap.guide >= 0 && snap.guide < static_cast<int>(level.guides.size())) {
        names << QString::fromStdString(level.guides[static_cast<std::size_t>(snap.guide)].name);
    }
    for (const Key key : {snap.key, snap.other}) {
        names << nameOf(level, key);
    }
    names.removeAll(QString());
    names.removeDuplicates();
    const QString whose = snap.kind == SnapKind::Alignment ? aligned(level, snap) : joined(names);
    const QString name =
        whose.isEmpty() || *text.of == '\0' ? translatedName(text.alone) : translatedName(text.of).arg(whose);
    if (snap.kind == SnapKind::Alignment || snap.lines.empty()) {
        return name;
    }
    return name + QStringLiteral(", ") + translatedName(textOf(SnapKind::Alignment).of).arg(aligned(level, snap));
}

} // namespace spacetow
