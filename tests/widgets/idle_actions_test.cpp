// What would do nothing rests and says why, or has nothing to do and says so.
#include "editor/window/actions.h"

#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <algorithm>

using namespace spacetow;
using spacetow::test::TestWindow;

namespace {

constexpr Key ship = 1, payload = 2, finish = 3, box = 4, wall = 5, locked = 6, rope = 7;

Object oneOfAKind(Key key, ObjectData data) {
    return {key, "", std::move(data), {}};
}

/// One of each kind.
Level everyKind() {
    Level level;
    level.objects.append(oneOfAKind(ship, ShipObject{{-3, 0}, 0}));
    level.objects.append(oneOfAKind(payload, PayloadObject{{-2, 0}}));
    level.objects.append(oneOfAKind(finish, FinishObject{{2, 2}, {3, 2}}));
    level.objects.append(oneOfAKind(box, BodyObject{.shapes = {Polygon{{{0, 0}, {1, 0}, {1, 1}}}}}));
    level.objects.append(oneOfAKind(wall, BodyObject{.shapes = {EdgeChain{{{0, -2}, {2, -2}}, false, noBack}}}));
    level.objects.append(oneOfAKind(locked, BodyObject{.shapes = {Circle{{0, 3}, 0.5}}}));
    ConnectorObject connector;
    connector.a = box;
    connector.b = wall;
    level.objects.append(oneOfAKind(rope, connector));
    Object held = level.objects[5];
    held.locked = true;
    level.objects.replace(5, held);
    return level;
}

struct IdleWindow : TestWindow {
    IdleWindow() { document().reset(everyKind()); }

    void select(std::vector<Key> keys) { document().select(Selection(std::move(keys))); }
    const QAction& action(ActionId id) { return window->actions()[id]; }
    /// The action rests, and its tip says this.
    bool restsFor(ActionId id, const QString& why) {
        return !action(id).isEnabled() && action(id).statusTip().endsWith(why);
    }
};

} // namespace

class IdleActionsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatALevelHasOneOfIsNotDuplicated() {
        IdleWindow test;
        const QString why = "Ship, payload and finish exist once, and connectors are copied with their two bodies.";
        for (const Act act : {Act::Duplicate, Act::DuplicateInPlace, Act::LinearArray, Act::RadialArray}) {
            for (const std::vector<Key>& alone :
                 {std::vector<Key>{ship}, {payload}, {finish}, {rope}, {ship, payload}}) {
                test.select(alone);
                QVERIFY2(test.restsFor(act, why), qPrintable(test.action(act).text()));
            }
            test.select({ship, box});
            QVERIFY2(test.action(act).isEnabled(), qPrintable(test.action(act).text()));
        }
        test.select({ship});
        QVERIFY(test.action(Act::Copy).isEnabled() && test.action(Act::Cut).isEnabled()); // for another level
    }

    void onlyWhatHasADirectionIsReversed() {
        IdleWindow test;
        for (const Key key : {ship, payload, finish, box}) {
            test.select({key});
            QVERIFY(test.restsFor(Act::Reverse, "Select a wall or a line first."));
        }
        test.select({ship, wall}); // as many as before
        QVERIFY(test.action(Act::Reverse).isEnabled());
    }

    void onlyGroupsAreUngroupedAndTheirMembersCount() {
        IdleWindow test;
        test.select({wall, ship});
        QVERIFY(test.restsFor(Act::Ungroup, "Select a group first."));
        test.trigger(Act::Group);
        QCOMPARE(test.document().selection().size(), 1);
        QVERIFY(test.action(Act::Ungroup).isEnabled());
        QVERIFY(test.action(Act::Reverse).isEnabled() && test.action(Act::Duplicate).isEnabled());
        test.trigger(Act::Ungroup);
        QVERIFY(!test.action(Act::Ungroup).isEnabled());
    }

    void onlyWhatHasNodesGetsMore() {
        IdleWindow test;
        test.select({ship});
        QVERIFY(test.restsFor(Act::InsertMidpoints, "What is selected has no nodes."));
        test.select({box});
        QVERIFY(test.action(Act::InsertMidpoints).isEnabled());
    }

    void whatIsLockedIsNeitherRemovedNorTurned() {
        IdleWindow test;
        const QString why = "What is selected is locked.";
        for (const Act act : {Act::Cut, Act::Delete, Act::RotateLeft, Act::FlipHorizontally, Act::Reverse}) {
            test.select({locked});
            QVERIFY2(test.restsFor(act, why), qPrintable(test.action(act).text()));
            test.select({wall});
            QVERIFY2(test.action(act).isEnabled(), qPrintable(test.action(act).text()));
        }
    }

    void theHintSaysThatWhatIsSelectedIsLocked() {
        IdleWindow test;
        const auto hint = [&test] { return test.window->statusLine().hint(); };
        QTest::mouseMove(&test.canvas(), test.at(-1, -3)); // where nothing is
        test.select({box});
        QVERIFY(!hint().contains("locked"));
        test.select({locked});
        QVERIFY2(hint().contains("1 selected · locked") && hint().contains("Ctrl+Shift+L: unlock all"),
                 qPrintable(hint()));
        test.select({});
        QTest::mouseMove(&test.canvas(), test.at(0, 3));
        QVERIFY2(hint().startsWith("Locked") && hint().contains("Ctrl+Shift+L: unlock all"), qPrintable(hint()));
        test.trigger(Act::UnlockAll);
        QVERIFY2(hint().startsWith("Click: select"), qPrintable(hint()));
    }

    void whatTheLevelChangesToDecides() {
        IdleWindow test;
        test.select({locked});
        QVERIFY(!test.action(Act::Delete).isEnabled());
        test.trigger(Act::UnlockAll);
        QVERIFY(test.action(Act::Delete).isEnabled());
    }

    void pastingASecondShipSaysThatThereIsOne() {
        IdleWindow test;
        test.select({ship});
        test.trigger(Act::Copy);
        test.trigger(Act::Paste);
        QCOMPARE(test.window->messageBar().text(),
                 QString("A level has one ship, one payload and one finish, and this one has them already."));
        test.select({rope});
        test.trigger(Act::Copy);
        test.trigger(Act::Paste);
        QCOMPARE(test.window->messageBar().text(),
                 QString("A connector is pasted together with the two bodies that it joins."));
    }

    void anActionThatChangesNothingSaysSo() {
        IdleWindow test;
        test.select({box});
        test.trigger(Act::ToFront);
        QVERIFY(test.window->statusLine().currentMessage().isEmpty());
        const int position = test.document().position();
        test.trigger(Act::ToFront);
        QCOMPARE(test.document().position(), position);
        QCOMPARE(test.window->statusLine().currentMessage(), QString("“To Front” changes nothing here."));
    }
};

SPACETOW_TEST(IdleActionsTest)
#include "idle_actions_test.moc"
