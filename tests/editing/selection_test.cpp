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

SPACETOW_TEST(SelectionTest)
#include "selection_test.moc"
