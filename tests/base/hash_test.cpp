#include "core/base/hash.h"

#include "tests/support/test_main.h"

#include <cmath>
#include <set>

using namespace spacetow;

namespace {

template <class... T>
std::uint64_t hashOf(T... values) {
    StateHash hash;
    (hash.add(values), ...);
    return hash.value();
}

} // namespace

class HashTest : public QObject {
    Q_OBJECT

  private slots:
    void equalStatesHaveEqualHashes();
    void everyBitAndTheOrderCount();
    void minusZeroCountsAsZero();
    void theValueIsTheSameOnEveryPlatform();
};

void HashTest::equalStatesHaveEqualHashes() {
    QCOMPARE(hashOf(1.5, std::uint64_t{7}), hashOf(1.5, std::uint64_t{7}));
    StateHash hash;
    hash.add(2.0);
    QCOMPARE(hash.value(), hash.value()); // asking changes nothing
}

void HashTest::everyBitAndTheOrderCount() {
    std::set<std::uint64_t> seen{hashOf(std::uint64_t{0}), hashOf()};
    for (int bit = 0; bit < 64; ++bit) {
        QVERIFY(seen.insert(hashOf(std::uint64_t{1} << bit)).second);
        QVERIFY(seen.insert(hashOf(std::uint64_t{1} << bit, std::uint64_t{0})).second);
        QVERIFY(seen.insert(hashOf(std::uint64_t{0}, std::uint64_t{1} << bit)).second);
    }
    QVERIFY(hashOf(1.0, 2.0) != hashOf(2.0, 1.0));
    QVERIFY(hashOf(1.0) != hashOf(std::nextafter(1.0, 2.0)));
}

void HashTest::minusZeroCountsAsZero() {
    QCOMPARE(hashOf(-0.0), hashOf(0.0));
}

void HashTest::theValueIsTheSameOnEveryPlatform() {
    // Written down once: a change of the hash would make every recorded session look wrong.
    QCOMPARE(hashOf(std::uint64_t{1}, 2.5), std::uint64_t{0xc946f4da4920c38ull});
}

SPACETOW_TEST(HashTest)
#include "hash_test.moc"
