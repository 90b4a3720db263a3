#include "core/level/compare.h"

#include "core/level/arrange.h"
#include "core/level/edits.h"
#include "core/level/file.h"
#include "core/level/groups.h"
#include "tests/support/cpu_time.h"
#include "tests/support/random_level.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

using ComparedKeys = std::vector<Key>;

Level threeBalls() {
    Level level;
    for (const Key key : {1u, 2u, 3u}) {
        BodyObject body;
        body.position = {double(key), 0};
        body.shapes = {Circle{{0, 0}, 0.5}};
        level.objects.append({key, "ball", body, {}});
    }
    return level;
}

template <class Change>
Level withBall(Level level, Key key, Change change) {
    Object object = *level.objects.find(key);
    change(object, std::get<BodyObject>(object.data));
    level.objects.replace(level.objects.indexOf(key), object);
    return level;
}

/// Of the one object that is different.
ObjectDifference only(const Level& before, const Level& after) {
    const LevelDifference difference = differenceBetween(before, after);
    EXPECTS(difference.objects.size() == 1);
    return difference.objects.front();
}

QStringList names(const std::vector<FieldDifference>& fields) {
    QStringList result;
    for (const FieldDifference& field : fields) {
        result << QString::fromStdString(field.id);
    }
    return result;
}

} // namespace

class CompareTest : public QObject {
    Q_OBJECT

  private slots:
    void aLevelIsNoDifferentFromWhatIsReadFromItsFile() {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const Level level = randomLevel(seed);
            QVERIFY2(differenceBetween(level, *parseLevel(levelText(level)).level).empty(), seedText(seed));
        }
    }

    void whatComesAndGoesIsTold() {
        const Level before = threeBalls();
        Level after = removed(before, ComparedKeys{2});
        after = added(after, {9, "new", BodyObject{.shapes = {Circle{}}}, {}});
        const LevelDifference difference = differenceBetween(before, after);
        QCOMPARE(difference.objects.size(), std::size_t(2));
        QCOMPARE(difference.objects[0].key, Key(2));
        QCOMPARE(difference.objects[0].change, ObjectChange::Removed);
        QCOMPARE(difference.objects[1].key, Key(9));
        QCOMPARE(difference.objects[1].change, ObjectChange::Added);
    }

    void aMoveIsAMoveWhetherOfTheBodyOrOfAllItsShapes() {
        const Level before = threeBalls();
        const ObjectDifference body = only(before, moved(before, ComparedKeys{2}, {1, 0}));
        QCOMPARE(body.change, ObjectChange::Moved);
        QCOMPARE(names(body.fields), QStringList{"position.x"});
        QCOMPARE(std::get<double>(body.fields.front().before), 2.0);
        QCOMPARE(std::get<double>(body.fields.front().after), 3.0);
        const ObjectDifference shapes = only(before, withBall(before, 2, [](Object&, BodyObject& ball) {
                                                 std::get<Circle>(ball.shapes[0]).center = {0, 4};
                                             }));
        QCOMPARE(shapes.change, ObjectChange::Moved);
        QVERIFY(shapes.shapesMoved && !shapes.shapesChanged);
    }

    void tagsFieldsAndShapesAreToldApart() {
        const Level before = threeBalls();
        const ObjectDifference tags =
            only(before, withBall(before, 1, [](Object&, BodyObject& ball) { ball.filter.tags = TagMask{6}; }));
        QCOMPARE(tags.change, ObjectChange::Retagged);
        const ObjectDifference field = only(before, withBall(before, 1, [](Object& object, BodyObject& ball) {
                                                object.name = "stone";
                                                ball.friction = 0.7;
                                            }));
        QCOMPARE(field.change, ObjectChange::Changed);
        QCOMPARE(names(field.fields), (QStringList{"name", "friction"}));
        const ObjectDifference shape =
            only(before,
                 withBall(before, 1, [](Object&, BodyObject& ball) { std::get<Circle>(ball.shapes[0]).radius = 2; }));
        QCOMPARE(shape.change, ObjectChange::Changed);
        QVERIFY(shape.shapesChanged && shape.fields.empty());
        const ObjectDifference kind = only(before, [&] {
            Level after = before;
            after.objects.replace(0, {1, "ball", ShipObject{}, {}});
            return after;
        }());
        QVERIFY(kind.otherKind);
        QCOMPARE(kind.change, ObjectChange::Changed);
    }

    void ofANewOrderOnlyThoseAreNamedThatHaveLeftTheirPlace() {
        const Level before = threeBalls();
        const ObjectDifference first = only(before, reordered(before, ComparedKeys{1}, OrderTo::Front));
        QCOMPARE(first.key, Key(1));
        QCOMPARE(first.change, ObjectChange::Reordered);
    }

    void theLevelsOwnFieldsTagsAndGuidesAreCompared() {
        const Level before = threeBalls();
        Level after = before;
        after.gravity.y() = -2;
        after.rules.lives = 5;
        after.tags.set(9, {"lava", 0xff0000});
        after.guides.push_back({{1, 2}, 0, "floor"});
        const LevelDifference difference = differenceBetween(before, after);
        QCOMPARE(names(difference.fields), (QStringList{"gravity.y", "lives"}));
        QCOMPARE(difference.tags.size(), std::size_t(1));
        QCOMPARE(difference.tags.front().after.name, std::string("lava"));
        QCOMPARE(difference.guidesAdded.size(), std::size_t(1));
        QCOMPARE(differenceBetween(after, before).guidesRemoved.size(), std::size_t(1));
        QVERIFY(difference.objects.empty());
    }

    void everyFieldOfEveryKindCountsAndNothingElseDoes() {
        const Level full = populatedLevel();
        Level plain = full;
        for (int i = 0; i < full.objects.size(); ++i) {
            Object object = full.objects[i];
            object.unknownFields = R"({"/glow": 7})";
            plain.objects.replace(i, object);
            QVERIFY(only(full, plain).unknownFields);
            plain = full;
        }
        QVERIFY(differenceBetween(full, plain).empty());
    }

    void whatIsTakenOverBringsWhatItRefersToAndMeansTheSame() {
        Level level = withTag(Level(), 9, {"lava"});
        level.objects.append({1, "floor", BodyObject{.shapes = {Circle{}}}, {}});
        Level other = withTag(Level(), 9, {"ice"});
        other.objects.append({5, "first", BodyObject{.shapes = {Circle{}}}, {}});
        other.objects.append({1, "floor", BodyObject{.shapes = {Circle{}}}, {}});
        other.objects.append({2, "group", GroupObject{}, {}});
        other.objects.append({3, "ball", BodyObject{.shapes = {Circle{}}}, {}, 2});
        other.objects.append({4, "rope", ConnectorObject{.a = 1, .b = 3}, {}});
        Object ball = *other.objects.find(3);
        std::get<BodyObject>(ball.data).filter.tags = TagMask::bit(9);
        other.objects.replace(other.objects.indexOf(3), ball);
        const Level result = takenOver(level, other, std::vector<Key>{4, 5});
        std::vector<Key> keys;
        for (const Object& object : result.objects) {
            keys.push_back(object.key);
        }
        QCOMPARE(keys, (std::vector<Key>{5, 1, 2, 3, 4}));
        const auto ice = result.tags.indexOf("ice");
        QVERIFY(ice && *ice != 9 && result.tags[9].name == "lava");
        QCOMPARE(std::get<BodyObject>(result.objects.find(3)->data).filter.tags, TagMask::bit(*ice));
        QVERIFY(takenOver(result, level, std::vector<Key>{2, 3, 4, 5}).objects == level.objects);
    }

    void manyObjectsAreTakenOverInTime() {
        Level other;
        std::vector<Key> keys;
        for (Key key = 1; key <= 20'000; ++key) {
            other.objects.append({key, {}, BodyObject{.shapes = {Circle{}}}, {}});
            keys.push_back(key);
        }
        const CpuTimer timer;
        QVERIFY(takenOver(Level(), other, keys).objects == other.objects);
        QVERIFY2(timer.seconds() < 1, qPrintable(QString::number(timer.seconds())));
    }
};

SPACETOW_TEST(CompareTest)
#include "compare_test.moc"
