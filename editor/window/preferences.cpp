#include "editor/window/preferences.h"

#include "editor/canvas/overlay_table.h"
#include "editor/canvas/painter_draw.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>
#include <array>

namespace spacetow {

namespace {

constexpr auto recentKey = "recent";
constexpr double minStep = 0.001; // m
constexpr double maxStep = 100;   // m
constexpr int maxDivision = 100;  // parts of a step

QString overlayKey(const OverlayRow& row) {
    return QStringLiteral("overlays/%1").arg(QLatin1String(row.name));
}

QString overlayKey(const OverlayInk& ink) {
    return QStringLiteral("overlay-colors/%1").arg(QLatin1String(ink.name));
}

struct NamedSnap {
    const char* key;
    bool SnapSettings::*on;
};
constexpr std::array snapKeys{
    NamedSnap{"snap/grid", &SnapSettings::grid},
    NamedSnap{"snap/smart", &SnapSettings::smart},
    NamedSnap{"snap/vertices", &SnapSettings::vertices},
    NamedSnap{"snap/edges", &SnapSettings::edges},
    NamedSnap{"snap/midpoints", &SnapSettings::midpoints},
    NamedSnap{"snap/intersections", &SnapSettings::intersections},
    NamedSnap{"snap/perpendiculars", &SnapSettings::perpendiculars},
    NamedSnap{"snap/guides", &SnapSettings::guides},
    NamedSnap{"snap/alignment", &SnapSettings::alignment},
    NamedSnap{"snap/angles", &SnapSettings::angles},
};

} // namespace

QByteArray Preferences::geometry() const {
    return QSettings().value("window/geometry").toByteArray();
}

QByteArray Preferences::windowState() const {
    return QSettings().value("window/state").toByteArray();
}

void Preferences::setWindow(const QByteArray& geometry, const QByteArray& state) {
    QSettings settings;
    settings.setValue("window/geometry", geometry);
    settings.setValue("window/state", state);
}

QStringList Preferences::recentFiles() const {
    QStringList files = QSettings().value(recentKey).toStringList();
    files.removeIf([](const QString& path) { return !QFileInfo::exists(path); });
    return files;
}

void Preferences::addRecent(const QString& path) {
    QStringList files = recentFiles();
    files.removeAll(path);
    files.prepend(path);
    QSettings().setValue(recentKey, QStringList(files.mid(0, maxRecent)));
}

void Preferences::removeRecent(const QString& path) {
    QStringList files = QSettings().value(recentKey).toStringList();
    files.removeAll(path);
    QSettings().setValue(recentKey, files);
}

void Preferences::clearRecent() {
    QSettings().remove(recentKey);
}

bool Preferences::restoresWindows() const {
    return QSettings().value("windows/restore", true).toBool();
}

void Preferences::setRestoresWindows(bool restores) {
    QSettings().setValue("windows/restore", restores);
}

bool Preferences::welcomes() const {
    return QSettings().value("windows/welcome", true).toBool();
}

void Preferences::setWelcomes(bool welcomes) {
    QSettings().setValue("windows/welcome", welcomes);
}

QString Preferences::language() const {
    return QSettings().value("language").toString();
}

void Preferences::setLanguage(const QString& code) {
    QSettings().setValue("language", code);
}

SnapSettings Preferences::snap() const {
    const QSettings settings;
    SnapSettings snap;
    for (const NamedSnap& named : snapKeys) {
        snap.*named.on = settings.value(named.key, snap.*named.on).toBool();
    }
    const double step = settings.value("snap/step", snap.step).toDouble();
    snap.step = step >= minStep && step <= maxStep ? step : snap.step;
    const int division = settings.value("snap/division", snap.division).toInt();
    snap.division = division >= 1 && division <= maxDivision ? division : snap.division;
    return snap;
}

void Preferences::setSnap(const SnapSettings& snap) {
    QSettings settings;
    for (const NamedSnap& named : snapKeys) {
        settings.setValue(named.key, snap.*named.on);
    }
    settings.setValue("snap/step", snap.step);
    settings.setValue("snap/division", snap.division);
}

bool Preferences::grid() const {
    return QSettings().value("grid", true).toBool();
}

void Preferences::setGrid(bool visible) {
    QSettings().setValue("grid", visible);
}

bool Preferences::rulers() const {
    return QSettings().value("rulers", true).toBool();
}

void Preferences::setRulers(bool visible) {
    QSettings().setValue("rulers", visible);
}

bool Preferences::guides() const {
    return QSettings().value("guides", true).toBool();
}

void Preferences::setGuides(bool visible) {
    QSettings().setValue("guides", visible);
}

Appearance Preferences::appearance() const {
    const QString name = QSettings().value("appearance").toString();
    return name == QLatin1String("light")  ? Appearance::Light
           : name == QLatin1String("dark") ? Appearance::Dark
                                           : Appearance::System;
}

void Preferences::setAppearance(Appearance appearance) {
    QSettings().setValue("appearance", appearance == Appearance::Light  ? QStringLiteral("light")
                                       : appearance == Appearance::Dark ? QStringLiteral("dark")
                                                                        : QStringLiteral("system"));
}

OverlayFlags Preferences::overlays() const {
    const QSettings settings;
    OverlayFlags overlays;
    for (const OverlayRow& row : overlayRows()) {
        overlays.*row.flag = settings.value(overlayKey(row), overlays.*row.flag).toBool();
    }
    overlays.problems = settings.value("overlays/problems", overlays.problems).toBool();
    return overlays;
}

void Preferences::setOverlays(const OverlayFlags& overlays) {
    QSettings settings;
    for (const OverlayRow& row : overlayRows()) {
        settings.setValue(overlayKey(row), overlays.*row.flag);
    }
    settings.setValue("overlays/problems", overlays.problems);
}

OverlayPalette Preferences::overlayPalette() const {
    const QSettings settings;
    OverlayPalette palette;
    if (settings.value("overlay-colors/set").toString() == QLatin1String("okabe-ito")) {
        palette.set = OverlayColorSet::OkabeIto;
    }
    for (const OverlayInk& ink : overlayInks()) {
        const QColor own(settings.value(overlayKey(ink)).toString());
        if (own.isValid()) {
            palette.own[ink.name] = toColor(own);
        }
    }
    return palette;
}

void Preferences::setOverlayPalette(const OverlayPalette& palette) {
    QSettings settings;
    const bool isOkabeIto = palette.set == OverlayColorSet::OkabeIto;
    settings.setValue("overlay-colors/set", isOkabeIto ? QStringLiteral("okabe-ito") : QStringLiteral("standard"));
    for (const OverlayInk& ink : overlayInks()) {
        if (const auto own = palette.own.find(ink.name); own != palette.own.end()) {
            settings.setValue(overlayKey(ink), toQColor(own->second).name());
        } else {
            settings.remove(overlayKey(ink));
        }
    }
}

bool Preferences::isLegendShown() const {
    return QSettings().value("overlays/legend", true).toBool();
}

void Preferences::setLegendShown(bool shown) {
    QSettings().setValue("overlays/legend", shown);
}

QStringList Preferences::foldedSections() const {
    return QSettings().value("inspector/folded").toStringList();
}

void Preferences::setFoldedSections(const QStringList& titles) {
    QSettings().setValue("inspector/folded", titles);
}

KeyBindings Preferences::keyBindings() const {
    const QByteArray kept = QSettings().value("keys").toByteArray();
    return kept.isEmpty() ? KeyBindings() : readKeys(kept).bindings.value_or(KeyBindings());
}

void Preferences::setKeyBindings(const KeyBindings& bindings) {
    if (bindings.areUsual()) {
        QSettings().remove("keys");
    } else {
        QSettings().setValue("keys", keysText(bindings, false));
    }
}

QStringList Preferences::recentlyFound() const {
    return QSettings().value("finder/recent").toStringList();
}

void Preferences::addRecentlyFound(const QString& code) {
    QStringList codes = recentlyFound();
    codes.removeAll(code);
    codes.prepend(code);
    QSettings().setValue("finder/recent", QStringList(codes.mid(0, maxRecent)));
}

} // namespace spacetow
