#include "editor/panels/transform_bar.h"

#include "core/level/arrange.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <QCheckBox>
#include <QTest>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level wall() {
    Level level;
    level.objects.append(bodyWith(1, LineChain{{{0, 0}, {2, 0}, {2, 1}}, false}, {1, 1}));
    return level;
}

struct Typing : Drive {
    Typing() : Drive(wall()), bar(document, toolbox) {
        document.select(Selection({1}));
        bar.begin();
    }
    NumberField& field(int index) { return *bar.findChildren<NumberField*>().at(index); }
    Aabb box() { return placedBounds(level(), document.selection().keys()); }
    TransformBar bar;
};

} // namespace

class TransformBarTest : public QObject {
    Q_OBJECT

  private slots:
    void placeAndSizeAreShownAndTyped() {
        Typing typing;
        QCOMPARE(typing.field(0).value(), std::optional(1.0));
        QCOMPARE(typing.field(2).value(), std::optional(2.0));
        QCOMPARE(typing.field(3).value(), std::optional(1.0));
        typing.field(0).entered(5);
        typing.field(2).entered(3);
        QVERIFY(typing.box().min == Vec2(5, 1) && typing.box().max == Vec2(8, 2));
        QCOMPARE(typing.document.history(), (std::vector<Label>{{"move", 1}, {"scale", 1}}));
        typing.document.undo();
        QCOMPARE(typing.field(2).value(), std::optional(2.0));
    }

    void relativeMovesByMetresAndScalesByPercent() {
        Typing typing;
        typing.bar.findChild<QCheckBox*>()->setChecked(true);
        QCOMPARE(typing.field(2).value(), std::optional(100.0));
        typing.field(1).entered(2);
        typing.field(3).entered(200);
        QVERIFY(typing.box().min == Vec2(1, 3) && typing.box().max == Vec2(3, 5));
        QCOMPARE(typing.field(3).value(), std::optional(100.0));
    }

    void turningIsByAnAngle() {
        Typing typing;
        typing.field(4).entered(90);
        QVERIFY((typing.box().size() - Vec2(1, 2)).norm() < 1e-9);
        QCOMPARE(typing.document.undoLabel(), (Label{"rotate", 1}));
    }

    void withNothingSelectedNothingCanBeTyped() {
        Typing typing;
        typing.document.select({});
        QVERIFY(!typing.field(0).isEnabled());
        typing.field(0).entered(5);
        QVERIFY(typing.document.history().empty());
    }
};

SPACETOW_TEST(TransformBarTest)
#include "transform_bar_test.moc"
