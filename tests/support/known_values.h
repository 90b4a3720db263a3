#pragma once
// Tests made of sentences and numbers: each row says what a number must be, and its name says why.

#include "tests/support/test_main.h"

#include <cmath>

namespace spacetow::test {

inline void knownValueColumns() {
    QTest::addColumn<double>("found");
    QTest::addColumn<double>("expected");
    QTest::addColumn<double>("tolerance");
}

inline void known(const char* sentence, double found, double expected, double tolerance = 1e-12) {
    QTest::newRow(sentence) << found << expected << tolerance;
}

inline void checkKnownValue() {
    QFETCH(double, found);
    QFETCH(double, expected);
    QFETCH(double, tolerance);
    QVERIFY2(found == expected || std::abs(found - expected) <= tolerance,
             qPrintable(QString("%1, expected %2").arg(found, 0, 'g', 17).arg(expected, 0, 'g', 17)));
}

} // namespace spacetow::test
