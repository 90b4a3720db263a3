#include "editor/exchange/file_mark.h"

#include "tests/support/test_main.h"

#include <string>

using namespace spacetow;

class FileMarkTest : public QObject {
    Q_OBJECT

  private slots:
    void aFileIsWhatItsContentSays_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<FileMark>("mark");
        const auto row = [](const char* name, const QByteArray& text, FileMark mark) {
            QTest::newRow(name) << text << mark;
        };
        row("level", "{\"schema\": 3, \"name\": \"a\"}", FileMark::Level);
        row("level, BOM and blanks", "\xef\xbb\xbf \r\n{ \"name\": \"body\", \"schema\" : 3", FileMark::Level);
        row("level with a body inside", "{\"rules\": {\"body\": [1]}, \"objects\": []}", FileMark::Level);
        row("replay", "{\"replay\": 1, \"level\": \"schema\"}", FileMark::Replay);
        row("scene", "{\"allowSleep\": true, \"gravity\": {\"x\": 0}, \"body\" : [{}]}", FileMark::Foreign);
        row("a body that is none", "{\"body\": \"text\"}", FileMark::None);
        row("map", "{\"height\": 2, \"layers\": [{\"objects\": []}], \"type\": \"map\"}", FileMark::Foreign);
        row("old map", "{\"layers\": [], \"tilewidth\": 16}", FileMark::Foreign);
        row("tileset", "{\"type\": \"tileset\"}", FileMark::Foreign);
        row("other type", "{\"type\": \"FeatureCollection\"}", FileMark::None);
        row("name in a text", "{\"a\": \"\\\"schema\\\": 1\"}", FileMark::None);
        row("SVG", "<?xml version='1.0'?>\n<!-- <map> -->\n<svg:svg xmlns:svg='x'/>", FileMark::Foreign);
        row("SVG with a doctype", "<!DOCTYPE svg [<!ENTITY a '<b'>]><svg>", FileMark::None);
        row("SVG with a short doctype", "<!DOCTYPE svg PUBLIC 'a' 'b'>\n<svg width='1'>", FileMark::Foreign);
        row("map of Tiled", "<map version='1'>", FileMark::Foreign);
        row("page", "<html><svg></svg></html>", FileMark::None);
        row("UTF-16", QByteArray("\xff\xfe<\0s\0", 6), FileMark::Foreign);
        row("nothing", "", FileMark::None);
        row("text", "schema", FileMark::None);
    }
    void aFileIsWhatItsContentSays() {
        QFETCH(QByteArray, text);
        QFETCH(FileMark, mark);
        QCOMPARE(markOf({text.constData(), std::size_t(text.size())}), mark);
    }

    void moreOfAFileNeverContradictsItsBeginning() {
        for (const std::string text : {"{\"a\": [\"schema\"], \"schema\": 2, \"body\": []}",
                                       "{\"type\": \"map\", \"schema\": 2}", "<!-- x --><svg><map/></svg>"}) {
            const FileMark whole = markOf(text);
            QVERIFY(whole != FileMark::None);
            for (std::size_t size = 0; size <= text.size(); ++size) {
                const FileMark mark = markOf(std::string_view(text).substr(0, size));
                QVERIFY2(mark == FileMark::None || mark == whole, text.c_str());
            }
        }
    }
};

SPACETOW_TEST(FileMarkTest)
#include "file_mark_test.moc"
