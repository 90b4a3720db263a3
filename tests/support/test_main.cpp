#include "tests/support/test_main.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#ifdef QT_WIDGETS_LIB
#include <QApplication>
using Application = QApplication;
#else
#include <QCoreApplication>
using Application = QCoreApplication;
#endif

namespace {

using Factory = std::function<std::unique_ptr<QObject>()>;

std::map<std::string, Factory>& factories() {
    static std::map<std::string, Factory> all;
    return all;
}

} // namespace

namespace spacetow::test {

bool registerTest(const char* file, Factory make) {
    return factories().emplace(std::filesystem::path(file).stem().string(), std::move(make)).second;
}

} // namespace spacetow::test

/// Usage: PROGRAM [FILE…] [-- ARGUMENTS FOR QT TEST…]
int main(int argc, char** argv) {
    Application application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    QStringList wanted;
    QStringList forQtTest{arguments.front()};
    bool passOn = false;
    for (const QString& argument : arguments.mid(1)) {
        if (argument == "--") {
            passOn = true;
        } else {
            (passOn ? forQtTest : wanted) << argument;
        }
    }
    for (const QString& name : wanted) {
        if (!factories().contains(name.toStdString())) {
            std::fprintf(stderr, "there is no test file named %s here\n", qPrintable(name));
            return 2;
        }
    }
    int failures = 0;
    for (const auto& [name, make] : factories()) {
        if (wanted.isEmpty() || wanted.contains(QString::fromStdString(name))) {
            failures += QTest::qExec(make().get(), forQtTest);
        }
    }
    return std::min(failures, 100);
}
