#include "editor/play/key_map.h"

namespace spacetow {

PlayKey playKey(int key, Qt::KeyboardModifiers modifiers) {
    if (modifiers & ~(Qt::ShiftModifier | Qt::KeypadModifier)) {
        return PlayKey::None;
    }
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

bool HeldKeys::press(int key, PlayKey meaning) {
    const bool steers =
        meaning == PlayKey::Left || meaning == PlayKey::Right || meaning == PlayKey::Thrust || meaning == PlayKey::Tow;
    if (steers) {
        m_keys.insert(key);
    }
    return steers;
}

Controls HeldKeys::controls() const {
    Controls controls;
    for (const int key : m_keys) {
        // What was held when a modifier was pressed stays held, so the modifiers of now do not matter.
        const PlayKey meaning = playKey(key, Qt::NoModifier);
        controls.left |= meaning == PlayKey::Left;
        controls.right |= meaning == PlayKey::Right;
        controls.thrust |= meaning == PlayKey::Thrust;
        controls.tow |= meaning == PlayKey::Tow;
    }
    return controls;
}

} // namespace spacetow
