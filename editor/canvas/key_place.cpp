#include "editor/canvas/key_place.h"

#include <QGuiApplication>
#include <QKeyEvent>

#include <iterator>
#include <string_view>

namespace spacetow {

namespace {

/// The keys of a US keyboard by their scan code, from 2 on; blanks stand for those that need no translation. Windows
/// and the kernels of Linux and BSD agree on these.
constexpr std::string_view places = "1234567890-=  QWERTYUIOP[]  ASDFGHJKL;'` \\ZXCVBNM,./";
constexpr quint32 firstCode = 2;
constexpr quint32 codesOfX = 8; // X11 and Wayland add this

/// 0 where the desktop tells none.
quint32 scanCode(const QKeyEvent& event) {
    const quint32 code = event.nativeScanCode();
    if (QGuiApplication::platformName() == QLatin1String("windows")) {
        return code;
    }
    return code > codesOfX ? code - codesOfX : 0;
}

/// Printable characters of ASCII and keys without a character are the same on every keyboard that has them.
bool isOnUsKeyboard(int key) {
    const bool dead = key >= Qt::Key_Dead_Grave && key <= Qt::Key_Dead_Longsolidusoverlay;
    return (key >= Qt::Key_Space && key <= Qt::Key_AsciiTilde) || (key >= Qt::Key_Escape && !dead);
}

} // namespace

std::optional<Qt::Key> keyAtPlace(const QKeyEvent& event) {
    const quint32 index = scanCode(event) - firstCode; // wraps round for 0
    if (index >= places.size() || places[index] == ' ') {
        return {};
    }
    return static_cast<Qt::Key>(places[index]);
}

int latinKey(const QKeyEvent& event) {
    return isOnUsKeyboard(event.key()) ? event.key() : keyAtPlace(event).value_or(static_cast<Qt::Key>(event.key()));
}

quint32 keyNumber(const QKeyEvent& event) {
    constexpr quint32 noScanCode = 1u << 31;
    return event.nativeScanCode() != 0 ? event.nativeScanCode() : noScanCode | static_cast<quint32>(event.key());
}

} // namespace spacetow
