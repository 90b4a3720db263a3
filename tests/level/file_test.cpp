#include "core/level/file.h"

#include "core/level/json_text.h"
#include "core/level/lint.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <bit>
#include <cmath>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::string withObjects(const std::string& objects) {
    return R"({"schema": 1, "objects": [)" + objects + "]}";
}

const Problem* problemOf(const LevelFile& file, const std::string& code) {
    for (const Problem& problem : file.problems) {
        if (problem.code.text() == code) {
            return &problem;
        }
    }
    return nullptr;
}

std::string codes(const LevelFile& file) {
    std::string text;
    for (const Problem& problem : file.problems) {
        text += std::string(problem.code.text()) + ' ';
    }
    return text;
}

} // namespace

class FileTest : public QObject {
    Q_OBJECT

  private slots:
    void randomLevelsComeBackEqualAndTheSameToTheByte() {
        for (std::uint64_t seed = 1; seed <= 400; ++seed) {
            const Level level = randomLevel(seed);
            const std::string text = levelText(level);
            const LevelFile file = parseLevel(text);
            QVERIFY2(file.level.has_value(), ("seed " + std::to_string(seed) + ": " + codes(file)).c_str());
            QVERIFY2(*file.level == level, ("seed " + std::to_string(seed)).c_str());
            QVERIFY2(levelText(*file.level) == text, ("seed " + std::to_string(seed)).c_str());
            QVERIFY2(text.ends_with("\n"), "newline at the end");
        }
    }

    void noLineIsLongerThan120CharactersUnlessOneTextIs() {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Level level = randomLevel(seed);
            level.description.clear();
            const QStringList lines = QString::fromStdString(levelText(level)).split('\n');
            for (const QString& line : lines) {
                QVERIFY2(line.toUtf8().size() <= 120, qPrintable(line));
            }
        }
    }

    void aMovedVertexChangesOneLine() {
        Level level = randomLevel(3);
        BodyObject body;
        body.shapes = {EdgeChain{std::vector<Vec2>(50, Vec2(1.25, 2.5)), true, noBack}};
        level.objects.append({12345, "cave", body, {}});
        const QStringList before = QString::fromStdString(levelText(level)).split('\n');
        std::get<EdgeChain>(body.shapes[0]).vertices[20].x() = 7;
        level.objects.replace(level.objects.size() - 1, {12345, "cave", body, {}});
        const QStringList after = QString::fromStdString(levelText(level)).split('\n');
        QCOMPARE(after.size(), before.size());
        int differences = 0;
        for (int i = 0; i < after.size(); ++i) {
            differences += after[i] == before[i] ? 0 : 1;
        }
        QCOMPARE(differences, 1);
    }

    void numbersAreSpelledWithTheFewestDigits_data() {
        QTest::addColumn<double>("number");
        QTest::addColumn<QString>("text");
        QTest::newRow("whole") << 5.0 << "5";
        QTest::newRow("tenth") << 0.1 << "0.1";
        QTest::newRow("sum of tenths") << 0.1 + 0.2 << "0.30000000000000004";
        QTest::newRow("large") << 100000.0 << "100000";
        QTest::newRow("huge") << 1e300 << "1e+300";
        QTest::newRow("tiny") << 5e-324 << "5e-324";
        QTest::newRow("small") << 0.00025 << "0.00025";
        QTest::newRow("minus zero is zero") << -0.0 << "0";
        QTest::newRow("no number") << std::nan("") << "null";
    }
    void numbersAreSpelledWithTheFewestDigits() {
        QFETCH(double, number);
        QFETCH(QString, text);
        QCOMPARE(QString::fromStdString(spelledNumber(number)), text);
    }

    void anyNumberReadsBackToTheLastBit() {
        Random random(11);
        for (int i = 0; i < 3000; ++i) {
            const std::uint64_t bits = std::uint64_t{random.next()} << 32 | random.next();
            const auto number = std::bit_cast<double>(bits);
            if (std::isfinite(number) && number != 0) {
                const std::string text = spelledNumber(number);
                QCOMPARE(std::strtod(text.c_str(), nullptr), number);
            }
        }
    }

    void everyDefaultMayBeLeftOut() {
        const LevelFile file = parseLevel(
            withObjects(R"({"key": "00000001", "type": "body", "shapes": [{"type": "circle", "radius": 2}]})"));
        QVERIFY2(file.level.has_value(), codes(file).c_str());
        Level expected;
        BodyObject body;
        body.shapes = {Circle{{0, 0}, 2}};
        expected.objects.append({1, "", body, {}});
        QVERIFY(*file.level == expected);
        QVERIFY(file.problems.empty());
    }

    void anEdgeWithoutABackHasNoDepth() {
        Level level;
        BodyObject body;
        body.shapes = {EdgeChain{{{0, 0}, {1, 0}}, false, noBack}};
        level.objects.append({1, "", body, {}});
        QVERIFY(levelText(level).find("\"depth\": null") != std::string::npos);
        QVERIFY(*parseLevel(levelText(level)).level == level);
    }

    void tagsAreStoredByName() {
        Level level;
        level.tags.set(9, {"ice", 0x00ff00});
        BodyObject body;
        body.shapes = {Circle{}};
        body.filter = {TagMask::bit(9) | TagMask::bit(17), TagMask::bit(0)};
        level.objects.append({1, "", body, {}});
        const std::string text = levelText(level);
        QVERIFY(text.find(R"("tags": ["ice", "#17"])") != std::string::npos);
        QVERIFY(text.find(R"("touches": ["wall"])") != std::string::npos);
        // Renumbering the tag shows in the table only.
        const std::string renumbered =
            QString::fromStdString(text).replace("\"index\": 9", "\"index\": 12").toStdString();
        const LevelFile file = parseLevel(renumbered);
        QVERIFY(std::get<BodyObject>(file.level->objects[0].data).filter.tags == (TagMask::bit(12) | TagMask::bit(17)));
        QCOMPARE(levelText(*file.level), renumbered);
    }

    void unknownFieldsOfARopeThatIsTheGamesOwnSurviveASave() {
        const LevelFile file = parseLevel(R"({"schema": 2, "rules": {"rope": {"knots": 3}}, "objects": []})");
        QVERIFY(file.level.has_value());
        QVERIFY(file.level->rules == Rules());
        QVERIFY(levelText(*file.level).find(R"("rope": {"knots": 3})") != std::string::npos);
        QVERIFY(levelText(Level()).find("rope") == std::string::npos);
    }

    void unknownFieldsSurviveASave() {
        Level level = populatedLevel();
        std::string text = levelText(level);
        const auto insertAfter = [&text](const std::string& what, const std::string& addition) {
            const auto at = text.find(what);
            QVERIFY2(at != std::string::npos, what.c_str());
            text.insert(at + what.size(), addition);
        };
        insertAfter("\"proportion\": 0.625}", ",\n    \"weather\": \"rain\"");
        insertAfter("\"color\": \"#abcdef\"", R"(, "material": {"slip": 0.5, "a/b~c": [1, 2.5, null]})");
        insertAfter("\"center\": [3, 3], \"radius\": 0.25", R"(, "glow": true)");
        insertAfter("\"b\": [42, 43]", R"(, "w": 18446744073709551615)");
        insertAfter("\"position\": [20, 21], \"angle\": 0.5", R"(, "v": -9223372036854775808)");
        const LevelFile file = parseLevel(text);
        QVERIFY2(file.level.has_value(), codes(file).c_str());
        QCOMPARE(std::ranges::count(file.problems, LevelCode("unknown-field"), &Problem::code), 5);
        QCOMPARE(problemOf(file, "unknown-field")->severity, Severity::Warning);
        QCOMPARE(levelText(*file.level), text);

        // Removing an earlier tag must not move the unknown field to another one.
        Level changed = *file.level;
        changed.tags.set(0, {});
        QVERIFY(levelText(changed).find(R"("color": "#abcdef", "material")") != std::string::npos);
    }

    void unknownFieldsOfTheLevelSurviveToo() {
        const std::string text = levelText(Level()).insert(1, "\n  \"future\": [1, {}],");
        const LevelFile file = parseLevel(text);
        QVERIFY(file.level.has_value());
        QVERIFY(levelText(*file.level).ends_with("\"objects\": [],\n  \"future\": [1, {}]\n}\n"));
    }

    void objectsGoThroughTheClipboard() {
        const Level level = populatedLevel();
        const std::vector<Key> keys{1, 3, 6};
        std::vector<Problem> problems;
        const ForeignObjects foreign = parseObjects(objectsText(level, keys), problems);
        QVERIFY(problems.empty());
        QCOMPARE(foreign.objects.size(), std::size_t{3});
        for (const Object& object : foreign.objects) {
            QVERIFY(object == *level.objects.find(object.key));
        }
        for (int i = 0; i < TagTable::size; ++i) {
            QVERIFY(foreign.tags[i].name.empty() || foreign.tags[i] == level.tags[i]);
        }
    }

    void copiedTextTellsTheTagsOfItsObjectsOnly() {
        Level level = populatedLevel();
        level.tags.set(17, {"lava", 0xff0000});
        const std::vector<Key> keys{1};
        const std::string without = objectsText(level, keys);
        QVERIFY(without.find("lava") != std::string::npos); // is what object 1 is
        level.tags.set(18, {"ice", 0x0000ff});
        QCOMPARE(objectsText(level, keys), without);
    }

    void tagsThatAreOnlyNamedAreGivenAPlace() {
        std::vector<Problem> problems;
        const std::string text = withObjects(
            R"({"key": "00000001", "type": "body", "tags": ["lava", "#3"], "touches": {"except": ["ice"]}, )"
            R"("shapes": [{"type": "circle", "radius": 1}]})");
        const ForeignObjects foreign = parseObjects(text, problems);
        QVERIFY(problems.empty());
        const Filter filter = std::get<BodyObject>(foreign.objects.at(0).data).filter;
        const std::optional<int> lava = foreign.tags.indexOf("lava");
        const std::optional<int> ice = foreign.tags.indexOf("ice");
        QVERIFY(lava && ice && lava != ice);
        QVERIFY(filter.tags == (TagMask::bit(*lava) | TagMask::bit(3)));
        QCOMPARE(filter.touches.bits, ~TagMask::bit(*ice).bits);
    }

    void everythingButAFewIsWrittenAsWhatItIs() {
        Level level;
        BodyObject body;
        body.shapes = {Circle{}};
        const auto spelled = [&](TagMask touches) {
            body.filter.touches = touches;
            Level with = level;
            with.objects.append({1, "", body, {}});
            const std::string text = levelText(with);
            const LevelFile read = parseLevel(text);
            return read.level && *read.level == with ? text : std::string("does not read back");
        };
        const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
        QVERIFY(has(spelled(TagMask{~(1U << debrisTag)}), R"("touches": {"except": ["debris"]})"));
        QVERIFY(has(spelled(TagMask{~(1U << debrisTag | 1U << 20)}), R"("touches": {"except": ["debris", "#20"]})"));
        QVERIFY(has(spelled(TagMask{3}), R"("touches": ["wall", "ship"])"));
        QVERIFY(has(spelled(TagMask{}), R"("touches": [])"));
        QVERIFY(!has(spelled(TagMask::all()), "touches"));
        for (std::uint32_t tags = 0; tags <= 32; ++tags) {
            QVERIFY(spelled(TagMask{tags == 32 ? ~0U : (1U << tags) - 1}) != "does not read back");
        }
    }

    void pastingLeavesOutWhatIsWrong() {
        std::vector<Problem> problems;
        const std::string text = withObjects(R"({"key": "00000001", "type": "ship", "angle": "up"},
                                                {"key": "00000002", "type": "ship"}, 3)");
        const std::vector<Object> objects = parseObjects(text, problems).objects;
        QCOMPARE(objects.size(), std::size_t{1});
        QCOMPARE(objects[0].key, Key{2});
        QCOMPARE(problems.size(), std::size_t{2});
        QVERIFY(parseObjects("hello", problems).objects.empty());
        QCOMPARE(problems.back().code.text(), std::string("not-json"));
    }

    void pastingLeavesOutWhatSaysAFieldTwice() {
        std::vector<Problem> problems;
        const std::string text = withObjects(R"({"key": "00000001", "type": "ship", "glow": 1, "glow": 2},
                                                {"key": "00000002", "type": "ship"},
                                                {"key": "00000003", "type": "body", "shapes": [
                                                 {"type": "circle", "radius": 1, "radius": 2}]})");
        const std::vector<Object> objects = parseObjects(text, problems).objects;
        QCOMPARE(objects.size(), std::size_t{1});
        QCOMPARE(objects[0].key, Key{2});
        QCOMPARE(std::ranges::count(problems, LevelCode("duplicate-field"), &Problem::code), 2);
    }

    void everyProblemIsFoundInOnePass() {
        const LevelFile file = parseLevel(withObjects(R"({"key": "1", "type": "ship"},
{"key": "00000002", "type": "boat"},
{"key": "00000003", "type": "ship", "angle": true},
{"key": "00000003", "type": "payload"})"));
        QVERIFY(!file.level);
        QCOMPARE(codes(file), std::string("bad-key unknown-choice not-a-number duplicate-key "));
        QCOMPARE(file.problems[2].line, 3);
        QCOMPARE(file.problems[2].pointer, std::string("/objects/2/angle"));
        QCOMPARE(file.problems[2].object, Key{3});
        QCOMPARE(file.problems[3].line, 4);
    }

    void lintComesWithTheLinesOfTheFile() {
        const LevelFile file = parseLevel(withObjects(R"(
{"key": "00000001", "type": "body", "shapes": [
  {"type": "polygon", "vertices": [[0, 0], [1, 0],
    [1, 0], [0, 1]]}]})"));
        QVERIFY(file.level.has_value());
        QCOMPARE(codes(file), std::string("repeated-vertex "));
        QCOMPARE(file.problems[0].line, 4);
        QCOMPARE(file.problems[0].pointer, std::string("/objects/0/shapes/0/vertices/2"));
    }

    void theListOfProblemsEndsSomewhere() {
        std::string objects;
        for (int i = 0; i < 5000; ++i) {
            objects += (i > 0 ? "," : "") + std::string("{\"type\": \"ship\"}");
        }
        const LevelFile file = parseLevel(withObjects(objects));
        QVERIFY(!file.level);
        QVERIFY(file.problems.size() <= 1001);
        QVERIFY(hasErrors(file.problems));
    }

    void whoAsksLintItselfIsSparedItsAnswer() {
        Level level;
        level.objects.append({5, {}, BodyObject(), {}});
        const std::string text = levelText(level);
        QVERIFY(!parseLevel(text).problems.empty());
        const LevelFile file = parseLevel(text, Checks::FileOnly);
        QVERIFY(file.problems.empty());
        QVERIFY(*file.level == level);
        QVERIFY(!parseLevel("{", Checks::FileOnly).problems.empty());
    }
};

SPACETOW_TEST(FileTest)
#include "file_test.moc"
