#include "core/level/level_title.h"

#include "core/level/file.h"
#include "tests/support/test_main.h"

using namespace spacetow;

class LevelTitleTest : public QObject {
    Q_OBJECT

  private slots:
    void theBeginningOfAFileTellsTheName() {
        Level level;
        level.name = "Über \"den\" Wolken";
        level.description = std::string(10'000, 'x');
        const std::string text = levelText(level);
        QCOMPARE(titleIn(std::string_view(text).substr(0, 200)), std::optional(level.name));
        QCOMPARE(titleIn(text), std::optional(level.name));
    }
    void whatHasNoNameOrIsNoLevelHasNone() {
        for (const std::string_view text :
             {"", "{", "{\"name\": 3}", "{\"name\": \"\"}", "{\"tags\": [{\"name\": \"wall\"}]}", "[\"name\", \"a\"]",
              "{\"name\": \"cut o", "\xff\xfe{", "<svg name=\"a\">"}) {
            QVERIFY2(!titleIn(text), text.data());
        }
    }
};

SPACETOW_TEST(LevelTitleTest)
#include "level_title_test.moc"
