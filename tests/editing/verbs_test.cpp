#include "editor/editing/verbs.h"

#include "editor/editing/arrange_verbs.h"
#include "editor/editing/clipboard.h"
#include "tests/support/drive.h"
#include "tests/support/test_main.h"

#include <numbers>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Two joined balls and a wall, a ship, a payload and a finish.
Level everything() {
    Level level;
    level.objects.append(bodyWith(1, Circle{{0, 0}, 0.5}, {0, 0}));
    level.objects.append(bodyWith(2, Circle{{0, 0}, 0.5}, {2, 0}));
    ConnectorObject connector;
    connector.a = 1;
    connector.b = 2;
    level.objects.append({3, "rope", connector, {}});
    level.objects.append(bodyWith(4, EdgeChain{{{0, 0}, {2, 0}, {2, 1}}, false, noBack}, {4, 4}));
    level.objects.append({5, "", ShipObject{{-2, 0}, 0}, {}});
    level.objects.append({6, "", PayloadObject{{-4, 0}, 0.2, 0.25}, {}});
    level.objects.append({7, "", FinishObject{{-4, 4}, {-2, 4}}, {}});
    return level;
}

struct Editor : Drive {
    explicit Editor(std::vector<Key> keys) : Drive(everything()) { document.select(Selection(std::move(keys))); }
    bool run(const std::optional<FinishedEdit>& finished) { return toolbox.finish(finished); }
    const BodyObject& body(Key key) const { return std::get<BodyObject>(level().objects.find(key)->data); }
    std::string lastLabel() const { return std::string(document.undoLabel().code.text()); }
};

} // namespace

class VerbsTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingSelectedMeansNothingToDo();
    void removingTakesTheConnectorsAlong();
    void duplicatesLieOneStepAsideAndAreSelected();
    void nudgesMergeIntoOneEntry();
    void nudgingThereAndBackIsNoEntry();
    void fullTurnComesBackWithoutDrift();
    void rotatingASingleBallTurnsItOnItsSpot();
    void reversingTurnsTheWallRound();
    void reversingWhatHasNoSideIsNoEntry();
    void allAndInverseComplementEachOther();
    void cutAndPasteBringBackTheSame();
    void pasteInPlaceGivesFreshKeys();
    void whatIsPastedIntoAnEnteredGroupBecomesItsMember();
    void aLayerIsPastedAtTheTopWhateverGroupIsEntered();
    void pasteCentresOnThePointByGridSteps_data();
    void pasteCentresOnThePointByGridSteps();
    void aSecondShipIsNotPasted();
    void whatIsNoLevelTextPastesNothing_data();
    void whatIsNoLevelTextPastesNothing();
};

void VerbsTest::nothingSelectedMeansNothingToDo() {
    Editor editor({});
    QVERIFY(!editor.run(removeSelected(editor.toolbox.context())));
    QVERIFY(!editor.run(duplicateSelected(editor.toolbox.context())));
    QVERIFY(!editor.run(nudgeSelected(editor.toolbox.context(), {1, 0})));
    QVERIFY(!editor.run(rotateSelected(editor.toolbox.context(), 1)));
    QVERIFY(!editor.run(reverseSelected(editor.toolbox.context())));
    QVERIFY(!editor.run(cut(editor.toolbox.context())));
    QVERIFY(copied(editor.document.current()).empty());
}

void VerbsTest::removingTakesTheConnectorsAlong() {
    Editor editor({1, 4});
    QVERIFY(editor.run(removeSelected(editor.toolbox.context())));
    QVERIFY(!editor.level().objects.find(1) && !editor.level().objects.find(3) && !editor.level().objects.find(4));
    QCOMPARE(editor.level().objects.size(), 4);
    QCOMPARE(editor.document.undoLabel(), (Label{"delete", 2}));
    editor.document.undo();
    QVERIFY(editor.level() == everything());
    QVERIFY(editor.document.selection() == Selection({1, 4}));
}

void VerbsTest::duplicatesLieOneStepAsideAndAreSelected() {
    Editor editor({1, 2, 3, 5});
    QVERIFY(editor.run(duplicateSelected(editor.toolbox.context())));
    QCOMPARE(editor.level().objects.size(), 10); // the ship is not copied
    QCOMPARE(editor.document.selection().size(), 3);
    std::vector<Vec2> places;
    for (const Key key : editor.document.selection().keys()) {
        QVERIFY(!everything().objects.find(key));
        if (const auto* body = std::get_if<BodyObject>(&editor.level().objects.find(key)->data)) {
            places.push_back(body->position);
        }
    }
    std::sort(places.begin(), places.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
    QVERIFY(places == (std::vector<Vec2>{{0.25, -0.25}, {2.25, -0.25}}));
}

void VerbsTest::nudgesMergeIntoOneEntry() {
    Editor editor({1, 2});
    for (int i = 0; i < 5; ++i) {
        QVERIFY(editor.run(nudgeSelected(editor.toolbox.context(), {0.25, 0})));
        editor.later(std::chrono::milliseconds(900));
    }
    QCOMPARE(editor.document.history(), (std::vector<Label>{{"move", 2}}));
    QVERIFY(editor.body(2).position == Vec2(3.25, 0));
    editor.later(std::chrono::milliseconds(200));
    QVERIFY(editor.run(nudgeSelected(editor.toolbox.context(), {0.25, 0})));
    QCOMPARE(editor.document.history().size(), std::size_t{2});
}

void VerbsTest::nudgingThereAndBackIsNoEntry() {
    Editor editor({1});
    QVERIFY(editor.run(nudgeSelected(editor.toolbox.context(), {0.25, 0})));
    QVERIFY(editor.run(nudgeSelected(editor.toolbox.context(), {-0.25, 0})));
    QVERIFY(editor.document.history().empty());
    QVERIFY(!editor.document.isModified());
}

void VerbsTest::fullTurnComesBackWithoutDrift() {
    Editor editor({1, 4, 5, 7});
    for (int i = 0; i < 24; ++i) {
        QVERIFY(editor.run(rotateSelected(editor.toolbox.context(), std::numbers::pi / 12)));
    }
    for (const Key key : {1u, 4u}) {
        const BodyObject before = std::get<BodyObject>(everything().objects.find(key)->data);
        QVERIFY((editor.body(key).position - before.position).norm() < 1e-9);
        QVERIFY(std::abs(std::remainder(editor.body(key).angle - before.angle, 2 * std::numbers::pi)) < 1e-9);
    }
    const auto& finish = std::get<FinishObject>(editor.level().objects.find(7)->data);
    QVERIFY((finish.a - Vec2(-4, 4)).norm() < 1e-9 && (finish.b - Vec2(-2, 4)).norm() < 1e-9);
}

void VerbsTest::rotatingASingleBallTurnsItOnItsSpot() {
    Editor editor({2});
    QVERIFY(editor.run(rotateSelected(editor.toolbox.context(), 0.5)));
    QVERIFY((editor.body(2).position - Vec2(2, 0)).norm() < 1e-12);
    QCOMPARE(editor.body(2).angle, 0.5);
    QCOMPARE(editor.lastLabel(), std::string("rotate"));
}

void VerbsTest::reversingTurnsTheWallRound() {
    Editor editor({1, 4});
    std::vector<Vec2> before = worldPoints(*editor.level().objects.find(4));
    QVERIFY(editor.run(reverseSelected(editor.toolbox.context())));
    std::reverse(before.begin(), before.end());
    QVERIFY(worldPoints(*editor.level().objects.find(4)) == before);
    QVERIFY(editor.run(reverseSelected(editor.toolbox.context())));
    QVERIFY(editor.level() == everything());
}

void VerbsTest::reversingWhatHasNoSideIsNoEntry() {
    Editor editor({1, 5});
    editor.run(reverseSelected(editor.toolbox.context()));
    QVERIFY(editor.document.history().empty());
}

void VerbsTest::allAndInverseComplementEachOther() {
    Editor editor({1, 4});
    QCOMPARE(selectAll(editor.document.current()), Selection({1, 2, 3, 4, 5, 6, 7}));
    QCOMPARE(invertedSelection(editor.document.current()), Selection({2, 3, 5, 6, 7}));
    editor.document.select(selectAll(editor.document.current()));
    QVERIFY(invertedSelection(editor.document.current()).empty());
}

void VerbsTest::cutAndPasteBringBackTheSame() {
    Editor editor({1, 2, 3, 5, 6, 7});
    const std::string text = copied(editor.document.current());
    QVERIFY(editor.run(cut(editor.toolbox.context())));
    QCOMPARE(editor.document.undoLabel(), (Label{"cut", 6}));
    QCOMPARE(editor.level().objects.size(), 1);
    QVERIFY(editor.run(pasted(editor.toolbox.context(), text, std::nullopt)));
    QCOMPARE(editor.document.undoLabel(), (Label{"paste", 6}));
    QCOMPARE(editor.level().objects.size(), 7);
    QVERIFY(std::get<ShipObject>(firstOf<ShipObject>(editor.level())->data) == (ShipObject{{-2, 0}, 0}));
    QCOMPARE(editor.document.selection().size(), 6);
    const Object* rope = firstOf<ConnectorObject>(editor.level());
    const auto& connector = std::get<ConnectorObject>(rope->data);
    QVERIFY(editor.body(connector.a).position == Vec2(0, 0));
    QVERIFY(editor.body(connector.b).position == Vec2(2, 0));
    QCOMPARE(rope->name, std::string("rope"));
}

void VerbsTest::pasteInPlaceGivesFreshKeys() {
    Editor editor({4});
    const std::string text = copied(editor.document.current());
    for (int i = 0; i < 3; ++i) {
        QVERIFY(editor.run(pasted(editor.toolbox.context(), text, std::nullopt)));
    }
    QCOMPARE(editor.level().objects.size(), 10);
    QCOMPARE(selectAll(editor.document.current()).size(), 10); // no key twice
    QVERIFY(editor.body(editor.newest().key) == editor.body(4));
}

void VerbsTest::whatIsPastedIntoAnEnteredGroupBecomesItsMember() {
    Editor editor({4});
    const std::string text = copied(editor.document.current());
    editor.document.select(Selection({1, 2}));
    QVERIFY(editor.run(groupSelected(editor.toolbox.context())));
    const Key group = editor.document.selection().keys().front();
    editor.document.select(Selection({1}).entering(group));
    QVERIFY(editor.run(pasted(editor.toolbox.context(), text, std::nullopt)));
    QCOMPARE(editor.newest().parent, group);
    QCOMPARE(editor.document.selection().entered(), group);
    QCOMPARE(editor.document.selection().keys(), std::vector<Key>{editor.newest().key});
}

void VerbsTest::aLayerIsPastedAtTheTopWhateverGroupIsEntered() {
    Editor editor({4});
    QVERIFY(editor.run(newLayer(editor.toolbox.context())));
    const Key layer = editor.level().objects.find(4)->parent;
    QVERIFY(layer != 0);
    editor.document.select(Selection({layer}));
    const std::string text = copied(editor.document.current());
    editor.document.select(Selection({1, 2}));
    QVERIFY(editor.run(groupSelected(editor.toolbox.context())));
    const Key group = editor.document.selection().keys().front();
    editor.document.select(Selection({1}).entering(group));
    QVERIFY(editor.run(pasted(editor.toolbox.context(), text, std::nullopt)));
    QCOMPARE(editor.document.selection().size(), 1);
    const Object* pastedLayer = editor.level().objects.find(editor.document.selection().keys().front());
    QVERIFY(std::get<GroupObject>(pastedLayer->data).layer);
    QCOMPARE(pastedLayer->parent, Key{0});
    QCOMPARE(editor.newest().parent, pastedLayer->key);
    QCOMPARE(editor.document.selection().entered(), Key{0});
}

void VerbsTest::pasteCentresOnThePointByGridSteps_data() {
    QTest::addColumn<bool>("grid");
    QTest::addColumn<double>("x");
    QTest::newRow("grid") << true << 10.0;
    QTest::newRow("free") << false << 10.1;
}

void VerbsTest::pasteCentresOnThePointByGridSteps() {
    QFETCH(bool, grid);
    QFETCH(double, x);
    Editor editor({2});
    editor.toolbox.snap.grid = grid;
    const std::string text = copied(editor.document.current());
    QVERIFY(editor.run(pasted(editor.toolbox.context(), text, Vec2(10.1, 0))));
    QCOMPARE(editor.body(editor.newest().key).position.x(), x);
}

void VerbsTest::aSecondShipIsNotPasted() {
    Editor editor({5});
    const std::string text = copied(editor.document.current());
    QVERIFY(!editor.run(pasted(editor.toolbox.context(), text, Vec2(0, 0))));
    editor.document.select(Selection({4, 5}));
    QVERIFY(editor.run(pasted(editor.toolbox.context(), copied(editor.document.current()), Vec2(0, 0))));
    QCOMPARE(editor.level().objects.size(), 8);
    QCOMPARE(editor.document.selection().size(), 1);
}

void VerbsTest::whatIsNoLevelTextPastesNothing_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("words") << QByteArray("Dear Anna, the level is attached.");
    QTest::newRow("other json") << QByteArray("{\"a\": [1, 2, 3]}");
    QTest::newRow("list of numbers") << QByteArray("[1, 2, 3]");
    QTest::newRow("cut off") << QByteArray("[{\"type\": \"body\", \"sha");
    QTest::newRow("not text") << QByteArray("\xff\xfe\x00\x01", 4);
}

void VerbsTest::whatIsNoLevelTextPastesNothing() {
    QFETCH(QByteArray, text);
    Editor editor({});
    QVERIFY(!editor.run(pasted(editor.toolbox.context(), text.toStdString(), Vec2(0, 0))));
    QVERIFY(editor.level() == everything());
}

SPACETOW_TEST(VerbsTest)
#include "verbs_test.moc"
