#include "core/level/object_list.h"

#include "core/base/random.h"
#include "core/level/level.h"
#include "tests/support/full_run.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <algorithm>
#include <numeric>

using namespace spacetow;
using namespace spacetow::test;

namespace {

Object named(Key key) {
    return {key, std::to_string(key), ShipObject(), {}};
}

/// A list and the plain vector of keys that it should be like.
struct Twin {
    ObjectList list;
    std::vector<Key> keys;
    Key last = 0; // ever given out

    int below(Random& random, int count) const { return static_cast<int>(random.below(static_cast<unsigned>(count))); }

    void append() {
        keys.push_back(++last);
        list.append(named(last));
    }
    /// One of the things that edits do.
    void change(Random& random) {
        const int size = static_cast<int>(keys.size());
        const int kind = below(random, 11);
        if (size < 2 || kind < 3) {
            append();
            return;
        }
        const int at = below(random, size);
        if (kind == 3) {
            keys.insert(keys.begin() + at, ++last);
            list.insert(at, named(last));
        } else if (kind == 4) {
            keys[static_cast<std::size_t>(at)] = ++last;
            list.replace(at, named(last));
        } else if (kind == 5) {
            std::vector<int> order(keys.size());
            std::iota(order.begin(), order.end(), 0);
            std::rotate(order.begin() + at / 2, order.begin() + at, order.begin() + at + 1); // one goes forward
            std::rotate(keys.begin() + at / 2, keys.begin() + at, keys.begin() + at + 1);
            list.rearrange(order);
        } else if (kind == 6) {
            const unsigned divisor = 2 + random.below(90);
            std::erase_if(keys, [&](Key key) { return key % divisor == 0; });
            list.eraseIf([&](const Object& object) { return object.key % divisor == 0; });
        } else if (kind == 7) {
            list.replace(at, named(keys[static_cast<std::size_t>(at)]));
        } else if (kind == 8) {
            std::vector<int> order(keys.size());
            std::iota(order.begin(), order.end(), 0);
            std::swap(order[static_cast<std::size_t>(at)], order[static_cast<std::size_t>(below(random, size))]);
            const std::vector<Key> before = keys;
            std::ranges::transform(order, keys.begin(), [&](int i) { return before[static_cast<std::size_t>(i)]; });
            list.rearrange(order);
        } else {
            keys.erase(keys.begin() + at);
            list.erase(at);
        }
    }
    bool agree() const {
        std::vector<Key> seen;
        for (const Object& object : list) {
            seen.push_back(object.key);
        }
        for (int i = 0; i < list.size(); ++i) {
            if (list[i].key != keys[static_cast<std::size_t>(i)]) {
                return false;
            }
        }
        return seen == keys && list.size() == static_cast<int>(keys.size());
    }
    /// Whether every key is found where it is, and others nowhere.
    bool allAreFound() const {
        for (std::size_t i = 0; i < keys.size(); ++i) {
            if (list.indexOf(keys[i]) != static_cast<int>(i) || list.find(keys[i]) != &list[static_cast<int>(i)]) {
                return false;
            }
        }
        return list.indexOf(last + 1) == -1 && list.find(last + 2) == nullptr;
    }
};

} // namespace

class ObjectListTest : public QObject {
    Q_OBJECT

  private slots:
    void itIsLikeAVectorWhateverIsDoneToIt() {
        const unsigned seeds = usualOrThin(fullOrQuick(400U, 60U), 10U);
        for (unsigned seed = 0; seed < seeds; ++seed) {
            Random random(seed);
            Twin twin;
            for (unsigned i = random.below(1500); i > 0; --i) {
                twin.append();
            }
            for (int i = 0; i < 150; ++i) {
                twin.change(random);
                if (random.below(8) == 0) {
                    QVERIFY2(twin.agree() && twin.allAreFound(), seedText(seed));
                }
            }
            QVERIFY2(twin.agree() && twin.allAreFound(), seedText(seed));
        }
    }

    void copiesGoTheirOwnWays() {
        for (unsigned seed = 0; seed < 40; ++seed) {
            Random random(seed);
            std::vector<Twin> twins(1);
            for (unsigned i = random.below(900); i > 0; --i) {
                twins.front().append();
            }
            for (int i = 0; i < 60; ++i) {
                Twin& some = twins[random.below(static_cast<unsigned>(twins.size()))];
                if (twins.size() < 6 && random.below(5) == 0) {
                    const Twin copy = some;
                    twins.push_back(copy);
                } else if (random.below(4) == 0) {
                    QVERIFY2(some.allAreFound(), seedText(seed));
                } else {
                    some.change(random);
                }
            }
            for (const Twin& twin : twins) {
                QVERIFY2(twin.agree() && twin.allAreFound(), seedText(seed));
            }
        }
    }

    void differencesAreThePlacesThatDoNotShareTheirPiece() {
        for (unsigned seed = 0; seed < 60; ++seed) {
            Random random(seed);
            Twin before;
            for (unsigned i = random.below(1200); i > 0; --i) {
                before.append();
            }
            Twin after = before;
            for (unsigned i = random.below(4); i > 0; --i) {
                after.change(random);
            }
            std::vector<int> expected;
            for (int i = 0; i < std::max(before.list.size(), after.list.size()); ++i) {
                if (!after.list.sharesPiece(i, before.list)) {
                    expected.push_back(i);
                }
            }
            std::vector<int> visited;
            after.list.visitDifferences(before.list, [&](int index) { visited.push_back(index); });
            QVERIFY2(visited == expected, seedText(seed));
        }
    }

    void aListThatWasMovedAwayIsEmptyAndOfUse() {
        Twin twin;
        for (int i = 0; i < 300; ++i) {
            twin.append();
        }
        QVERIFY(twin.allAreFound());
        const ObjectList taken = std::move(twin.list);
        QCOMPARE(taken.size(), 300);
        QVERIFY(twin.list.empty() && twin.list.find(5) == nullptr); // NOLINT(bugprone-use-after-move)
        twin.keys.clear();
        twin.append();
        QVERIFY(twin.agree() && twin.allAreFound());
    }
};

SPACETOW_TEST(ObjectListTest)
#include "object_list_test.moc"
