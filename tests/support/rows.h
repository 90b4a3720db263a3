#pragma once
// Rows that many tests have: one for each number of iterations.

#include "core/physics/world/world.h"
#include "tests/support/full_run.h"
#include "tests/support/seed_text.h"
#include "tests/support/test_main.h"

#include <vector>

namespace spacetow::test {

/// A thin run has no rows of a hundred, which are a few times twenty and would take four fifths of its time. Levels
/// have a hundred unless they say otherwise, so the tests of the game go on with them.
inline const std::vector<int> iterationCounts = isThinRun() ? std::vector{4, 20} : std::vector{4, 20, 100};

/// A column with the iteration counts, and a row for each.
inline void iterationRows() {
    QTest::addColumn<int>("iterations");
    for (const int iterations : iterationCounts) {
        QTest::addRow("%d iterations", iterations) << iterations;
    }
}

} // namespace spacetow::test
