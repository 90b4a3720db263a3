#include "editor/editing/selection.h"

#include "core/base/random.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <set>

using namespace spacetow;
using namespace spacetow::test;

class SelectionTest : public QObject {
    Q_OBJECT

  private slots:
    void keysComeOutAscendingAndOnce();
    void itBehavesLikeASet();
    void keysThatTheLevelDoesNotHaveAreLeftOut();
    void nodesBringTheirObjectsAlongAndGoWithThem();
    void nodesThatTheLevelDoesNotHaveAreLeftOut();
    void thePivotGoesWithWhatWasSelected();
    void aGroupThatIsGoneIsLeft();
};

void SelectionTest::keysComeOutAscendingAndOnce() {
    QCOMPARE(Selection({7, 3, 7, 1, 3}).keys(), (std::vector<Key>{1, 3, 7}));
}

void SelectionTest::itBehavesLikeASet() {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        Random random(seed);
        Selection selection;
        std::set<Key> model;
        for (int i = 0; i < 100; ++i) {
            const Key key = 1 + random.below(12);
            switch (random.below(3)) {
            case 0:
                selection = selection.with(key);
                model.insert(key);
                break;
            case 1:
                selection = selection.without(key);
                model.erase(key);
                break;
            default:
                selection = selection.toggled(key);
                if (!model.insert(key).second) {
                    model.erase(key);
                }
            }
            QVERIFY2(selection.keys() == std::vector<Key>(model.begin(), model.end()),
                     qPrintable(QString::number(seed)));
            QCOMPARE(selection.contains(5), model.contains(5));
        }
    }
}

void SelectionTest::keysThatTheLevelDoesNotHaveAreLeftOut() {
    Level level;
    level.objects.append(bodyWith(9, Circle{}));
    level.objects.append(bodyWith(4, Circle{}));
    QCOMPARE(Selection({2, 4, 9, 11}).within(level), Selection({4, 9}));
    QCOMPARE(Selection().within(level), Selection());
}

void SelectionTest::nodesBringTheirObjectsAlongAndGoWithThem() {
    const NodeRef first{4, 0, 1};
    const NodeRef second{9, 0, 0};
    const Selection selection({7}, {second, first, second});
    QCOMPARE(selection.keys(), (std::vector<Key>{4, 7, 9}));
    QCOMPARE(selection.nodes().size(), std::size_t{2});
    QVERIFY(selection.contains(first) && !selection.contains(NodeRef{4, 0, 0}));
    const Selection rest = selection.without(4);
    QVERIFY(!rest.contains(first) && rest.contains(second));
    QVERIFY(!rest.toggled(second).contains(second));
    QVERIFY(rest.toggled(NodeRef{9, 0, 3}).contains(NodeRef{9, 0, 3}));
}

void SelectionTest::nodesThatTheLevelDoesNotHaveAreLeftOut() {
    Level level;
    level.objects.append(bodyWith(4, LineChain{{{0, 0}, {1, 0}}, false}));
    level.objects.append(bodyWith(9, Circle{}));
    const Selection selection({9}, {{4, 0, 1}, {4, 0, 2}, {4, 1, 0}, {9, 0, 0}, {5, 0, 0}});
    QCOMPARE(selection.within(level).nodes(), (std::vector<NodeRef>{{4, 0, 1}}));
    QCOMPARE(selection.within(level).keys(), (std::vector<Key>{4, 9}));
}

void SelectionTest::thePivotGoesWithWhatWasSelected() {
    Level level;
    level.objects.append(bodyWith(4, Circle{}));
    const Selection selection = Selection({4, 5}).withPivot(Vec2(1, 2));
    QVERIFY(!selection.with(6).pivot() && !selection.without(4).pivot());
    QVERIFY(!selection.within(level).pivot());
    QVERIFY(Selection({4}).withPivot(Vec2(1, 2)).within(level).pivot() == Vec2(1, 2));
}

void SelectionTest::aGroupThatIsGoneIsLeft() {
    Level level;
    level.objects.append({4, "", GroupObject{}, {}});
    level.objects.append(bodyWith(5, Circle{}));
    QCOMPARE(Selection({5}).entering(4).within(level).entered(), Key{4});
    QCOMPARE(Selection({5}).entering(5).within(level).entered(), Key{0});
    QCOMPARE(Selection().entering(4).within(Level()).entered(), Key{0});
}

SPACETOW_TEST(SelectionTest)
#include "selection_test.moc"
