#pragma once
// Several Qt Test classes in one program. Each test file ends with SPACETOW_TEST(ItsClass) and its .moc include;
// the program runs the files named on its command line (without ".cpp"), or all of them.

#include <QTest>

#include <functional>
#include <memory>
#include <string>

namespace spacetow::test {

/// Adds a test class under the base name of `file`; returns a value so that it can run during static initialisation.
bool registerTest(const char* file, std::function<std::unique_ptr<QObject>()> make);

} // namespace spacetow::test

#define SPACETOW_TEST(Class)                                                                                           \
    static const bool registered##Class =                                                                              \
        spacetow::test::registerTest(__FILE__, [] { return std::unique_ptr<QObject>(new Class); });
