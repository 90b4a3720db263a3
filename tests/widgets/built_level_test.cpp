// A whole level, from an empty window to a win: drawn with mouse and keys alone, saved, and flown with the keys of the
// game; the recording of the flight wins the saved file again.

#include "core/game/autopilot.h"
#include "core/game/replay.h"
#include "core/level/file.h"
#include "core/level/lint.h"
#include "tests/support/drive.h"
#include "tests/support/game_view.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Draws as a user does: keys go to whoever has the focus, and the mouse to the canvas.
struct Builder : TestWindow {
    void keys(const char* text) {
        for (const char* letter = text; *letter != '\0'; ++letter) {
            QTest::keyClick(QApplication::focusWidget(), *letter);
        }
    }
    void typePoint(const char* length, const char* angle) {
        keys(length);
        key(Qt::Key_Tab);
        keys(angle);
        key(Qt::Key_Return);
    }
    template <class T>
    const T& only() {
        return std::get<T>(firstOf<T>(level())->data);
    }

    void build() {
        while (!window->toolbox().snap.grid) {
            key(Qt::Key_G, Qt::ShiftModifier); // points land on the grid
        }
        keys("--"); // the whole cave in view
        // The cave: its first side by the mouse, two by typing, the last by a click on the first point.
        key(Qt::Key_E);
        click(-5.1, -3.1);
        click(4.9, -2.9);
        typePoint("6", "90");
        typePoint("10", "180");
        click(-4.95, -3.05);
        // A platform under the payload, from corner to corner, and a boulder.
        key(Qt::Key_R);
        drag(-1.5, -3, -0.5, -2.5);
        key(Qt::Key_C);
        click(1, -2.5);
        click(1, -2.25);
        // Ship, payload and finish.
        key(Qt::Key_I);
        click(-3, 1);
        key(Qt::Key_I);
        click(-1, -2.25);
        key(Qt::Key_I);
        drag(3, -3, 3, 3);
    }
};

const std::array<std::pair<bool Controls::*, Qt::Key>, 4> steering{{{&Controls::left, Qt::Key_Left},
                                                                    {&Controls::right, Qt::Key_Right},
                                                                    {&Controls::thrust, Qt::Key_Up},
                                                                    {&Controls::tow, Qt::Key_Space}}};

/// Presses and lets go what is held differently now.
void pressKeys(Canvas& view, const Controls& before, const Controls& now) {
    for (const auto& [held, key] : steering) {
        if (now.*held && !(before.*held)) {
            QTest::keyPress(&view, key);
        } else if (!(now.*held) && before.*held) {
            QTest::keyRelease(&view, key);
        }
    }
}

/// The pilot looks at a game of its own, which goes the same way.
Replay flownByKeys(Game& game, const Level& level) {
    Autopilot pilot({{{{-2, 0.5}, 0.6}, {{-1, -1.3}, 0.5}}, {{{-0.5, -0.4}, 0.4}, {{4.3, 0.4}, 0.6}}});
    Session seen(level);
    Controls held;
    for (int i = 0; i < 4000 && seen.phase() != Phase::Won && seen.phase() != Phase::Crashed; ++i) {
        const Controls next = pilot.next(seen);
        pressKeys(game.view(), held, next);
        held = next;
        seen.step(next);
        game.run(1);
    }
    pressKeys(game.view(), held, {});
    return game.live().runner()->askRecording()().run;
}

} // namespace

class BuiltLevelTest : public QObject {
    Q_OBJECT

  private slots:
    void aLevelDrawnWithMouseAndKeysAloneIsWon() {
        Builder builder;
        builder.build();
        const auto& cave = std::get<BodyObject>(builder.level().objects[0].data);
        QVERIFY(cave.shapes.front() == LevelShape(EdgeChain{{{0, 0}, {10, 0}, {10, 6}, {0, 6}}, true, noBack}));
        QVERIFY(cave.position == Vec2(-5, -3));
        QCOMPARE(builder.level().objects.size(), 6);
        QVERIFY(builder.only<ShipObject>().position == Vec2(-3, 1));
        QVERIFY(builder.only<PayloadObject>().position == Vec2(-1, -2.25));
        QVERIFY(builder.only<FinishObject>() == (FinishObject{{3, -3}, {3, 3}}));

        builder.toSave = builder.file(QStringLiteral("built.json"));
        builder.key(Qt::Key_S, Qt::ControlModifier);
        const Result<LevelFile> file = readLevel(builder.toSave.toStdString());
        QVERIFY(file && file.value().level);
        QVERIFY(file.value().problems.empty());
        const Level& level = *file.value().level;
        QVERIFY(level == builder.level());

        Game game(level);
        const Replay flight = flownByKeys(game, level);
        QCOMPARE(game.phase(), Phase::Won);
        const Outcome outcome = replayed(level, flight);
        QVERIFY(outcome.won());
        QCOMPARE(outcome.lives, level.rules.lives);
    }

    void undoneToTheStartItIsTheEmptyLevelAgain() {
        Builder builder;
        const Level before = builder.level();
        builder.build();
        for (int i = 0; i < 6; ++i) {
            builder.key(Qt::Key_Z, Qt::ControlModifier);
        }
        QVERIFY(builder.level() == before);
        for (int i = 0; i < 6; ++i) {
            builder.key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        }
        QCOMPARE(builder.level().objects.size(), 6);
    }
};

SPACETOW_TEST(BuiltLevelTest)
#include "built_level_test.moc"
