#include "tests/support/test_main.h"

#include "core/game/rules.h"

#include <array>

using namespace spacetow;

class RulesTest : public QObject {
    Q_OBJECT

  private slots:
    void theRightPairsTouch() {
        using rules::debrisFilter, rules::finishFilter, rules::payloadFilter, rules::shipFilter;
        const Filter wall{};
        const std::array<Filter, 5> all{wall, shipFilter, payloadFilter, finishFilter, debrisFilter};
        const std::array<std::array<bool, 5>, 5> touch{{{true, true, true, false, true},
                                                        {true, false, true, false, false},
                                                        {true, true, false, true, false},
                                                        {false, false, true, false, false},
                                                        {true, false, false, false, true}}};
        for (std::size_t i = 0; i < 5; ++i) {
            for (std::size_t j = 0; j < 5; ++j) {
                QCOMPARE(mayTouch(all[i], all[j]), touch[i][j]);
            }
        }
    }
};

SPACETOW_TEST(RulesTest)
#include "rules_test.moc"
