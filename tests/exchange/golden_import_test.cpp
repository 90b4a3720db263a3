// Each folder of tests/golden/import holds a file of another program as in.*, and either the level that it becomes,
// out.json, with what is not taken over, report.txt, or why it is refused, error.txt.
#include "core/level/file.h"
#include "editor/exchange/import.h"
#include "tests/support/folders.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QFile>

using namespace spacetow;
using namespace spacetow::test;

namespace {

QByteArray wholeFile(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// "code: argument | argument" for each.
QByteArray codeLines(const std::vector<Error>& notes) {
    std::string text;
    for (const Error& note : notes) {
        text += std::string(note.code.text()) + ':';
        for (std::size_t i = 0; i < note.arguments.size(); ++i) {
            text += (i == 0 ? " " : " | ") + note.arguments[i];
        }
        text += '\n';
    }
    return QByteArray::fromStdString(text);
}

Result<Import> importedFrom(const QByteArray& bytes) {
    const Result<Drawing> drawing = readDrawing({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return drawing ? importOf(drawing.value(), {}) : drawing.error();
}

} // namespace

class GoldenImportTest : public QObject {
    Q_OBJECT

  private slots:
    void aFileBecomesWhatIsLaidDown_data() {
        QTest::addColumn<QString>("path");
        const QString folder = sourceFolder() + "/tests/golden/import";
        for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            QTest::newRow(qPrintable(name)) << folder + '/' + name;
        }
    }
    void aFileBecomesWhatIsLaidDown() {
        QFETCH(QString, path);
        const QStringList inputs = QDir(path).entryList({"in.*"});
        QCOMPARE(inputs.size(), 1);
        Result<Import> import = importedFrom(wholeFile(path + '/' + inputs.front()));
        if (!import) {
            QVERIFY(!QFile::exists(path + "/out.json"));
            QCOMPARE(codeLines({import.error()}), wholeFile(path + "/error.txt"));
            return;
        }
        QVERIFY(!QFile::exists(path + "/error.txt"));
        QCOMPARE(codeLines(import.value().notes), wholeFile(path + "/report.txt"));
        const Imported result = imported(Level(), std::move(import).value().foreign, {.seed = 1});
        QCOMPARE(QByteArray::fromStdString(levelText(result.level)), wholeFile(path + "/out.json"));
        QVERIFY(!saveError(result.level));
        QVERIFY(parseLevel(levelText(result.level), Checks::FileOnly).problems.empty());
    }
};

SPACETOW_TEST(GoldenImportTest)
#include "golden_import_test.moc"
