#include "editor/panels/inspector.h"

#include "core/level/edits.h"
#include "tests/support/inspector_fixture.h"
#include "tests/support/test_main.h"

#include <QComboBox>
#include <QLineEdit>

using namespace spacetow;
using namespace spacetow::test;

class InspectorTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsEnteredGoesToAllSelectedObjects() {
        InspectorFixture test({circleObject(1, 0, 0.5), circleObject(2, 3, 0.7), circleObject(3, 5, 0.9)}, {1, 2});
        QCOMPARE(test.number("radius").placeholderText(), QString("mixed"));
        QVERIFY(test.number("radius").text().isEmpty());
        test.type("radius", "0,25");
        QCOMPARE(std::get<Circle>(test.body(0).shapes[0]).radius, 0.25);
        QCOMPARE(std::get<Circle>(test.body(1).shapes[0]).radius, 0.25);
        QCOMPARE(std::get<Circle>(test.body(2).shapes[0]).radius, 0.9);
        QCOMPARE(test.document.position(), 1);
        test.document.undo();
        QCOMPARE(std::get<Circle>(test.body(1).shapes[0]).radius, 0.7);
        QVERIFY(test.number("radius").text().isEmpty());
    }

    void aRectangleHasAWidthAndAHeight() {
        BodyObject box;
        box.shapes = {Polygon{{Vec2(-1.5, -0.5), Vec2(1.5, -0.5), Vec2(1.5, 0.5), Vec2(-1.5, 0.5)}}};
        InspectorFixture test({{1, {}, box, {}}, circleObject(2, 3, 0.5)}, {1});
        QCOMPARE(test.number("width").value(), std::optional(3.0));
        QCOMPARE(test.number("height").value(), std::optional(1.0));
        test.type("width", "6");
        QCOMPARE(std::get<Polygon>(test.body(0).shapes[0]).vertices[2], Vec2(3, 0.5));
        QCOMPARE(test.body(0).position, Vec2(0, 0));
        QCOMPARE(test.document.undoLabel(), (Label{"change", 1, "width"}));
        test.type("height", "0");
        QCOMPARE(test.document.position(), 1);
        test.document.select(Selection({2}));
        QVERIFY(!test.isSeen("width") && !test.isSeen("height"));
    }

    void theHistorySaysWhichFieldWasChanged() {
        InspectorFixture test({circleObject(1, 0, 0.5), circleObject(2, 3, 0.5)}, {1});
        test.type("angle", "45");
        QCOMPARE(test.document.undoLabel(), (Label{"change", 1, "angle"}));
        test.document.select(Selection({1, 2}));
        test.type("density", "2");
        QCOMPARE(test.document.undoLabel(), (Label{"change", 2, "density"}));
        test.document.select({});
        test.type("gravity.y", "-1");
        QCOMPARE(test.document.undoLabel(), (Label{"change-level", 1, "gravity.y"}));
        test.inspector.form().resetButton("gravity.y")->click();
        QCOMPARE(test.document.undoLabel(), (Label{"change-level", 1, "gravity"}));
    }

    void aNumberOutsideItsRangeChangesNothing_data() {
        QTest::addColumn<QByteArray>("id");
        QTest::addColumn<QString>("text");
        QTest::newRow("no density") << QByteArray("density") << "0";
        QTest::newRow("negative density") << QByteArray("density") << "-1";
        QTest::newRow("restitution above one") << QByteArray("restitution") << "1.01";
        QTest::newRow("negative damping") << QByteArray("linearDamping") << "-0.1";
        QTest::newRow("words") << QByteArray("friction") << "rough";
        QTest::newRow("required") << QByteArray("friction") << "";
        QTest::newRow("far away") << QByteArray("position.x") << "1e7";
    }
    void aNumberOutsideItsRangeChangesNothing() {
        QFETCH(QByteArray, id);
        QFETCH(QString, text);
        InspectorFixture test({circleObject(1, 0, 0.5)}, {1});
        const Level before = test.document.level();
        test.type(id.constData(), text);
        QVERIFY(test.document.level() == before);
        QVERIFY(!test.document.canUndo());
    }

    void lookingAtANumberDoesNotRoundIt() {
        const double third = 1.0 / 3;
        InspectorFixture test({circleObject(1, third, 0.5)}, {1});
        NumberField& field = test.number("position.x");
        field.setFocus();
        QTest::keyClick(&field, Qt::Key_End);
        QTest::keyClick(&field, Qt::Key_Return);
        field.clearFocus();
        QCOMPARE(test.body(0).position.x(), third);
        QVERIFY(!test.document.canUndo());
    }

    void arrowKeysStepAndMakeOneEntry() {
        InspectorFixture test({circleObject(1, 0, 0.5)}, {1});
        NumberField& field = test.number("density");
        field.setFocus();
        for (int i = 0; i < 5; ++i) {
            QTest::keyClick(&field, Qt::Key_Up);
        }
        QCOMPARE(test.body(0).density, 1.5);
        QCOMPARE(test.document.position(), 1);
        QTest::keyClick(&field, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(test.body(0).density, 0.5);
    }

    void anglesAreShownInDegrees() {
        InspectorFixture test({circleObject(1, 0, 0.5)}, {1});
        test.type("angle", "90");
        QVERIFY(std::abs(test.body(0).angle - 1.5707963267948966) < 1e-12);
        QCOMPARE(test.number("angle").value(), std::optional(90.0));
    }

    void anEmptyDepthMeansNoBack() {
        InspectorFixture test({wallObject(1, 0.5)}, {1});
        QCOMPARE(test.number("depth").value().value_or(0), 0.5);
        test.type("depth", "");
        QCOMPARE(std::get<EdgeChain>(test.body(0).shapes[0]).depth, noBack);
        QVERIFY(test.number("depth").text().isEmpty());
        test.type("depth", "0.2");
        QCOMPARE(std::get<EdgeChain>(test.body(0).shapes[0]).depth, 0.2);
    }

    void anEmptyMassComesFromTheShapes() {
        InspectorFixture test({circleObject(1, 0, 0.5)}, {1});
        QVERIFY(!test.body(0).mass);
        test.type("mass", "2");
        QCOMPARE(test.body(0).mass.value_or(0), 2.0);
        test.type("mass", "");
        QVERIFY(!test.body(0).mass);
    }

    void shapesOfOneBodyThatDifferAreMixedAndKeptUntilTypedOver() {
        InspectorFixture test({twoCircles(1, 0.2, 0.5)}, {1});
        QVERIFY(test.number("radius").isMixed());
        QVERIFY(test.number("radius").text().isEmpty());
        test.type("density", "3");
        test.number("radius").setFocus();
        test.number("density").setFocus();
        QCOMPARE(test.radius(0, 0), 0.2);
        QCOMPARE(test.radius(0, 1), 0.5);
        test.type("radius", "*=2");
        QCOMPARE(test.radius(0, 0), 0.4);
        QCOMPARE(test.radius(0, 1), 1.0);
        test.type("radius", "0.25");
        QCOMPARE(test.radius(0, 0), 0.25);
        QCOMPARE(test.radius(0, 1), 0.25);
        QVERIFY(!test.number("radius").isMixed());
    }

    void oneShapeOfABodyIsChosen() {
        InspectorFixture test({twoCircles(1, 0.2, 0.5), circleObject(2, 5, 0.7)}, {1});
        QComboBox& box = test.inspector.shapeBox();
        QVERIFY(box.isVisible());
        QCOMPARE(box.count(), 3);
        box.setCurrentIndex(2);
        Q_EMIT box.activated(2);
        QCOMPARE(test.number("radius").value(), std::optional(0.5));
        test.type("radius", "0.75");
        QCOMPARE(test.radius(0, 0), 0.2);
        QCOMPARE(test.radius(0, 1), 0.75);
        test.document.select(Selection({1, 2}));
        QVERIFY(!box.isVisible());
        QVERIFY(test.number("radius").isMixed());
        test.document.select(Selection({2}));
        QVERIFY(!box.isVisible());
    }

    void selectedNodesSayWhichShapeIsMeant() {
        BodyObject body;
        body.shapes = {EdgeChain{{Vec2(0, 0), Vec2(1, 0)}, false, 0.25},
                       EdgeChain{{Vec2(0, 2), Vec2(1, 2)}, false, 0.5}};
        InspectorFixture test({{1, {}, body, {}}}, {1});
        QVERIFY(test.number("depth").isMixed());
        test.document.select(Selection({1}, {{1, 1, 0}}));
        QCOMPARE(test.number("depth").value(), std::optional(0.5));
        test.type("depth", "1");
        QCOMPARE(std::get<EdgeChain>(test.body(0).shapes[0]).depth, 0.25);
        QCOMPARE(std::get<EdgeChain>(test.body(0).shapes[1]).depth, 1.0);
        QVERIFY(!test.inspector.shapeBox().isVisible());
    }

    void everythingThatHasAFieldShowsIt() {
        InspectorFixture test({circleObject(1, 0, 0.5), wallObject(2, noBack), {3, {}, ShipObject{}, {}}}, {1});
        QVERIFY(test.isSeen("radius") && !test.isSeen("depth") && test.isSeen("kind"));
        test.document.select(Selection({2}));
        QVERIFY(!test.isSeen("radius") && test.isSeen("depth") && test.isSeen("closed"));
        test.document.select(Selection({3}));
        QVERIFY(test.isSeen("position.x") && test.isSeen("angle") && !test.isSeen("kind") && !test.isSeen("density"));
        test.document.select(Selection({1, 2, 3}));
        QVERIFY(test.isSeen("radius") && test.isSeen("depth") && test.isSeen("density"));
        test.type("density", "4");
        test.type("radius", "0.75");
        QCOMPARE(test.body(0).density, 4.0);
        QCOMPARE(test.body(1).density, 4.0);
        QCOMPARE(test.radius(0, 0), 0.75);
        QVERIFY(std::get<ShipObject>(test.document.level().objects[2].data) == ShipObject{});
    }

    void switchesAreSetForAll() {
        InspectorFixture test({circleObject(1, 0, 0.5), circleObject(2, 1, 0.5)}, {1});
        test.box("frozen").click();
        test.document.select(Selection({1, 2}));
        QCOMPARE(test.box("frozen").checkState(), Qt::PartiallyChecked);
        QCOMPARE(test.box("tangible").checkState(), Qt::Checked);
        QTest::mouseClick(&test.box("frozen"), Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(test.body(0).frozen && test.body(1).frozen);
        QCOMPARE(test.box("frozen").checkState(), Qt::Checked);
        QTest::mouseClick(&test.box("frozen"), Qt::LeftButton, {}, QPoint(8, 8));
        QVERIFY(!test.body(0).frozen && !test.body(1).frozen);
    }

    void aChoiceIsMadeForAllByKey() {
        InspectorFixture test({circleObject(1, 0, 0.5), circleObject(2, 1, 0.5)}, {1, 2});
        auto* kind = qobject_cast<QComboBox*>(test.inspector.form().editor("kind"));
        kind->setFocus();
        QTest::keyClick(kind, Qt::Key_Down);
        QVERIFY(test.body(0).kind == BodyKind::Kinematic && test.body(1).kind == BodyKind::Kinematic);
        QTest::keyClick(kind, Qt::Key_Down);
        QVERIFY(test.body(0).kind == BodyKind::Dynamic && test.body(1).kind == BodyKind::Dynamic);
        test.document.select(Selection({1}));
        QTest::keyClick(kind, Qt::Key_Up);
        test.document.select(Selection({1, 2}));
        QCOMPARE(kind->currentIndex(), -1);
    }

    void gesturesShowTheirNumbersLive() {
        InspectorFixture test({circleObject(1, 0, 0.5)}, {1});
        const std::vector<Key> keys{1};
        test.document.preview(
            {std::make_shared<Level>(moved(test.document.level(), keys, Vec2(2.5, 0))), test.document.selection()});
        QCOMPARE(test.number("position.x").value().value_or(0), 2.5);
        test.document.dropPreview();
        QCOMPARE(test.number("position.x").value().value_or(1), 0.0);
    }

    void theLevelIsEditedWhenNothingIsSelected() {
        InspectorFixture test({circleObject(1, 0, 0.5)}, {});
        test.type("gravity.y", "-3.5");
        QCOMPARE(test.document.level().gravity.y(), -3.5);
        test.type("lives", "5");
        QCOMPARE(test.document.level().rules.lives, 5);
        test.type("lives", "2.5");
        QCOMPARE(test.document.level().rules.lives, 5);
        auto* name = qobject_cast<QLineEdit*>(test.inspector.form().editor("name"));
        name->setFocus();
        name->selectAll();
        QTest::keyClicks(name, "Depths");
        QTest::keyClick(name, Qt::Key_Return);
        QCOMPARE(test.document.level().name, std::string("Depths"));
    }
};

SPACETOW_TEST(InspectorTest)
#include "inspector_test.moc"
