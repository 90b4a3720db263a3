#include "core/base/disjoint_sets.h"
#include "core/base/random.h"

#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numeric>

using namespace spacetow;
using test::seedText;

namespace {

constexpr std::uint32_t indexCount = 60;

std::vector<std::uint32_t> singletons() {
    std::vector<std::uint32_t> parents(indexCount);
    std::iota(parents.begin(), parents.end(), 0u);
    return parents;
}

/// The slow way: everybody knows the lowest of his set.
void relabel(std::vector<std::uint32_t>& lowest, std::uint32_t a, std::uint32_t b) {
    const std::uint32_t from = std::max(lowest[a], lowest[b]);
    const std::uint32_t to = std::min(lowest[a], lowest[b]);
    std::replace(lowest.begin(), lowest.end(), from, to);
}

} // namespace

class DisjointSetsTest : public QObject {
    Q_OBJECT

  private slots:
    void anIndexAloneIsItsOwnRoot();
    void theRootIsTheLowestOfWhatHasBeenUnited();
};

void DisjointSetsTest::anIndexAloneIsItsOwnRoot() {
    std::vector<std::uint32_t> parents = singletons();
    uniteSets(parents, 7, 7);
    for (std::uint32_t i = 0; i < indexCount; ++i) {
        QCOMPARE(rootOf(parents, i), i);
    }
}

void DisjointSetsTest::theRootIsTheLowestOfWhatHasBeenUnited() {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Random random(seed);
        std::vector<std::uint32_t> parents = singletons();
        std::vector<std::uint32_t> lowest = singletons();
        for (int unions = 0; unions < 50; ++unions) {
            const std::uint32_t a = random.below(indexCount);
            const std::uint32_t b = random.below(indexCount);
            uniteSets(parents, a, b);
            relabel(lowest, a, b);
            for (std::uint32_t i = 0; i < indexCount; ++i) {
                QVERIFY2(rootOf(parents, i) == lowest[i], seedText(seed));
            }
        }
    }
}

SPACETOW_TEST(DisjointSetsTest)
#include "disjoint_sets_test.moc"
