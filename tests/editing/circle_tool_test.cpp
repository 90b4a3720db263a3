#include "editor/editing/circle_tool.h"

#include "tests/support/drive.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct CircleDrawer : Drive {
    CircleDrawer() { toolbox.choose(ToolId::Circle); }
    Circle circle() const { return std::get<Circle>(std::get<BodyObject>(newest().data).shapes.front()); }
};

} // namespace

class CircleToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aDragDrawsFromTheCentre();
    void twoClicksDrawToo();
    void theRadiusSnaps_data();
    void theRadiusSnaps();
    void aCircleWithoutRadiusIsNotDrawn();
    void escapeCancels();
    void aSecondDragMayGiveTheRadius();
    void enterSetsTheRimWhereThePointerIs();
};

void CircleToolTest::enterSetsTheRimWhereThePointerIs() {
    CircleDrawer drive;
    drive.click({1, 2});
    drive.move({1, 4});
    drive.key(ToolKey::Enter);
    QVERIFY(drive.circle() == (Circle{{0, 0}, 2}));
    QVERIFY(!drive.toolbox.isBusy());
}

void CircleToolTest::aDragDrawsFromTheCentre() {
    CircleDrawer drive;
    drive.press({1, 2});
    drive.move({1, 3});
    QCOMPARE(drive.circle().radius, 1.0); // while dragging
    QVERIFY(drive.document.history().empty());
    QCOMPARE(drive.toolbox.hint(), (Hint{"draw-circle.radius", {"1.00"}}));
    drive.move({1, 3.5});
    drive.release({1, 3.5});
    const auto& body = std::get<BodyObject>(drive.newest().data);
    QVERIFY(body.position == Vec2(1, 2));
    QCOMPARE(body.kind, BodyKind::Static);
    QCOMPARE(body.filter.tags.bits, TagMask::bit(wallTag).bits);
    QVERIFY(drive.circle() == (Circle{{0, 0}, 1.5}));
    QCOMPARE(drive.document.history(), (std::vector<Label>{{"draw-circle", 1}}));
    QVERIFY(drive.document.selection() == Selection({drive.newest().key}));
    drive.document.undo();
    QVERIFY(drive.level().objects.empty());
}

void CircleToolTest::twoClicksDrawToo() {
    CircleDrawer drive;
    drive.click({1, 2});
    QVERIFY(drive.toolbox.isBusy());
    QVERIFY(drive.level().objects.empty());
    drive.click({3, 2});
    QVERIFY(drive.circle() == (Circle{{0, 0}, 2}));
    QVERIFY(worldPoints(drive.newest()).front() == Vec2(1, 2));
    QVERIFY(!drive.toolbox.isBusy());
}

void CircleToolTest::theRadiusSnaps_data() {
    QTest::addColumn<bool>("ctrl");
    QTest::addColumn<double>("radius");
    QTest::newRow("to the grid") << false << 1.5;
    QTest::newRow("not with ctrl") << true << std::hypot(1.1, 1.1);
}

void CircleToolTest::theRadiusSnaps() {
    QFETCH(bool, ctrl);
    QFETCH(double, radius);
    CircleDrawer drive;
    drive.click({0, 0});
    drive.held.ctrl = ctrl;
    drive.click({1.1, 1.1});
    QCOMPARE(drive.circle().radius, radius);
}

void CircleToolTest::aCircleWithoutRadiusIsNotDrawn() {
    CircleDrawer drive;
    drive.click({{0, 0}, {0.1, 0}});
    QVERIFY(drive.level().objects.empty());
    QCOMPARE(drive.toolbox.hint().code, std::string("draw-circle.too-small"));
    drive.move({1, 0});
    QCOMPARE(drive.toolbox.hint().code, std::string("draw-circle.radius"));
    drive.key(ToolKey::Escape);
    drive.press({0, 0});
    drive.move({3, 0});
    drive.release({0, 0});
    QVERIFY(drive.level().objects.empty());
    QVERIFY(drive.document.history().empty());
}

void CircleToolTest::escapeCancels() {
    CircleDrawer drive;
    drive.press({0, 0});
    drive.move({3, 0});
    drive.key(ToolKey::Escape);
    drive.release({3, 0});
    QVERIFY(drive.level().objects.empty());
    drive.click({0, 0});
    drive.key(ToolKey::Escape);
    QVERIFY(!drive.toolbox.isBusy());
    drive.click({1, 1});
    QVERIFY(drive.level().objects.empty());
}

void CircleToolTest::aSecondDragMayGiveTheRadius() {
    CircleDrawer drive;
    drive.click({0, 0});
    drive.drag({0.5, 0}, {2, 0});
    QVERIFY(drive.circle() == (Circle{{0, 0}, 2}));
    QCOMPARE(drive.level().objects.size(), 1);
}

SPACETOW_TEST(CircleToolTest)
#include "circle_tool_test.moc"
