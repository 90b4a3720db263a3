#include "editor/editing/outline_verbs.h"

#include "tests/support/drive.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

using OutlineKeys = std::vector<Key>;

/// Balls 1 and 2 in the group 3, a ball 4 beside it, a layer 5 with the ball 6; drawn in the order 3, 1, 2, 4, 5, 6.
Level outlinedLevel() {
    const auto with = [](Object object, Key parent) {
        object.parent = parent;
        return object;
    };
    Level level;
    level.objects.append({3, "pair", GroupObject{}, {}});
    level.objects.append(with(bodyWith(1, Circle{{0, 0}, 0.5}, {0, 0}), 3));
    level.objects.append(with(bodyWith(2, Circle{{0, 0}, 0.5}, {3, 0}), 3));
    level.objects.append(bodyWith(4, Circle{{0, 0}, 0.5}, {6, 1}));
    level.objects.append({5, "front", GroupObject{true, {}}, {}});
    level.objects.append(with(bodyWith(6, Circle{{0, 0}, 0.5}, {9, 1}), 5));
    return level;
}

struct Outline : Drive {
    Outline() : Drive(outlinedLevel()) {}
    template <class Verb, class... Arguments>
    bool run(Verb verb, Arguments... arguments) {
        return toolbox.finish(verb(document.current(), arguments...));
    }
    const Object& at(Key key) const { return *level().objects.find(key); }
    std::string last() const { return std::string(document.undoLabel().code.text()); }
};

} // namespace

class OutlineVerbsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsPutElsewhereIsSelectedWhereItIs() {
        Outline outline;
        QVERIFY(outline.run(regroup, OutlineKeys{4}, ObjectPlace{3, 0}));
        QCOMPARE(outline.at(4).parent, Key{3});
        QCOMPARE(outline.document.selection(), Selection({4}).entering(3));
        QCOMPARE(outline.last(), std::string("regroup"));
        QVERIFY(outline.run(regroup, OutlineKeys{4}, ObjectPlace{3, 1}));
        QCOMPARE(outline.last(), std::string("order"));
        outline.document.undo();
        outline.document.undo();
        QCOMPARE(outline.level(), outlinedLevel());
    }

    void aGroupIsNotPutIntoItselfNorALayerIntoAGroup() {
        const Level level = outlinedLevel();
        QVERIFY(!mayRegroup(level, OutlineKeys{3}, 3));
        QVERIFY(!mayRegroup(level, OutlineKeys{5}, 3));
        QVERIFY(!mayRegroup(level, OutlineKeys{1}, 4));
        QVERIFY(!mayRegroup(level, OutlineKeys{1}, 77));
        QVERIFY(mayRegroup(level, OutlineKeys{3}, 5));
        QVERIFY(mayRegroup(level, OutlineKeys{3, 4}, 3));
        QVERIFY(mayRegroup(level, OutlineKeys{5}, 0));
        Outline outline;
        QVERIFY(!outline.run(regroup, OutlineKeys{3}, ObjectPlace{3, 0}));
    }

    void whatIsLockedStaysAndTakesNothingIn() {
        Outline outline;
        QVERIFY(outline.run(lockObjects, OutlineKeys{2}, true));
        QVERIFY(!outline.run(regroup, OutlineKeys{2}, ObjectPlace{0, 0}));
        QVERIFY(!outline.run(regroup, OutlineKeys{3}, ObjectPlace{5, 0}));
        QVERIFY(outline.run(regroup, OutlineKeys{1, 2}, ObjectPlace{0, 0}));
        QCOMPARE(outline.at(2).parent, Key{3});
        QVERIFY(outline.run(lockObjects, OutlineKeys{5}, true));
        QVERIFY(!mayRegroup(outline.level(), OutlineKeys{4}, 5));
    }

    void theGroupOfAllThatIsSelectedIsEntered() {
        const Level level = outlinedLevel();
        QCOMPARE(selectionOf(level, {1, 2}).entered(), Key{3});
        QCOMPARE(selectionOf(level, {1, 4}).entered(), Key{0});
        QCOMPARE(selectionOf(level, {6}).entered(), Key{0}); // a layer is not entered
        QCOMPARE(selectionOf(level, {3}).entered(), Key{0});
    }

    void namesColorsEyesAndLocksAreEntriesOfTheHistory() {
        Outline outline;
        QVERIFY(outline.run(renameObject, Key{4}, std::string("stone")));
        QVERIFY(!outline.run(renameObject, Key{4}, std::string("stone")));
        QCOMPARE(outline.at(4).name, std::string("stone"));
        QVERIFY(outline.run(colorGroup, Key{5}, std::optional<std::uint32_t>(0xff0000)));
        QVERIFY(!outline.run(colorGroup, Key{4}, std::optional<std::uint32_t>(0xff0000)));
        QCOMPARE(std::get<GroupObject>(outline.at(5).data).color, std::optional<std::uint32_t>(0xff0000));
        QVERIFY(outline.run(showObjects, OutlineKeys{1, 4}, false));
        QVERIFY(!outline.at(1).visible && !outline.at(4).visible);
        QVERIFY(outline.run(showObjects, OutlineKeys{1, 4}, true));
        QCOMPARE(outline.last(), std::string("show"));
        QCOMPARE(outline.document.history().size(), std::size_t{4});
    }

    void whatIsHiddenLeavesTheSelection() {
        Outline outline;
        outline.document.select(Selection({4, 6}));
        QVERIFY(outline.run(showObjects, OutlineKeys{5}, false)); // the layer that 6 is in
        QCOMPARE(outline.document.selection(), Selection({4}));
        outline.document.undo();
        QCOMPARE(outline.document.selection(), Selection({4, 6}));
        QVERIFY(outline.run(showObjects, OutlineKeys{3}, false)); // nothing of it is selected
        QCOMPARE(outline.document.selection(), Selection({4, 6}));
        QVERIFY(outline.run(lockObjects, OutlineKeys{4}, true)); // one sees it, and may want to unlock it
        QCOMPARE(outline.document.selection(), Selection({4, 6}));
    }
};

SPACETOW_TEST(OutlineVerbsTest)
#include "outline_verbs_test.moc"
