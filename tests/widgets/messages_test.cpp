#include "editor/window/messages.h"

#include "core/base/system_reason.h"
#include "core/level/fixes.h"
#include "editor/editing/codes.h"
#include "editor/editing/tools.h"
#include "editor/window/messages_table.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <QDirIterator>
#include <QLocale>
#include <QRegularExpression>
#include <QScopeGuard>

#include <cerrno>
#include <set>

using namespace spacetow;

namespace {

/// All of our own code below the folder, but for comments, the tables of codes and what is made of codes.
QString codeIn(const QString& folder) {
    QString text;
    QDirIterator files(test::sourceFolder() + "/" + folder, {"*.cpp", "*.h"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        const QString name = files.fileName();
        if (!name.endsWith("codes.h") && !name.startsWith("messages") && name != "fixes.cpp" &&
            file.open(QIODevice::ReadOnly)) {
            while (!file.atEnd()) {
                text += QString::fromUtf8(file.readLine()).section("//", 0, 0) + '\n';
            }
        }
    }
    return text;
}

template <class Codes>
QStringList textsOf() {
    QStringList texts;
    Codes::each([&texts](std::string_view text) { texts << QString::fromUtf8(text); });
    return texts;
}

/// Of tools, and those that come from no single one.
std::set<std::string_view> hintCodes() {
    std::set<std::string_view> codes(sharedHintCodes.begin(), sharedHintCodes.end());
    for (const ToolRow& tool : toolRows()) {
        codes.insert(tool.hints.begin(), tool.hints.end());
    }
    return codes;
}

int highestPlaceholder(const QString& text) {
    int highest = 0;
    static const QRegularExpression placeholder("%([1-9])");
    auto found = placeholder.globalMatch(text);
    while (found.hasNext()) {
        highest = std::max(highest, found.next().captured(1).toInt());
    }
    return highest;
}

} // namespace

class MessagesTest : public QObject {
    Q_OBJECT

  private slots:
    void everyCodeHasASentence() {
        QVERIFY(textsOf<SentenceCode>().size() > 200);
        for (const QString& code : textsOf<SentenceCode>()) {
            QVERIFY2(hasSentence(code.toStdString()), qPrintable(code));
        }
        QVERIFY(textsOf<LabelCode>().size() > 90);
        for (const QString& code : textsOf<LabelCode>()) {
            QVERIFY2(hasLabel(code.toStdString()), qPrintable(code));
        }
    }

    /// That a sentence has a code, and that what is handed out is one, the compiler sees to.
    void everyCodeIsHandedOut() {
        const QString text = codeIn("core") + codeIn("editor");
        for (const QString& code : textsOf<SentenceCode>() + textsOf<LabelCode>()) {
            const bool isCure = code.startsWith("fix-") && code != "fix-all"; // which fixes.cpp has
            QVERIFY2(isCure || text.contains('"' + code + '"'), qPrintable(code));
        }
        for (const QString& cure : textsOf<FixCode>()) {
            QVERIFY2(std::ranges::any_of(fixes(), [&cure](const Fix& fix) { return cure == fix.label.text().data(); }),
                     qPrintable(cure));
        }
    }

    void noCodeStandsInTwoTables() {
        QStringList codes = textsOf<SentenceCode>() + textsOf<LabelCode>();
        QCOMPARE(codes.removeDuplicates(), 0);
    }

    void everyHintHasASentenceAndEverySentenceIsOfAHint() {
        std::set<std::string_view> codes = hintCodes();
        for (const std::string_view code : codes) {
            QVERIFY2(hasSentence(code), std::string(code).c_str());
        }
        for (const HintText& hint : hintTexts()) {
            QVERIFY2(codes.contains(hint.code), hint.code);
        }
    }

    void noCodeHasTwoSentences() {
        std::set<std::string_view> seen;
        for (const auto texts : {problemTexts(), exchangeTexts(), explainTexts()}) {
            for (const MessageText& message : texts) {
                QVERIFY2(seen.insert(message.code.text()).second, message.text);
            }
        }
        for (const HintText& hint : hintTexts()) {
            QVERIFY2(seen.insert(hint.code).second, hint.code);
        }
        seen.clear();
        for (const LabelText& label : labelTexts()) {
            QVERIFY2(seen.insert(label.code.text()).second, label.one);
        }
    }

    void anObjectWithoutANameIsToldByKindAndPlace() {
        Problem problem{.code = "payload-in-wall", .arguments = {"roof", "kind-polygon", "3", "-2.5"}};
        QCOMPARE(sentence(problem), QStringLiteral("The payload starts in touch with the object “roof”."));
        problem.arguments[0].clear();
        QCOMPARE(sentence(problem), QStringLiteral("The payload starts in touch with the polygon at 3; -2.5 m."));
    }

    void argumentsFillTheirPlaces_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("text");
        QTest::newRow("in order") << QStringList{"depth", "-1", "0", "9"}
                                  << "“depth” is -1; it must lie between 0 and 9.";
        QTest::newRow("percent signs stay")
            << QStringList{"%2", "%n", "100%", "%1"} << "“%2” is %n; it must lie between 100% and %1.";
        QTest::newRow("missing ones are empty") << QStringList{"depth"} << "“depth” is ; it must lie between  and .";
    }
    void argumentsFillTheirPlaces() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, text);
        Problem problem;
        problem.code = "out-of-range";
        for (const QString& argument : arguments) {
            problem.arguments.push_back(argument.toStdString());
        }
        QCOMPARE(sentence(problem), text);
    }

    void aReportSaysHowOftenAndWhere_data() {
        QTest::addColumn<QString>("count");
        QTest::addColumn<QString>("lines");
        QTest::addColumn<QString>("text");
        QTest::newRow("one") << "1"
                             << "3"
                             << "Filters were not applied (once, in line 3).";
        QTest::newRow("two lines") << "2"
                                   << "3, 5"
                                   << "Filters were not applied (2 times, in lines 3, 5).";
        QTest::newRow("many") << "9"
                              << "3, 5 …"
                              << "Filters were not applied (9 times, in lines 3, 5 …).";
        QTest::newRow("no lines") << "2"
                                  << ""
                                  << "Filters were not applied (2 times).";
    }
    void aReportSaysHowOftenAndWhere() {
        QFETCH(QString, count);
        QFETCH(QString, lines);
        QFETCH(QString, text);
        QCOMPARE(sentence(Error{SentenceCode("import-filter"), {count.toStdString(), lines.toStdString(), ""}}), text);
    }

    void numbersAndSizesAreSpelledAsTheUserDoes_data() {
        QTest::addColumn<QString>("locale");
        QTest::addColumn<QStringList>("told");
        QTest::newRow("C") << "C"
                           << QStringList{"at most 8.4 MB can", "at most 33.6 MB can",     "1000000 updates",
                                          "0.25 m deep",        "Move 12345 objects",      "Velocity 12345 m/s, 2.5°",
                                          "12345 times",        "is 12345678901234567890;"};
        QTest::newRow("English") << "en_US" << QStringList{"at most 8.4 MB can",  "at most 33.6 MB can",
                                                           "1,000,000 updates",   "0.25 m deep",
                                                           "Move 12,345 objects", "Velocity 12,345 m/s, 2.5°",
                                                           "12,345 times",        "is 12345678901234567890;"};
        QTest::newRow("German") << "de_DE" << QStringList{"at most 8,4 MB can",  "at most 33,6 MB can",
                                                          "1.000.000 updates",   "0,25 m deep",
                                                          "Move 12.345 objects", "Velocity 12.345 m/s, 2,5°",
                                                          "12.345 times",        "is 12345678901234567890;"};
    }
    void numbersAndSizesAreSpelledAsTheUserDoes() {
        QFETCH(QString, locale);
        QFETCH(QStringList, told);
        const QLocale before;
        const auto restore = qScopeGuard([&before] { QLocale::setDefault(before); });
        QLocale::setDefault(QLocale(locale));
        const QStringList sentences{
            sentence(Error{SentenceCode("file-too-large"), {"/a/1000.json", "8388608"}}),
            sentence(Error{SentenceCode("text-too-large"), {"33554432"}}),
            sentence(Error{SentenceCode("replay-too-long"), {"1000000"}}),
            sentence(Problem{.code = "wall-too-thin", .arguments = {"0.25", "3"}}),
            sentence(Label{"move", 12345}),
            sentence(Hint{"velocity.dragging", {"12345", "2.5"}}),
            sentence(Error{SentenceCode("import-filter"), {"12345", "3, 5 …", ""}}),
            sentence(Problem{.code = "out-of-range", .arguments = {"iterations", "12345678901234567890", "1", "9"}}),
        };
        for (qsizetype i = 0; i < told.size(); ++i) {
            QVERIFY2(sentences[i].contains(told[i]), qPrintable(sentences[i]));
        }
        // Names and keys are none.
        QVERIFY(sentences[0].contains("/a/1000.json"));
        QVERIFY(sentence(Hint{"select.in-named-group", {"2", "1000"}}).contains(QStringLiteral("“1000”")));
        QVERIFY(sentence(Problem{.code = "key-taken", .arguments = {"12345678"}}).contains("12345678"));
    }

    void theSystemsReasonsAreGivenInTheUsersWords() {
        const Error gone{SentenceCode("cannot-read"), {"/a.json", systemReason(ENOENT)}};
        QVERIFY2(sentence(gone).contains("there is no such file"), qPrintable(sentence(gone)));
        const Error odd{SentenceCode("cannot-read"), {"/a.json", "Frobnicated"}};
        QVERIFY(sentence(odd).endsWith(": Frobnicated."));
        for (const ReasonText& reason : systemReasons()) { // they are parts of sentences
            QVERIFY2(QChar(reason.text[0]).isLower() && !QString(reason.text).endsWith('.'), reason.text);
        }
    }

    void labelsCountTheirObjects() {
        QCOMPARE(sentence(Label{"move", 1}), QString("Move object"));
        QCOMPARE(sentence(Label{"move", 3}), QString("Move 3 objects"));
        QCOMPARE(sentence(Label{"draw-edge", 1}), QString("Draw one-way walls"));
    }

    void labelsNameTheFieldThatWasChanged() {
        QCOMPARE(sentence(Label{"change", 1, "angle"}), QString("Change “Angle”"));
        QCOMPARE(sentence(Label{"change", 3, "position.y"}), QString("Change “Position y” of 3 objects"));
        QCOMPARE(sentence(Label{"change", 1, "position"}), QString("Change “Position”"));
        QCOMPARE(sentence(Label{"change", 1, "locked"}), QString("Change “Locked”"));
        QCOMPARE(sentence(Label{"change-level", 1, "lives"}), QString("Change “Lives” of the level"));
        QCOMPARE(sentence(Label{"change", 2}), QString("Change 2 objects"));
    }

    void anUnknownCodeIsShownAsItIs() {
        QCOMPARE(sentence(Hint{"no-such-thing", {}}), QString("No such thing"));
        QCOMPARE(sentence(Hint{}), QString());
    }

    void sentencesEndAsSentencesDo() {
        for (const MessageText& message : problemTexts()) {
            const char* const code = message.code.text().data();
            for (const QString text : {message.text, message.unnamed}) {
                QVERIFY2(highestPlaceholder(text) <= 5, code);
                if (text.isEmpty() || QByteArray(code).startsWith("kind-")) {
                    continue; // a part of a sentence
                }
                QVERIFY2(text.endsWith('.') || text.endsWith("%3") || text.endsWith(": %2"), code);
                QVERIFY2(text[0].isUpper() || text[0] == u'“', code);
            }
        }
    }
};

SPACETOW_TEST(MessagesTest)
#include "messages_test.moc"
