#include "editor/editing/field_targets.h"

#include "tests/support/test_main.h"

using namespace spacetow;

class FieldTargetsTest : public QObject {
    Q_OBJECT

  private slots:
    void nodesSayWhichShapesAreMeantOnce() {
        const Selection selection({1, 2, 3}, {{1, 0, 0}, {1, 0, 4}, {1, 2, 1}, {3, 1, 0}});
        const std::vector<ShapeRef> shapes = shapesOf(selection);
        QVERIFY(shapes == (std::vector<ShapeRef>{{1, 0}, {1, 2}, {3, 1}}));
        QCOMPARE(shapesOf(shapes, 1), (std::vector<int>{0, 2}));
        QCOMPARE(shapesOf(shapes, 2), std::vector<int>());
        QCOMPARE(shapesOf(shapes, 3), std::vector<int>{1});
    }

    void withoutNodesAllShapesAreMeant() { QVERIFY(shapesOf(Selection({1, 2})).empty()); }
};

SPACETOW_TEST(FieldTargetsTest)
#include "field_targets_test.moc"
