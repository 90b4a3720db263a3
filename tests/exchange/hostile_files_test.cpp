// Files that are made to be slow, large or wrong: each ends soon, in an import or in a reason.
#include "core/base/random.h"
#include "core/level/fields.h"
#include "core/level/file.h"
#include "editor/exchange/import.h"
#include "tests/support/folders.h"
#include "tests/support/full_run.h"
#include "tests/support/import_fuzz.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>

using namespace spacetow;
using namespace spacetow::test;

namespace {

std::string inSvg(const std::string& content) {
    return R"(<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100">)" + content + "</svg>";
}

Result<Import> importedText(const std::string& text, const ImportOptions& options = {}) {
    const Result<Drawing> drawing = readDrawing(text);
    return drawing ? importOf(drawing.value(), options) : drawing.error();
}

std::string repeated(const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) {
        all += text;
    }
    return all;
}

std::string codeOf(const Result<Import>& import) {
    return import ? std::string() : std::string(import.error().code.text());
}

std::string firstNote(const Result<Import>& import) {
    return import && !import.value().notes.empty() ? std::string(import.value().notes.front().code.text())
                                                   : std::string();
}

std::string randomScribble(int points) {
    Random random(3);
    std::string data = "M";
    for (int i = 0; i < points; ++i) {
        data += std::to_string(random.uniform(0, 100)) + ' ' + std::to_string(random.uniform(0, 100)) + ' ';
    }
    return inSvg("<path d='" + data + "'/>");
}

} // namespace

class HostileFilesTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsTooMuchIsRefused() {
        QCOMPARE(codeOf(importedText(inSvg(repeated("<g>", 300) + repeated("</g>", 300)))), "import-too-deep");
        QCOMPARE(codeOf(importedText(std::string(maxLevelBytes + 1, ' '))), "text-too-large");
        QCOMPARE(codeOf(importedText(repeated("[", 100000))), "import-unknown");
        QCOMPARE(codeOf(importedText("{\"body\":" + repeated("[", 100000))), "nested-too-deep");
        QCOMPARE(codeOf(importedText(std::string("\x1f\x8b\x08", 3))), "import-compressed");
        QCOMPARE(codeOf(importedText("")), "empty-file");
        QCOMPARE(codeOf(importedText(inSvg("<rect width='1e9' height='3'/>"))), "import-too-far");
        QCOMPARE(codeOf(importedText(inSvg("<g transform='scale(1e300)'><rect width='1e300' height='3'/></g>"))),
                 "import-too-far");
    }

    void whatWasLeftOutIsToldEvenWhereThatIsAllThereIs() {
        const Result<Drawing> map =
            readDrawing(R"(<map width="1" height="1" tilewidth="8" tileheight="8"><layer name="Ground"><data )"
                        R"(encoding="base64" compression="zlib">eJxjYAAAAAEAAQ==</data></layer></map>)");
        QVERIFY(bool(map));
        std::vector<Error> leftOut;
        const Result<Import> import = importOf(map.value(), {}, {}, &leftOut);
        QCOMPARE(codeOf(import), "import-nothing");
        QCOMPARE(leftOut.size(), std::size_t{1});
        QCOMPARE(leftOut.front().code.text(), std::string("import-tiles"));
    }

    void usesThatMultiplyAreStopped() {
        std::string defs = "<defs><rect id='l0' width='1' height='1'/>";
        for (int i = 1; i <= 30; ++i) {
            const std::string use = "<use href='#l" + std::to_string(i - 1) + "'/>";
            defs += "<g id='l" + std::to_string(i) + "'>" + use + use + use + use + "</g>";
        }
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(codeOf(importedText(inSvg(defs + "</defs><use href='#l30'/>"))), "import-too-many");
        QVERIFY2(timer.elapsed() < 10000, qPrintable(QString::number(timer.elapsed())));
    }

    void scribblesThatCrossThemselvesBecomeWhatTheyFillOrWalls() {
        const Result<Import> little = importedText(randomScribble(100));
        QVERIFY(little && little.value().notes.empty());
        const BodyObject& body = std::get<BodyObject>(little.value().foreign.objects.front().data);
        QVERIFY(body.shapes.size() > 10 && std::holds_alternative<Polygon>(body.shapes.front()));
        QElapsedTimer timer;
        timer.start();
        const Result<Import> much = importedText(randomScribble(20'000));
        QCOMPARE(firstNote(much), "import-tangled");
        QVERIFY2(timer.elapsed() < 10000, qPrintable(QString::number(timer.elapsed())));
    }

    void curvesThatWouldMakeTooManyVerticesAreRefused() {
        const std::string circle = "<path d='M0 0a2000 2000 0 1 1 1 0z' fill='none' stroke='red'/>";
        QCOMPARE(codeOf(importedText(inSvg(circle), {1e6, leastTolerance})), "import-too-many-vertices");
        QCOMPARE(codeOf(importedText(inSvg(circle), {100.0, leastTolerance})), std::string());
        QCOMPARE(codeOf(importedText(inSvg(repeated(circle, 300)), {100.0, leastTolerance})),
                 "import-too-many-vertices");
    }

    void aPolygonOfTooManyVerticesBecomesAWallRoundIt() {
        const ImportOptions options{1.0, leastTolerance};
        const Result<Import> import = importedText(inSvg("<ellipse rx='50' ry='51'/>"), options);
        QCOMPARE(firstNote(import), "import-large-polygon");
        const BodyObject& body = std::get<BodyObject>(import.value().foreign.objects.front().data);
        QVERIFY(std::get<LineChain>(body.shapes.front()).closed);
    }

    void anImportThatIsStoppedEnds() {
        std::stop_source source;
        source.request_stop();
        const Watch watch{source.get_token()};
        const std::string text = inSvg(repeated("<rect width='1' height='1'/>", 1000));
        QCOMPARE(readDrawing(text, watch).error().code.text(), std::string("import-stopped"));
        QCOMPARE(importOf(readDrawing(text).value(), {}, watch).error().code.text(), std::string("import-stopped"));
    }

    void whatFuzzingHasFoundHolds() {
        const QString folder = sourceFolder() + "/tests/fuzz/found";
        for (const QString& name : QDir(folder).entryList({"svg*", "tiled*"}, QDir::Files)) {
            QFile file(folder + '/' + name);
            QVERIFY(file.open(QIODevice::ReadOnly));
            tryImport(file.readAll().toStdString());
        }
    }

    /// Bytes of the golden files are changed, left out and doubled at random.
    void damagedFilesAreReadOrRefused() {
        Random random(99);
        const QString folder = sourceFolder() + "/tests/golden/import";
        for (const QString& name : QDir(folder).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            const QString inside = folder + '/' + name;
            QFile file(inside + '/' + QDir(inside).entryList({"in.*"}).value(0));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const std::string whole = file.readAll().toStdString();
            for (int round = 0; round < fullOrQuick(300, 12); ++round) {
                std::string text = whole;
                for (int change = 0; change < 1 + round % 4; ++change) {
                    const std::size_t at = random.next() % text.size();
                    const std::size_t length = std::min<std::size_t>(random.next() % 20, text.size() - at);
                    switch (random.next() % 3) {
                    case 0:
                        text[at] = static_cast<char>(32 + random.next() % 96);
                        break;
                    case 1:
                        text.erase(at, std::min(length, text.size() - 1));
                        break;
                    default:
                        text.insert(at, text.substr(at, length));
                    }
                }
                tryImport(text); // what does not hold ends the program
            }
        }
    }
};

SPACETOW_TEST(HostileFilesTest)
#include "hostile_files_test.moc"
