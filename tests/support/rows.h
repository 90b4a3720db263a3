#pragma once
// Rows that many tests have: one for each number of iterations.

#include "core/physics/world.h"
#include "tests/support/full_run.h"
#include "tests/support/test_main.h"

#include <array>
#include <cstdint>

namespace spacetow::test {

constexpr std::array iterationCounts{4, 20, 100};

/// A column with the iteration counts, and a row for each.
inline void iterationRows() {
    QTest::addColumn<int>("iterations");
    for (const int iterations : iterationCounts) {
        QTest::addRow("%d iterations", iterations) << iterations;
    }
}

inline QByteArray seedText(std::uint64_t seed) {
    return "seed " + QByteArray::number(static_cast<qulonglong>(seed));
}

} // namespace spacetow::test
