#include "editor/editing/arrange_verbs.h"

#include "core/level/edits.h"
#include "core/level/groups.h"
#include "core/level/object_geometry.h"
#include "editor/editing/verbs.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <array>
#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

using ArrangedKeys = std::vector<Key>;

/// Balls of radius 0.5: 1 at (0, 0), 2 at (3, 0), 3 at (6, 1).
Level ballsInARow() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.5}, {0, 0}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 0.5}, {3, 0}));
    level.objects.append(bodyWith(3, Circle{{0, 0}, 0.5}, {6, 1}));
    return level;
}

struct ArrangeEditor : Drive {
    explicit ArrangeEditor(ArrangedKeys keys) : Drive(ballsInARow()) { document.select(Selection(std::move(keys))); }
    template <class Verb, class... Arguments>
    bool run(Verb verb, Arguments... arguments) {
        return toolbox.finish(verb(toolbox.context(), arguments...));
    }
    Vec2 placeOf(Key key) const { return *spacetow::placeOf(level().objects.find(key)->data); }
    const ArrangedKeys& keys() const { return document.selection().keys(); }
    std::string last() const { return std::string(document.undoLabel().code.text()); }
};

} // namespace

class ArrangeVerbsTest : public QObject {
    Q_OBJECT

  private slots:
    void withNothingSelectedThereIsNothingToArrange() {
        ArrangeEditor editor({});
        QVERIFY(!editor.run(alignSelected, AlignTo::Left));
        QVERIFY(!editor.run(distributeSelected, Spread::Gaps, true));
        QVERIFY(!editor.run(orderSelected, OrderTo::Front));
        QVERIFY(!editor.run(groupSelected));
        QVERIFY(!editor.run(ungroupSelected));
        QVERIFY(!editor.run(selectedToLayer, 1));
        QVERIFY(!editor.run(hideSelected));
        QVERIFY(!editor.run(lockSelected));
        QVERIFY(!editor.run(isolateSelected));
        QVERIFY(!editor.run(duplicateInPlace));
        QVERIFY(!editor.run(repeatLast));
        QVERIFY(!editor.run(flipSelected, FlipAxis::Vertical));
        QVERIFY(editor.document.history().empty());
    }

    void aligningAndFlippingAreOneEntryEach() {
        ArrangeEditor editor({1, 2, 3});
        QVERIFY(editor.run(alignSelected, AlignTo::Top));
        QVERIFY(editor.placeOf(1) == Vec2(0, 1));
        QCOMPARE(editor.document.undoLabel(), (Label{"align", 3}));
        QVERIFY(editor.run(flipSelected, FlipAxis::Horizontal));
        QVERIFY(editor.placeOf(1) == Vec2(6, 1));
        editor.document.undo();
        editor.document.undo();
        QVERIFY(editor.level() == ballsInARow());
    }

    void aGroupIsSelectedAndComesApartAgain() {
        ArrangeEditor editor({1, 2});
        QVERIFY(editor.run(groupSelected));
        QCOMPARE(editor.keys().size(), std::size_t{1});
        const Key group = editor.keys().front();
        QCOMPARE(editor.level().objects.find(1)->parent, group);
        QVERIFY(editor.run(ungroupSelected));
        QCOMPARE(editor.keys(), (ArrangedKeys{1, 2}));
        QVERIFY(editor.level().objects.find(group) == nullptr);
        QVERIFY(!editor.run(ungroupSelected));
    }

    void aLayerTakesTheSelectionAndGivesItOnToTheNext() {
        ArrangeEditor editor({1});
        QVERIFY(editor.run(newLayer));
        QCOMPARE(editor.keys(), (ArrangedKeys{1})); // a layer itself cannot be selected by a click
        const Key lower = editor.level().objects.find(1)->parent;
        QVERIFY(std::get<GroupObject>(editor.level().objects.find(lower)->data).layer);
        editor.document.select(Selection());
        QVERIFY(editor.run(newLayer));
        const Key upper = editor.newest().key;
        editor.document.select(Selection({1, 2}));
        QVERIFY(editor.run(selectedToLayer, 1));
        QCOMPARE(editor.level().objects.find(1)->parent, upper);
        QCOMPARE(editor.level().objects.find(2)->parent, upper);
        QVERIFY(!editor.run(selectedToLayer, 1));
        QVERIFY(editor.run(selectedToLayer, -1));
        QVERIFY(editor.run(selectedToLayer, -1));
        QCOMPARE(editor.level().objects.find(1)->parent, Key{0});
        QVERIFY(!editor.run(selectedToLayer, -1));
    }

    void whatIsHiddenOrLockedIsNoLongerSelected() {
        ArrangeEditor editor({1});
        QVERIFY(editor.run(hideSelected));
        QVERIFY(editor.keys().empty());
        QVERIFY(!editor.level().objects.find(1)->visible);
        editor.document.select(Selection({2}));
        QVERIFY(editor.run(lockSelected));
        QVERIFY(editor.keys().empty());
        QVERIFY(editor.level().objects.find(2)->locked);
        QVERIFY(editor.run(showAll));
        QVERIFY(editor.run(unlockAll));
        QVERIFY(editor.level() == ballsInARow());
        QVERIFY(!editor.run(showAll));
        QVERIFY(!editor.run(unlockAll));
    }

    void whatIsLockedIsNeitherMovedNorTurnedNorRemoved() {
        ArrangeEditor editor({2});
        editor.document.commit(
            {}, {std::make_shared<const Level>(withLocked(ballsInARow(), ArrangedKeys{2}, true)), Selection({2})});
        const Level before = editor.level();
        editor.run(nudgeSelected, Vec2(1, 0));
        editor.run(rotateSelected, 1.0);
        editor.run(flipSelected, FlipAxis::Horizontal);
        editor.run(reverseSelected);
        editor.run(alignSelected, AlignTo::Left);
        editor.run(removeSelected);
        editor.drag({3, 0}, {4, 0});
        QVERIFY(editor.level() == before);
    }

    void isolatingKeepsTheSelection() {
        ArrangeEditor editor({1});
        QVERIFY(editor.run(isolateSelected));
        QCOMPARE(editor.keys(), (ArrangedKeys{1}));
        QVERIFY(editor.level().objects.find(1)->visible && !editor.level().objects.find(3)->visible);
    }

    void aMoveIsRepeatedOnAnotherSelection() {
        ArrangeEditor editor({1});
        editor.drag({0, 0}, {1, 2});
        QVERIFY(editor.run(repeatLast));
        QVERIFY(editor.placeOf(1) == Vec2(2, 4));
        editor.document.select(Selection({3}));
        QVERIFY(editor.run(repeatLast));
        QVERIFY(editor.placeOf(3) == Vec2(7, 3));
        QCOMPARE(editor.last(), std::string("repeat"));
    }

    void aCopyThatWasMovedAndTurnedIsRepeatedAsOneStep() {
        ArrangeEditor editor({1});
        QVERIFY(editor.run(duplicateInPlace));
        QCOMPARE(editor.level().objects.size(), 4);
        const Key copy = editor.keys().front();
        QVERIFY(editor.placeOf(copy) == Vec2(0, 0));
        editor.drag({0, 0}, {0, 2});
        QVERIFY(editor.run(repeatLast));
        QVERIFY(editor.run(repeatLast));
        QCOMPARE(editor.level().objects.size(), 6);
        QVERIFY(editor.placeOf(editor.newest().key) == Vec2(0, 6));
        QCOMPARE(editor.keys(), (ArrangedKeys{editor.newest().key}));
    }

    void turningIsRepeatedAboutTheSamePivot() {
        ArrangeEditor editor({2});
        editor.document.select(Selection({2}).withPivot(Vec2(0, 0)));
        QVERIFY(editor.run(duplicateInPlace));
        editor.document.select(editor.document.selection().withPivot(Vec2(0, 0)));
        QVERIFY(editor.run(rotateSelected, std::numbers::pi / 2));
        QVERIFY(editor.run(repeatLast));
        QVERIFY((editor.placeOf(editor.newest().key) - Vec2(-3, 0)).norm() < 1e-9);
    }

    void sameKindAndSameTagsAreSelected() {
        ArrangeEditor editor({});
        Level level = ballsInARow();
        level.objects.append({5, "", ShipObject{{-4, 0}, 0}, {}});
        BodyObject tagged = std::get<BodyObject>(level.objects.find(2)->data);
        tagged.filter.tags = TagMask{2};
        Object object = *level.objects.find(2);
        object.data = tagged;
        level = withObject(std::move(level), object);
        editor.document.reset(level);
        editor.document.select(Selection({1}));
        QCOMPARE(sameKind(editor.document.current()).keys(), (ArrangedKeys{1, 2, 3}));
        QCOMPARE(sameTags(editor.document.current()).keys(), (ArrangedKeys{1, 3}));
    }
};

SPACETOW_TEST(ArrangeVerbsTest)
#include "arrange_verbs_test.moc"
