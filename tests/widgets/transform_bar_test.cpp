#include "editor/panels/transform_bar.h"

#include "core/level/arrange.h"
#include "core/level/fields.h"
#include "editor/window/messages.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <QCheckBox>
#include <QTest>

#include <cmath>
#include <numbers>

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
    void type(int index, const QString& text) {
        field(index).selectAll();
        QTest::keyClicks(&field(index), text);
        QTest::keyClick(&field(index), Qt::Key_Return);
    }
    QString fault() { return bar.findChild<FaultLabel*>()->text(); }
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
        typing.type(0, "5");
        typing.type(2, "3");
        QVERIFY(typing.box().min == Vec2(5, 1) && typing.box().max == Vec2(8, 2));
        QCOMPARE(typing.document.history(), (std::vector<Label>{{"move", 1}, {"scale", 1}}));
        typing.document.undo();
        QCOMPARE(typing.field(2).value(), std::optional(2.0));
    }

    void theSizeOfABodyThatIsTurnedIsThatOfItsSides() {
        Typing typing;
        Level level;
        Object board = bodyWith(1, Polygon{{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}}}, {3, 1});
        std::get<BodyObject>(board.data).angle = std::numbers::pi / 6;
        level.objects.append(board);
        typing.document.reset(level);
        typing.document.select(Selection({1}));
        const auto body = [&] { return std::get<BodyObject>(typing.level().objects[0].data); };
        QVERIFY(std::abs(*typing.field(2).value() - 2) < 1e-9);
        QVERIFY(std::abs(*typing.field(3).value() - 1) < 1e-9);
        typing.type(2, "3");
        QVERIFY(std::abs(*typing.field(2).value() - 3) < 1e-9);
        QVERIFY(std::abs(*typing.field(3).value() - 1) < 1e-9);
        QCOMPARE(body().angle, std::numbers::pi / 6);
        typing.type(0, "5"); // the place stays that of the bounds
        QVERIFY(std::abs(typing.box().min.x() - 5) < 1e-9);
        QCOMPARE(body().angle, std::numbers::pi / 6);
    }

    void relativeMovesByMetresAndScalesByPercent() {
        Typing typing;
        typing.bar.findChild<QCheckBox*>()->setChecked(true);
        QCOMPARE(typing.field(2).value(), std::optional(100.0));
        typing.type(1, "2");
        typing.type(3, "200");
        QVERIFY(typing.box().min == Vec2(1, 3) && typing.box().max == Vec2(3, 5));
        QCOMPARE(typing.field(3).value(), std::optional(100.0));
    }

    void turningIsByAnAngle() {
        Typing typing;
        typing.type(4, "90");
        QVERIFY((typing.box().size() - Vec2(1, 2)).norm() < 1e-9);
        QCOMPARE(typing.document.undoLabel(), (Label{"rotate", 1}));
    }

    void withNothingSelectedNothingCanBeTyped() {
        Typing typing;
        typing.document.select({});
        QVERIFY(!typing.field(0).isEnabled());
        typing.field(0).enter({NumberChange{NumberChange::Kind::Set, 5}});
        QVERIFY(typing.document.history().empty());
    }

    void expressionsAndUnitsAreTakenWithCommaAndPoint() {
        Typing typing;
        typing.type(0, "+=0,5");
        QCOMPARE(typing.box().min.x(), 1.5);
        typing.type(2, "*=2");
        QCOMPARE(typing.box().size().x(), 4.0);
        typing.type(1, "20 cm + 1/2");
        QCOMPARE(typing.box().min.y(), 0.7);
        typing.type(4, "pi/2 rad");
        QVERIFY((typing.box().size() - Vec2(1, 4)).norm() < 1e-9);
        QCOMPARE(typing.document.history().size(), std::size_t(4));
    }

    void whatIsNoExpressionIsKeptAndSaysWhyBeneath_data() {
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("text");
        QTest::newRow("word") << 0 << "2*foo";
        QTest::newRow("wrong unit") << 0 << "3 kg";
        QTest::newRow("off the map") << 1 << "1e9";
        QTest::newRow("its other end off the map") << 0 << QString::number(limits::coordinate);
        QTest::newRow("no width") << 2 << "0";
        QTest::newRow("wider than the map") << 2 << "1e12";
    }
    void whatIsNoExpressionIsKeptAndSaysWhyBeneath() {
        QFETCH(int, index);
        QFETCH(QString, text);
        Typing typing;
        typing.bar.setWords([](const Error& error) { return sentence(error); });
        typing.type(index, text);
        QCOMPARE(typing.field(index).text(), text);
        QVERIFY(typing.fault().endsWith('.'));
        QVERIFY(!typing.bar.findChild<FaultLabel*>()->isHidden());
        QVERIFY(typing.document.history().empty());
        typing.type(index, "4");
        QVERIFY(typing.fault().isEmpty());
        QCOMPARE(typing.document.history().size(), std::size_t(1));
    }

    void aDragOnALabelIsOneEntryAndEscapeTakesItBack() {
        Typing typing;
        for (const int index : {0, 1, 2, 3, 4}) {
            const Level before = typing.level();
            NumberField& field = typing.field(index);
            field.beginScrub();
            field.scrub(10, {});
            QVERIFY(typing.document.hasPreview());
            QVERIFY(!(typing.level() == before));
            field.endScrub(false);
            QVERIFY(typing.level() == before);
            QVERIFY(!typing.document.canUndo());
            field.beginScrub();
            field.scrub(10, {});
            field.scrub(20, {});
            const Level dragged = typing.level();
            field.endScrub(true);
            QVERIFY(typing.level() == dragged);
            typing.document.undo();
            QVERIFY(typing.level() == before);
        }
    }
};

SPACETOW_TEST(TransformBarTest)
#include "transform_bar_test.moc"
