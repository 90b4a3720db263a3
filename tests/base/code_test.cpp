#include "core/base/code.h"

#include "tests/support/test_main.h"

#include <map>
#include <string>
#include <type_traits>

using namespace spacetow;

namespace {

constexpr std::string_view lowCodes[] = {"no-ground", "no-sky"};
constexpr std::string_view highCodes[] = {"no-roof"};
using LowCode = CodeOf<lowCodes>;
using HighCode = LowCode::And<highCodes>;

static_assert(!std::is_constructible_v<LowCode, std::string>); // what is only known when the program runs
static_assert(!std::is_constructible_v<Code, const char*>);    // of which no table is asked
static_assert(std::is_convertible_v<LowCode, HighCode>);
static_assert(!std::is_convertible_v<HighCode, LowCode>); // which may not have it

} // namespace

class CodeTest : public QObject {
    Q_OBJECT

  private slots:
    void codesAreEqualWhenTheyAreSpelledAlike() {
        const HighCode high = "no-sky";
        const Code any = LowCode("no-sky");
        QVERIFY(high == any && any == high && high == "no-sky" && high != "no-roof");
        QVERIFY(any != LowCode("no-ground") && Code() == LowCode() && Code() != any);
    }

    void aCodeOfALowerLayerIsOneOfAllAbove() {
        std::string texts;
        HighCode::each([&texts](std::string_view text) { texts += std::string(text) + ' '; });
        QCOMPARE(texts, std::string("no-ground no-sky no-roof "));
        QCOMPARE(HighCode("no-ground").text(), LowCode("no-ground").text());
    }

    void codesHaveAnOrder() {
        std::map<Code, int> counts;
        for (const HighCode code : {HighCode("no-roof"), HighCode("no-ground"), HighCode("no-roof")}) {
            ++counts[code];
        }
        QCOMPARE(counts.size(), std::size_t{2});
        QCOMPARE(counts.at(HighCode("no-roof")), 2);
    }
};

SPACETOW_TEST(CodeTest)
#include "code_test.moc"
