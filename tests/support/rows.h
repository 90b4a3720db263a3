#pragma once
// Rows that many tests have: one for each number of iterations; and how far random searches go.

#include "core/physics/world.h"
#include "tests/support/test_main.h"

#include <cstdint>
#include <cstdlib>

namespace spacetow::test {

inline void iterationRows() {
    QTest::addColumn<int>("iterations");
    for (const int iterations : {4, 20, 100}) {
        QTest::addRow("%d iterations", iterations) << iterations;
    }
}

/// Whether the long random searches are asked for.
inline bool isFullRun() {
    return std::getenv("SPACETOW_FULL") != nullptr;
}

inline QByteArray seedText(std::uint64_t seed) {
    return "seed " + QByteArray::number(static_cast<qulonglong>(seed));
}

} // namespace spacetow::test
