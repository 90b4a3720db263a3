#include "editor/panels/guide_bar.h"

#include "tests/support/test_main.h"
#include "tests/support/window.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

constexpr double pi = std::numbers::pi;

Guide guideAt(double x, double y, double angle) {
    Guide guide;
    guide.point = Vec2(x, y);
    guide.angle = angle;
    return guide;
}

void open(TestWindow& test, std::vector<Guide> guides) {
    Level level;
    level.guides = std::move(guides);
    test.document().reset(level);
}

void type(QLineEdit& field, const QString& text) {
    field.setFocus();
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

} // namespace

class GuideBarTest : public QObject {
    Q_OBJECT

  private slots:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void aDoubleClickOnAGuideOpensIt() {
        TestWindow test;
        open(test, {guideAt(0, 1, 0)});
        QVERIFY(!test.window->guideBar().isVisible());
        QTest::mouseMove(&test.canvas(), test.at(2, 1));
        QTest::mouseDClick(&test.canvas(), Qt::LeftButton, {}, test.at(2, 1));
        QVERIFY(test.window->guideBar().isVisible());
        QCOMPARE(test.window->guideBar().guide(), std::optional<std::size_t>(0));
        QCOMPARE(test.window->guideBar().y().text(), QStringLiteral("1"));
        QVERIFY(test.window->guideBar().y().hasFocus()); // the coordinate that matters
        QTest::mouseRelease(&test.canvas(), Qt::LeftButton, {}, test.at(2, 1));
        QVERIFY(test.level().guides[0] == guideAt(0, 1, 0));
    }

    void whatIsTypedIsWrittenInOneStepEach() {
        TestWindow test;
        open(test, {guideAt(0, 1, 0), guideAt(3, 0, pi / 2)});
        test.window->openGuide(1);
        GuideBar& bar = test.window->guideBar();
        QVERIFY(bar.x().hasFocus());
        type(bar.x(), "2.5");
        QCOMPARE(test.level().guides[1].point, Vec2(2.5, 0));
        type(bar.y(), "-4");
        type(bar.angle(), "30");
        type(bar.name(), "roof <b>");
        QCOMPARE(test.level().guides[1].point, Vec2(2.5, -4));
        QVERIFY(std::abs(test.level().guides[1].angle - pi / 6) < 1e-12);
        QCOMPARE(test.level().guides[1].name, std::string("roof <b>"));
        QCOMPARE(bar.angle().text(), QStringLiteral("30"));
        QVERIFY(test.level().guides[0] == guideAt(0, 1, 0));
        while (test.document().canUndo()) {
            test.trigger(Act::Undo);
        }
        QVERIFY(test.level().guides[1] == guideAt(3, 0, pi / 2));
    }

    void aDragOnALabelIsOneEntryAndEscapeTakesItBack() {
        TestWindow test;
        open(test, {guideAt(0, 1, 0)});
        test.window->openGuide(0);
        GuideBar& bar = test.window->guideBar();
        for (NumberField* field : {&bar.x(), &bar.y(), &bar.angle()}) {
            const Level before = test.level();
            const auto labels = bar.findChildren<ScrubLabel*>();
            const auto label = std::ranges::find(labels, static_cast<QWidget*>(field), &QLabel::buddy);
            QVERIFY(label != labels.end());
            const QPoint start = (*label)->rect().center();
            const auto pull = [&](Qt::Key end) {
                QTest::mousePress(*label, Qt::LeftButton, {}, start);
                QTest::mouseMove(*label, start + QPoint(20, 0));
                QTest::mouseMove(*label, start + QPoint(60, 0));
                QVERIFY(!(test.level() == before));
                if (end == Qt::Key_Escape) {
                    QTest::keyClick(field, end);
                }
                QTest::mouseRelease(*label, Qt::LeftButton, {}, start + QPoint(60, 0));
            };
            pull(Qt::Key_Escape);
            QVERIFY(test.level() == before && !test.document().canUndo());
            pull(Qt::Key_unknown);
            QCOMPARE(test.document().historySize(), 1);
            test.trigger(Act::Undo);
            QVERIFY(test.level() == before);
            test.document().reset(before);
        }
    }

    void rubbishIsNotTaken() {
        TestWindow test;
        open(test, {guideAt(0, 1, 0)});
        test.window->openGuide(0);
        for (const char* text : {"two", "", "1e99", "nan"}) {
            type(test.window->guideBar().y(), QLatin1String(text));
            QVERIFY(test.level().guides[0] == guideAt(0, 1, 0));
        }
        QVERIFY(!test.document().canUndo());
    }

    void itFollowsTheLevelAndClosesWithItsGuide() {
        TestWindow test;
        open(test, {guideAt(0, 1, 0)});
        test.window->openGuide(0);
        GuideBar& bar = test.window->guideBar();
        test.canvas().setFocus();
        test.drag(2, 1, 2, 2);
        QVERIFY(bar.y().text().startsWith("2") || bar.y().text().startsWith("1.9"));
        QTest::mouseClick(&bar.deleteButton(), Qt::LeftButton);
        QVERIFY(test.level().guides.empty());
        QVERIFY(!bar.isVisible());
        QVERIFY(test.canvas().hasFocus());
        test.trigger(Act::Undo);
        QCOMPARE(test.level().guides.size(), std::size_t{1});
        test.window->openGuide(0);
        test.trigger(Act::ClearGuides);
        QVERIFY(!bar.isVisible() && test.level().guides.empty());
    }

    void escapeClosesItAndAnotherLevelDoes() {
        TestWindow test;
        test.trigger(Act::AddGuide);
        QCOMPARE(test.level().guides.size(), std::size_t{1});
        GuideBar& bar = test.window->guideBar();
        QVERIFY(bar.isVisible() && bar.y().hasFocus());
        QTest::keyClick(&bar.y(), Qt::Key_Escape);
        QVERIFY(!bar.isVisible());
        test.window->openGuide(0);
        test.trigger(Act::Play);
        QVERIFY(!bar.isVisible());
        test.trigger(Act::Stop);
        test.window->openGuide(0);
        test.unsaved = Unsaved::Discard;
        test.trigger(Act::New);
        QVERIFY(!bar.isVisible());
    }

    void itFitsBesideThePanelsInTheSmallestWindow() {
        TestWindow test;
        open(test, {guideAt(-1234.5, 1234.5, 0.5)});
        test.window->resize(800, 600);
        test.window->openGuide(0);
        QApplication::processEvents();
        QCOMPARE(test.window->size(), QSize(800, 600));
        QCOMPARE(cutOffTexts(test.window->guideBar()), QStringList());
        for (const QLineEdit* field : test.window->guideBar().findChildren<QLineEdit*>()) {
            QVERIFY(field->width() >= field->minimumSizeHint().width());
        }
    }
};

SPACETOW_TEST(GuideBarTest)
#include "guide_bar_test.moc"
