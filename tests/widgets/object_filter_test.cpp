#include "editor/panels/object_filter.h"

#include "tests/support/body_with.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// Of these: a wall (1) "Left wall" with the tag "ice", a hidden moving circle (2), a layer (3) "Back", a ship (4).
Level filtered() {
    Level level;
    level.tags.set(7, {"ice", 0xffffff});
    level.tags.set(8, {"big rock", 0xffffff});
    Object wall = bodyWith(1, EdgeChain{{{0, 0}, {1, 0}}});
    wall.name = "Left wall";
    std::get<BodyObject>(wall.data).filter.tags = TagMask::bit(7);
    level.objects.append(wall);
    Object circle = bodyWith(2, Circle{{0, 0}, 1});
    std::get<BodyObject>(circle.data).kind = BodyKind::Dynamic;
    std::get<BodyObject>(circle.data).filter.tags = TagMask::bit(8);
    circle.visible = false;
    level.objects.append(circle);
    level.objects.append({3, "Back", GroupObject{true, {}}, {}});
    level.objects.append({4, "", ShipObject{}, {}});
    return level;
}

} // namespace

class ObjectFilterTest : public QObject {
    Q_OBJECT

  private slots:
    void wordsFindObjects_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QList<int>>("keys");
        QTest::newRow("nothing") << "  " << QList<int>{1, 2, 3, 4};
        QTest::newRow("part of a name") << "LEFT" << QList<int>{1};
        QTest::newRow("the kind in place of a name") << "ship" << QList<int>{4};
        QTest::newRow("words in any order") << "wall left" << QList<int>{1};
        QTest::newRow("words with a blank") << "\"left wall\"" << QList<int>{1};
        QTest::newRow("words that are not there") << "\"wall left\"" << QList<int>();
        QTest::newRow("shape") << "kind:wall" << QList<int>{1};
        QTest::newRow("part of a kind") << "kind:circ" << QList<int>{2};
        QTest::newRow("motion") << "kind:dynamic" << QList<int>{2};
        QTest::newRow("any body") << "kind:body" << QList<int>{1, 2};
        QTest::newRow("layer") << "kind:layer" << QList<int>{3};
        QTest::newRow("layers are groups") << "kind:group" << QList<int>{3};
        QTest::newRow("tag") << "tag:ice" << QList<int>{1};
        QTest::newRow("tag with a blank") << "tag:\"big rock\"" << QList<int>{2};
        QTest::newRow("unknown tag") << "tag:none" << QList<int>();
        QTest::newRow("hidden") << "is:hidden" << QList<int>{2};
        QTest::newRow("not hidden") << "-is:hidden" << QList<int>{1, 3, 4};
        QTest::newRow("both") << "kind:body -tag:ice" << QList<int>{2};
    }
    void wordsFindObjects() {
        QFETCH(const QString, text);
        QFETCH(const QList<int>, keys);
        const Level level = filtered();
        ObjectFilter filter(text);
        filter.prepare(level.tags);
        QList<int> found;
        for (const Object& object : level.objects) {
            if (filter.finds(object)) {
                found << static_cast<int>(object.key);
            }
        }
        QCOMPARE(found, keys);
    }

    void everyKindThatIsOfferedFindsSomething() {
        for (const QString& kind : ObjectFilter::kinds()) {
            ObjectFilter filter(ObjectFilter::term("kind", kind));
            Level level = filtered();
            level.objects.append(bodyWith(5, Polygon{{{0, 0}, {1, 0}, {0, 1}}}));
            level.objects.append(bodyWith(6, LineChain{{{0, 0}, {1, 0}}}));
            Object moving = bodyWith(7, Circle{{0, 0}, 1});
            std::get<BodyObject>(moving.data).kind = BodyKind::Kinematic;
            level.objects.append(moving);
            level.objects.append({8, "", PayloadObject{}, {}});
            level.objects.append({9, "", FinishObject{}, {}});
            level.objects.append({10, "", ConnectorObject{1, 2, {0, 0}, {0, 0}}, {}});
            int found = 0;
            for (const Object& object : level.objects) {
                found += filter.finds(object) ? 1 : 0;
            }
            QVERIFY2(found > 0 && found < level.objects.size() / 2 + 1, qPrintable(kind));
        }
    }
};

SPACETOW_TEST(ObjectFilterTest)
#include "object_filter_test.moc"
