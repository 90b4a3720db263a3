#include "core/level/field_survey.h"

#include "core/level/field_edits.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <algorithm>

using namespace spacetow;

namespace {

Object bodyMadeOf(Key key, std::vector<LevelShape> shapes) {
    BodyObject body;
    body.shapes = std::move(shapes);
    return {key, {}, body, {}};
}

Circle circleOf(double radius) {
    return {Vec2(0, 0), radius};
}

std::vector<FieldSummary> surveyed(const std::vector<Object>& objects, std::span<const int> shapes = {}) {
    FieldSurvey survey;
    for (const Object& object : objects) {
        survey.add(object, shapes);
    }
    return survey.summaries();
}

FieldEdit editTo(std::string id, FieldValue value) {
    return {std::move(id), [value](const FieldValue&) { return std::optional(value); }};
}

Level levelHolding(std::vector<Object> objects) {
    Level level;
    for (Object& object : objects) {
        level.objects.append(std::move(object));
    }
    return level;
}

double radiusIn(const Level& level, int object, std::size_t shape) {
    const auto& body = std::get<BodyObject>(level.objects[object].data);
    return std::get<Circle>(body.shapes[shape]).radius;
}

/// One object of every kind, and a body of every kind of shape.
std::vector<Object> everyKind() {
    std::vector<Object> objects{bodyMadeOf(1, {circleOf(0.5), EdgeChain{{{0, 0}, {1, 0}}, false, 0.25},
                                               LineChain{{{0, 0}, {1, 0}}, false}, Polygon{{{0, 0}, {1, 0}, {0, 1}}}}),
                                {2, "ship", ShipObject{{1, 2}, 0.5}, {}},
                                {3, "payload", PayloadObject{{3, 4}, 0.3, 2}, {}},
                                {4, "finish", FinishObject{{0, 0}, {2, 2}}, {}}};
    ConnectorObject connector;
    connector.a = 1;
    connector.b = 2;
    connector.length = 2;
    objects.push_back({5, "rope", connector, {}});
    return objects;
}

} // namespace

class FieldSurveyTest : public QObject {
    Q_OBJECT

  private slots:
    void shapesOfOneBodyThatDifferAreMixed() {
        const auto fields = surveyed({bodyMadeOf(1, {circleOf(0.2), circleOf(0.5)})});
        const FieldSummary* found = summaryOf(fields, "radius");
        QVERIFY(found != nullptr && found->isMixed && found->isOfShape);
        QCOMPARE(found->count, 1);
        QVERIFY(!summaryOf(surveyed({bodyMadeOf(1, {circleOf(0.2), circleOf(0.2)})}), "radius")->isMixed);
    }

    void onlyTheShapesThatAreMeantAreLookedAt() {
        const std::vector<int> second{1};
        const auto fields = surveyed({bodyMadeOf(1, {circleOf(0.2), circleOf(0.5)})}, second);
        QCOMPARE(std::get<double>(summaryOf(fields, "radius")->value), 0.5);
        QVERIFY(!summaryOf(fields, "radius")->isMixed);
        const std::vector<int> none{7};
        QVERIFY(summaryOf(surveyed({bodyMadeOf(1, {circleOf(0.2)})}, none), "radius") == nullptr);
    }

    void fieldsOfDifferentKindsAreOneWhenTheyHaveOneName() {
        const auto fields = surveyed(everyKind());
        QCOMPARE(summaryOf(fields, "position.x")->count, 3);
        QVERIFY(summaryOf(fields, "position.x")->isMixed);
        QCOMPARE(summaryOf(fields, "name")->count, 5);
        QCOMPARE(summaryOf(fields, "stiffness")->count, 1);
        QVERIFY(!summaryOf(fields, "stiffness")->isMixed);
        QCOMPARE(summaryOf(fields, "radius")->count, 2);
        QVERIFY(summaryOf(fields, "no such field") == nullptr);
        // Ends of a connector are keys, those of a finish are points.
        QVERIFY(std::holds_alternative<KeyValue>(summaryOf(fields, "a")->value));
        QVERIFY(std::holds_alternative<double>(summaryOf(fields, "a.x")->value));
    }

    void whatDiffersFromItsDefaultIsKnown() {
        Object object = bodyMadeOf(1, {circleOf(1)});
        QVERIFY(summaryOf(surveyed({object}), "density")->isStandard);
        std::get<BodyObject>(object.data).density = 2;
        const auto fields = surveyed({object, bodyMadeOf(2, {circleOf(1)})});
        QVERIFY(!summaryOf(fields, "density")->isStandard);
        QCOMPARE(std::get<double>(summaryOf(fields, "density")->standard), 1.0);
        QVERIFY(!summaryOf(fields, "radius")->hasStandard); // is required
        QVERIFY(std::holds_alternative<Unset>(summaryOf(fields, "mass")->standard));
    }

    void masksAreJoinedBitByBit() {
        Object a = bodyMadeOf(1, {circleOf(1)});
        Object b = bodyMadeOf(2, {circleOf(1)});
        std::get<BodyObject>(a.data).filter = {TagMask{3}, TagMask::all()};
        std::get<BodyObject>(b.data).filter = {TagMask{6}, TagMask{5}};
        const auto fields = surveyed({a, b});
        QCOMPARE(summaryOf(fields, "tags")->any.bits, 7U);
        QCOMPARE(summaryOf(fields, "tags")->every.bits, 2U);
        QCOMPARE(summaryOf(fields, "touches")->exceptions, 1);
    }

    void everyFieldOfEveryKindCanBeSetToWhatItIs() {
        for (Object object : everyKind()) {
            const Object before = object;
            for (const FieldSummary& field : surveyed({before})) {
                const bool isPoints = std::holds_alternative<PointCount>(field.value);
                QCOMPARE(editField(object, editTo(field.id, field.value)), !isPoints);
                QVERIFY2(object == before, field.id.c_str());
            }
        }
    }

    void everyFieldOfEveryKindCanBeChangedAndNothingElseIs() {
        for (const Object& before : everyKind()) {
            for (const FieldSummary& field : surveyed({before})) {
                FieldValue other = field.value;
                if (const double* number = std::get_if<double>(&field.value)) {
                    other = *number > 0.5 * (field.field.min + field.field.max) ? field.field.min + 1 : *number + 1;
                    other = field.field.max <= 1 ? FieldValue(*number == 0.25 ? 0.5 : 0.25) : other;
                } else if (const bool* flag = std::get_if<bool>(&field.value)) {
                    other = !*flag;
                } else if (const auto* text = std::get_if<std::string>(&field.value)) {
                    other = *text + "!";
                } else if (const Choice* choice = std::get_if<Choice>(&field.value)) {
                    other = Choice{choice->index == 0 ? 1 : 0};
                } else if (const TagMask* mask = std::get_if<TagMask>(&field.value)) {
                    other = TagMask{mask->bits ^ 2U};
                } else if (const KeyValue* key = std::get_if<KeyValue>(&field.value)) {
                    other = KeyValue{key->key + 1};
                } else if (std::holds_alternative<Unset>(field.value)) {
                    other = field.id == "parent" ? FieldValue(KeyValue{7}) : FieldValue(1.5);
                } else {
                    continue;
                }
                Object object = before;
                QVERIFY2(editField(object, editTo(field.id, other)), field.id.c_str());
                const auto after = surveyed({object});
                for (const FieldSummary& same : surveyed({before})) {
                    const FieldSummary* now = summaryOf(after, same.id);
                    QVERIFY2((now->value == same.value) == (same.id != field.id),
                             (field.id + " changed, looked at " + same.id).c_str());
                }
            }
        }
    }

    void whatIsNotMeantIsLeftAlone() {
        const Level level =
            levelHolding({bodyMadeOf(1, {circleOf(0.2), circleOf(0.5)}), bodyMadeOf(2, {circleOf(0.7)})});
        const std::vector<Key> keys{1};
        const std::vector<ShapeRef> second{{1, 1}};
        const FieldEditResult all = withFieldEdited(level, {keys, {}}, editTo("radius", 3.0));
        QCOMPARE(radiusIn(all.level, 0, 0), 3.0);
        QCOMPARE(radiusIn(all.level, 0, 1), 3.0);
        QCOMPARE(radiusIn(all.level, 1, 0), 0.7);
        QCOMPARE(all.changed, 2);
        const FieldEditResult one = withFieldEdited(level, {keys, second}, editTo("radius", 3.0));
        QCOMPARE(radiusIn(one.level, 0, 0), 0.2);
        QCOMPARE(radiusIn(one.level, 0, 1), 3.0);
        // Other fields are those of the object, whatever shape is meant.
        const FieldEditResult body = withFieldEdited(level, {keys, second}, editTo("density", 3.0));
        QCOMPARE(std::get<BodyObject>(body.level.objects[0].data).density, 3.0);
        QVERIFY(body.level.objects.sharesPiece(1, level.objects));
    }

    void eachValueIsChangedByItself() {
        const Level level =
            levelHolding({bodyMadeOf(1, {circleOf(0.2), circleOf(0.5)}), bodyMadeOf(2, {circleOf(0.75)})});
        const std::vector<Key> keys{1, 2};
        const FieldEditResult doubled = withFieldEdited(
            level, {keys, {}},
            {"radius", [](const FieldValue& value) { return std::optional(FieldValue(2 * std::get<double>(value))); }});
        QCOMPARE(radiusIn(doubled.level, 0, 0), 0.4);
        QCOMPARE(radiusIn(doubled.level, 0, 1), 1.0);
        QCOMPARE(radiusIn(doubled.level, 1, 0), 1.5);
    }

    void valuesOutsideTheirRangeAreRefused() {
        const Level level = levelHolding({bodyMadeOf(1, {circleOf(0.2), circleOf(0.5)})});
        const std::vector<Key> keys{1};
        QCOMPARE(withFieldEdited(level, {keys, {}}, editTo("radius", 0.0)).refused, 2);
        QCOMPARE(withFieldEdited(level, {keys, {}}, editTo("restitution", 1.5)).refused, 1);
        QCOMPARE(withFieldEdited(level, {keys, {}}, editTo("mass", -1.0)).refused, 1);
        QCOMPARE(withFieldEdited(level, {keys, {}}, editTo("restitution", 0.5)).refused, 0);
        QCOMPARE(withLevelFieldEdited(Level(), editTo("lives", 2.5)).refused, 1);
        QCOMPARE(withLevelFieldEdited(Level(), editTo("lives", 7.0)).level.rules.lives, 7);
    }

    void editsOfRandomLevelsLeaveTheirInputUntouched() {
        constexpr std::uint64_t seed = 20261202;
        for (std::uint64_t i = 0; i < 20; ++i) {
            const Level level = test::randomLevel(seed + i);
            const Level copy = level;
            std::vector<Key> keys;
            for (const Object& object : level.objects) {
                keys.push_back(object.key);
            }
            std::ranges::sort(keys);
            FieldSurvey survey;
            for (const Object& object : level.objects) {
                survey.add(object);
            }
            for (const FieldSummary& field : survey.summaries()) {
                const FieldEditResult edited = withFieldEdited(level, {keys, {}}, editTo(field.id, field.value));
                QVERIFY2(level == copy, (field.id + ", seed " + std::to_string(seed + i)).c_str());
                FieldSurvey after;
                for (const Object& object : edited.level.objects) {
                    after.add(object);
                }
                const auto fields = after.summaries();
                const bool isPoints = std::holds_alternative<PointCount>(field.value);
                const bool isNoneOfMany = std::holds_alternative<Unset>(field.value) && !field.mayBeUnset;
                QVERIFY2(isPoints || isNoneOfMany || edited.refused > 0 || !summaryOf(fields, field.id)->isMixed,
                         (field.id + ", seed " + std::to_string(seed + i)).c_str());
            }
        }
    }
};

SPACETOW_TEST(FieldSurveyTest)
#include "field_survey_test.moc"
