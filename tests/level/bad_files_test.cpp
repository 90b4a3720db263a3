#include "core/level/file.h"

#include "core/level/key_text.h"
#include "tests/support/cpu_time.h"
#include "tests/support/full_run.h"
#include "tests/support/random_level.h"
#include "tests/support/test_main.h"

#include <sys/resource.h>

using namespace spacetow;
using namespace spacetow::test;

namespace {

/// The most memory that this process has ever used, bytes.
long peakMemory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

std::string repeated(const std::string& text, int count) {
    std::string out;
    out.reserve(text.size() * static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        out += text;
    }
    return out;
}

const std::string start = R"({"schema": 1, "objects": [)";

std::string body(const std::string& shape) {
    return start + R"({"key": "00000001", "type": "body", "shapes": [)" + shape + "]}]}";
}

std::string object(int key, const std::string& fields) {
    return "{\"key\": \"" + keyText(static_cast<Key>(key)) + "\", " + fields + '}';
}

} // namespace

class BadFilesTest : public QObject {
    Q_OBJECT

  private slots:
    void errorsOfObjectsHaveTheirLinesBehindAnyNumberOfWarnings() {
        std::string text = R"({"schema": 2, "objects": [)";
        for (int i = 1; i <= 3; ++i) { // polygons that cross themselves, in lines 2 to 4
            text += (i == 1 ? "\n" : ",\n") + object(i, R"("type": "body", "shapes": [{"type": "polygon", "vertices": )"
                                                        R"([[0, 0], [1, 1], [1, 0], [0, 1]]}])");
        }
        text += "]";
        for (int i = 0; i < 1100; ++i) {
            text += ",\n\"what" + std::to_string(i) + "\": 0";
        }
        std::vector<int> lines;
        for (const Problem& problem : parseLevel(text + '}').problems) {
            if (problem.severity == Severity::Error) {
                lines.push_back(problem.line);
            }
        }
        QCOMPARE(lines, (std::vector{2, 3, 4}));
    }
    void anErrorIsToldHoweverManyWarningsComeBeforeItAndHowManyMoreThereAre() {
        std::string text = R"({"schema": 2)";
        for (int i = 0; i < 1100; ++i) {
            text += ",\n\"what" + std::to_string(i) + "\": 0";
        }
        text += ",\n\"objects\": [7]}";
        const LevelFile file = parseLevel(text);
        QVERIFY(!file.level);
        const auto told = [&file](LevelCode code) { return std::ranges::count(file.problems, code, &Problem::code); };
        QCOMPARE(told("not-an-object"), 1);
        QCOMPARE(told("unknown-field"), 999);
        const auto more = std::ranges::find(file.problems, LevelCode("more-problems"), &Problem::code);
        QVERIFY(more != file.problems.end());
        QCOMPARE(more->arguments, std::vector<std::string>{"101"});
    }

    void aBadFileIsRefusedWithItsReasonAndLine_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("code");
        QTest::addColumn<int>("line");
        const auto row = [](const char* name, const std::string& text, const char* code, int line = 1) {
            QTest::newRow(name) << QByteArray(text.data(), static_cast<qsizetype>(text.size())) << QString(code)
                                << line;
        };
        row("empty", "", "empty-file");
        row("blanks only", " \n \n", "empty-file");
        row("not JSON at all", "hello", "not-json");
        row("a picture", "\x89PNG\r\n\x1a\n", "not-utf8");
        row("Latin-1", "{\n\"name\": \"H\xf6hle\"}", "not-utf8", 2);
        row("half a character at the end", "{\"a\": \"\xc3", "not-utf8");
        row("overlong character", "{\"a\": \"\xc0\xaf\"}", "not-utf8");
        row("surrogate in UTF-8", "{\"a\": \"\xed\xa0\x80\"}", "not-utf8");
        row("lone surrogate escape", "{\"a\": \"\\ud800\"}", "not-json");
        row("zero byte after the end", start + "]}" + std::string(1, '\0') + "junk", "zero-byte");
        row("text after the end", start + "]}\n}", "not-json", 2);
        row("cut off", "{\n\"schema\": 1,\n\"objects\": [", "unexpected-end", 3);
        row("cut off in a text", "{\"name\": \"ab", "unexpected-end");
        row("trailing comma in a list", "{\"schema\": 1,\n\"objects\": [1,\n]}", "trailing-comma", 2);
        row("trailing comma in an object", "{\"schema\": 1,}", "trailing-comma");
        row("line break in a text", "{\n\"name\": \"ab\n\"}", "open-text", 2);
        row("control character in a text", "{\"name\": \"a\x07\"}", "control-character");
        row("comment", "{\n// why\n}", "not-json", 2);
        row("single quotes", "{'schema': 1}", "not-json");
        row("NaN", "{\"schema\": 1,\n\"updateSeconds\": NaN}", "not-finite-literal", 2);
        row("minus infinity", "{\"a\": -Infinity}", "not-finite-literal");
        row("nan", "{\"a\": nan}", "not-finite-literal");
        row("too large a number", "{\n\n\"a\": 1e999}", "number-too-large", 3);
        row("leading zero", "{\"a\": 01}", "not-json");
        row("a list", "[]", "not-a-level");
        row("a number", "\n7\n", "not-a-level", 2);
        row("no schema", "{\"objects\": []}", "missing-schema");
        row("newer schema", "{\"name\": 5,\n\"schema\": 3}", "newer-schema", 2);
        row("schema zero", "{\"schema\": 0}", "bad-schema");
        row("schema in words", "{\"schema\": \"one\"}", "bad-schema");
        row("field twice", "{\"schema\": 1, \"objects\": [],\n\"objects\": []}", "duplicate-field", 2);
        row("no objects", "{\"schema\": 1}", "missing-field");
        row("objects no list", "{\"schema\": 1, \"objects\": {}}", "not-a-list");
        row("object no object", start + "\n7]}", "not-an-object", 2);
        row("no key", start + R"({"type": "ship"}]})", "missing-field");
        row("key zero", start + R"({"key": "00000000", "type": "ship"}]})", "bad-key");
        row("key too short", start + R"({"key": "1234567", "type": "ship"}]})", "bad-key");
        row("key no text", start + R"({"key": 12345678, "type": "ship"}]})", "bad-key");
        row("no type", start + R"({"key": "00000001"}]})", "missing-field");
        row("unknown type", start + R"({"key": "00000001", "type": "boat"}]})", "unknown-choice");
        row("no shapes", start + R"({"key": "00000001", "type": "body"}]})", "missing-field");
        row("unknown shape", body(R"({"type": "square"})"), "unknown-choice");
        row("no radius", body(R"({"type": "circle"})"), "missing-field");
        row("radius a text", body(R"({"type": "circle", "radius": "1"})"), "not-a-number");
        row("radius null", body(R"({"type": "circle", "radius": null})"), "not-a-number");
        row("depth a text", body(R"({"type": "edges", "depth": "all", "vertices": []})"), "not-a-depth");
        row("closed a number", body(R"({"type": "edges", "closed": 1, "vertices": []})"), "not-a-flag");
        row("vertex of three", body(R"({"type": "lines", "vertices": [[1, 2, 3]]})"), "not-a-point");
        row("vertex of texts", body(R"({"type": "lines", "vertices": [["1", "2"]]})"), "not-a-point");
        row("vertices an object", body(R"({"type": "lines", "vertices": {}})"), "not-a-list");
        row("name a number", R"({"schema": 1, "name": 5, "objects": []})", "not-a-text");
        row("half a life", R"({"schema": 1, "rules": {"lives": 2.5}, "objects": []})", "not-an-integer");
        row("too many lives", R"({"schema": 1, "rules": {"lives": 1e30}, "objects": []})", "out-of-range");
        row("rules a list", R"({"schema": 1, "rules": [], "objects": []})", "not-an-object");
        row("tags an object", R"({"schema": 1, "tags": {}, "objects": []})", "not-a-list");
        row("tag without index", R"({"schema": 1, "tags": [{"name": "a"}], "objects": []})", "missing-field");
        row("tag index 32", R"({"schema": 1, "tags": [{"index": 32, "name": "a"}], "objects": []})", "bad-tag-index");
        row("tag name twice",
            R"({"schema": 1, "tags": [{"index": 1, "name": "a"}, {"index": 2, "name": "a"}], "objects": []})",
            "duplicate-tag");
        row("tag index twice",
            R"({"schema": 1, "tags": [{"index": 1, "name": "a"}, {"index": 1, "name": "b"}], "objects": []})",
            "duplicate-tag-index");
        row("tag named #3", "{\"schema\": 1, \"tags\": [{\"index\": 1, \"name\": \"#3\"}], \"objects\": []}",
            "bad-tag-name");
        row("tag in red", R"({"schema": 1, "tags": [{"index": 1, "name": "a", "color": "red"}], "objects": []})",
            "bad-color");
        row("unknown tag", start + R"({"key": "00000001", "type": "body", "tags": ["ice"], "shapes": []}]})",
            "unknown-tag");
        row("touches none", start + R"({"key": "00000001", "type": "body", "touches": "none", "shapes": []}]})",
            "not-touches");
        for (const char* touches : {"{}", R"({"except": "wall"})", R"({"but": []})", R"({"except": [], "glow": 1})"}) {
            row(touches,
                start + R"({"key": "00000001", "type": "body", "touches": )" + touches + R"(, "shapes": []}]})",
                "not-touches");
        }
        row("excepted tag that is none",
            start + R"({"key": "00000001", "type": "body", "touches": {"except": ["lava"]}, "shapes": []}]})",
            "unknown-tag");
    }
    void aBadFileIsRefusedWithItsReasonAndLine() {
        QFETCH(QByteArray, text);
        QFETCH(QString, code);
        QFETCH(int, line);
        const LevelFile file = parseLevel(text.toStdString());
        QVERIFY(!file.level);
        QVERIFY(!file.problems.empty());
        QCOMPARE(QString::fromUtf8(file.problems[0].code.text()), code);
        QCOMPARE(file.problems[0].line, line);
        QCOMPARE(file.problems[0].severity, Severity::Error);
    }

    void aByteOrderMarkIsReportedAndDropped() {
        const LevelFile file = parseLevel("\xef\xbb\xbf" + start + "]}");
        QVERIFY(file.level.has_value());
        QCOMPARE(file.problems.size(), std::size_t{1});
        QCOMPARE(file.problems[0].code.text(), std::string("byte-order-mark"));
        QCOMPARE(file.problems[0].severity, Severity::Warning);
    }

    void whatCouldFillTheMemoryIsRefusedQuickly_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("code");
        const auto row = [](const char* name, const std::string& text, const char* code) {
            QTest::newRow(name) << QByteArray(text.data(), static_cast<qsizetype>(text.size())) << QString(code);
        };
        row("deep lists", repeated("[", 5000000), "nested-too-deep");
        row("deep objects", "{\"schema\": 1, \"a\": " + repeated("{\"a\":", 2000000), "nested-too-deep");
        row("ten million vertices",
            start + R"({"key":"00000001","type":"body","shapes":[{"type":"lines","vertices":[)" +
                repeated("[0,0],", 10000000) + "[0,0]]}]}]}",
            "too-many-vertices");
        row("many small values", "{\"schema\":1,\"a\":[" + repeated("0,", 20000000) + "0]}", "too-many-values");
        row("many texts", "{\"schema\":1,\"a\":[" + repeated("\"\",", 15000000) + "0]}", "too-many-values");
        row("longer than allowed", std::string(maxLevelBytes + 1, ' '), "text-too-large");
    }
    void whatCouldFillTheMemoryIsRefusedQuickly() {
        QFETCH(QByteArray, text);
        QFETCH(QString, code);
        const CpuTimer timer;
        const LevelFile file = parseLevel({text.data(), static_cast<std::size_t>(text.size())});
        QVERIFY(!file.level);
        QCOMPARE(QString::fromUtf8(file.problems.at(0).code.text()), code);
        QVERIFY2(timer.seconds() < 10, qPrintable(QString::number(timer.seconds())));
        // Sanitizers keep for a while what is given back.
        QVERIFY2(peakMemory() < (isSanitized ? 1600L : 1000L) << 20, qPrintable(QString::number(peakMemory())));
    }

    void aMillionFieldsAreReadInTime_data() {
        QTest::addColumn<QByteArray>("text");
        std::string unknown = R"({"schema":1,"objects":[],"x":0)";
        for (int i = 0; i < 300000; ++i) {
            unknown += ",\"a" + std::to_string(i) + "\":0";
        }
        QTest::newRow("unknown fields") << QByteArray::fromStdString(unknown + '}');
        std::string objects = start;
        for (int i = 1; i <= 100000; ++i) {
            objects += (i > 1 ? "," : "") + object(i, "\"type\": \"ship\"");
        }
        QTest::newRow("ships") << QByteArray::fromStdString(objects + "]}");
        QTest::newRow("filters") << QByteArray::fromStdString(start + manyFilters() + "]}");
    }
    void aMillionFieldsAreReadInTime() {
        QFETCH(QByteArray, text);
        const CpuTimer timer;
        QVERIFY(parseLevel(text.toStdString()).level.has_value());
        QVERIFY2(timer.seconds() < 10, qPrintable(QString::number(timer.seconds())));
    }

    void noMutationOfAFileCrashesOrHangs() {
        const std::string original = levelText(populatedLevel());
        const CpuTimer timer;
        for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
            Random random(seed);
            std::string text = original;
            for (std::uint32_t i = 1 + random.below(4); i > 0; --i) {
                mutate(text, random);
            }
            const LevelFile file = parseLevel(text);
            QVERIFY2(file.level || hasErrors(file.problems), ("seed " + std::to_string(seed)).c_str());
            if (file.level) {
                const std::string saved = levelText(*file.level);
                const LevelFile again = parseLevel(saved);
                QVERIFY2(again.level && *again.level == *file.level, ("seed " + std::to_string(seed)).c_str());
                QVERIFY2(levelText(*again.level) == saved, ("seed " + std::to_string(seed)).c_str());
            }
        }
        QVERIFY(timer.seconds() < 60);
    }

  private:
    static std::string manyFilters() {
        std::string out;
        for (int i = 1; i <= 3000; ++i) {
            std::string tags;
            for (int bit = 0; bit < 12; ++bit) {
                if ((i >> bit & 1) != 0) {
                    tags += (tags.empty() ? "\"#" : ",\"#") + std::to_string(bit + 5) + '"';
                }
            }
            out += (i > 1 ? "," : "") +
                   object(i, "\"type\": \"body\", \"tags\": [" + tags +
                                 "], \"touches\": [\"#30\"], \"shapes\": [{\"type\": \"circle\", \"radius\": 1}]");
        }
        return out;
    }
    static void mutate(std::string& text, Random& random) {
        static const std::vector<std::string> pieces{"null",
                                                     "-1",
                                                     "1e308",
                                                     "\"\"",
                                                     "[",
                                                     "]",
                                                     "{",
                                                     "}",
                                                     ",",
                                                     ":",
                                                     "\"",
                                                     "\\u0000",
                                                     "true",
                                                     "1e-320",
                                                     "[]",
                                                     "{}",
                                                     "0.5",
                                                     "\\",
                                                     "\"key\": ",
                                                     "\"00000001\"",
                                                     "99999999999999999999",
                                                     "\xff",
                                                     "\n"};
        const std::uint32_t at = random.below(static_cast<std::uint32_t>(text.size()));
        const std::uint32_t length =
            random.below(static_cast<std::uint32_t>(std::min<std::size_t>(30, text.size() - at)));
        const std::string& piece = pieces[random.below(static_cast<std::uint32_t>(pieces.size()))];
        switch (random.below(5)) {
        case 0:
            text[at] = static_cast<char>(random.below(256));
            break;
        case 1:
            text.erase(at, length + 1);
            break;
        case 2:
            text.insert(at, piece);
            break;
        case 3:
            text.replace(at, length, piece);
            break;
        default:
            text.insert(random.below(static_cast<std::uint32_t>(text.size())), text.substr(at, length));
        }
        if (text.empty()) {
            text = "{";
        }
    }
};

SPACETOW_TEST(BadFilesTest)
#include "bad_files_test.moc"
