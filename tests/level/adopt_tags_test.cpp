#include "core/level/adopt_tags.h"

#include "core/level/codes.h"
#include "tests/support/test_main.h"

using namespace spacetow;

namespace {

Object foreignBody(Key key, TagMask tags, TagMask touches = TagMask::all()) {
    BodyObject made;
    made.shapes = {Circle{}};
    made.filter = {tags, touches};
    return {key, {}, made, {}};
}

Filter adoptedFilter(const AdoptedObjects& adopted) {
    return std::get<BodyObject>(adopted.objects.front().data).filter;
}

} // namespace

class AdoptTagsTest : public QObject {
    Q_OBJECT

  private slots:
    void tagsOfOneNameAreOne() {
        ForeignObjects foreign{{foreignBody(1, TagMask::bit(9), TagMask::bit(shipTag))}, {}};
        foreign.tags.set(9, {"lava", 0xff0000});
        Level level;
        level.tags.set(20, {"lava", 0x00ff00});
        const AdoptedObjects adopted = withTagsAdopted(level, foreign);
        QVERIFY(adoptedFilter(adopted) == (Filter{TagMask::bit(20), TagMask::bit(shipTag)}));
        QVERIFY(adopted.level == level);
        QVERIFY(adopted.notes.empty());
    }

    void aTagThatTheLevelLacksIsMadeInItWithItsColour() {
        ForeignObjects foreign{{foreignBody(1, TagMask{1U | 1U << 9}, TagMask{~(1U << 10)})}, {}};
        foreign.tags.set(9, {"lava", 0xff0000});
        foreign.tags.set(10, {"ice", 0x0000ff});
        foreign.tags.set(11, {"unused", 1});
        const AdoptedObjects adopted = withTagsAdopted(Level(), foreign);
        const std::optional<int> lava = adopted.level.tags.indexOf("lava");
        const std::optional<int> ice = adopted.level.tags.indexOf("ice");
        QVERIFY(lava && ice && !adopted.level.tags.indexOf("unused"));
        QCOMPARE(adopted.level.tags[*lava].color, 0xff0000U);
        QVERIFY(adoptedFilter(adopted).tags == (TagMask::bit(wallTag) | TagMask::bit(*lava)));
        QCOMPARE(adoptedFilter(adopted).touches.bits, ~TagMask::bit(*ice).bits);
        QCOMPARE(adopted.notes, (std::vector<Error>{{LevelCode("tags-made"), {"lava, ice"}}}));
    }

    void aTagThatIsInUseWithoutANameIsNotTaken() {
        ForeignObjects foreign{{foreignBody(1, TagMask::bit(9))}, {}};
        foreign.tags.set(9, {"lava", 0});
        Level level;
        level.objects.append(foreignBody(7, TagMask::bit(5), TagMask{~(1U << 6)}));
        const AdoptedObjects adopted = withTagsAdopted(level, foreign);
        QCOMPARE(adopted.level.tags.indexOf("lava"), std::optional(7));
    }

    void aNumberedTagDoesNotBecomeAnotherTag() {
        const ForeignObjects foreign{{foreignBody(1, TagMask::bit(17))}, {}};
        Level level;
        QVERIFY(adoptedFilter(withTagsAdopted(level, foreign)).tags == TagMask::bit(17));
        level.tags.set(17, {"ice", 0});
        const TagMask tags = adoptedFilter(withTagsAdopted(level, foreign)).tags;
        QVERIFY(!tags.contains(17) && !(tags == TagMask{}));
        QVERIFY(!tags.intersects(level.tags.named()));
    }

    void theGamesOwnTagsAreKnownByTheirIndex() {
        ForeignObjects foreign{{foreignBody(1, TagMask::bit(wallTag))}, {}};
        foreign.tags.set(wallTag, {"rock", 0});
        const AdoptedObjects adopted = withTagsAdopted(Level(), foreign);
        QVERIFY(adoptedFilter(adopted).tags == TagMask::bit(wallTag));
        QCOMPARE(adopted.notes, (std::vector<Error>{{LevelCode("tag-renamed"), {"rock", "wall"}}}));
        Level level;
        level.tags.set(12, {"rock", 0});
        QVERIFY(adoptedFilter(withTagsAdopted(level, foreign)).tags == TagMask::bit(12));
    }

    void whatHasNoRoomIsLeftOffAndTold() {
        ForeignObjects foreign{{foreignBody(1, TagMask{1U | 1U << 9})}, {}};
        foreign.tags.set(9, {"lava", 0});
        Level level;
        for (int i = 0; i < TagTable::size; ++i) {
            level.tags.set(i, {i == wallTag ? "wall" : "tag " + std::to_string(i), 0});
        }
        const AdoptedObjects adopted = withTagsAdopted(level, foreign);
        QVERIFY(adoptedFilter(adopted).tags == TagMask::bit(wallTag));
        QVERIFY(adopted.level == level);
        QCOMPARE(adopted.notes, (std::vector<Error>{{LevelCode("tags-dropped"), {"lava"}}}));
    }
};

SPACETOW_TEST(AdoptTagsTest)
#include "adopt_tags_test.moc"
