#include "editor/panels/tag_matrix_panel.h"

#include "core/game/session.h"
#include "tests/support/test_main.h"
#include "tests/support/window.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object taggedBody(Key key, TagMask tags, TagMask touches = TagMask::all()) {
    BodyObject made;
    made.kind = BodyKind::Dynamic;
    made.shapes = {Circle{}};
    made.filter = {tags, touches};
    return {key, {}, made, {}};
}

Level levelOfTagged(const std::vector<Object>& objects) {
    Level level;
    for (const Object& object : objects) {
        level.objects.append(object);
    }
    return level;
}

struct TagMatrixFixture {
    explicit TagMatrixFixture(const std::vector<Object>& objects) : document(levelOfTagged(objects)), panel(document) {
        panel.resize(500, 500);
        panel.show();
    }
    TagMask touches(int index) { return std::get<BodyObject>(document.level().objects[index].data).filter.touches; }
    void click(int a, int b) {
        QTest::mouseClick(&panel.view(), Qt::LeftButton, {}, panel.view().cellOf(a, b).center());
    }

    Document document;
    TagMatrixPanel panel;
};

} // namespace

class TagMatrixTest : public QObject {
    Q_OBJECT

  private slots:
    void everyPairHasOneCellThatNoneElseHas() {
        TagMatrixFixture test({taggedBody(1, TagMask{1U << 9})});
        TagMatrixView& view = test.panel.view();
        int cells = 0;
        for (int y = 2; y < view.height(); y += 4) {
            for (int x = 2; x < view.width(); x += 4) {
                const auto pair = view.pairAt({x, y});
                cells += pair ? 1 : 0;
                QVERIFY(!pair || view.cellOf(pair->a, pair->b).contains(x, y));
                QVERIFY(!pair || view.cellOf(pair->b, pair->a).contains(x, y));
                QVERIFY(!pair || !view.nameAt({x, y}));
            }
        }
        QVERIFY(cells > 100);
        QVERIFY(view.rect().contains(view.cellOf(9, wallTag)));
    }

    void aClickPartsAndJoinsThoseOfTwoTags() {
        TagMatrixFixture test({taggedBody(1, TagMask::bit(wallTag)), taggedBody(2, TagMask::bit(debrisTag))});
        test.click(wallTag, debrisTag);
        QVERIFY(!test.touches(0).contains(debrisTag) && !test.touches(1).contains(wallTag));
        QVERIFY(test.touches(0).contains(wallTag) && test.touches(0).contains(17));
        QCOMPARE(test.document.undoLabel().code.text(), std::string("change-tags"));
        test.click(debrisTag, wallTag);
        QVERIFY(test.touches(0) == TagMask::all() && test.touches(1) == TagMask::all());
        test.document.undo();
        QVERIFY(!test.touches(0).contains(debrisTag));
    }

    void whatTouchedInTheLastRunIsMarked() {
        Object floor = taggedBody(1, TagMask::bit(6));
        std::get<BodyObject>(floor.data).kind = BodyKind::Static;
        Object touching = taggedBody(2, TagMask::bit(7));
        std::get<BodyObject>(touching.data).position = {1.5, 0};
        Object passing = taggedBody(3, TagMask::bit(8), TagMask{});
        std::get<BodyObject>(passing.data).position = {-1.5, 0};
        TagMatrixFixture test({floor, touching, passing});
        TagMatrixView& view = test.panel.view();
        const auto seen = [&view](int a, int b) { return view.grab(view.cellOf(a, b)).toImage(); };
        const QImage before = seen(6, 7);
        const QImage beforePassing = seen(6, 8);
        const QImage beforeOthers = seen(7, 8);
        Session session(test.document.level());
        session.setExplains(true);
        session.step(Controls{});
        test.panel.showTouches(session.tagTouches());
        QVERIFY(view.textFor(6, 7).contains("did touch") && !view.textFor(6, 7).contains("met"));
        QVERIFY(view.textFor(8, 6).contains("met in the last run") && !view.textFor(8, 6).contains("did touch"));
        QVERIFY(!view.textFor(7, 8).contains("last run"));
        QVERIFY(seen(6, 7) != before);
        QVERIFY(seen(6, 8) != beforePassing);
        QVERIFY(seen(6, 8) != seen(6, 7));
        QVERIFY(seen(7, 8) == beforeOthers);
    }

    void theKeysGoFromCellToCell() {
        TagMatrixFixture test({taggedBody(1, TagMask::bit(wallTag))});
        TagMatrixView& view = test.panel.view();
        view.setFocus();
        for (int i = 0; i < 40; ++i) {
            QTest::keyClick(&view, Qt::Key_Right); // the first row ends with the pair of its tag with itself
        }
        QTest::keyClick(&view, Qt::Key_Space);
        QVERIFY(!test.touches(0).contains(wallTag));
        QTest::keyClick(&view, Qt::Key_Left);
        QTest::keyClick(&view, Qt::Key_Return);
        QVERIFY(!test.touches(0).contains(shipTag));
        QTest::keyClick(&view, Qt::Key_Down);
        QTest::keyClick(&view, Qt::Key_Space); // nobody is a ship or a payload here
        QVERIFY(test.document.position() == 2);
    }

    void whatTheGameLaysDownCannotBeChanged() {
        TagMatrixFixture test({{1, {}, ShipObject{}, {}}, {2, {}, FinishObject{}, {}}, {3, {}, PayloadObject{}, {}}});
        test.click(shipTag, finishTag);
        test.click(shipTag, payloadTag);
        QVERIFY(!test.document.canUndo());
    }

    void aTagIsRenamedAndItsObjectsAreSelected() {
        TagMatrixFixture test(
            {taggedBody(1, TagMask::bit(wallTag)), taggedBody(2, TagMask::bit(debrisTag)), taggedBody(3, TagMask{1})});
        test.panel.rename(wallTag);
        QVERIFY(test.panel.nameLine().isVisible());
        test.panel.nameLine().setText("ship");
        QTest::keyClick(&test.panel.nameLine(), Qt::Key_Return);
        QVERIFY(test.panel.nameLine().isVisible()); // the name is taken
        QCOMPARE(test.document.level().tags[wallTag].name, std::string("wall"));
        test.panel.nameLine().setText("rock");
        QTest::keyClick(&test.panel.nameLine(), Qt::Key_Return);
        QCOMPARE(test.document.level().tags[wallTag].name, std::string("rock"));
        QVERIFY(!test.panel.nameLine().isVisible());
        Q_EMIT test.panel.view().selectionWanted(wallTag);
        QVERIFY(test.document.selection() == Selection({1, 3}));
    }

    void tagsAreWrittenOnTheCanvasInTheirColours() {
        TestWindow test;
        Level level = levelOfTagged({taggedBody(1, TagMask{1})});
        level.tags.set(0, {"rock", 0x12cd34});
        test.document().reset(level);
        test.window->setLegendShown(false); // which has the colour as well
        test.canvas().fitLevel();
        const auto dots = [&test] {
            const QImage image = test.canvas().grab().toImage();
            int count = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    count += (image.pixel(x, y) & 0xffffffU) == 0x12cd34U ? 1 : 0;
                }
            }
            return count;
        };
        QCOMPARE(dots(), 0);
        test.trigger(Act::OverlayTags);
        QVERIFY(dots() > 20);
        test.canvas().zoom(1e-4); // a label would hide what it is about
        QCOMPARE(dots(), 0);
        test.canvas().fitLevel();
        QVERIFY(dots() > 20);
        GroupObject group;
        Level grouped = level;
        grouped.objects.append({7, {}, group, {}});
        grouped.objects.replace(0, [&level] {
            Object member = level.objects[0];
            member.parent = 7;
            return member;
        }());
        test.document().reset(grouped);
        QVERIFY(dots() > 20);
        Object hidden = grouped.objects[1];
        hidden.visible = false;
        grouped.objects.replace(1, hidden);
        test.document().reset(grouped);
        QCOMPARE(dots(), 0); // what is hidden says nothing
        test.document().reset(level);
        test.trigger(Act::OverlaysOff);
        QCOMPARE(dots(), 0);
    }

    void whatTheSelectionCollidesWithIsMarkedOnTheCanvas() {
        TestWindow test;
        test.document().reset(levelOfTagged(
            {taggedBody(1, TagMask{1}, TagMask{2}), taggedBody(2, TagMask{2}), taggedBody(3, TagMask{4}, TagMask{8})}));
        test.document().select(Selection({1}));
        QVERIFY(test.canvas().highlighted().empty());
        test.trigger(Act::ShowCollisions);
        QCOMPARE(test.canvas().highlighted(), std::vector<Key>{2});
        test.document().select(Selection({3}));
        QVERIFY(test.canvas().highlighted().empty());
        test.document().select(Selection({2}));
        QCOMPARE(test.canvas().highlighted(), std::vector<Key>{1});
        const QImage marked = test.canvas().grab().toImage();
        test.trigger(Act::ShowCollisions);
        QVERIFY(test.canvas().highlighted().empty());
        QVERIFY(test.canvas().grab().toImage() != marked);
    }
};

SPACETOW_TEST(TagMatrixTest)
#include "tag_matrix_test.moc"
