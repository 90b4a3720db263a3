#include "core/level/unknown_fields.h"

#include "core/level/fields.h"
#include "core/level/file.h"
#include "core/level/fix_edits.h"
#include "core/level/guides.h"
#include "core/level/key_text.h"
#include "core/level/lint.h"
#include "tests/support/cpu_time.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// A file with the fields in each place where fields can be.
std::string fileWith(const std::string& fields) {
    return R"({"schema": 2, "name": "n", "rules": {"lives": 3, )" + fields + R"(}, "tags": [{"index": 7, )" + fields +
           R"(}], "guides": [{"point": [0, 0], )" + fields + R"(}], "objects": [{"key": "00000001", "type": "body", )" +
           fields + R"(, "shapes": [{"type": "circle", "radius": 1, )" + fields + "}]}], " + fields + "}";
}

int countOf(const std::string& text, const std::string& part) {
    int count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++count;
    }
    return count;
}

const char* const oddFields[] = {R"("x": 123456789012345678901234567890)",
                                 R"("x": 1.10)",
                                 R"("x": 1e-400)",
                                 R"("x": -0)",
                                 R"("x": 1E+5)",
                                 R"("x": 1.0)",
                                 R"("x": 0.1e1)",
                                 R"("x": -9223372036854775809)",
                                 R"("x": null)",
                                 "\"x\": \"\\u00e9\\/\\\"\\\\ é \\ud83d\\ude00\"",
                                 R"("x": "{[,:]}")",
                                 R"("x": [ 1,2.50 , {"a":[]}])",
                                 R"("a\u0062c": 1)",
                                 R"("": 1)",
                                 "\"a\\\"b\\\\\": {\"\\u0063\\\\\\\"\": \"\\\\\\\\\"}",
                                 R"("\u002f\u007e": 1)",
                                 R"("~1/~0/": 1)",
                                 R"("\\": [[]])",
                                 "\"x\": {\n    \"deep\": [\n      1.50\n    ]\n  }",
                                 "\"x\": [\r\n\t1\r\n]",
                                 R"("b": 1, "a": 2, "c": 3)"};
const char* const tagWithoutName = R"({"schema": 2, "tags": [{"index": 5, "name": "ice", "color": "#808080"},)"
                                   R"({"index": 3, "color": "#808080", "slip": 1.50}, {"index": 1}], "objects": []})";
const char* const tagWritten = R"({"index": 3, "name": "", "color": "#808080", "slip": 1.50})";
const char* const tagTwice = R"({"schema": 2, "tags": [{"index": 3, "a": 1}, {"index": 3, "b": 1}], "objects":[]})";

/// Dense, so that little text says much.
std::string manyShips() {
    std::string text = R"({"schema":1,"objects":[)";
    for (int i = 1; i <= 1'400'000; ++i) {
        text += (i > 1 ? ",{\"key\":\"" : "{\"key\":\"") + keyText(static_cast<Key>(i)) + "\",\"type\":\"ship\"}";
    }
    return text + "]}";
}

/// What is wrong with writing and reading once more; empty when all comes back.
std::string wrongWithReturn(const std::string& text) {
    const LevelFile file = parseLevel(text);
    if (!file.level) {
        return std::string(file.problems.at(0).code.text());
    }
    const std::string written = levelText(*file.level);
    const LevelFile again = parseLevel(written);
    if (!again.level) {
        return "what was written is refused: " + std::string(again.problems.at(0).code.text());
    }
    if (!(*again.level == *file.level)) {
        return "another level comes back";
    }
    return levelText(*again.level) == written ? std::string() : "another text comes back";
}

} // namespace

class UnknownFieldsTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsNotUnderstoodComesBackByteForByte_data() {
        QTest::addColumn<QByteArray>("field");
        for (const char* field : oddFields) {
            QTest::newRow(field) << QByteArray(field);
        }
    }
    void whatIsNotUnderstoodComesBackByteForByte() {
        QFETCH(QByteArray, field);
        const std::string text = fileWith(field.toStdString());
        QCOMPARE(wrongWithReturn(text), std::string());
        const std::string written = levelText(*parseLevel(text).level);
        const std::string wanted = field.toStdString();
        if (wanted.find(", \"") == std::string::npos || wanted.find(": 1, ") == std::string::npos) {
            QVERIFY2(countOf(written, wanted) == 6, written.c_str());
        } else { // the fields of the level stand on lines of their own
            QVERIFY2(countOf(written, wanted) >= 3, written.c_str());
        }
    }

    void aFileIsTheSameToTheByteWithValuesOverManyLines() {
        const std::string text = levelText(Level()).insert(levelText(Level()).size() - 3, R"(,
  "weather": {
    "rain": 0.250,
    "wind": [
      1, 2.5
    ]
  })");
        QCOMPARE(levelText(*parseLevel(text).level), text);
    }

    void anEscapedSlashInANameIsOneLikeAnyOther() {
        const std::string text = fileWith(R"("a\/b": 1)");
        QCOMPARE(wrongWithReturn(text), std::string());
        QCOMPARE(countOf(levelText(*parseLevel(text).level), R"("a/b": 1)"), 6);
    }

    void aTagOfWhichOnlyUnknownFieldsAreToldIsKept() {
        const std::string text = tagWithoutName;
        QCOMPARE(wrongWithReturn(text), std::string());
        Level level = *parseLevel(text).level;
        QVERIFY(levelText(level).find(tagWritten) != std::string::npos);
        QVERIFY(levelText(level).find(R"("index": 1)") == std::string::npos);
        level.tags.set(3, {"mud", 0x123456});
        level.tags.set(0, {"wall", 0x123456});
        QVERIFY(levelText(level).find(R"("name": "mud", "color": "#123456", "slip": 1.50})") != std::string::npos);
        QCOMPARE(parseLevel(tagTwice).problems.at(0).code.text(), std::string("unknown-field"));
        QVERIFY(!parseLevel(tagTwice).level);
    }

    void equalLevelsComeBackWhereverTheirUnknownFieldsStand() {
        QCOMPARE(wrongWithReturn(R"({"schema": 1, "name": "n", "rules": {"lives": 3, "flip!": false}, "objects": [],)"
                                 R"( "updateSeco\u0000nds": 0.02, "subspeps": 2})"),
                 std::string());
        QCOMPARE(wrongWithReturn(R"({"z": 1, "objects": [{"b": 1, "shapes": [{"c": 1, "type": "circle", "d": 1,)"
                                 R"( "radius": 1}], "a": 2, "type": "body", "key": "00000001"}], "schema": 2,)"
                                 R"( "guides": [{"q": 0, "point": [0, 0]}], "tags": [{"y": 1, "index": 30, "x": 2},)"
                                 R"( {"index": 2, "w": 2}], "a": 2, "rules": {"n": 1}})"),
                 std::string());
    }

    void fieldsOfGuidesStayWithThem() {
        const std::string text = R"({"schema": 2, "guides": [{"point": [0, 0], "x": 1}, {"point": [1, 0], "x": 2.0},)"
                                 R"( {"point": [2, 0]}], "objects": [], "x": 3})";
        const Level level = guideRemoved(*parseLevel(text).level, 0);
        QVERIFY(levelText(level).find(R"({"point": [1, 0], "x": 2.0})") != std::string::npos);
        QCOMPARE(guidesCleared(level).unknownFields, std::string(R"({"/x": 3})"));
    }

    void fieldsOfHiddenProblemsStayWithThem() {
        const std::string text =
            R"({"schema": 2, "hiddenProblems": [{"rule": "wall-twice", "x": 1}, {"rule": "b", "x": 2.0}],)"
            R"( "objects": []})";
        const Problem first{Severity::Warning, "wall-twice"};
        const Level level = *parseLevel(text).level;
        QVERIFY(withProblemHidden(level, first, true) == level);
        const std::string shown = levelText(withProblemHidden(level, first, false));
        QVERIFY2(shown.find(R"({"rule": "b", "x": 2.0})") != std::string::npos, shown.c_str());
        QVERIFY(withProblemHidden(withProblemHidden(level, first, false), first, true).hiddenProblems.size() == 2);
    }

    void fieldsOfShapesStayWithThemWhenOthersCannotBeBuilt() {
        const std::string text = R"({"schema": 2, "objects": [{"key": "00000001", "type": "body", "shapes": [)"
                                 R"({"type": "lines", "vertices": [[0, 0], [0, 0]], "x": 1},)"
                                 R"( {"type": "circle", "radius": 2, "x": 2.0}]}]})";
        const Level level = withoutUnbuildable(*parseLevel(text).level, 1);
        const std::string written = levelText(level);
        QVERIFY2(written.find(R"({"type": "circle", "radius": 2, "x": 2.0})") != std::string::npos, written.c_str());
    }

    void aFieldThatHasBecomeAKnownOneIsNotWrittenTwice() {
        Level level;
        level.objects.append({1, {}, ShipObject{{0, 0}, 0.5}, R"({"/angle": 7, "/shapes/0/x": 1, "/glow": 2})"});
        const std::string text = levelText(level);
        QVERIFY(text.find(R"("angle": 0.5, "glow": 2})") != std::string::npos);
        QVERIFY(parseLevel(text).level.has_value());
    }

    void fieldsAreTakenApartAndPutTogether() {
        const std::string text = R"({"/a\u0062": 1.0, "/shapes/0/~1": [ ], "/shapes/2/x": "\/"})";
        const std::vector<UnknownField> fields = unknownFields(text);
        QCOMPARE(fields.size(), std::size_t{3});
        QCOMPARE(fields[0].name, std::string(R"(a\u0062)"));
        QCOMPARE(fields[1].place + ' ' + fields[1].name + ' ' + fields[1].value, std::string("/shapes/0 / [ ]"));
        QCOMPARE(unknownFieldsText(fields), text);
        QCOMPARE(withoutEntries(text, "/shapes", std::array{0, 1}),
                 std::string(R"({"/a\u0062": 1.0, "/shapes/0/x": "\/"})"));
        QCOMPARE(withoutEntries({}, "/shapes", std::array{0}), std::string());
    }

    void aHundredThousandUnknownFieldsAreSavedInTimeThatGrowsWithTheirNumber() {
        std::string fields = "\"a\": 0";
        std::string shapes;
        for (int i = 0; i < 50'000; ++i) {
            const std::string field = "\"f" + std::to_string(i) + "\": 0";
            fields += ", " + field;
            shapes += (i > 0 ? ", " : "") + std::string(R"({"type": "circle", "radius": 1, )") + field + '}';
        }
        const std::string text = R"({"schema": 2, "objects": [{"key": "00000001", "type": "body", "shapes": [)" +
                                 shapes + "]}], " + fields + '}';
        const CpuTimer timer;
        const Level level = *parseLevel(text, Checks::FileOnly).level;
        const std::string written = levelText(level);
        constexpr double most = 20; // s; were each compared with all others, it would take minutes
        QVERIFY2(timer.seconds() < most, qPrintable(QString::number(timer.seconds())));
        QVERIFY(*parseLevel(written, Checks::FileOnly).level == level);
    }

    void whatIsLeftOutLeavesNothingToTheNext() {
        std::vector<Problem> problems;
        const std::string text = R"({"schema": 2, "tags": [{"index": 3, "name": "mud", "x": 1}], "objects": [)"
                                 R"({"key": "00000001", "type": "boat", "y": 1, "shapes": [{"z": 1}]},)"
                                 R"({"key": "00000002", "type": "body", "shapes": [{"w": 1}, {"type": "circle"}]},)"
                                 R"({"key": "00000003", "type": "ship", "v": 1}]})";
        const ForeignObjects foreign = parseObjects(text, problems);
        QCOMPARE(foreign.objects.size(), std::size_t{1});
        QCOMPARE(foreign.objects[0].unknownFields, std::string(R"({"/v": 1})"));
    }

    void whatIsSavedCanBeRead() {
        // What counts for the reader counts for the writer, in unknown fields as well.
        std::string vertices = "[[0,0]";
        for (int i = 0; i < limits::vertices; ++i) {
            vertices += ",[0,0]";
        }
        Level level;
        level.unknownFields = R"({"/vertices": )" + vertices + "]}";
        QVERIFY(!parseLevel(levelText(level), Checks::FileOnly).level);
        QCOMPARE(savableText(level).error().code.text(), std::string("too-many-vertices"));
        if (isFullRun()) {
            BodyObject body;
            body.shapes = std::vector<LevelShape>(1'050'000, Circle{{3, 4}, 0.25});
            level = Level();
            level.objects.append({1, {}, body, {}});
            const Result<std::string> text = savableText(level);
            QVERIFY2(bool(text), text ? "" : text.error().code.text().data());
            QVERIFY(parseLevel(text.value(), Checks::FileOnly).level.has_value());
        }
    }

    void whatCouldNotBeSavedAgainIsNotOpened() {
        if (!isFullRun()) {
            QSKIP("takes long: a file must be very large to become too large when saved");
        }
        // Ships are written with a place, which takes twice as many values as are there.
        const LevelFile file = parseLevel(manyShips(), Checks::FileOnly);
        QVERIFY(!file.level);
        QCOMPARE(file.problems.back().code.text(), std::string("too-large-to-save"));
    }
};

SPACETOW_TEST(UnknownFieldsTest)
#include "unknown_fields_test.moc"
