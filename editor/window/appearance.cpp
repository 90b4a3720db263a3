#include "editor/window/appearance.h"

#include "editor/window/preferences.h"
#include "editor/window/style.h"

#include <QApplication>
#include <QFileInfo>
#include <QToolTip>

#ifdef SPACETOW_DBUS
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#endif

namespace spacetow {

namespace {

/// As it was before anybody changed it.
const QPalette& toolkitPalette() {
    static const QPalette palette = QGuiApplication::palette();
    return palette;
}

} // namespace

Shade desktopShade(const QByteArray& gtkTheme, const QPalette& toolkit) {
    const QByteArray theme = gtkTheme.toLower();
    if (theme.isEmpty()) {
        return shadeOf(toolkit);
    }
    return theme.endsWith(":dark") || theme.endsWith("-dark") ? Shade::Dark : Shade::Light;
}

Wardrobe::Wardrobe(Appearance appearance) : m_appearance(appearance) {
    toolkitPalette();
    if (qobject_cast<const Style*>(QApplication::style()) == nullptr) {
        QApplication::setStyle(new Style); // which the application owns from now on
    }
    dress();
    askDesktop();
}

void Wardrobe::setAppearance(Appearance appearance) {
    m_appearance = appearance;
    dress();
}

Shade Wardrobe::shade() const {
    switch (m_appearance) {
    case Appearance::Light:
        return Shade::Light;
    case Appearance::Dark:
        return Shade::Dark;
    case Appearance::System:
        break;
    }
    return m_desktop.value_or(desktopShade(qgetenv("GTK_THEME"), toolkitPalette()));
}

void Wardrobe::dress() const {
    const QPalette palette = panelPalette(shade());
    if (QApplication::palette() != palette) {
        QApplication::setPalette(palette);
        QToolTip::setPalette(palette);
    }
}

std::shared_ptr<Wardrobe> wardrobe() {
    static std::weak_ptr<Wardrobe> shared;
    std::shared_ptr<Wardrobe> one = shared.lock();
    if (!one) {
        one = std::make_shared<Wardrobe>(Preferences().appearance());
        shared = one;
    }
    return one;
}

#ifdef SPACETOW_DBUS

namespace {

const QString service = QStringLiteral("org.freedesktop.portal.Desktop");
const QString path = QStringLiteral("/org/freedesktop/portal/desktop");
const QString settings = QStringLiteral("org.freedesktop.portal.Settings");
const QString group = QStringLiteral("org.freedesktop.appearance");
const QString key = QStringLiteral("color-scheme");

/// A bus that runs already: none is to be started for a colour.
bool hasBus() {
    return !qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS") ||
           QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus"));
}

/// The portal wraps its answer once or twice.
unsigned unwrapped(QVariant value) {
    while (value.canConvert<QDBusVariant>()) {
        value = value.value<QDBusVariant>().variant();
    }
    return value.toUInt();
}

} // namespace

void Wardrobe::askDesktop() {
    if (!hasBus()) {
        return;
    }
    QDBusConnection bus = QDBusConnection::sessionBus();
    if (!bus.isConnected()) {
        return;
    }
    bus.connect(service, path, settings, QStringLiteral("SettingChanged"), this,
                SLOT(settingChanged(QString, QString, QDBusVariant)));
    QDBusMessage question = QDBusMessage::createMethodCall(service, path, settings, QStringLiteral("Read"));
    question << group << key;
    const auto* answer = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
    connect(answer, &QDBusPendingCallWatcher::finished, this, [this](QDBusPendingCallWatcher* done) {
        const QDBusPendingReply<QDBusVariant> reply = *done;
        if (reply.isValid()) {
            desktopSays(unwrapped(reply.value().variant()));
        }
        done->deleteLater();
    });
}

void Wardrobe::settingChanged(const QString& changedGroup, const QString& changedKey, const QDBusVariant& value) {
    if (changedGroup == group && changedKey == key) {
        desktopSays(unwrapped(value.variant()));
    }
}

#else

void Wardrobe::askDesktop() {}

void Wardrobe::settingChanged(const QString&, const QString&, const QDBusVariant&) {}

#endif

void Wardrobe::desktopSays(unsigned scheme) {
    constexpr unsigned preferDark = 1;
    constexpr unsigned preferLight = 2;
    m_desktop = scheme == preferDark    ? std::optional(Shade::Dark)
                : scheme == preferLight ? std::optional(Shade::Light)
                                        : std::nullopt;
    dress();
}

} // namespace spacetow
