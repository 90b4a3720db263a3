#include "editor/panels/array_bar.h"

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

    void whatElseHappensClosesTheBar() {
        Arrays arrays;
        arrays.bar.begin(ArrayBar::Kind::Linear);
        arrays.document.select({});
        QVERIFY(arrays.bar.isHidden());
        QVERIFY(arrays.level() == ball());
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
