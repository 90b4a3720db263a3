// A level is run, held, changed and gone on with; what is kept of it.
#include "core/level/file.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <QPushButton>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Without gravity: a ball that flies to the right, far below it a wall.
Level driftingBall() {
    Level level;
    level.gravity = Vec2(0, 0);
    level.iterations = 4;
    BodyObject ball{.kind = BodyKind::Dynamic, .shapes = {Circle{{0, 0}, 0.3}}, .velocity = {0.2, 0}};
    ball.mass = 1;
    level.objects.append({1, "ball", ball, {}});
    level.objects.append({2, "wall", BodyObject{.shapes = {Circle{{0, 0}, 0.5}}, .position = {0, -4}}, {}});
    return level;
}

struct SandboxSession : TestWindow {
    SandboxSession() {
        document().reset(driftingBall());
        before = levelText(level());
        trigger(Act::Simulate);
    }
    LiveRun& run() { return window->liveRun(); }
    RunChanges& changes() { return window->openLevel()->runChanges; }
    /// In the inspector, of what is selected.
    NumberField& type(const char* id, const QString& text) {
        NumberField& field = *qobject_cast<NumberField*>(window->inspector().form().editor(id));
        field.setFocus();
        field.selectAll();
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
        return field;
    }
    const BodyObject& body(Key key) { return std::get<BodyObject>(level().objects.find(key)->data); }
    /// As it is now in the run; none while it is not there.
    std::optional<BodyPicture> running(Key key) {
        const BodyPicture* const found =
            run().frame()->now->find([key](const BodyPicture& one) { return one.look->key == key; });
        return found != nullptr ? std::optional(*found) : std::nullopt;
    }
    void press(const QString& words) {
        for (QPushButton* each : window->runChangesPanel().findChildren<QPushButton*>()) {
            if (each->text().remove(QLatin1Char('&')) == words) {
                each->click();
            }
        }
    }

    std::string before;
};

} // namespace

class SandboxSessionTest : public QObject {
    Q_OBJECT

  private slots:
    void ofThreeChangesTwoAreKeptAndOneOfThemIsUndone() {
        SandboxSession test;
        QTRY_VERIFY(test.run().updates() > 5);
        test.trigger(Act::Pause);
        QTRY_VERIFY(test.run().frame()->paused);
        test.run().seek(2); // back to where the ball was then
        QTRY_COMPARE(test.run().updates(), std::int64_t(2));
        QVERIFY(test.running(1)->pose.position.x() < 0.01);
        test.document().select(Selection({1}));
        test.type("friction", "0.9");
        test.document().select(Selection({2}));
        test.canvas().setFocus();
        test.key(Qt::Key_Up); // nudges the wall
        const double nudged = test.body(2).position.y();
        QVERIFY(nudged > -4);
        QTRY_COMPARE(test.running(2)->pose.position.y(), nudged); // seen while it is held
        test.document().select({});
        test.type("gravity.y", "-5");
        test.trigger(Act::Pause); // goes on from there
        QTRY_VERIFY(test.run().updates() > 2);
        QTRY_VERIFY(test.running(1)->velocity.y() < -0.1);
        const std::string ran = levelText(test.level());
        test.trigger(Act::Stop);
        QVERIFY(levelText(test.level()) == test.before);
        QCOMPARE(test.changes().changes().size(), std::size_t(3));
        QVERIFY(test.window->runChangesPanel().isVisible());
        test.changes().setTicked(1, false); // the friction; the level comes first
        test.press("Keep Ticked");
        QCOMPARE(test.level().gravity.y(), -5.0);
        QCOMPARE(test.body(2).position.y(), nudged);
        QCOMPARE(test.body(1).friction, 0.3);
        test.trigger(Act::Undo);
        QCOMPARE(test.level().gravity.y(), -5.0);
        QCOMPARE(test.body(2).position.y(), -4.0);
        test.trigger(Act::Undo);
        QVERIFY(levelText(test.level()) == test.before);
        test.trigger(Act::Undo); // all that was changed in the run
        QVERIFY(levelText(test.level()) == ran);
    }

    void whatIsDrawnWhileItRunsIsInTheRunAndGoneWhenDiscarded() {
        SandboxSession test;
        test.trigger(ToolId::Circle);
        test.drag(3, 0, 3.5, 0);
        QCOMPARE(test.level().objects.size(), 3);
        const Key drawn = test.level().objects[2].key;
        QTRY_VERIFY(test.running(drawn).has_value());
        test.trigger(Act::Undo);
        QTRY_VERIFY(!test.running(drawn).has_value());
        test.trigger(Act::Redo);
        QTRY_VERIFY(test.running(drawn).has_value());
        test.trigger(Act::Stop);
        test.press("Discard All");
        QVERIFY(levelText(test.level()) == test.before);
        QVERIFY(!test.window->isWindowModified());
    }

    void aMassOfZeroIsRefusedWithASentenceAndTheRunGoesOn() {
        SandboxSession test;
        test.document().select(Selection({1}));
        const NumberField& field = test.type("mass", "0");
        QVERIFY(!field.fault().isEmpty());
        QVERIFY(levelText(test.level()) == test.before);
        const std::int64_t then = test.run().updates();
        QTRY_VERIFY(test.run().updates() > then + 2);
        test.trigger(Act::Stop);
        QVERIFY(!test.changes().areWaiting());
        QCOMPARE(test.document().historySize(), 0);
    }

    void aShipThatStartsAtThePointerIsNoChangeOfTheLevel() {
        TestWindow test;
        Level level = driftingBall();
        level.objects.append({3, "ship", ShipObject{}, {}});
        test.document().reset(level);
        QTest::mouseMove(&test.canvas(), test.at(2, 1));
        test.trigger(Act::PlayFromHere);
        QVERIFY(test.window->isInGame());
        test.trigger(Act::Stop);
        QVERIFY(test.level() == level);
        QVERIFY(!test.window->openLevel()->runChanges.areWaiting());
    }
};

SPACETOW_TEST(SandboxSessionTest)
#include "sandbox_session_test.moc"
