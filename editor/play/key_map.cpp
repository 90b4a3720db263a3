#include "editor/play/key_map.h"

#include "editor/canvas/key_place.h"

#include <QKeyEvent>

#include <algorithm>

namespace spacetow {

namespace {

// clang-format off
constexpr PlayKeyRow gameKeys[] = {
    {PlayKey::Thrust, "game/thrust", QT_TRANSLATE_NOOP("Keys", "Thrust"), "W Up"},
    {PlayKey::Left, "game/left", QT_TRANSLATE_NOOP("Keys", "Turn left"), "A Left"},
    {PlayKey::Right, "game/right", QT_TRANSLATE_NOOP("Keys", "Turn right"), "D Right"},
    {PlayKey::Tow, "game/tow", QT_TRANSLATE_NOOP("Keys", "Tow the payload when it is near; again: let it go"), "Space"},
    {PlayKey::Pause, "game/pause", QT_TRANSLATE_NOOP("Keys", "Hold the game, or go on"), "P"},
    {PlayKey::Step, "game/step", QT_TRANSLATE_NOOP("Keys", "Hold the game and advance it by one update"), "O"},
    {PlayKey::Restart, "game/restart", QT_TRANSLATE_NOOP("Keys", "Start the level over"), "R"},
    {PlayKey::Follow, "game/follow", QT_TRANSLATE_NOOP("Keys", "Let the view follow the ship again"), "F"},
    {PlayKey::Slower, "game/slower", QT_TRANSLATE_NOOP("Keys", "Let time run slower"), "["},
    {PlayKey::Faster, "game/faster", QT_TRANSLATE_NOOP("Keys", "Let time run faster"), "]"},
    {PlayKey::FrameBack, "game/back", QT_TRANSLATE_NOOP("Keys", "While held: one update back"), ","},
    {PlayKey::FrameForward, "game/forward", QT_TRANSLATE_NOOP("Keys", "While held: one update on"), "."},
    {PlayKey::Rewind, "game/rewind", QT_TRANSLATE_NOOP("Keys", "Turn time back, as long as the key is held"),
     "Backspace"},
};
// clang-format on

bool steers(PlayKey meaning) {
    return meaning == PlayKey::Left || meaning == PlayKey::Right || meaning == PlayKey::Thrust ||
           meaning == PlayKey::Tow;
}

QList<QKeySequence> spelledKeys(const char* words) {
    QList<QKeySequence> keys;
    for (const QString& word : QString::fromLatin1(words).split(QLatin1Char(' '))) {
        keys << QKeySequence(word, QKeySequence::PortableText);
    }
    return keys;
}

} // namespace

std::span<const PlayKeyRow> playKeyRows() {
    return gameKeys;
}

const PlayKeys::Rows& PlayKeys::usual() {
    static const Rows rows = [] {
        Rows made;
        for (const PlayKeyRow& row : gameKeys) {
            made[static_cast<std::size_t>(row.meaning)] = spelledKeys(row.keys);
        }
        return made;
    }();
    return rows;
}

QString PlayKeys::shown(PlayKey meaning) const {
    const QList<QKeySequence>& keys = of(meaning);
    return keys.isEmpty() ? QString() : keys.front().toString(QKeySequence::NativeText);
}

template <class Which>
PlayKey PlayKeys::find(int key, const Which& which) const {
    for (const PlayKeyRow& row : gameKeys) {
        const QList<QKeySequence>& usualOnes = usual()[static_cast<std::size_t>(row.meaning)];
        for (const QKeySequence& one : of(row.meaning)) {
            if (one[0].key() == key && which(row.meaning, usualOnes.contains(one))) {
                return row.meaning;
            }
        }
    }
    return PlayKey::None;
}

PlayKey PlayKeys::meaningOf(const QKeyEvent& event) const {
    if (event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier | Qt::GroupSwitchModifier)) {
        return PlayKey::None;
    }
    const int key = latinKey(event);
    if (key == Qt::Key_Escape) {
        return PlayKey::Menu;
    }
    const bool isLetter = key >= Qt::Key_A && key <= Qt::Key_Z;
    const auto chosen = [](PlayKey, bool isUsual) { return !isUsual; };
    const auto commands = [](PlayKey meaning, bool) { return !steers(meaning); };
    // Shift makes other signs of signs, but leaves the key in its place.
    const auto byPlace = [isLetter](PlayKey meaning, bool isUsual) { return isUsual ? steers(meaning) : !isLetter; };
    const auto all = [](PlayKey, bool) { return true; };
    // A letter that says a command is one wherever it lies.
    const Qt::Key place = keyAtPlace(event).value_or(Qt::Key_unknown);
    for (const PlayKey meaning : {find(key, chosen), find(key, commands), find(place, byPlace), find(key, all)}) {
        if (meaning != PlayKey::None) {
            return meaning;
        }
    }
    return PlayKey::None;
}

PlayKey playKey(const QKeyEvent& event) {
    return PlayKeys().meaningOf(event);
}

bool HeldKeys::press(const QKeyEvent& event, const PlayKeys& keys) {
    const PlayKey meaning = keys.meaningOf(event);
    if (steers(meaning)) {
        m_keys[keyNumber(event)] = meaning;
    }
    return steers(meaning);
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
