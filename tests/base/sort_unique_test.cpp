#include "core/base/sort_unique.h"

#include "tests/support/test_main.h"

using namespace spacetow;

class SortUniqueTest : public QObject {
    Q_OBJECT

  private slots:
    void eachElementRemainsOnceAndInOrder();
    void elementsBeforeTheFirstStayAsTheyAre();
};

void SortUniqueTest::eachElementRemainsOnceAndInOrder() {
    std::vector<int> list{3, 1, 3, 2, 1};
    sortUnique(list);
    QVERIFY((list == std::vector<int>{1, 2, 3}));
    list.clear();
    sortUnique(list);
    QVERIFY(list.empty());
}

void SortUniqueTest::elementsBeforeTheFirstStayAsTheyAre() {
    std::vector<int> list{9, 1, 3, 1, 3};
    sortUnique(list, 2);
    QVERIFY((list == std::vector<int>{9, 1, 1, 3}));
}

SPACETOW_TEST(SortUniqueTest)
#include "sort_unique_test.moc"
