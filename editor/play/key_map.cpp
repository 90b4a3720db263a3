#include "editor/play/key_map.h"

#include "editor/canvas/key_place.h"

#include <QKeyEvent>

namespace spacetow {

namespace {

PlayKey commandOf(int key) {
    switch (key) {
    case Qt::Key_Escape:
        return PlayKey::Menu;
    case Qt::Key_P:
    case Qt::Key_F9:
        return PlayKey::Pause;
    case Qt::Key_O:
    case Qt::Key_F10:
        return PlayKey::Step;
    case Qt::Key_R:
        return PlayKey::Restart;
    case Qt::Key_F:
        return PlayKey::Follow;
    default:
        return PlayKey::None;
    }
}

PlayKey steeringOf(int key) {
    switch (key) {
    case Qt::Key_Left:
    case Qt::Key_A:
        return PlayKey::Left;
    case Qt::Key_Right:
    case Qt::Key_D:
        return PlayKey::Right;
    case Qt::Key_Up:
    case Qt::Key_W:
        return PlayKey::Thrust;
    case Qt::Key_Space:
        return PlayKey::Tow;
    default:
        return PlayKey::None;
    }
}

} // namespace

PlayKey playKey(const QKeyEvent& event) {
    if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier | Qt::GroupSwitchModifier)) {
        return PlayKey::None;
    }
    // A letter that says a command is one wherever it lies.
    const int key = latinKey(event);
    for (const PlayKey meaning :
         {commandOf(key), steeringOf(keyAtPlace(event).value_or(Qt::Key_unknown)), steeringOf(key)}) {
        if (meaning != PlayKey::None) {
            return meaning;
        }
    }
    return PlayKey::None;
}

bool HeldKeys::press(const QKeyEvent& event) {
    const PlayKey meaning = playKey(event);
    const bool steers =
        meaning == PlayKey::Left || meaning == PlayKey::Right || meaning == PlayKey::Thrust || meaning == PlayKey::Tow;
    if (steers) {
        m_keys[keyNumber(event)] = meaning;
    }
    return steers;
}

void HeldKeys::release(const QKeyEvent& event) {
    m_keys.erase(keyNumber(event));
}

Controls HeldKeys::controls() const {
    Controls controls;
    for (const auto& [number, meaning] : m_keys) {
        controls.left |= meaning == PlayKey::Left;
        controls.right |= meaning == PlayKey::Right;
        controls.thrust |= meaning == PlayKey::Thrust;
        controls.tow |= meaning == PlayKey::Tow;
    }
    return controls;
}

} // namespace spacetow
