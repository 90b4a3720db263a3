#include "core/level/level.h"

#include "core/game/ship.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object named(Key key, std::string name) {
    return {key, std::move(name), ShipObject(), {}};
}

std::string order(const ObjectList& list) {
    std::string names;
    for (const Object& object : list) {
        names += object.name;
    }
    return names;
}

ObjectList abcd() {
    ObjectList list;
    for (const char c : std::string("abcd")) {
        list.append(named(static_cast<Key>(c), std::string(1, c)));
    }
    return list;
}

} // namespace

class LevelTest : public QObject {
    Q_OBJECT

  private slots:
    void anObjectIsFoundByItsKey() {
        const ObjectList list = abcd();
        QCOMPARE(list.indexOf('c'), 2);
        QCOMPARE(list.indexOf('x'), -1);
        QCOMPARE(list.find('d')->name, std::string("d"));
        QVERIFY(list.find('x') == nullptr);
    }

    void insertingReplacingAndErasingKeepTheOrder() {
        ObjectList list = abcd();
        list.insert(1, named('x', "x"));
        list.replace(0, named('y', "y"));
        list.erase(3);
        QCOMPARE(order(list), std::string("yxbd"));
        list.eraseIf([](const Object& object) { return object.key < 'x'; });
        QCOMPARE(order(list), std::string("yx"));
    }

    void aCopySharesItsPiecesUntilTheyAreReplaced() {
        const ObjectList original = abcd();
        ObjectList copy = original;
        copy.replace(1, named('b', "b"));
        QVERIFY(copy == original);
        QVERIFY(copy.sharesPiece(0, original));
        QVERIFY(!copy.sharesPiece(1, original));
        copy.replace(1, named('b', "other"));
        QVERIFY(!(copy == original));
    }

    void equalLevelsAreEqualInValue() {
        QVERIFY(randomLevel(7) == randomLevel(7));
        QVERIFY(!(randomLevel(7) == randomLevel(8)));
    }

    void freshKeysAreNeitherZeroNorTaken() {
        Level level;
        for (int i = 0; i < 200; ++i) {
            const Key key = freshKey(level, 5);
            QVERIFY(key != 0 && level.objects.find(key) == nullptr);
            level.objects.append(named(key, ""));
        }
        QCOMPARE(freshKey(level, 9), freshKey(level, 9));
    }

    void theOutlineOfTheShipIsItsHull() {
        const auto outline = shipOutline();
        const Polygon hull = shipHull();
        QCOMPARE(hull.vertices.size(), outline.size());
        for (std::size_t i = 0; i < outline.size(); ++i) {
            QVERIFY((hull.vertices[i] - outline[i]).norm() < 1e-12);
        }
    }

    void aNewTableNamesTheTagsOfTheGame() {
        const TagTable tags;
        QCOMPARE(tags.named().bits, 0x1fu);
        QCOMPARE(tags.indexOf("payload"), std::optional(payloadTag));
        QCOMPARE(tags.indexOf(""), std::nullopt);
        for (int i = 0; i < 5; ++i) {
            for (int j = 0; j < i; ++j) {
                QVERIFY(tags[i].color != tags[j].color);
            }
        }
        QCOMPARE(TagTable::empty().named().bits, 0u);
    }
};

SPACETOW_TEST(LevelTest)
#include "level_test.moc"
