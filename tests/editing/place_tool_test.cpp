#include "editor/editing/place_tool.h"

#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

struct Placer : Drive {
    explicit Placer(ToolId tool) { toolbox.choose(tool); }
    template <class T>
    T only() const {
        return std::get<T>(firstOf<T>(level())->data);
    }
};

} // namespace

class PlaceToolTest : public QObject {
    Q_OBJECT

  private slots:
    void aClickPlacesTheShip();
    void placingAgainMovesTheShip();
    void aDragTurnsTheShip_data();
    void aDragTurnsTheShip();
    void thePayloadKeepsItsSizeWhenMoved();
    void aDragCarriesThePayload();
    void theFinishIsDraggedOrClicked_data();
    void theFinishIsDraggedOrClicked();
    void aFinishHasALength();
    void oneKeyGoesThroughAllKinds();
    void whatTheLevelLacksComesFirst();
    void inALevelThatHasAllTheKindThatWasInTheHandLastComesFirst();
    void escapeLeavesNothingBehind();
    void theGhostShowsWhatAClickWouldDo();
};

void PlaceToolTest::aClickPlacesTheShip() {
    Placer drive(ToolId::Ship);
    drive.click({1.1, 2});
    QVERIFY(drive.only<ShipObject>() == (ShipObject{{1, 2}, 0}));
    QCOMPARE(drive.document.history(), (std::vector<Label>{{"place-ship", 1}}));
    QVERIFY(drive.document.selection() == Selection({drive.newest().key}));
}

void PlaceToolTest::placingAgainMovesTheShip() {
    Placer drive(ToolId::Ship);
    drive.drag({1, 2}, {3, 2});
    const Key key = drive.newest().key;
    const double angle = drive.only<ShipObject>().angle;
    drive.click({5, 5});
    QCOMPARE(drive.level().objects.size(), 1);
    QCOMPARE(drive.newest().key, key);
    QVERIFY(drive.only<ShipObject>() == (ShipObject{{5, 5}, angle}));
    QVERIFY(drive.document.selection() == Selection({key}));
}

void PlaceToolTest::aDragTurnsTheShip_data() {
    QTest::addColumn<Vec2>("to");
    QTest::addColumn<bool>("shift");
    QTest::addColumn<double>("degrees"); // anticlockwise from nose up
    QTest::newRow("up") << Vec2(0, 3) << false << 0.0;
    QTest::newRow("left") << Vec2(-3, 0) << false << 90.0;
    QTest::newRow("right") << Vec2(3, 0) << false << -90.0;
    QTest::newRow("slanted") << Vec2(-3, 3) << false << 45.0;
    QTest::newRow("shift") << Vec2(-3, 3.4) << true << 45.0;
}

void PlaceToolTest::aDragTurnsTheShip() {
    QFETCH(Vec2, to);
    QFETCH(bool, shift);
    QFETCH(double, degrees);
    Placer drive(ToolId::Ship);
    drive.press({0, 0});
    drive.held.shift = shift;
    drive.move(to);
    QCOMPARE(drive.toolbox.hint().code, std::string("place-ship.turning"));
    drive.release(to);
    QVERIFY(drive.only<ShipObject>().position == Vec2(0, 0));
    QVERIFY(std::abs(drive.only<ShipObject>().angle * 180 / std::numbers::pi - degrees) < 1e-9);
    QCOMPARE(drive.document.history().size(), std::size_t{1});
}

void PlaceToolTest::thePayloadKeepsItsSizeWhenMoved() {
    Level level;
    level.objects.append({7, "ball", PayloadObject{{0, 0}, 0.4, 3}, {}});
    Placer drive(ToolId::Payload);
    drive.document.reset(level);
    drive.click({2, 2});
    QVERIFY(drive.only<PayloadObject>() == (PayloadObject{{2, 2}, 0.4, 3}));
    QCOMPARE(drive.newest().key, Key{7});
    QCOMPARE(drive.newest().name, std::string("ball"));
}

void PlaceToolTest::aDragCarriesThePayload() {
    Placer drive(ToolId::Payload);
    drive.drag({0, 0}, {3, 1});
    QVERIFY(drive.only<PayloadObject>().position == Vec2(3, 1));
    QCOMPARE(drive.document.history(), (std::vector<Label>{{"place-payload", 1}}));
}

void PlaceToolTest::theFinishIsDraggedOrClicked_data() {
    QTest::addColumn<bool>("clicks");
    QTest::newRow("drag") << false;
    QTest::newRow("clicks") << true;
}

void PlaceToolTest::theFinishIsDraggedOrClicked() {
    QFETCH(bool, clicks);
    Placer drive(ToolId::Finish);
    if (clicks) {
        drive.click({1, 1});
        QVERIFY(drive.toolbox.isBusy());
        QVERIFY(drive.level().objects.empty());
        drive.click({1, 3});
    } else {
        drive.drag({1, 1}, {1, 3});
    }
    QVERIFY(drive.only<FinishObject>() == (FinishObject{{1, 1}, {1, 3}}));
    QVERIFY(!drive.toolbox.isBusy());
    QCOMPARE(drive.document.history(), (std::vector<Label>{{"place-finish", 1}}));
    const Key key = drive.newest().key;
    drive.drag({4, 1}, {5, 1});
    QVERIFY(drive.only<FinishObject>() == (FinishObject{{4, 1}, {5, 1}}));
    QCOMPARE(drive.level().objects.size(), 1);
    QCOMPARE(drive.newest().key, key);
}

void PlaceToolTest::aFinishHasALength() {
    Placer drive(ToolId::Finish);
    drive.click({{1, 1}, {1.1, 1}});
    QVERIFY(drive.level().objects.empty());
    QCOMPARE(drive.toolbox.hint().code, std::string("place-finish.too-short"));
    drive.click({2, 1});
    QVERIFY(drive.only<FinishObject>() == (FinishObject{{1, 1}, {2, 1}}));
    drive.document.reset({});
    drive.press({1, 1});
    drive.move({3, 3});
    drive.release({1, 1});
    QVERIFY(drive.level().objects.empty());
}

void PlaceToolTest::oneKeyGoesThroughAllKinds() {
    Drive drive;
    for (const ToolId expected : {ToolId::Ship, ToolId::Payload, ToolId::Finish, ToolId::Ship}) {
        drive.toolbox.choosePlaceTool();
        QCOMPARE(drive.toolbox.current(), expected);
    }
}

namespace {

/// Places all three with the key that goes through them, and lets go.
void placeAll(Drive& drive) {
    for (double x = 0; x < 3; ++x) {
        drive.toolbox.choosePlaceTool();
        drive.drag({4 * x, 0}, {4 * x + 2, 0});
    }
    drive.toolbox.choose(ToolId::Select);
}

} // namespace

void PlaceToolTest::whatTheLevelLacksComesFirst() {
    Drive drive;
    placeAll(drive);
    QCOMPARE(drive.level().objects.size(), 3);
    drive.document.undo(); // the finish
    drive.toolbox.choose(ToolId::Payload);
    drive.toolbox.choose(ToolId::Select);
    drive.toolbox.choosePlaceTool();
    QCOMPARE(drive.toolbox.current(), ToolId::Finish);
    drive.toolbox.choosePlaceTool();
    QCOMPARE(drive.toolbox.current(), ToolId::Ship);
}

void PlaceToolTest::inALevelThatHasAllTheKindThatWasInTheHandLastComesFirst() {
    Drive drive;
    placeAll(drive);
    drive.toolbox.choose(ToolId::Payload);
    drive.toolbox.choose(ToolId::Select);
    drive.toolbox.choosePlaceTool();
    QCOMPARE(drive.toolbox.current(), ToolId::Payload);
    drive.toolbox.choosePlaceTool();
    QCOMPARE(drive.toolbox.current(), ToolId::Finish);
}

void PlaceToolTest::escapeLeavesNothingBehind() {
    for (const ToolId tool : placeTools) {
        Placer drive(tool);
        drive.press({0, 0});
        drive.move({3, 1});
        QCOMPARE(drive.level().objects.size(), 1);
        drive.key(ToolKey::Escape);
        drive.release({3, 1});
        QVERIFY(drive.level().objects.empty());
    }
    Placer drive(ToolId::Finish);
    drive.click({0, 0});
    drive.toolbox.choose(ToolId::Ship);
    QVERIFY(!drive.toolbox.isBusy());
}

void PlaceToolTest::theGhostShowsWhatAClickWouldDo() {
    Placer ship(ToolId::Ship);
    ship.move({1.1, 1});
    QCOMPARE(ship.toolbox.overlay().lines.size(), std::size_t{1});
    Placer payload(ToolId::Payload);
    payload.move({1.1, 1});
    QCOMPARE(payload.toolbox.overlay().circles.size(), std::size_t{1});
    QVERIFY(payload.toolbox.overlay().circles.front().center == Vec2(1, 1));
    payload.toolbox.leave();
    QVERIFY(payload.toolbox.overlay().circles.empty());
}

SPACETOW_TEST(PlaceToolTest)
#include "place_tool_test.moc"
