#include "editor/window/messages.h"

#include "editor/editing/codes.h"
#include "editor/editing/tools.h"
#include "editor/window/messages_table.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <QDirIterator>
#include <QRegularExpression>

#include <set>

using namespace spacetow;

namespace {

/// All of our own code below the folder, in one text.
QString sourcesIn(const QString& folder) {
    QString text;
    QDirIterator files(test::sourceFolder() + "/" + folder, {"*.cpp", "*.h"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.fileName().contains("messages") && file.open(QIODevice::ReadOnly)) {
            text += QString::fromUtf8(file.readAll());
        }
    }
    return text;
}

/// Codes that the sources hand out as problems or errors.
std::set<QString> emittedCodes() {
    static const QRegularExpression patterns[] = {
        QRegularExpression(R"(Error\{\s*"([a-z0-9-]+)\")"),
        QRegularExpression(R"(Severity::(?:Error|Warning|Note),\s*"([a-z0-9-]+)\")"),
        QRegularExpression(R"((?:reject|refuse|cannot)\(\s*"([a-z0-9-]+)\")"),
        QRegularExpression(R"(problem(?:At|Of)\([^;]*?"([a-z0-9-]+)\")"),
        QRegularExpression(R"(\bcode = "([a-z0-9-]+)\")"),
        QRegularExpression(R"(counted<[^>]*>\(level, findings, "([a-z0-9-]+)\")"),
        QRegularExpression(R"(std::pair\([a-z]+\.count, "([a-z0-9-]+)\")"),
    };
    const QString text = sourcesIn("core") + sourcesIn("editor/exchange") + sourcesIn("editor/window");
    std::set<QString> codes;
    for (const QRegularExpression& pattern : patterns) {
        auto found = pattern.globalMatch(text);
        while (found.hasNext()) {
            codes.insert(found.next().captured(1));
        }
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
    void everyCodeOfTheCoreHasASentence() {
        const std::set<QString> codes = emittedCodes();
        QVERIFY2(codes.size() > 70, qPrintable(QString::number(codes.size())));
        for (const QString& code : codes) {
            QVERIFY2(hasSentence(code.toStdString()), qPrintable(code));
        }
    }

    void everySentenceBelongsToACode() {
        const QString text = sourcesIn("core") + sourcesIn("editor/exchange") + sourcesIn("editor/window");
        for (const MessageText& message : exchangeTexts()) {
            QVERIFY2(text.contains(QStringLiteral("\"%1\"").arg(message.code)), message.code);
        }
        for (const MessageText& message : problemTexts()) {
            const QString code = QString(message.code).remove(QStringLiteral("-unnamed"));
            QVERIFY2(text.contains(QStringLiteral("\"%1\"").arg(code)), message.code);
        }
    }

    void everyHintAndLabelOfTheToolsHasASentence() {
        for (const ToolRow& tool : toolRows()) {
            for (const std::string_view code : tool.hints) {
                QVERIFY2(hasSentence(std::string(code)), std::string(code).c_str());
            }
        }
        for (const std::string_view code : sharedHintCodes) {
            QVERIFY2(hasSentence(std::string(code)), std::string(code).c_str());
        }
        for (const std::string_view code : labelCodes) {
            QVERIFY2(hasLabel(std::string(code)), std::string(code).c_str());
        }
    }

    void everyLabelOfThePanelsHasASentence() {
        static const QRegularExpression commit(R"(commit\(\s*\{\s*"([a-z-]+)\")");
        auto found = commit.globalMatch(sourcesIn("editor"));
        int count = 0;
        while (found.hasNext()) {
            const QString code = found.next().captured(1);
            QVERIFY2(hasLabel(code.toStdString()), qPrintable(code));
            ++count;
        }
        QVERIFY(count > 0);
    }

    void noCodeIsListedTwice() {
        std::set<std::string> seen;
        for (const MessageText& message : problemTexts()) {
            QVERIFY2(seen.insert(message.code).second, message.code);
        }
        for (const MessageText& message : exchangeTexts()) {
            QVERIFY2(seen.insert(message.code).second, message.code);
        }
        for (const MessageText& message : hintTexts()) {
            QVERIFY2(seen.insert(message.code).second, message.code);
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
        QCOMPARE(sentence(Error{"import-filter", {count.toStdString(), lines.toStdString(), ""}}), text);
    }

    void labelsCountTheirObjects() {
        QCOMPARE(sentence(Label{"move", 1}), QString("Move object"));
        QCOMPARE(sentence(Label{"move", 3}), QString("Move 3 objects"));
        QCOMPARE(sentence(Label{"draw-edge", 1}), QString("Draw one-way walls"));
    }

    void anUnknownCodeIsShownAsItIs() {
        QCOMPARE(sentence(Label{"set-friction", 1}), QString("Set friction"));
        QCOMPARE(sentence(Error{"no-such-thing", {}}), QString("No such thing"));
        QCOMPARE(sentence(Hint{}), QString());
    }

    void sentencesEndAsSentencesDo() {
        for (const MessageText& message : problemTexts()) {
            const QString text = message.text;
            QVERIFY2(highestPlaceholder(text) <= 5, message.code);
            if (QByteArray(message.code).startsWith("kind-")) {
                continue; // a part of a sentence
            }
            QVERIFY2(text.endsWith('.') || text.endsWith("%3"), message.code);
            QVERIFY2(text[0].isUpper() || text[0] == u'“', message.code);
        }
    }
};

SPACETOW_TEST(MessagesTest)
#include "messages_test.moc"
