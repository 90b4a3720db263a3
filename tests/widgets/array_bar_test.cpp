#include "editor/panels/array_bar.h"

#include "core/level/edits.h"
#include "editor/window/messages.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <QTest>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Level ball() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.5}, {0, 0}));
    return level;
}

struct Arrays : Drive {
    Arrays() : Drive(ball()), bar(document, toolbox) { document.select(Selection({1})); }
    ArrayBar bar;
};

} // namespace

class ArrayBarTest : public QObject {
    Q_OBJECT

  private slots:
    void theArrayIsShownAtOnceAndMadeAsOneEntry() {
        Arrays arrays;
        arrays.bar.begin(ArrayBar::Kind::Linear);
        QVERIFY(!arrays.bar.isHidden());
        QCOMPARE(arrays.level().objects.size(), 4);
        QCOMPARE(arrays.document.current().level->objects.size(), 1);
        arrays.bar.apply();
        QVERIFY(arrays.bar.isHidden());
        QCOMPARE(arrays.document.current().level->objects.size(), 4);
        QCOMPARE(arrays.document.undoLabel(), (Label{"array", 3}));
        QCOMPARE(arrays.document.selection().size(), 4);
        arrays.document.undo();
        QVERIFY(arrays.level() == ball());
    }

    void cancelAndEscapeLeaveTheLevelAsItWas() {
        Arrays arrays;
        arrays.bar.begin(ArrayBar::Kind::Radial);
        QVERIFY(arrays.document.hasPreview());
        QTest::keyClick(&arrays.bar, Qt::Key_Escape);
        QVERIFY(arrays.bar.isHidden() && !arrays.document.hasPreview());
        QVERIFY(arrays.level() == ball());
        QVERIFY(arrays.document.history().empty());
    }

    void aMillionCopiesAreRefusedInASentence() {
        Arrays arrays;
        arrays.bar.show();
        arrays.bar.begin(ArrayBar::Kind::Linear);
        arrays.bar.findChildren<NumberField*>().front()->entered(1e6);
        auto* const refusal = arrays.bar.findChild<QLabel*>(QStringLiteral("refusal"));
        QVERIFY(!refusal->text().isEmpty());
        QVERIFY(!arrays.document.hasPreview());
        arrays.bar.apply();
        QVERIFY(!arrays.bar.isHidden());
        QVERIFY(arrays.document.history().empty());
        arrays.bar.findChildren<NumberField*>().front()->entered(2);
        QVERIFY(refusal->text().isEmpty());
        QCOMPARE(arrays.level().objects.size(), 3);
    }

    void whatIsNoExpressionIsRefusedInASentenceAndNoArrayIsMade() {
        Arrays arrays;
        arrays.bar.setWords([](const Error& error) { return sentence(error); });
        arrays.bar.begin(ArrayBar::Kind::Linear);
        NumberField* copies = arrays.bar.findChildren<NumberField*>().front();
        copies->selectAll();
        QTest::keyClicks(copies, "2*foo");
        QTest::keyClick(copies, Qt::Key_Return);
        QVERIFY(!arrays.bar.isHidden());
        QCOMPARE(copies->text(), QString("2*foo"));
        QVERIFY(arrays.bar.findChild<FaultLabel*>()->text().contains("foo"));
        arrays.bar.apply();
        QVERIFY(arrays.document.history().empty());
        copies->selectAll();
        QTest::keyClicks(copies, "2*3");
        arrays.bar.apply(); // what is typed counts without Enter
        QCOMPARE(arrays.document.undoLabel(), (Label{"array", 6}));
    }

    void aDragOnALabelIsShownAtOnce() {
        Arrays arrays;
        arrays.bar.begin(ArrayBar::Kind::Linear);
        NumberField* copies = arrays.bar.findChildren<NumberField*>().front();
        copies->beginScrub();
        copies->scrub(10, {});
        QCOMPARE(arrays.level().objects.size(), 6);
        copies->endScrub(false);
        QCOMPARE(arrays.level().objects.size(), 4);
    }

    void aClickOnTheCanvasLeavesTheBarOpenForWhatIsSelectedThen() {
        Arrays arrays;
        arrays.document.commit(
            {"draw-circle"},
            {std::make_shared<const Level>(added(ball(), bodyWith(2, Circle{{0, 0}, 0.5}, {0, 5}))), Selection({1})});
        arrays.bar.begin(ArrayBar::Kind::Linear);
        arrays.click({0, -5});
        QCoreApplication::processEvents();
        QVERIFY(!arrays.bar.isHidden() && !arrays.document.hasPreview());
        auto* const refusal = arrays.bar.findChild<QLabel*>(QStringLiteral("refusal"));
        QVERIFY(!refusal->text().isEmpty());
        arrays.bar.apply();
        QVERIFY(!arrays.bar.isHidden());
        arrays.click({0, 5});
        QCoreApplication::processEvents();
        QVERIFY(refusal->text().isEmpty());
        QCOMPARE(arrays.level().objects.size(), 5);
        arrays.bar.apply();
        QCOMPARE(arrays.document.selection().size(), 4);
        QVERIFY(arrays.document.selection().contains(2));
        QVERIFY(!arrays.document.selection().contains(1));
    }

    void whatIsDoneToTheLevelMeanwhileIsKept() {
        Arrays arrays;
        arrays.bar.begin(ArrayBar::Kind::Linear);
        arrays.drag({0, 0}, {0, 3});
        QCoreApplication::processEvents();
        QVERIFY(arrays.document.hasPreview());
        QCOMPARE(arrays.level().objects.size(), 4);
        arrays.bar.apply();
        QCOMPARE(arrays.document.history().size(), std::size_t{2});
        for (const Object& object : arrays.level().objects) {
            QVERIFY(std::abs(std::get<BodyObject>(object.data).position.y() - 3) < 0.2);
        }
        arrays.bar.begin(ArrayBar::Kind::Linear);
        arrays.document.undo();
        arrays.bar.apply(); // before the bar has seen it
        QCOMPARE(arrays.level().objects.size(), 4);
    }

    void whatWasTypedStaysForTheNextSelection() {
        Arrays arrays;
        arrays.bar.begin(ArrayBar::Kind::Linear);
        const auto fields = arrays.bar.findChildren<NumberField*>();
        fields[2]->entered(7);
        arrays.document.select({});
        QCoreApplication::processEvents();
        arrays.document.select(Selection({1}));
        QCoreApplication::processEvents();
        QCOMPARE(std::get<BodyObject>(arrays.newest().data).position, Vec2(21, 0));
    }

    void withoutASelectionThereIsNoBar() {
        Arrays arrays;
        arrays.document.select({});
        arrays.bar.begin(ArrayBar::Kind::Linear);
        QVERIFY(arrays.bar.isHidden());
    }
};

SPACETOW_TEST(ArrayBarTest)
#include "array_bar_test.moc"
