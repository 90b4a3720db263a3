#pragma once
// Where the clone and the build are that a test belongs to.

#include <QString>

namespace spacetow::test {

/// The root of the clone, without a slash at its end.
QString sourceFolder();
/// The folder of the preset's build, as build/dev; the programs are in its bin.
QString binaryFolder();

} // namespace spacetow::test
