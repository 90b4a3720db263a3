#pragma once
// The name of a row that a random search failed in, so that it can be repeated.

#include <QByteArray>

#include <cstdint>

namespace spacetow::test {

inline QByteArray seedText(std::uint64_t seed) {
    return "seed " + QByteArray::number(static_cast<qulonglong>(seed));
}

} // namespace spacetow::test
